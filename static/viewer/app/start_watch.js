/** Milliseconds without a file of the core after which the user is told. */
const PATIENCE = 20_000;

/**
 * Watches over the start of the core: where nothing has come for a while it says so, and offers to begin again. A slow
 * network is no error: the start goes on meanwhile.
 */
export class StartWatch {
  #client;
  #messages;
  #last = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {EventTarget} client @param {import("./messages.js").Messages} messages @param {number} [patience] milliseconds */
  constructor(client, messages, patience = PATIENCE) {
    this.#client = client;
    this.#messages = messages;
    this.patience = patience;
    client.addEventListener("loading", this.#heard);
    this.#wait();
  }

  /** The core has started, or failed. */
  end() {
    clearTimeout(this.#timer);
    this.#client.removeEventListener("loading", this.#heard);
    this.#messages.settle("start");
  }

  #heard = (/** @type {Event} */ event) => {
    this.#last = /** @type {CustomEvent<{ file: string }>} */ (event).detail.file;
    this.#messages.settle("start");
    this.#wait();
  };

  #wait() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      const seconds = Math.round(this.patience / 1000);
      this.#messages.say(
        "warning",
        `The measuring engine takes long to load: nothing has come for ${seconds} s${this.#last ? `, after ${this.#last}` : ""}. The network may be slow or gone`,
        { topic: "start", action: { name: "try again", press: () => location.reload() } },
      );
    }, this.patience);
  }
}
