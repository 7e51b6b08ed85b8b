/** What the user prefers whatever is open: facts that are kept in this browser. */
const KEPT = /** @type {const} */ (["keeping", "remember"]);
const MEMORY = "hexalab.preferences";

/** Take on what was chosen before, and keep what is chosen from now on. @param {import("../state/facts.js").Facts} facts */
export function rememberPreferences(facts) {
  /** @type {Record<string, unknown>} */
  let known = {};
  try {
    known = JSON.parse(localStorage.getItem(MEMORY) ?? "{}") ?? {};
  } catch {
    // a browser that keeps nothing
  }
  for (const name of KEPT)
    if (typeof known[name] === typeof facts.get(name)) facts.set({ [name]: known[name] });
  for (const name of KEPT)
    facts.on(name, () => {
      try {
        const chosen = Object.fromEntries(KEPT.map((one) => [one, facts.get(one)]));
        localStorage.setItem(MEMORY, JSON.stringify(chosen));
      } catch {
        // it holds as long as the page
      }
    });
}
