import { Ahead } from "./catalogue/ahead.js";
import { CoreClient } from "./core/client.js";
import { soon } from "./core/soon.js";
import { WorkerTransport } from "./core/worker_transport.js";

/**
 * What is begun before the page is built, by a script of its own: the core's worker starts and the preview comes while the
 * larger script is still on its way, and keeps the page busy.
 */

const { worker, runtime, root } = document.documentElement.dataset;

/** Processor cores on which the first picture and Python get in each other's way: there one comes after the other. */
const FEW_CORES = 2;

/** Milliseconds that Python waits for the first picture, at most: a later one waits for the network. */
const PATIENCE = 1000;

/** The mesh that the page's address names: "source/mesh", an address, or nothing. */
export const addressed = new URLSearchParams(location.search).get("mesh") ?? "";

export const ahead = new Ahead(new URL(/** @type {string} */ (root), location.href).href, addressed);

const inTurn = addressed !== "" && navigator.hardwareConcurrency <= FEW_CORES;

export const client = new CoreClient(
  new WorkerTransport({
    worker: new URL(/** @type {string} */ (worker), document.baseURI),
    runtime: new URL(/** @type {string} */ (runtime), document.baseURI),
    turn: inTurn ? soon(ahead.shown, PATIENCE) : null,
  }),
);
