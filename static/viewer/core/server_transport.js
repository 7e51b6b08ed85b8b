import { framed } from "./frame.js";

/**
 * The way to a core that runs natively on this machine: `hexalab view`, behind a server that answers this page alone.
 *
 * @typedef {import("./client.js").Transport} Transport
 * @typedef {import("./client.js").Listener} Listener
 *
 * @typedef {{ id: string, name: string, surface?: boolean }} Offer  a mesh that the core can open without its bytes being sent, or a surface
 * @typedef {{ version: string, token: string, offers: readonly Offer[], status: object | null, watched: boolean, opens: boolean,
 *   compare: string | null }} Hello
 * @typedef {{ changed?: string, gone?: string, stopped?: boolean, identified?: { question: number, sha256: string } }} News
 *   what the core tells without having been asked
 */

const GONE = "the program on this machine that this page asks is gone: start `hexalab view` again";

/** Milliseconds before the news are listened to again, when the connection was lost. */
const PAUSE = 500;

/** So often in a row the connection may be lost. */
const MOST_LOSSES = 3;

/** @implements {Transport} */
export class ServerTransport {
  #root;
  #token;
  #told;
  /** @type {AbortController} */
  #life = new AbortController();
  #seat = "";

  /**
   * @param {string} root address of the server, ending in a slash
   * @param {string} token
   * @param {{ hello: (hello: Hello) => void, news: (news: News) => void }} told what the server tells besides answers
   */
  constructor(root, token, told) {
    this.#root = root;
    this.#token = token;
    this.#told = told;
  }

  /** @param {Listener} listener */
  start(listener) {
    const life = (this.#life = new AbortController());
    this.#seat = crypto.randomUUID();
    this.#greet(life).then(
      () => {
        listener.ready({ interpreter: 0, numpy: 0, core: 0 });
        void this.#listen(listener, life.signal);
      },
      (error) => life.signal.aborted || listener.failed({ kind: "ServerError", message: error.message }),
    );
    this.#listener = listener;
  }

  /** @type {Listener | null} */
  #listener = null;

  /** @param {AbortController} life */
  async #greet(life) {
    const answer = await this.#post("hello", null, life.signal);
    if (!answer.ok) throw new Error(await refused(answer));
    const hello = /** @type {Hello} */ (await answer.json());
    this.#token = hello.token;
    this.#told.hello(hello);
  }

  /** @param {import("./question.js").Question} question */
  send(question) {
    const { signal } = this.#life;
    const listener = /** @type {Listener} */ (this.#listener);
    this.#ask(question, signal).then(
      ({ packed, milliseconds }) =>
        signal.aborted || listener.answered(question.id, packed, { milliseconds }),
      (error) => signal.aborted || listener.broken({ kind: "ServerError", message: error.message }),
    );
  }

  stop() {
    this.#life.abort();
  }

  /** @param {import("./question.js").Question} question @param {AbortSignal} signal */
  async #ask(question, signal) {
    const answer = await this.#post("ask", framed(question), signal);
    if (!answer.ok) throw new Error(await refused(answer));
    const packed = await answer.arrayBuffer();
    return { packed, milliseconds: Number(answer.headers.get("X-HexaLab-Milliseconds")) };
  }

  /** @param {string} what @param {Blob | null} body @param {AbortSignal} signal @returns {Promise<Response>} */
  async #post(what, body, signal) {
    const headers = { "X-HexaLab-Token": this.#token, "X-HexaLab-Seat": this.#seat };
    try {
      return await fetch(`${this.#root}${what}`, { method: "POST", headers, body: body ?? "", signal });
    } catch (cause) {
      throw new Error(GONE, { cause });
    }
  }

  /** Hear the news, as long as this core lives. @param {Listener} listener @param {AbortSignal} signal */
  async #listen(listener, signal) {
    for (let losses = 0; losses < MOST_LOSSES && !signal.aborted; losses++) {
      try {
        const answer = await this.#post("events", null, signal);
        if (!answer.ok || !answer.body) break;
        for await (const news of linesOf(answer.body)) {
          losses = 0;
          this.#hear(listener, /** @type {News} */ (JSON.parse(news)));
        }
      } catch {
        // the connection was lost
      }
      await new Promise((resolve) => setTimeout(resolve, PAUSE));
    }
    if (!signal.aborted) this.#told.news({ stopped: true });
  }

  /** @param {Listener} listener @param {News} news */
  #hear(listener, news) {
    const { identified } = news;
    if (identified) listener.identified(identified.question, identified.sha256);
    else this.#told.news(news);
    if (news.stopped) this.#life.abort();
  }
}

/** @param {Response} answer */
async function refused(answer) {
  const text = (await answer.text()).trim();
  return answer.status === 403
    ? `the program on this machine does not let this page in (${text}): open the address that it printed`
    : text || `the program on this machine answered ${answer.status}`;
}

/** @param {ReadableStream<Uint8Array>} stream */
async function* linesOf(stream) {
  const reader = stream.getReader();
  const decoder = new TextDecoder();
  let rest = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    const lines = (rest + decoder.decode(value, { stream: true })).split("\n");
    rest = lines.pop() ?? "";
    yield* lines;
  }
}
