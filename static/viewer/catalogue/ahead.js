import { download } from "../../offline/download.js";
import { Catalogue } from "./catalogue.js";

/** Milliseconds that the page waits for the catalogue before it is built: where it is at hand, it takes less. */
const PATIENCE = 60;

/**
 * What the first picture of a catalogue mesh needs, asked for before the page is built: it comes while that is done.
 *
 *     const ahead = new Ahead(root, "shapes/cube");
 *     await ahead.asked;
 *     // build the page
 *     const bytes = await ahead.preview(entry.mesh.preview);
 */
export class Ahead {
  /** The catalogue's index. @type {Promise<Catalogue>} */
  catalogue;
  /** When the preview is asked for, or it is time to go on without. @type {Promise<unknown>} */
  asked;
  /** @type {{ address: string, bytes: Promise<ArrayBuffer> } | null} */
  #early = null;

  /** @param {string} root whole address of the site's root @param {string} mesh "source/mesh", or anything else */
  constructor(root, mesh) {
    this.catalogue = Catalogue.fetch(root);
    const asking = this.catalogue.then(
      (catalogue) => this.#ask(catalogue, mesh),
      () => {}, // said by whoever needs it
    );
    this.asked = mesh
      ? Promise.race([asking, new Promise((resolve) => setTimeout(resolve, PATIENCE))])
      : Promise.resolve();
  }

  /** @param {Catalogue} catalogue @param {string} mesh */
  #ask(catalogue, mesh) {
    const [source, slug] = mesh.split("/");
    const address = catalogue.entry(source, slug)?.mesh.preview;
    if (!address) return;
    const bytes = download(address, () => {});
    bytes.catch(() => {}); // said by whoever needs it
    this.#early = { address, bytes };
  }

  /** A mesh's preview: the one that was asked for, once, or another. @param {string} address @returns {Promise<ArrayBuffer>} */
  preview(address) {
    const early = this.#early;
    this.#early = null;
    return early?.address === address ? early.bytes : download(address, () => {});
  }
}
