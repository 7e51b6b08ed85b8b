// The page that the scene's tests drive: a scene on a canvas, and typed arrays from base64.
import { Lighting } from "../../../static/viewer/lighting/lighting.js";
import { Scene } from "../../../static/viewer/scene/scene.js";

const TYPES = { f32: Float32Array, i16: Int16Array, u32: Uint32Array, u8: Uint8Array };

/** @typedef {{ base64: string, type: keyof typeof TYPES }} Array64 */

/** @param {unknown} value @returns {unknown} */
function unpack(value) {
  if (Array.isArray(value) || value === null || typeof value !== "object") return value;
  if ("base64" in value) {
    const { base64, type } = /** @type {Array64} */ (value);
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    return new TYPES[type](bytes.buffer);
  }
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
}

/** @type {Scene | undefined} */
let scene;

Object.assign(window, {
  unpack,
  /**
   * @param {number} width CSS pixels
   * @param {number} height
   * @param {number} pixelRatio
   * @param {import("../../../static/viewer/scene/types.js").CameraStatus} camera
   * @param {number} [directions] from which light is gathered
   */
  start: (width, height, pixelRatio, camera, directions) => {
    scene?.dispose();
    document.querySelector("canvas")?.remove();
    const canvas = document.createElement("canvas");
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    document.body.append(canvas);
    scene = new Scene(canvas, camera, (renderer, layer) => new Lighting(renderer, layer, directions));
    scene.resize(width, height, pixelRatio);
    Object.assign(window, { scene });
  },
  next: (frames = 1) =>
    new Promise((done) => {
      const turn = (/** @type {number} */ left) =>
        left === 0 ? done(undefined) : requestAnimationFrame(() => turn(left - 1));
      turn(frames);
    }),
});
