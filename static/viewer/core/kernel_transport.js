import { framed } from "./frame.js";

/**
 * The way to a core in a notebook's kernel: binary messages of the widget whose frame this page stands in.
 *
 * @typedef {import("./client.js").Transport} Transport
 * @typedef {import("./client.js").Listener} Listener
 *
 * @typedef {Record<string, unknown> & { kind: string }} Message
 * @typedef {{ version: string, offers: readonly { id: string, name: string }[], status: object | null, opens: boolean, compare?: string | null }} Hello
 *
 * @typedef {object} Port  the widget's end, which stands in the notebook's page
 * @property {(message: Message, bytes?: ArrayBuffer) => void} send to the kernel, in pieces
 * @property {(kind: string, hear: (message: any, block: ArrayBuffer | null) => void) => void} on what the kernel sends
 * @property {() => Port} another way to the same kernel, for another mesh
 * @property {() => void} close
 * @property {(name: string) => any} get a value that widget and kernel share
 * @property {(name: string, value: unknown) => void} set a value that widget and kernel share
 * @property {(name: string, changed: (value: any) => void) => void} follow such a value
 */

/** Milliseconds after which it is said that an answer is missing. */
const SLOW = 10_000;

const GONE = "the notebook's kernel is gone: run the cell again";

/** @implements {Transport} */
export class KernelTransport {
  #port;
  #told;
  /** @type {Listener | null} */
  #listener = null;

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #waiting;

  /** @param {Port} port @param {{ hello: (hello: Hello) => void, slow: (slow: boolean) => void }} told what is to be known besides answers */
  constructor(port, told) {
    this.#port = port;
    this.#told = told;
    port.on("hello", ({ hello }) => {
      this.#heard();
      this.#told.hello(hello);
      this.#listener?.ready({ interpreter: 0, numpy: 0, core: 0 });
    });
    port.on("answer", ({ number, milliseconds }, block) => {
      this.#heard();
      if (block) this.#listener?.answered(number, block, { milliseconds });
    });
    port.on("refused", ({ reason }) =>
      this.#listener?.broken({ kind: "KernelError", message: String(reason) }),
    );
    port.on("identified", ({ number, sha256 }) => this.#listener?.identified(number, sha256));
  }

  /** @param {Listener} listener */
  start(listener) {
    this.#listener = listener;
    this.#wait();
    this.#try(() => this.#port.send({ kind: "hello" }), listener.failed);
  }

  /** @param {import("./question.js").Question} question */
  send(question) {
    const listener = this.#listener;
    if (!listener) return;
    this.#wait();
    void framed(question)
      .arrayBuffer()
      .then((bytes) =>
        this.#try(() => this.#port.send({ kind: "ask", number: question.id }, bytes), listener.broken),
      );
  }

  stop() {
    clearTimeout(this.#waiting);
    this.#listener = null;
  }

  /** It is not started again: the kernel lets its session go. */
  end() {
    this.#port.close();
  }

  /** A kernel that is busy answers late, one that is gone never, and neither says so. */
  #wait() {
    clearTimeout(this.#waiting);
    this.#waiting = setTimeout(() => this.#told.slow(true), SLOW);
  }

  #heard() {
    clearTimeout(this.#waiting);
    this.#told.slow(false);
  }

  /** @param {() => void} act @param {(failure: import("./client.js").Failure) => void} fail */
  #try(act, fail) {
    try {
      act();
    } catch {
      queueMicrotask(() => fail({ kind: "KernelError", message: GONE }));
    }
  }
}
