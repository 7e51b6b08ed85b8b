import { fileSize } from "./sizes.js";

/** Milliseconds without a byte after which a server counts as dead. */
const PATIENCE = 60e3;

/** Bytes that a file may have: more do not fit into one array of a browser. */
const MOST = 2e9;

/**
 * Fetch a file, with progress, and say in words what went wrong.
 *
 * @param {string} address
 * @param {(fraction: number | null, text?: string, size?: number) => void} report with bytes so far
 * @param {{ signal?: AbortSignal, patience?: number, most?: number, size?: number }} [options] milliseconds without a byte, bytes;
 *   `size`: bytes of the file as far as is known. A host may send it packed, and tells of another origin's page only how many bytes
 *   that makes
 * @returns {Promise<ArrayBuffer>}
 */
export async function download(address, report, { signal, patience = PATIENCE, most = MOST, size = 0 } = {}) {
  const { host } = new URL(address, location.href);
  const clock = new Clock(patience, signal);
  try {
    const answer = await fetch(address, { credentials: "same-origin", signal: clock.signal });
    clock.wind();
    if (!answer.ok) throw new Refused(`${host} answered ${answer.status} ${answer.statusText}`.trimEnd());
    const encoded = answer.headers.has("content-encoding");
    const announced = encoded ? 0 : Number(answer.headers.get("content-length") ?? 0);
    const total = size || announced;
    if (total > most) throw tooLarge(host, total, most);
    if (!answer.body) return await answer.arrayBuffer();
    return await collect(answer.body, { total, most, host, report, clock });
  } catch (cause) {
    if (signal?.aborted) throw cause;
    const reason = clock.late
      ? `${host} has sent nothing for ${Math.round(patience / 1000)} seconds`
      : cause instanceof Refused
        ? cause.message
        : whyUnreachable();
    throw new Error(`${address} could not be fetched: ${reason}`, { cause });
  } finally {
    clock.stop();
  }
}

/** A server's answer that is not the file. */
class Refused extends Error {}

/** Breaks a fetch off when nothing comes, or when its caller wants no more. */
class Clock {
  late = false;
  #broken = new AbortController();
  #patience;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #alarm;

  /** @param {number} patience milliseconds @param {AbortSignal} [signal] of the caller */
  constructor(patience, signal) {
    this.#patience = patience;
    this.signal = signal ? AbortSignal.any([signal, this.#broken.signal]) : this.#broken.signal;
    this.wind();
  }

  wind() {
    clearTimeout(this.#alarm);
    this.#alarm = setTimeout(() => {
      this.late = true;
      this.#broken.abort();
    }, this.#patience);
  }

  stop() {
    clearTimeout(this.#alarm);
  }
}

function whyUnreachable() {
  return navigator.onLine === false
    ? "there is no network"
    : "the server can't be reached, or does not let other sites read its files (CORS)";
}

/** @param {string} host @param {number} size @param {number} most */
function tooLarge(host, size, most) {
  return new Refused(
    `${host} sends ${fileSize(size)}, and ${fileSize(most)} are the most that a browser can hold`,
  );
}

/**
 * @param {ReadableStream<Uint8Array>} body
 * @param {{ total: number, most: number, host: string, report: Parameters<typeof download>[1], clock: Clock }} how bytes announced, or 0
 */
async function collect(body, { total, most, host, report, clock }) {
  /** @type {Uint8Array[]} */
  const parts = [];
  let size = 0;
  const reader = body.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    clock.wind();
    parts.push(value);
    size += value.length;
    if (size > most) {
      void reader.cancel();
      throw tooLarge(host, size, most);
    }
    const known = total > 0 && size <= total; // a packed file turns out larger than announced
    report(
      known ? size / total : null,
      `fetching, ${fileSize(size)}${known ? ` of ${fileSize(total)}` : ""}`,
      size,
    );
  }
  return new Blob(/** @type {BlobPart[]} */ (parts)).arrayBuffer();
}
