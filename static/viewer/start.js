import { Ahead } from "./catalogue/ahead.js";
import { CoreClient } from "./core/client.js";
import { WorkerTransport } from "./core/worker_transport.js";

/**
 * What is begun before the page is built, by a script of its own: the core's worker starts and the preview comes while the
 * larger script is still on its way, and keeps the page busy.
 */

const { worker, runtime, root } = document.documentElement.dataset;

/** The mesh that the page's address names: "source/mesh", an address, or nothing. */
export const addressed = new URLSearchParams(location.search).get("mesh") ?? "";

export const ahead = new Ahead(new URL(/** @type {string} */ (root), location.href).href, addressed);

export const client = new CoreClient(
  new WorkerTransport({
    worker: new URL(/** @type {string} */ (worker), document.baseURI),
    runtime: new URL(/** @type {string} */ (runtime), document.baseURI),
  }),
);
