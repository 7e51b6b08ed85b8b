import { scriptAddress } from "../../offline/trusted.js";

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
  #turn;
  /** @type {Worker | null} */
  #worker = null;

  /**
   * @param {object} places
   * @param {string | URL} places.worker address of the bundled worker
   * @param {string | URL} places.runtime address of the interpreter's folder, ending in a slash
   * @param {Promise<unknown> | null} [places.turn] before which the interpreter does not start
   */
  constructor({ worker, runtime, turn = null }) {
    this.#address = worker;
    this.#runtime = String(runtime);
    this.#turn = turn;
  }

  /** @param {Listener} listener */
  start(listener) {
    let worker;
    try {
      worker = this.makeWorker(this.#address);
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      queueMicrotask(() =>
        listener.failed({ kind: "WorkerError", message: `no worker can be had here: ${reason}` }),
      );
      return;
    }
    worker.onmessage = ({ data }) => {
      if (data.ready) listener.ready(data.ready);
      else if (data.failed) listener.failed(data.failed);
      else if (data.loading) listener.loading(data.loading);
      else if (data.refused) listener.refused(data.id, data.refused);
      else if (data.sha256) listener.identified(data.id, data.sha256, data.bytes);
      else if (data.broken) listener.broken(data.broken);
      else listener.answered(data.id, data.packed, data);
    };
    worker.onerror = (event) => {
      event.preventDefault?.();
      const message =
        event.message || `the script of the core's worker could not be loaded (${this.#address})`;
      listener.broken({ kind: "WorkerError", message });
    };
    worker.onmessageerror = () =>
      listener.broken({ kind: "WorkerError", message: "an answer of the core could not be received" });
    const boot = () => worker.postMessage({ boot: this.#runtime });
    if (this.#turn === null) boot();
    else void this.#turn.then(boot);
    this.#worker = worker;
  }

  /** @param {string | URL} address @returns {Worker} */
  makeWorker(address) {
    return new Worker(scriptAddress(address), { type: "module", name: "hexalab core" });
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
