import { download } from "../../offline/download.js";
import { sha256 } from "../../offline/hash.js";
import { isRecent, Shelf } from "../../offline/shelf.js";
import { nameIn } from "./address.js";

/** @typedef {import("../state/origin.js").Origin} Origin @typedef {{ name: string, sha256: string, size: number }} Known */

/** Milliseconds without a byte after which a mesh that is kept is taken from there. */
const PATIENCE = 4000;

/**
 * Fetches meshes by their address, and keeps them for when there is no network. One whose content is known by its SHA-256 comes
 * from there at once; any other is fetched anew where there is a network.
 */
export class Fetching {
  #app;
  #shelf;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
    this.#shelf = new Shelf(new URL(app.host.root, document.baseURI));
  }

  /**
   * @param {string} address a whole one
   * @param {{ sha256?: string | null, bytes?: number | null }} [file] what is known of it
   * @returns {Origin}
   */
  from(address, { sha256, bytes } = {}) {
    const name = nameIn(address);
    const known = { name, sha256: sha256 ?? "", size: bytes ?? 0 };
    return { name, address, bytes: (report) => this.#bytes(address, known, report) };
  }

  /** @param {string} address @param {Known} known @param {import("../state/origin.js").Report} report */
  async #bytes(address, known, report) {
    const found = await this.#shelf.find(address);
    if (found && known.sha256 && found.row.sha256 === known.sha256) {
      const bytes = await found.response.arrayBuffer();
      if (!isRecent(found.row)) void this.#keep(address, bytes, known);
      return bytes;
    }
    try {
      const bytes = await download(address, report, {
        size: known.size,
        ...(found ? { patience: PATIENCE } : {}),
      });
      if (address.startsWith("http")) void this.#keep(address, bytes, known);
      return bytes;
    } catch (error) {
      if (!found) throw error;
      const date = found.row.date.toLocaleDateString("en-GB", { dateStyle: "long" });
      const reason = error instanceof Error ? error.message : String(error);
      this.#app.messages.say("warning", `${known.name} is as it was kept on ${date}: ${reason}`, {
        topic: "kept-mesh",
      });
      return found.response.arrayBuffer();
    }
  }

  /**
   * Beside the opening: the bytes are copied at once, and may be handed over then. What the catalogue says of the content is
   * believed when it has been seen to hold.
   *
   * @param {string} address @param {ArrayBuffer} bytes @param {Known} known
   */
  async #keep(address, bytes, { name, sha256: said }) {
    const file = new Blob([bytes]);
    try {
      const sum = said && (await sha256(await file.arrayBuffer()));
      await this.#shelf.put(address, file, { name, sha256: sum });
    } catch {
      const text = `The browser's storage is full: ${name} is not kept for when there is no network`;
      this.#app.messages.say("warning", text, { topic: "shelf" });
    }
  }
}
