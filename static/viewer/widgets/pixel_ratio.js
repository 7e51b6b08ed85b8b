/** Call when the pixel ratio changes, which alone changes no size: as when a window goes to another screen. @param {() => void} changed */
export function followPixelRatio(changed) {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
    "change",
    () => {
      changed();
      followPixelRatio(changed);
    },
    { once: true },
  );
}
