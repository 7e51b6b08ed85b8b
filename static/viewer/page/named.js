/**
 * What is told to be in the view: the open mesh, or the one whose portrait stands in its place.
 *
 * @param {import("../state/facts.js").Facts} facts
 * @returns {{ name: string, entry: import("../state/entry.js").Entry | null }} of the catalogue, if it is there; the name may be empty
 */
export function namedIn(facts) {
  const portrait = facts.get("portrait");
  const entry = facts.get("entry") ?? (portrait && !portrait.aside ? portrait.entry : null);
  return { name: entry?.mesh.name ?? facts.get("summary")?.name ?? "", entry };
}

/** The facts that it hangs on. */
export const NAMING = /** @type {const} */ (["summary", "entry", "portrait"]);
