import { Catalogue } from "./catalogue.js";

/**
 * What the first picture of a catalogue mesh needs, asked for before the page is built: it comes while that is done.
 *
 *     const ahead = new Ahead(root, "shapes/cube");
 *     // build the page
 *     const bytes = await ahead.bytes(entry.mesh.preview);
 */
export class Ahead {
  /** The catalogue's index. @type {Promise<Catalogue>} */
  catalogue;
  /** When the first picture is drawn, or none is to come before the core has read the mesh. @type {Promise<void>} */
  shown;
  /** Says so. @type {() => void} */
  tellShown = () => {};
  /** @type {{ address: string, bytes: Promise<ArrayBuffer> } | null} */
  #early = null;

  /** @param {string} root whole address of the site's root @param {string} mesh "source/mesh", or anything else */
  constructor(root, mesh) {
    this.catalogue = Catalogue.fetch(root);
    this.shown = new Promise((resolve) => (this.tellShown = resolve));
    void this.#ask(mesh).catch(() => {}); // said by whoever needs it
  }

  /** @param {string} mesh */
  async #ask(mesh) {
    const [source, slug] = mesh.split("/");
    const { preview, picture } = (await this.catalogue).entry(source, slug)?.mesh ?? {};
    const address = preview ?? picture;
    if (!address) return;
    const bytes = whole(address);
    bytes.catch(() => {}); // said by whoever needs it
    this.#early = { address, bytes };
  }

  /** A mesh's preview, or its portrait: what was asked for, once, or another. @param {string} address @returns {Promise<ArrayBuffer>} */
  bytes(address) {
    const early = this.#early;
    this.#early = null;
    return early?.address === address ? early.bytes : whole(address);
  }
}

/** Both are small: they come in one piece. @param {string} address @returns {Promise<ArrayBuffer>} */
async function whole(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} could not be fetched: ${answer.status}`);
  return answer.arrayBuffer();
}
