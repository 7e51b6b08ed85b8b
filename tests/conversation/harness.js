// The page that the conversation goes through: the viewer's own client over one of its transports.
import { CoreClient, CoreError } from "../../static/viewer/core/client.js";
import { ServerTransport } from "../../static/viewer/core/server_transport.js";
import { WorkerTransport } from "../../static/viewer/core/worker_transport.js";

/** What a core told without having been asked. @type {unknown[]} */
const news = [];

/** @type {Record<string, (place: Record<string, string>) => import("../../static/viewer/core/client.js").Transport>} */
const TRANSPORTS = {
  worker: ({ worker, runtime }) => new WorkerTransport({ worker, runtime }),
  server: ({ root, token }) =>
    new ServerTransport(root, token, {
      hello: (hello) => news.push({ hello }),
      news: (one) => news.push(one),
    }),
};

/** Any method may be tried here. @type {Omit<CoreClient, "call"> & { call: (method: string, args: unknown[]) => Promise<unknown> }} */
let client;

/** Arrays as {dtype, base64}, all else as it is. @param {unknown} value @returns {unknown} */
function told(value) {
  if (ArrayBuffer.isView(value)) {
    const bytes = new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
    const text = bytes.reduce((all, byte) => all + String.fromCharCode(byte), "");
    return { array: value.constructor.name.replace("Array", "").toLowerCase(), base64: btoa(text) };
  }
  if (Array.isArray(value)) return value.map(told);
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, told(one)]));
}

/** @param {unknown} one @returns {one is { base64: string }} */
const isFile = (one) => typeof one === "object" && one !== null && "base64" in one;

/** @param {string} base64 */
const blockOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;

Object.assign(window, {
  /** @param {string} way @param {Record<string, string>} place */
  begin: async (way, place) => {
    client = /** @type {any} */ (new CoreClient(TRANSPORTS[way](place)));
    await client.ready;
  },
  news: () => news,
  /** @param {string} method @param {unknown[]} args a file's bytes as {base64} */
  ask: async (method, args) => {
    try {
      const given = args.map((one) => (isFile(one) ? blockOf(one.base64) : one));
      return { result: told(await client.call(method, given)) };
    } catch (error) {
      if (!(error instanceof CoreError)) throw error;
      return { error: { kind: error.kind, message: error.message } };
    }
  },
  /** Restart the core as after a crash; resolves when it can be asked again. */
  again: () =>
    new Promise((resolve) => {
      client.addEventListener("restarted", () => resolve(undefined), { once: true });
      client.restart();
    }),
});
