/**
 * The page's end of the core: calls methods of the Python `Session` that lives in a worker.
 *
 *     const client = new CoreClient({ worker: "viewer/worker.js", runtime: "runtime/" });
 *     await client.ready;
 *     const summary = await client.call("open", ["cube.mesh", bytes]);
 *
 * One call is under way at a time; the others wait in order. A call with a `replace` key takes the place of one with
 * the same key that still waits (whose promise is rejected with `Superseded`), so that a pointer never queues.
 *
 * Events: "busy" when the first call starts and "idle" when the last has ended; "identified" ({sha256}) some time
 * after a file is opened; "died" and "restarted" when the worker had to be replaced.
 */

/** A newer call with the same key came before this one was sent. */
export class Superseded extends Error {
  name = "Superseded";
}

/** What the core said: `kind` is the Python exception's name, e.g. "MeshReadError". */
export class CoreError extends Error {
  /** @param {{kind: string, message: string}} error */
  constructor({ kind, message }) {
    super(message);
    this.name = "CoreError";
    this.kind = kind;
  }
}

/**
 * @typedef {{id: number, method: string, args: unknown[], replace?: string, transfer: Transferable[],
 *   resolve: (value: any) => void, reject: (error: Error) => void}} Call
 */

export class CoreClient extends EventTarget {
  #worker;
  #makeWorker;
  #runtime;
  #sequence = 0;
  /** @type {Call[]} */
  #waiting = [];
  /** @type {Call | null} */
  #running = null;
  /** Number of the call that opened the present mesh. */
  #opened = 0;
  #booted = false;
  /** Milliseconds of the last call of each method, measured in the worker. @type {Record<string, number>} */
  milliseconds = {};

  /**
   * @param {{worker: string | URL, runtime: string | URL, makeWorker?: () => Worker}} options
   *   `worker`: address of the bundled worker; `runtime`: of the interpreter's folder, ending in a slash
   */
  constructor({ worker, runtime, makeWorker }) {
    super();
    this.#runtime = String(runtime);
    this.#makeWorker = makeWorker ?? (() => new Worker(worker, { type: "module", name: "hexalab core" }));
    this.#worker = this.#start();
  }

  /** @returns {Worker} */
  #start() {
    this.#booted = false;
    const worker = this.#makeWorker();
    /** Settles when Python is ready: `{interpreter, core}` milliseconds. @type {Promise<{interpreter: number, core: number}>} */
    this.ready = new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => {
        if (data.ready) {
          this.#booted = true;
          resolve(data.ready);
          this.#next();
        } else if (data.failed) reject(new CoreError(data.failed));
        else this.#receive(data);
      };
      worker.onerror = (event) => {
        event.preventDefault?.();
        const error = new CoreError({
          kind: "WorkerError",
          message: event.message || "The core could not start.",
        });
        reject(error);
        if (this.#booted) this.restart();
      };
    });
    this.ready.catch((error) => this.#fail(error));
    worker.postMessage({ boot: this.#runtime });
    return worker;
  }

  /**
   * Call a method of `Session`.
   * @param {string} method
   * @param {unknown[]} [args] ArrayBuffers among them are handed over, not copied
   * @param {{replace?: string}} [options]
   * @returns {Promise<any>}
   */
  call(method, args = [], { replace } = {}) {
    return new Promise((resolve, reject) => {
      if (replace !== undefined) {
        const index = this.#waiting.findIndex((call) => call.replace === replace);
        if (index >= 0) this.#waiting.splice(index, 1)[0].reject(new Superseded());
      }
      const transfer = args.filter((argument) => argument instanceof ArrayBuffer);
      this.#waiting.push({ id: ++this.#sequence, method, args, replace, transfer, resolve, reject });
      this.#next();
    });
  }

  /** Number of calls under way or waiting. */
  get pending() {
    return this.#waiting.length + (this.#running ? 1 : 0);
  }

  /** Replace the worker; calls under way and waiting are rejected, the mesh has to be opened again. */
  restart() {
    this.#worker.terminate();
    this.dispatchEvent(new Event("died"));
    this.#fail(new CoreError({ kind: "WorkerError", message: "The core stopped and was started again." }));
    this.#worker = this.#start();
    this.ready?.then(() => this.dispatchEvent(new Event("restarted"))).catch(() => {});
  }

  dispose() {
    this.#worker.terminate();
    this.#fail(new CoreError({ kind: "WorkerError", message: "The core was closed." }));
  }

  #next() {
    if (!this.#booted || this.#running) return;
    const call = this.#waiting.shift();
    if (!call) return;
    this.#running = call;
    this.dispatchEvent(new CustomEvent("busy", { detail: { method: call.method } }));
    this.#worker.postMessage({ id: call.id, method: call.method, args: call.args }, call.transfer);
  }

  /** @param {{id?: number, result?: unknown, error?: any, milliseconds?: number, opened?: number, sha256?: string}} data */
  #receive(data) {
    if (data.sha256) {
      // A file that could not be read, or was followed by another, is not what is open.
      if (data.opened !== this.#opened) return;
      this.dispatchEvent(new CustomEvent("identified", { detail: { sha256: data.sha256 } }));
      return;
    }
    const call = this.#running;
    if (!call || call.id !== data.id) return;
    this.#running = null;
    if (data.milliseconds !== undefined) this.milliseconds[call.method] = data.milliseconds;
    if (data.error?.fatal) {
      call.reject(new CoreError(data.error));
      this.restart();
      return;
    }
    if (data.error) call.reject(new CoreError(data.error));
    else {
      if (call.method === "open") this.#opened = call.id;
      call.resolve(data.result);
    }
    this.#next();
    if (!this.pending) this.dispatchEvent(new Event("idle"));
  }

  /** @param {Error} error */
  #fail(error) {
    const calls = this.#running ? [this.#running, ...this.#waiting] : this.#waiting;
    this.#running = null;
    this.#waiting = [];
    for (const call of calls) call.reject(error);
  }
}
