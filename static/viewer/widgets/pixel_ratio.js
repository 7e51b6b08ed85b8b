/**
 * Call when the pixel ratio changes, which alone changes no size: as when a window goes to another screen.
 *
 * @param {() => void} changed
 * @param {AbortSignal} [signal] that ends it
 */
export function followPixelRatio(changed, signal) {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
    "change",
    () => {
      changed();
      followPixelRatio(changed, signal);
    },
    { once: true, signal },
  );
}
