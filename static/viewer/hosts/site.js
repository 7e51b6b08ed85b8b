import { Ahead } from "../catalogue/ahead.js";
import { CoreClient } from "../core/client.js";
import { soon } from "../core/soon.js";
import { fetchedSheet } from "./host.js";
import { WorkerTransport } from "../core/worker_transport.js";

/** Processor cores on which the first picture and Python get in each other's way: there one comes after the other. */
const FEW_CORES = 2;

/** Milliseconds that Python waits for the first picture, at most: a later one waits for the network. */
const PATIENCE = 1000;

/** The static site: the catalogue, Python in a worker, everything kept for when there is no network. @returns {import("./host.js").Host} */
export function site() {
  const { worker, runtime, root } = /** @type {Record<string, string>} */ (document.documentElement.dataset);
  const asked = new URLSearchParams(location.search);
  const addressed = asked.get("mesh") ?? "";
  const embedded = asked.has("embed");
  document.documentElement.toggleAttribute("data-embedded", embedded);
  const ahead = new Ahead(new URL(root, document.baseURI).href, addressed);
  const inTurn = addressed !== "" && navigator.hardwareConcurrency <= FEW_CORES;
  const transport = (/** @type {Promise<unknown> | null} */ turn) =>
    new WorkerTransport({
      worker: new URL(worker, document.baseURI),
      runtime: new URL(runtime, document.baseURI),
      turn,
    });
  const client = new CoreClient(transport(inTurn ? soon(ahead.shown, PATIENCE) : null));
  return {
    root,
    keeps: !embedded, // what was looked at before is no matter of the page around
    shares: true,
    steps: !embedded,
    embedded,
    directions: Number(asked.get("directions")) || undefined,
    addressed,
    beside: asked.get("with") === "" ? null : (asked.get("with") ?? ""),
    client,
    another: () => new CoreClient(transport(null)),
    ahead,
    sheet: fetchedSheet,
    offers: null,
  };
}
