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

/**
 * What is hidden and shown of cells, parts or groups.
 *
 * @template One @typedef {{ readonly enabled: boolean, readonly isolated: boolean, readonly hidden: readonly One[], readonly shown: readonly One[] }} Chosen
 */

/** @template One @param {readonly One[]} list @param {One} cell */
const without = (list, cell) => list.filter((one) => one !== cell);

/** @template One @param {readonly One[]} list */
const inOrder = (list) => [...new Set(list)].sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));

/** @template One @param {readonly One[]} list @param {One} cell */
const including = (list, cell) => inOrder([...list, cell]);

/** Hide a cell; one that was undug just leaves that list. @template One @param {Chosen<One>} picking @param {One} cell @returns {Chosen<One>} */
export function dig(picking, cell) {
  if (picking.shown.includes(cell)) return { ...picking, enabled: true, shown: without(picking.shown, cell) };
  return { ...picking, enabled: true, hidden: including(picking.hidden, cell) };
}

/** Show a cell; one that was dug just leaves that list. @template One @param {Chosen<One>} picking @param {One} cell @returns {Chosen<One>} */
export function undig(picking, cell) {
  if (picking.hidden.includes(cell))
    return { ...picking, enabled: true, hidden: without(picking.hidden, cell) };
  return { ...picking, enabled: true, shown: including(picking.shown, cell) };
}

/** Hide all but these cells. @template {number | string} One @param {Iterable<One>} cells @returns {Chosen<One>} */
export function isolate(cells) {
  return { enabled: true, isolated: true, hidden: [], shown: inOrder([...cells]) };
}

/** @returns {{ enabled: boolean, isolated: boolean, hidden: never[], shown: never[] }} */
export function clear() {
  return { enabled: true, isolated: false, hidden: [], shown: [] };
}

/** @param {Chosen<unknown>} picking */
export function isClear(picking) {
  return !picking.isolated && !picking.hidden.length && !picking.shown.length;
}

/**
 * Cell numbers as typed: "3, 10-14 20". They are those of the file; of a range all count that there are.
 *
 * @param {string} text @param {number} cells how many cells the mesh has @param {import("./numbering.js").Numbering} numbering
 * @returns {{ cells: number[], wrong: string }} rows; `wrong` names what could not be understood, or is empty
 */
export function parseCells(text, cells, numbering) {
  /** @type {Set<number>} */
  const found = new Set();
  for (const word of text.split(/[\s,;]+/).filter(Boolean)) {
    const match = /^(\d+)(?:[-–](\d+))?$/.exec(word);
    if (!match) return { cells: [], wrong: `“${word}” is not a cell number` };
    const [first, last] = [Number(match[1]), Number(match[2] ?? match[1])];
    const rows = numbering.between(Math.min(first, last), Math.max(first, last), cells);
    const [low, high] = numbering.ends(cells);
    if (!rows.length || Math.max(first, last) > high || Math.min(first, last) < low)
      return { cells: [], wrong: `“${word}”: no such cell, they run from ${low} to ${high}` };
    for (const row of rows) found.add(row);
  }
  return { cells: [...found].sort((a, b) => a - b), wrong: "" };
}

/** Numbers of cells in the form `parseCells` reads, runs drawn together. @param {readonly number[]} cells rows @param {import("./numbering.js").Numbering} numbering */
export function formatCells(cells, numbering) {
  /** @type {[number, number][]} */
  const runs = [];
  for (const cell of cells.map((row) => numbering.of(row)).sort((a, b) => a - b)) {
    const last = runs.at(-1);
    if (last && cell === last[1] + 1) last[1] = cell;
    else runs.push([cell, cell]);
  }
  return runs.map(([first, last]) => (first === last ? `${first}` : `${first}-${last}`)).join(", ");
}
