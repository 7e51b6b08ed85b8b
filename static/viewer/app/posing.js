/**
 * What is taken of the picture under settings that are set for that alone, one after the other; they are then what they were.
 * One may be within another, as a figure within a report.
 *
 * @template Taken
 * @param {Pick<import("./app.js").App, "store" | "drawing" | "facts">} app
 * @param {readonly import("../state/status.js").PartialStatus[]} poses
 * @param {(pose: number) => Promise<Taken>} take
 * @returns {Promise<Taken[]>}
 */
export async function posed({ store, drawing, facts }, poses, take) {
  const { status } = store;
  const within = facts.get("posing");
  const taken = [];
  facts.set({ posing: true });
  try {
    for (const [k, pose] of poses.entries()) {
      store.set(pose, { undo: false });
      await drawing.drawn();
      taken.push(await take(k));
    }
  } finally {
    const touched = new Set(poses.flatMap((pose) => Object.keys(pose)));
    const before = Object.entries(status).filter(([part]) => touched.has(part));
    store.set(Object.fromEntries(before), { undo: false });
    facts.set({ posing: within });
    await drawing.drawn();
  }
  return taken;
}
