/**
 * What is known of a second mesh, beside what is known of the first.
 *
 * @typedef {import("./facts.js").Facts} Facts
 * @typedef {keyof import("./facts.js").FactTable} FactName
 */

/**
 * Call `update` whenever one of these facts of the second mesh changes, or it comes or goes.
 *
 * @param {{ facts: Facts }} context @param {readonly FactName[]} names @param {() => void} update
 */
export function followSecond({ facts }, names, update) {
  /** @type {(() => void)[]} */
  let stops = [];
  const follow = () => {
    for (const stop of stops) stop();
    const second = facts.get("second");
    stops = second ? names.map((name) => second.on(name, update)) : [];
    update();
  };
  facts.on("second", follow);
  follow();
}
