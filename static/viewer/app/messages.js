/** @typedef {import("../state/facts.js").Message} Message */

/** Topics that are settled when another mesh has come. */
const OF_A_MESH = [
  "open",
  "keep",
  "drop",
  "offer",
  "status",
  "save",
  "inspect",
  "pick",
  "finding",
  "kept",
  "frame",
];

/** Messages that stay until they are read: no dialogs, no alerts. They leave when their matter is settled. */
export class Messages {
  static #last = 0;
  #facts;
  #about;
  #ended = false;

  /** @param {import("../state/facts.js").Facts} facts @param {string} [about] what topics begin with, where they are another mesh's */
  constructor(facts, about = "") {
    this.#facts = facts;
    this.#about = about;
  }

  /**
   * @param {Message["severity"]} severity @param {string} text
   * @param {{ topic?: string, action?: Message["action"] }} [options] a newer message on a topic takes the older one's place
   */
  say(severity, text, { topic, action } = {}) {
    if (this.#ended) return;
    const own = topic && this.#about + topic;
    const message = { id: ++Messages.#last, severity, text, action, topic: own };
    const others = this.#all.filter((one) => one.text !== text && (!own || one.topic !== own));
    this.#facts.set({ messages: [...others, message].slice(-4) });
  }

  /** What went wrong, in one sentence. @param {unknown} error @param {{ topic?: string }} [options] */
  error(error, options) {
    this.say("error", error instanceof Error ? error.message : String(error), options);
  }

  /** @param {number} id */
  dismiss(id) {
    this.#facts.set({ messages: this.#all.filter((one) => one.id !== id) });
  }

  /** Take back what was said on some topics. @param {...string} topics */
  settle(...topics) {
    const own = topics.map((topic) => this.#about + topic);
    const rest = this.#all.filter(({ topic }) => !topic || !own.includes(topic));
    if (rest.length < this.#all.length) this.#facts.set({ messages: rest });
  }

  /** Take back what was said about the mesh before, and what was done to it. */
  settleMesh() {
    this.settle(...OF_A_MESH);
  }

  /** What they are about is gone: all that was said of it is taken back, and nothing more is said. */
  end() {
    this.#ended = true;
    const rest = this.#all.filter(({ topic }) => !topic?.startsWith(this.#about));
    if (rest.length < this.#all.length) this.#facts.set({ messages: rest });
  }

  /** @returns {readonly Message[]} */
  get #all() {
    return this.#facts.get("messages");
  }
}
