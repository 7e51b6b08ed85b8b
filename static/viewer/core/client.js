import { unpack } from "../files/packing.js";
import { question } from "./question.js";

/**
 * The page's end of the core: calls methods of the Python `Session`, wherever that runs.
 *
 *     const client = new CoreClient(new WorkerTransport({ worker: "viewer/worker.js", runtime: "runtime/" }));
 *     await client.ready;
 *     const summary = await client.call("open", ["cube.mesh", bytes]);
 *
 * One call is under way at a time; the others wait in order. A call with a `replace` key takes the place of one with
 * the same key that still waits (whose promise is rejected with `Superseded`), so that a pointer never queues.
 *
 * Events: "busy" when the first call starts and "idle" when the last has ended; "loading" ({file}) when a part of the core has come; "died" and "restarted" when the core had to
 * be started anew; "stopped" ({error}) when it died of the same thing again, or could not be started anew: then every call
 * is refused until `restart`.
 *
 * @typedef {{ kind: string, message: string }} Failure  `kind` is the Python exception's name, e.g. "MeshReadError"
 *
 * @typedef {object} Listener  what a transport tells
 * @property {(timings: Start) => void} ready the core can be asked; milliseconds of its start
 * @property {(failure: Failure) => void} failed it can't be started
 * @property {(id: number, packed: ArrayBuffer, cost: Cost) => void} answered
 * @property {(failure: Failure) => void} broken it can't go on, with the question that is under way if there is one
 * @property {(id: number, failure: Failure) => void} refused the question with this id could not be read
 * @property {(id: number, sha256: string, bytes?: ArrayBuffer) => void} identified the file that the question with this id
 *   opened, and its bytes, where they come back
 * @property {(file: string) => void} loading a file that the core is made of has come
 *
 * @typedef {{ milliseconds: number, memory?: number }} Cost  what a call took, and bytes that the core holds since
 *
 * @typedef {object} Transport  the way to a core: a worker, a server, a notebook's kernel
 * @property {(listener: Listener) => void} start starts a core
 * @property {(question: import("./question.js").Question) => void} send one question; the next comes after its answer
 * @property {() => void} stop ends the core, which then tells nothing more
 * @property {() => void} [end] it is not started again: what the way itself holds is let go
 */

/** So often the core may die in a row before it is left alone. */
const MOST_DEATHS = 3;

/**
 * A file by its SHA-256 in hexadecimal, "" where that can't be known; and its bytes, where they come back.
 *
 * @typedef {{ sha256: string, bytes?: ArrayBuffer }} Identity
 */

/** @type {Identity} */
const UNKNOWN = { sha256: "" };

/** Methods by which the mesh becomes another. */
const OPENING = ["open", "open_offered"];

/** A newer call with the same key came before this one was sent. */
export class Superseded extends Error {
  name = "Superseded";
}

/** What the core said. */
export class CoreError extends Error {
  /** @param {Failure} failure */
  constructor({ kind, message }) {
    super(message);
    this.name = "CoreError";
    this.kind = kind;
  }
}

/**
 * @typedef {import("./types.js").Methods} Methods
 *
 * @typedef {{ id: number, method: string, args: readonly unknown[] | (() => readonly unknown[]), replace?: string,
 *   resolve: (value: unknown) => void, reject: (error: Error) => void }} Call
 *
 * @typedef {{ interpreter: number, numpy: number, core: number }} Start  milliseconds of the core's start
 */

export class CoreClient extends EventTarget {
  /** @type {Transport} */
  #transport;
  #sequence = 0;
  /** @type {Call[]} */
  #waiting = [];
  /** @type {Call | null} */
  #running = null;
  /** Number of the call that opened the present mesh. */
  #opened = 0;
  /** What the file is that was opened last, some time after that. @type {Promise<Identity>} */
  identity = Promise.resolve(UNKNOWN);
  /** @type {(identity: Identity) => void} */
  #identify = () => {};
  /** What was told before its answer has come, on another way. */
  #early = { id: 0, identity: UNKNOWN };
  #booted = false;
  /** Why no call can be answered. @type {Error | null} */
  #stopped = null;
  /** What the core died of last, and how often in a row: until it has done that. */
  #deaths = { method: "", count: 0 };
  /** Milliseconds of the last call of each method, measured where the core runs. @type {Record<string, number>} */
  milliseconds = {};
  /** Bytes of memory that the core holds: it never gives any back. Null while that is not known. @type {number | null} */
  memory = null;

  /** @param {Transport} transport */
  constructor(transport) {
    super();
    this.#transport = transport;
    /** Settles when the core runs. */
    this.ready = this.#start();
  }

