import { sizeUpon, takenOf } from "../scene/camera/portrait.js";
import { inOneLine } from "../state/entry.js";
import { portraitView } from "../state/opening_view.js";

/** @typedef {import("../state/origin.js").Origin} Origin */

/**
 * The portrait of a mesh of the catalogue stands in for it while its file is fetched: in the mesh's place where nothing is open
 * and the mesh will open under the portrait's view; else aside, since an open mesh stays on the screen until the new one is
 * there.
 */
export class Portraits {
  #app;
  #turn = 0;
  /** Whether the portrait that is shown, or on its way, is aside of a mesh that is open. */
  #aside = false;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
  }

  /** A mesh is asked for. @param {Origin} origin @returns {Promise<void>} when its portrait stands, or there is to be none */
  async begin({ entry, status, layers, renewed }) {
    this.#end();
    const { facts, store, ahead } = this.#app;
    const { picture, preview, name } = entry?.mesh ?? {};
    if (!entry || !picture || preview || renewed) return;
    const aside = facts.get("summary") !== null;
    const turn = this.#turn;
    const wanted = () =>
      turn === this.#turn && (aside || (facts.get("summary") === null && store.touched.size === 0));
    if (!wanted() || (!aside && (status || layers))) return; // it will open under another view
    this.#aside = aside;
    try {
      const image = await imageOf(await ahead.bytes(picture));
      image.alt = `${name}, a picture. ${inOneLine(entry.source, true)}`;
      const portrait = { entry, image, taken: takenOf(pixelsOf(image)), size: null, aside };
      if (!wanted()) return;
      facts.set({ portrait });
      if (!aside) this.#adopt(entry.mesh.view);
    } catch {
      // the mesh itself is on its way
    }
  }

  /** The panel tells of what is seen: what is changed before the mesh is there goes on from that. @param {import("../state/status.js").PartialStatus} [view] */
  #adopt(view) {
    const { store } = this.#app;
    const { version: _, mesh: __, ...settings } = portraitView(store.defaults, view);
    store.set(settings, { undo: false });
  }

  /** The mesh's own picture is drawn; it is whole when the GPU has its programs. */
  async seen() {
    const turn = this.#turn;
    await this.#app.scene.prepare();
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    if (turn !== this.#turn) return;
    this.#moveOverMesh();
    this.#end();
  }

  /** Going, it moves by the few pixels that were not to be known before. */
  #moveOverMesh() {
    const { facts, store } = this.#app;
    const portrait = facts.get("portrait");
    const outline = facts.get("summary")?.outline;
    const canvas = facts.get("canvas");
    const { camera } = store.status;
    if (!portrait || portrait.aside || !outline?.length || !canvas || !camera.fit) return;
    const { naturalWidth: width, naturalHeight: height } = portrait.image;
    const size = sizeUpon({ width, height }, outline, canvas, camera);
    facts.set({ portrait: { ...portrait, size } });
  }

  /** The mesh can't be had. Where nothing else is open, its portrait is better than nothing. */
  failed() {
    if (this.#aside) this.#end();
  }

  #end() {
    this.#turn++;
    this.#aside = false;
    this.#app.facts.set({ portrait: null });
  }
}

/** @param {ArrayBuffer} bytes of a picture @returns {Promise<HTMLImageElement>} that can be shown at once */
async function imageOf(bytes) {
  const address = URL.createObjectURL(new Blob([bytes]));
  const image = Object.assign(new Image(), { src: address, draggable: false });
  await image.decode().finally(() => URL.revokeObjectURL(address));
  return image;
}

/** @param {HTMLImageElement} image */
function pixelsOf(image) {
  const { naturalWidth: width, naturalHeight: height } = image;
  const canvas = new OffscreenCanvas(width, height);
  const options = { willReadFrequently: true };
  const pen = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d", options));
  pen.drawImage(image, 0, 0);
  return pen.getImageData(0, 0, width, height);
}
