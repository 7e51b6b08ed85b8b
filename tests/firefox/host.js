import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
};

/**
 * A host of static files, which can be cut off and can answer otherwise than its folder does.
 */
export class Host {
  /** Address to what is answered in place of the file. @type {Map<string, string>} */
  instead = new Map();
  #folder;
  #server;
  #port = 0;

  /** @param {string} folder */
  constructor(folder) {
    this.#folder = folder;
    this.#server = createServer((request, response) => void this.#answer(request, response));
  }

  get root() {
    return `http://localhost:${this.#port}/`;
  }

  /** @returns {Promise<void>} */
  listen() {
    return new Promise((resolve) =>
      this.#server.listen(this.#port, "127.0.0.1", () => {
        this.#port = /** @type {import("node:net").AddressInfo} */ (this.#server.address()).port;
        resolve();
      }),
    );
  }

  /** No request is answered from now on. @returns {Promise<void>} */
  cut() {
    return new Promise((resolve) => {
      this.#server.close(() => resolve());
      this.#server.closeAllConnections();
    });
  }

  /** @param {import("node:http").IncomingMessage} request @param {import("node:http").ServerResponse} response */
  async #answer(request, response) {
    let path = decodeURIComponent(new URL(request.url ?? "/", this.root).pathname);
    if (path.endsWith("/")) path += "index.html";
    const headers = {
      "content-type": TYPES[extname(path)] ?? "application/octet-stream",
      "cache-control": "no-cache",
      "access-control-allow-origin": "*",
    };
    const text = this.instead.get(path);
    if (text !== undefined) return response.writeHead(200, headers).end(text);
    const file = join(this.#folder, normalize(path));
    try {
      if (!(await stat(file)).isFile()) throw new Error("a folder");
      response.writeHead(200, headers);
      createReadStream(file).pipe(response);
    } catch {
      response.writeHead(404).end();
    }
  }
}
