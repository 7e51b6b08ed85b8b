/**
 * What is under way, in words, for the thin bar. The task begun last is the one that is shown.
 *
 *     const task = progress.begin("reading 1,000,000 cells");
 *     task.report(0.5);
 *     task.end();
 */
export class Progress {
  #facts;
  /** @type {Set<{ text: string, fraction: number | null }>} */
  #tasks = new Set();

  /** @param {import("../state/facts.js").Facts} facts */
  constructor(facts) {
    this.#facts = facts;
    facts.set({ progress: null });
  }

  /** @param {string} text */
  begin(text) {
    const task = { text, fraction: /** @type {number | null} */ (null) };
    this.#tasks.add(task);
    this.#show();
    return {
      /** @param {number | null} fraction @param {string} [words] */
      report: (fraction, words) => {
        task.fraction = fraction;
        task.text = words ?? task.text;
        this.#show();
      },
      end: () => {
        this.#tasks.delete(task);
        this.#show();
      },
    };
  }

  #show() {
    const task = [...this.#tasks].at(-1);
    this.#facts.set({ progress: task ? { ...task } : null });
  }
}
