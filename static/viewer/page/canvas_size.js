import { followPixelRatio } from "../widgets/pixel_ratio.js";

/**
 * A scene is drawn as large as its canvas is.
 *
 * @param {import("../scene/scene_like.js").SceneLike} scene @param {HTMLCanvasElement} canvas
 * @param {AbortSignal} [signal] that ends it
 */
export function followSize(scene, canvas, signal) {
  const resize = () => {
    const { clientWidth, clientHeight } = canvas;
    if (clientWidth && clientHeight && !signal?.aborted)
      scene.resize(clientWidth, clientHeight, devicePixelRatio);
  };
  const observer = new ResizeObserver(resize);
  observer.observe(canvas);
  signal?.addEventListener("abort", () => observer.disconnect());
  window.addEventListener("resize", resize, { signal });
  followPixelRatio(resize);
}
