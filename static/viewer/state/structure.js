/** @typedef {import("./status.js").Status["structure"]} Look  what of the structure is looked at */

/** Whether blocks are drawn apart. @param {Partial<Look>} look */
export function isApart({ kind, form, explode = 0 }) {
  return kind === "blocks" && form !== "surfaces" && explode > 0;
}

/** How many times as large as the mesh its blocks stand. @param {Partial<Look>} look */
export function spreadOf(look) {
  return isApart(look) ? 1 + (look.explode ?? 0) : 1;
}
