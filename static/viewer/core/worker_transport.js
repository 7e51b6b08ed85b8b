/**
 * The way to a core that runs in a worker of this page: Pyodide, as on the static site.
 *
 * @typedef {import("./client.js").Transport} Transport
 * @typedef {import("./client.js").Listener} Listener
 * @implements {Transport}
 */
export class WorkerTransport {
  #address;
  #runtime;
  /** @type {Worker | null} */
  #worker = null;

  /** @param {{ worker: string | URL, runtime: string | URL }} places `worker`: address of the bundled worker; `runtime`: of the interpreter's folder, ending in a slash */
  constructor({ worker, runtime }) {
    this.#address = worker;
    this.#runtime = String(runtime);
  }

  /** @param {Listener} listener */
  start(listener) {
    const worker = this.makeWorker(this.#address);
    worker.onmessage = ({ data }) => {
      if (data.ready) listener.ready(data.ready);
      else if (data.failed) listener.failed(data.failed);
      else if (data.sha256) listener.identified(data.id, data.sha256);
      else if (data.broken) listener.broken(data.broken);
      else listener.answered(data.id, data.packed, data.milliseconds);
    };
    worker.onerror = (event) => {
      event.preventDefault?.();
      listener.broken({ kind: "WorkerError", message: event.message || "The core could not start." });
    };
    worker.postMessage({ boot: this.#runtime });
    this.#worker = worker;
  }

  /** @param {string | URL} address @returns {Worker} */
  makeWorker(address) {
    return new Worker(address, { type: "module", name: "hexalab core" });
  }

  /** @param {import("./question.js").Question} question its blocks are handed over, not copied */
  send(question) {
    this.#worker?.postMessage(question, question.blocks);
  }

  stop() {
    this.#worker?.terminate();
    this.#worker = null;
  }
}