  /** @returns {Promise<Start>} */
  #start() {
    this.#booted = false;
    /** @type {Promise<Start>} */
    const ready = new Promise((resolve, reject) => {
      this.#transport.start({
        ready: (timings) => {
          this.#booted = true;
          resolve(timings);
          this.#next();
        },
        failed: (failure) => reject(new CoreError(failure)),
        broken: (failure) => {
          reject(new CoreError(failure));
          if (this.#booted) this.#break(failure);
        },
        answered: (id, packed, cost) => this.#receive(id, packed, cost),
        refused: (id, failure) => id === this.#running?.id && this.#refuse(new CoreError(failure)),
        loading: (file) => this.dispatchEvent(new CustomEvent("loading", { detail: { file } })),
        identified: (id, sha256, bytes) => this.#told(id, { sha256, bytes }),
      });
    });
    ready.catch((error) => this.#stop(error));
    return ready;
  }

  /**
   * Call a method of `Session`.
   *
   * @template {keyof Methods} Method
   * @param {Method} method
   * @param {Methods[Method]["args"] | (() => Methods[Method]["args"])} [args] ArrayBuffers among them are handed over, not copied;
   *   a function makes them when the call is sent
   * @param {{ replace?: string }} [options]
   * @returns {Promise<Methods[Method]["answer"]>}
   */
  call(method, args, { replace } = {}) {
    return new Promise((resolve, reject) => {
      if (this.#stopped) return reject(this.#stopped);
      if (replace !== undefined) {
        const index = this.#waiting.findIndex((call) => call.replace === replace);
        if (index >= 0) this.#waiting.splice(index, 1)[0].reject(new Superseded());
      }
      const answered = /** @type {(value: unknown) => void} */ (resolve);
      const call = { id: ++this.#sequence, method, args: args ?? [], replace, resolve: answered, reject };
      this.#waiting.push(call);
      this.#next();
    });
  }

  /** Number of calls under way or waiting. */
  get pending() {
    return this.#waiting.length + (this.#running ? 1 : 0);
  }

  /** Start the core anew; calls under way and waiting are rejected, the mesh has to be opened again. */
  restart() {
    this.#deaths = { method: "", count: 0 };
    this.#startAnew();
  }

  #startAnew() {
    this.#transport.stop();
    this.#stopped = null;
    this.#identify(UNKNOWN); // it is hashed no more
    this.dispatchEvent(new Event("died"));
    this.#fail(new CoreError({ kind: "WorkerError", message: "The core stopped and was started again." }));
    this.ready = this.#start();
    this.ready.then(
      () => this.dispatchEvent(new Event("restarted")),
      (error) => this.dispatchEvent(new CustomEvent("stopped", { detail: { error } })),
    );
  }

  dispose() {
    this.#transport.stop();
    this.#transport.end?.();
    this.#fail(new CoreError({ kind: "WorkerError", message: "The core was closed." }));
  }

  #next() {
    if (!this.#booted || this.#running) return;
    const call = this.#waiting.shift();
    if (!call) return;
    this.#running = call;
    this.dispatchEvent(new CustomEvent("busy", { detail: { method: call.method } }));
    try {
      const args = typeof call.args === "function" ? call.args() : call.args;
      this.#transport.send(question(call.id, call.method, args));
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      this.#refuse(
        new CoreError({ kind: "RequestError", message: `This can't be asked of the core: ${reason}` }),
      );
    }
  }

  /** The call under way was not taken: the others go on. @param {Error} error */
  #refuse(error) {
    this.#running?.reject(error);
    this.#running = null;
    this.#next();
    if (!this.pending) this.dispatchEvent(new Event("idle"));
  }

  /** @param {number} id @param {ArrayBuffer} packed @param {Cost} cost */
  #receive(id, packed, { milliseconds, memory }) {
    const call = this.#running;
    if (!call || call.id !== id) return;
    this.#running = null;
    this.milliseconds[call.method] = milliseconds;
    this.memory = memory ?? null;
    if (call.method === this.#deaths.method) this.#deaths = { method: "", count: 0 };
    const { error, result } = unpack(packed);
    if (error) call.reject(new CoreError(/** @type {Failure} */ (error)));
    else {
      if (OPENING.includes(call.method)) this.#begin(id);
      call.resolve(result);
    }
    this.#next();
    if (!this.pending) this.dispatchEvent(new Event("idle"));
  }

  /** Another mesh is open. @param {number} id */
  #begin(id) {
    this.#opened = id;
    this.#identify(UNKNOWN);
    this.identity = new Promise((resolve) => (this.#identify = resolve));
    if (this.#early.id === id) this.#identify(this.#early.identity);
  }

  /** A file that could not be read, or was followed by another, is not what is open. @param {number} id @param {Identity} identity */
  #told(id, identity) {
    if (id === this.#opened) this.#identify(identity);
    else this.#early = { id, identity };
  }

  /** @param {Failure} failure */
  #break(failure) {
    const error = new CoreError(failure);
    this.#deaths = { method: this.#running?.method ?? "", count: this.#deaths.count + 1 };
    this.#running?.reject(error);
    this.#running = null;
    if (this.#deaths.count < MOST_DEATHS) return this.#startAnew();
    this.#transport.stop();
    this.#stop(error);
    this.dispatchEvent(new CustomEvent("stopped", { detail: { error } }));
  }

  /** No call is answered from now on. @param {Error} error */
  #stop(error) {
    this.#booted = false;
    this.#stopped = error;
    this.#fail(error);
  }

  /** @param {Error} error */
  #fail(error) {
    const calls = this.#running ? [this.#running, ...this.#waiting] : this.#waiting;
    this.#running = null;
    this.#waiting = [];
    for (const call of calls) call.reject(error);
  }
}
