import { followPixelRatio } from "../widgets/pixel_ratio.js";

/**
 * A scene is drawn as large as its canvas is, and how large that is, is known.
 *
 * @param {import("../scene/scene_like.js").SceneLike} scene @param {HTMLCanvasElement} canvas
 * @param {import("../state/facts.js").Facts} facts
 * @param {AbortSignal} [signal] that ends it
 */
export function followSize(scene, canvas, facts, signal) {
  const resize = () => {
    const { clientWidth, clientHeight } = canvas;
    if (!clientWidth || !clientHeight || signal?.aborted) return;
    scene.resize(clientWidth, clientHeight, devicePixelRatio);
    facts.set({ canvas: { width: clientWidth, height: clientHeight } });
  };
  const observer = new ResizeObserver(resize);
  observer.observe(canvas);
  signal?.addEventListener("abort", () => observer.disconnect());
  window.addEventListener("resize", resize, { signal });
  followPixelRatio(resize, signal);
}
