// The page that the scene's tests drive: a scene on a canvas, and typed arrays from base64.
import { Scene } from "../../../static/viewer/scene/scene.js";

const TYPES = { f32: Float32Array, i16: Int16Array, u32: Uint32Array, u8: Uint8Array };

/** @param {any} value */
function unpack(value) {
  if (Array.isArray(value) || value === null || typeof value !== "object") return value;
  if (typeof value.base64 === "string") {
    const bytes = Uint8Array.from(atob(value.base64), (c) => c.charCodeAt(0));
    return new TYPES[value.type](bytes.buffer);
  }
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
}

const page = /** @type {any} */ (window);
page.unpack = unpack;
page.errors = [];
window.addEventListener("error", (event) => page.errors.push(event.message));
page.start = (width, height, pixelRatio, camera) => {
  page.scene?.dispose();
  document.querySelector("canvas")?.remove();
  const canvas = document.createElement("canvas");
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  document.body.append(canvas);
  page.scene = new Scene(canvas, camera);
  page.scene.resize(width, height, pixelRatio);
};
page.next = (frames = 1) =>
  new Promise((done) => {
    const turn = (left) => (left === 0 ? done(undefined) : requestAnimationFrame(() => turn(left - 1)));
    turn(frames);
  });
