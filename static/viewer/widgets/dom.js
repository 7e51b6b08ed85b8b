/**
 * @typedef {string | number | boolean | null | undefined} Attribute
 * @typedef {Readonly<Record<string, Attribute | ((event: never) => void)>>} Properties
 * @typedef {Node | string | null | undefined | false} Child
 */

/**
 * Makes an element. Properties that start with "on" are listeners, `class`, `for`, `aria-*`, `data-*` and the like
 * are attributes; true and false set and leave out an attribute. Text goes in as text, never as markup.
 *
 *     h("button", { class: "tool", type: "button", onclick: dig }, icon("dig"), "Dig")
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag @param {Properties} [properties] @param {...Child} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  apply(element, properties);
  element.append(...children.filter(isPresent));
  return element;
}

/** The same for SVG. @param {string} tag @param {Properties} [properties] @param {...Child} children */
export function s(tag, properties = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  apply(element, properties);
  element.append(...children.filter(isPresent));
  return /** @type {SVGElement} */ (element);
}

/** @param {Child} child @returns {child is Node | string} */
function isPresent(child) {
  return child !== null && child !== undefined && child !== false && child !== "";
}

/** @param {Element} element @param {Properties} properties */
function apply(element, properties) {
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === "function")
      element.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    else setAttribute(element, name, value);
  }
}

/** @param {Element} element @param {string} name @param {Attribute} value */
export function setAttribute(element, name, value) {
  if (value === false || value === null || value === undefined) element.removeAttribute(name);
  else element.setAttribute(name, value === true ? "" : String(value));
}

/** Sets text only where it differs, so that live regions do not repeat themselves. @param {Element} element @param {string} text */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

let lastId = 0;

/** A fresh id for labels and descriptions. @param {string} stem */
export function freshId(stem) {
  return `${stem}-${++lastId}`;
}
