import { takePicture } from "./screenshot.js";

/**
 * Draws one picture: on the canvas, for a file, or a trial that nobody sees.
 */
export class Pictures {
  #view;
  #painter;
  #layers;
  #lighting;

  /**
   * @param {import("./view.js").View} view
   * @param {import("./painter.js").Painter} painter
   * @param {import("../layers/layers.js").Layers} layers
   * @param {import("../../lighting/lighting.js").LightingLike} lighting
   */
  constructor(view, painter, layers, lighting) {
    this.#view = view;
    this.#painter = painter;
    this.#layers = layers;
    this.#lighting = lighting;
  }

  /**
   * Draws the canvas anew.
   *
   * @param {boolean} draft @param {boolean} many whether more drafts will follow
   * @param {boolean} bare the surface alone: the first picture waits for no program but that one
   */
  show(draft, many, bare) {
    const { rig } = this.#view;
    const { width, height } = this.#painter.pixels(draft);
    this.#view.aim();
    this.#prepare({ width, height, whole: height, pixelRatio: this.#view.ratioOf(width), draft });
    this.#painter.show(rig.camera, draft, { many, bare });
    if (bare) return;
    const canvas = this.#painter.canvas.width;
    this.#painter.corner((renderer) =>
      this.#layers.gizmo.draw(renderer, rig.orientation, canvas, this.#view.ratioOf(canvas)),
    );
  }

  /**
   * The drawing as a PNG of any size, without gizmo, plane and highlight.
   *
   * @param {{ width: number, height: number, transparent: boolean, drawn: () => void }} options drawn: told after each tile
   * @returns {Promise<Blob>}
   */
  take({ width, height, transparent, drawn }) {
    const pixelRatio = Math.max(1, height / this.#view.size.height);
    return takePicture(this.#painter, {
      width,
      height,
      transparent,
      draw: ({ target, tile, scale, background }) => {
        this.#view.aim(width / height, true);
        const { camera } = this.#view.rig;
        camera.setViewOffset(width * scale, height * scale, tile.x, tile.y, tile.width, tile.height);
        this.#prepare({
          width: tile.width,
          height: tile.height,
          whole: height * scale,
          pixelRatio: pixelRatio * scale,
          draft: false,
        });
        this.#painter.paint(camera, target, { background, overlay: false });
        camera.clearViewOffset();
        drawn();
      },
    });
  }

  /**
   * @param {{ width: number, height: number, whole: number, pixelRatio: number, draft: boolean }} target its pixels, and the
   *   height of the whole picture, of which it may be a tile
   */
  #prepare({ width, height, whole, pixelRatio, draft }) {
    const { rig } = this.#view;
    const pixel = this.#view.pixel(whole);
    this.#layers.view({ width, height, pixelRatio, pixel, draft, outside: rig.outside });
    this.#lighting.prepare(rig.camera, { width, height, perUnit: 1 / pixel, draft });
  }
}
