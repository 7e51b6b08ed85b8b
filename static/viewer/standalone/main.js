import { fromPlanes } from "../exchange/planes.js";
import { fromBase64 } from "../files/base64.js";
import { gunzipped } from "../files/gzip.js";
import { unpack } from "../files/packing.js";
import { BakedLight } from "../lighting/baked_light.js";
import { Scene } from "../scene/scene.js";
import { controls } from "./controls.js";
import { Shown } from "./shown.js";

/**
 * A mesh in a page of one file: no core, no network; what was saved is drawn as it was, and can be turned.
 *
 * @typedef {import("../exchange/sheet.js").Sheet} Sheet
 */

const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));

try {
  await start();
} catch (error) {
  const reason = error instanceof Error ? error.message : String(error);
  const note = /** @type {HTMLElement} */ (document.getElementById("note"));
  note.textContent = `The mesh can't be turned here, this is its picture: ${reason}`;
  note.hidden = false;
  canvas.hidden = true;
}

async function start() {
  const packed = document.getElementById("sheet")?.textContent ?? "";
  const sheet = /** @type {Sheet} */ (
    /** @type {unknown} */ (fromPlanes(unpack(await gunzipped(fromBase64(packed.trim())))))
  );
  /** @type {BakedLight | null} */
  let light = null;
  const scene = new Scene(canvas, sheet.status.camera, (_, layer) => (light = new BakedLight(layer)));
  const shown = new Shown(sheet, scene, /** @type {BakedLight} */ (/** @type {unknown} */ (light)));
  controls(sheet, shown, canvas);
  new ResizeObserver(() => {
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth && clientHeight) scene.resize(clientWidth, clientHeight, devicePixelRatio);
  }).observe(canvas);
  await scene.settled();
  document.getElementById("poster")?.remove();
  document.documentElement.dataset.ready = "";
}
