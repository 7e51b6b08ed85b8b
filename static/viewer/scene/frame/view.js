/**
 * A camera rig before a canvas: what of the model a pixel shows, and which pixels belong to a CSS pixel.
 */
export class View {
  rig;
  /** CSS pixels of the canvas. */
  size = { width: 1, height: 1 };
  #painter;
  #pixelRatio = 1;

  /** @param {import("../camera/camera_rig.js").CameraRig} rig @param {import("./painter.js").Painter} painter */
  constructor(rig, painter) {
    this.rig = rig;
    this.#painter = painter;
  }

  /** @param {number} width CSS pixels @param {number} height @param {number} pixelRatio device pixels to one of them */
  resize(width, height, pixelRatio) {
    this.size = { width: Math.max(1, width), height: Math.max(1, height) };
    this.#pixelRatio = pixelRatio;
    const [across, down] = [this.size.width, this.size.height].map((side) =>
      Math.max(1, Math.round(side * pixelRatio)),
    );
    this.#painter.resize(across, down);
  }

  /**
   * Brings the camera up to date.
   *
   * @param {number} [aspect] of the picture; the canvas's
   * @param {boolean} [bare] whether nothing covers it, as of a picture that is saved
   */
  aim(aspect = this.size.width / this.size.height, bare = false) {
    const { covered } = this.rig;
    this.rig.aspect = aspect;
    if (bare) this.rig.covered = 0;
    this.rig.update();
    this.rig.covered = covered;
  }

  /** Half the height of what a bare picture of a shape sees. @param {number} aspect width over height @returns {number} */
  halfHeight(aspect) {
    this.aim(aspect, true);
    const { halfHeight } = this.rig;
    this.aim();
    return halfHeight;
  }

  /** What covers most of the canvas does not move the middle. @param {number} pixels at its right @returns {boolean} whether it moved */
  cover(pixels) {
    const part = pixels / this.size.width;
    const covered = part < 0.7 ? part : 0;
    const moved = covered !== this.rig.covered;
    this.rig.covered = covered;
    return moved;
  }

  /** Pixels to a CSS pixel in a picture of the canvas of that width. @param {number} width */
  ratioOf(width) {
    return (this.#pixelRatio * width) / this.#painter.pixels(false).width;
  }

  /**
   * Side of a pixel at the target, in perspective at distance 1 from the eye; in diagonals.
   *
   * @param {number} height pixels of the whole picture
   * @returns {number}
   */
  pixel(height) {
    const { halfHeight, distance, projection } = this.rig;
    return (2 * halfHeight) / height / (projection === "perspective" ? distance : 1);
  }
}
