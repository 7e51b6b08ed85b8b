import { OrthographicCamera, Quaternion, Scene, Vector3 } from "three";
import { LinesLayer } from "../layers/lines_layer.js";

/** CSS pixels of the corner it stands in. */
export const GIZMO_SIZE = 84;

const AXES = ["#c8372d", "#2f7d4f", "#2f5fc0"];
/** Strokes of the letters in a box from -1 to 1. */
const LETTERS = [
  [-1, -1, 1, 1, -1, 1, 1, -1],
  [-1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, -1],
  [-1, 1, 1, 1, 1, 1, -1, -1, -1, -1, 1, -1],
];
/** From the middle of its corner to the rim: an axis is 1 long, its letter ends at 1.4, and lines have a width. */
const REACH = 1.6;
const POINT = new Vector3();

/**
 * The directions of x, y and z in a corner of the drawing.
 */
export class Gizmo {
  scene = new Scene();
  #camera = new OrthographicCamera(-REACH, REACH, REACH, -REACH, -2, 2);
  #lines = new LinesLayer(AXES.map((colour) => ({ colour, ink: 1 })));

  /** Of the eye, when the strokes were made. */
  #orientation = new Quaternion();

  constructor() {
    this.#lines.width = 1.75;
    this.scene.add(this.#lines.group);
    this.scene.matrixWorldAutoUpdate = false;
    this.#lines.group.visible = true;
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {Quaternion} orientation of the eye
   * @param {number} width device pixels of the drawing
   * @param {number} pixelRatio
   */
  draw(renderer, orientation, width, pixelRatio) {
    const side = Math.round(GIZMO_SIZE * pixelRatio);
    if (!orientation.equals(this.#orientation) || this.#lines.count === 0) {
      const { ends, styles } = strokes(orientation);
      this.#lines.set(ends, styles);
      this.#orientation.copy(orientation);
    }
    this.#lines.view({ width: side, height: side, pixelRatio, pixel: 0 });
    renderer.setViewport(width - side, 0, side, side);
    renderer.clearDepth();
    renderer.render(this.scene, this.#camera);
  }

  dispose() {
    this.#lines.dispose();
  }
}

/**
 * Lines of the three axes and their letters in the view's frame, those farther from the eye first.
 *
 * @param {Quaternion} orientation
 */
function strokes(orientation) {
  const back = orientation.clone().invert();
  const axes = [0, 1, 2].map((axis) => {
    const tip = POINT.set(+(axis === 0), +(axis === 1), +(axis === 2))
      .applyQuaternion(back)
      .toArray();
    return { axis, tip };
  });
  axes.sort((a, b) => a.tip[2] - b.tip[2]);
  /** @type {number[]} */
  const ends = [];
  /** @type {number[]} */
  const styles = [];
  for (const { axis, tip } of axes) {
    ends.push(0, 0, 0, ...tip);
    styles.push(axis);
    const [x, y] = [1.26 * tip[0], 1.26 * tip[1]];
    const letter = LETTERS[axis];
    for (let k = 0; k < letter.length; k += 4) {
      const [a, b, c, d] = letter
        .slice(k, k + 4)
        .map((value, i) => (i % 2 ? y + 0.12 * value : x + 0.09 * value));
      ends.push(a, b, tip[2], c, d, tip[2]);
      styles.push(axis);
    }
  }
  return { ends: new Float32Array(ends), styles: Uint8Array.from(styles) };
}
