/** An element as far as drawings make any: a tag with attributes and children. */
export class Drawn {
  /** @type {Record<string, string>} */
  attributes = {};
  /** @type {(Drawn | string)[]} */
  children = [];

  /** @param {string} tag */
  constructor(tag) {
    this.tag = tag;
  }

  /** @param {string} name @param {unknown} value */
  setAttribute(name, value) {
    this.attributes[name] = String(value);
  }

  /** @param {string} name */
  removeAttribute(name) {
    delete this.attributes[name];
  }

  /** @param {...(Drawn | string)} children */
  append(...children) {
    this.children.push(...children);
  }

  get text() {
    return this.children.filter((child) => typeof child === "string").join("");
  }
}

/** Have drawings be made without a browser. */
export function drawWithoutBrowser() {
  const document = {
    createElementNS: (/** @type {string} */ _, /** @type {string} */ tag) => new Drawn(tag),
  };
  Object.assign(globalThis, { document });
}

/** Corners of a path of straight lines. @param {string} d @returns {[number, number][]} */
export function cornersOf(d) {
  return d
    .split(/[ML]/)
    .filter(Boolean)
    .map((pair) => {
      const [x, y] = pair.split(" ").map(Number);
      return [x, y];
    });
}
