/**
 * Hand-picked cells (SPEC F4): what dig, undig and isolate make of the picking part of the status. `hidden` cells
 * are hidden whatever the filters say, `shown` cells are shown; when `isolated`, all but `shown` are hidden.
 *
 * @typedef {import("./status.js").Status["filters"]["picking"]} Picking
 */

/** Take a tool to hand, or put it away. @param {import("./facts.js").Facts} facts @param {import("./facts.js").Tool} tool */
export function toggleTool(facts, tool) {
  facts.set({ tool: facts.get("tool") === tool ? "turn" : tool });
}

/** @param {readonly number[]} list @param {number} cell */
const without = (list, cell) => list.filter((one) => one !== cell);

/** @param {readonly number[]} list @param {number} cell */
const including = (list, cell) => [...new Set([...list, cell])].sort((a, b) => a - b);

/** Hide a cell; one that was undug just leaves that list. @param {Picking} picking @param {number} cell @returns {Picking} */
export function dig(picking, cell) {
  if (picking.shown.includes(cell)) return { ...picking, enabled: true, shown: without(picking.shown, cell) };
  return { ...picking, enabled: true, hidden: including(picking.hidden, cell) };
}

/** Show a cell; one that was dug just leaves that list. @param {Picking} picking @param {number} cell @returns {Picking} */
export function undig(picking, cell) {
  if (picking.hidden.includes(cell))
    return { ...picking, enabled: true, hidden: without(picking.hidden, cell) };
  return { ...picking, enabled: true, shown: including(picking.shown, cell) };
}

/** Hide all but these cells. @param {Iterable<number>} cells @returns {Picking} */
export function isolate(cells) {
  return { enabled: true, isolated: true, hidden: [], shown: [...new Set(cells)].sort((a, b) => a - b) };
}

/** @returns {Picking} */
export function clear() {
  return { enabled: true, isolated: false, hidden: [], shown: [] };
}

/** @param {Picking} picking */
export function isClear(picking) {
  return !picking.isolated && !picking.hidden.length && !picking.shown.length;
}

/**
 * Cell numbers as typed: "3, 10-14 20". Numbers run from 0 in file order.
 *
 * @param {string} text @param {number} cells how many cells the mesh has
 * @returns {{ cells: number[], wrong: string }} `wrong` names what could not be understood, or is empty
 */
export function parseCells(text, cells) {
  /** @type {Set<number>} */
  const found = new Set();
  for (const word of text.split(/[\s,;]+/).filter(Boolean)) {
    const match = /^(\d+)(?:[-–](\d+))?$/.exec(word);
    if (!match) return { cells: [], wrong: `“${word}” is not a cell number` };
    const [first, last] = [Number(match[1]), Number(match[2] ?? match[1])];
    if (Math.max(first, last) >= cells)
      return { cells: [], wrong: `“${word}”: cells run from 0 to ${cells - 1}` };
    for (let cell = Math.min(first, last); cell <= Math.max(first, last); cell++) found.add(cell);
  }
  return { cells: [...found].sort((a, b) => a - b), wrong: "" };
}

/** Cell numbers in the form `parseCells` reads, runs drawn together. @param {readonly number[]} cells */
export function formatCells(cells) {
  /** @type {[number, number][]} */
  const runs = [];
  for (const cell of [...cells].sort((a, b) => a - b)) {
    const last = runs.at(-1);
    if (last && cell === last[1] + 1) last[1] = cell;
    else runs.push([cell, cell]);
  }
  return runs.map(([first, last]) => (first === last ? `${first}` : `${first}-${last}`)).join(", ");
}
