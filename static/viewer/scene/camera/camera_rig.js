import { MathUtils, Matrix4, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3 } from "three";
import { cornersOf } from "../../geometry/box.js";
import { fitted } from "./fit.js";

/** @typedef {import("../../geometry/box.js").Box} Box */

/** What is drawn while nothing is: a cube of diagonal 1. @type {Box} */
const UNIT = { low: [-0.29, -0.29, -0.29], high: [0.29, 0.29, 0.29] };

/** Part of the target's distance by which what is drawn may stand out of its box: lines are pulled to the eye by pixels. */
const RIM = 0.03;

/** Part of the target's distance that nothing nearer is seen from, and orthographic depth at the most. */
const NEAREST = 0.004;
const DEEPEST = 1000;

const MATRIX = new Matrix4();

/**
 * Where the eye is: target, orientation as a quaternion (so that no direction is special), distance, projection. While it
 * is fitted, target and distance follow from the mesh's frame and the picture's shape.
 */
export class CameraRig {
  /** Whether target and distance follow from frame and picture. */
  fit = true;
  /** What it is fitted to: points that stand for the mesh, 3 coordinates each. @type {ArrayLike<number>} */
  body = cornersOf(UNIT);
  /** How much larger than the body what is drawn of it may be. */
  #spread = 1;
  /** All that is drawn is within. @type {Box} */
  drawn = UNIT;
  target = new Vector3();
  orientation = new Quaternion();
  distance;
  fieldOfView;
  projection;
  aspect = 1;
  /** Part of the picture's width, at the right, that something covers: the middle is that of the rest. */
  covered = 0;

  /** The fit that was found last, and for what. @type {{ body: ArrayLike<number> | null, asked: unknown[], target: [number, number, number], distance: number }} */
  #fitted = { body: null, asked: [], target: [0, 0, 0], distance: 1 };
  #perspective = new PerspectiveCamera();
  #orthographic = new OrthographicCamera();

  /** @param {import("../types.js").CameraStatus} camera the first one */
  constructor(camera) {
    this.distance = camera.distance;
    this.fieldOfView = camera.field_of_view;
    this.projection = camera.projection;
    this.set(camera);
    this.#aim();
  }

  /** @returns {PerspectiveCamera | OrthographicCamera} the camera three draws with */
  get camera() {
    return this.projection === "orthographic" ? this.#orthographic : this.#perspective;
  }

  /** Half the height of what is seen at the target's distance. @returns {number} */
  get halfHeight() {
    return this.distance * Math.tan(MathUtils.degToRad(this.fieldOfView) / 2);
  }

  /** @returns {Vector3} */
  get eye() {
    return new Vector3(0, 0, this.distance).applyQuaternion(this.orientation).add(this.target);
  }

  /** Whether the eye stands outside of all that is drawn, so that nothing is cut open by the near plane. @returns {boolean} */
  get outside() {
    const { low, high } = this.drawn;
    const rim = this.#rim;
    return (
      this.projection === "orthographic" ||
      this.eye.toArray().some((place, axis) => place < low[axis] - rim || place > high[axis] + rim)
    );
  }

  /** @returns {import("../types.js").CameraStatus} */
  get status() {
    const direction = new Vector3(0, 0, -1).applyQuaternion(this.orientation);
    const up = new Vector3(0, 1, 0).applyQuaternion(this.orientation);
    return {
      fit: this.fit,
      target: this.target.toArray(),
      direction: direction.toArray(),
      up: up.toArray(),
      distance: this.distance,
      projection: this.projection,
      field_of_view: this.fieldOfView,
    };
  }

  get #rim() {
    return RIM * this.distance;
  }

  /** Lets target and distance be what they are at the moment. */
  release() {
    this.fit = false;
  }

  /** Where it would stand to see some points. @param {ArrayLike<number>} points @param {number} [filled] part of the picture that they fill */
  around(points, filled) {
    const { fieldOfView, projection } = this;
    const aspect = this.aspect * (1 - this.covered);
    const lens = { fieldOfView, aspect, projection, filled };
    const { target, distance } = fitted(points, this.orientation, lens);
    return { fit: false, target: target.toArray(), distance };
  }

  /** Stands where the fit asks for. */
  #aim() {
    if (!this.fit) return;
    const { body, aspect, covered, fieldOfView, projection, orientation } = this;
    const asked = [this.#spread, aspect, covered, fieldOfView, projection, ...orientation];
    if (this.#fitted.body !== body || asked.some((one, k) => one !== this.#fitted.asked[k]))
      this.#fitted = { body, asked, ...this.around(this.#spread === 1 ? body : scaled(body, this.#spread)) };
    this.target.fromArray(this.#fitted.target);
    this.distance = this.#fitted.distance;
  }

  /** Fits what is so many times as large as the body. @param {number} spread @returns {boolean} whether that moves it */
  reach(spread) {
    if (spread === this.#spread) return false;
    this.#spread = spread;
    this.#aim();
    return this.fit;
  }

  /**
   * Takes what the status holds; a direction of length 0 is left out.
   *
   * @param {Partial<import("../types.js").CameraStatus>} status
   * @returns {boolean} whether anything changed
   */
  set(status) {
    const before = JSON.stringify(this.status);
    if (status.fit !== undefined) this.fit = status.fit;
    if (status.target && !this.fit) this.target.fromArray(status.target);
    if (status.distance && status.distance > 0 && !this.fit) this.distance = status.distance;
    if (status.projection) this.projection = status.projection;
    if (status.field_of_view) this.fieldOfView = status.field_of_view;
    if (status.direction || status.up) {
      const present = this.status;
      this.#look(status.direction ?? present.direction, status.up ?? present.up);
    }
    this.#aim();
    return before !== JSON.stringify(this.status);
  }

  /**
   * @param {import("../types.js").Vector} direction
   * @param {import("../types.js").Vector} up
   */
  #look(direction, up) {
    const back = new Vector3().fromArray(direction).negate();
    if (back.lengthSq() === 0) return;
    back.normalize();
    const present = this.status;
    if (
      back.dot(new Vector3().fromArray(present.direction)) < -1 + 1e-12 &&
      new Vector3().fromArray(up).normalize().dot(new Vector3().fromArray(present.up)) > 1 - 1e-12
    )
      return; // its own status come back: no rounding may creep in
    const right = new Vector3().fromArray(up).cross(back);
    if (right.lengthSq() < 1e-12) right.set(back.y, back.z, back.x).cross(back);
    right.normalize();
    MATRIX.makeBasis(right, back.clone().cross(right), back);
    this.orientation.setFromRotationMatrix(MATRIX).normalize();
  }

  /** Brings three's camera up to date; near and far enclose what is drawn, as tight as depth needs. */
  update() {
    this.#aim();
    const camera = this.camera;
    camera.position.copy(this.eye);
    camera.quaternion.copy(this.orientation);
    const [least, most] = this.#depths();
    if (camera instanceof PerspectiveCamera) {
      const far = Math.max(most, this.distance * 0.02);
      camera.fov = this.fieldOfView;
      camera.aspect = this.aspect;
      camera.near = Math.max(least, Math.min(this.distance, far) * NEAREST);
      camera.far = Math.max(far, camera.near * 1.1);
    } else {
      camera.top = this.halfHeight;
      camera.bottom = -camera.top;
      camera.right = camera.top * this.aspect;
      camera.left = -camera.right;
      camera.near = Math.max(least, this.distance - DEEPEST);
      camera.far = Math.min(most, this.distance + DEEPEST);
    }
    camera.updateProjectionMatrix();
    if (this.covered) this.#shift(camera);
    camera.updateMatrixWorld(true);
  }

  /** Moves the picture's middle to that of what is not covered. @param {PerspectiveCamera | OrthographicCamera} camera */
  #shift(camera) {
    const { elements } = camera.projectionMatrix;
    if (camera instanceof PerspectiveCamera) elements[8] += this.covered;
    else elements[12] -= this.covered;
    camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  }

  /** Least and greatest depth before the eye of what is drawn. @returns {[number, number]} */
  #depths() {
    const { low, high } = this.drawn;
    const ahead = new Vector3(0, 0, -1).applyQuaternion(this.orientation).toArray();
    const eye = this.eye.toArray();
    const rim = this.#rim;
    let [least, most] = [-rim, rim];
    for (const axis of [0, 1, 2]) {
      const ends = [low[axis], high[axis]].map((end) => (end - eye[axis]) * ahead[axis]);
      least += Math.min(...ends);
      most += Math.max(...ends);
    }
    return [least, most];
  }

  /**
   * The point of the plane through the target, parallel to the screen, that stands under a place of the screen.
   *
   * @param {number} x from -1 (left) to 1
   * @param {number} y from -1 (bottom) to 1
   * @returns {Vector3}
   */
  pointAt(x, y) {
    const half = this.halfHeight;
    return new Vector3((x + this.covered) * half * this.aspect, y * half, 0)
      .applyQuaternion(this.orientation)
      .add(this.target);
  }

  /**
   * The ray under a place of the screen.
   *
   * @param {number} x from -1 (left) to 1
   * @param {number} y from -1 (bottom) to 1
   * @returns {{ origin: Vector3, direction: Vector3 }}
   */
  rayAt(x, y) {
    const through = this.pointAt(x, y);
    if (this.projection === "perspective") {
      const origin = this.eye;
      return { origin, direction: through.sub(origin).normalize() };
    }
    const direction = new Vector3(0, 0, -1).applyQuaternion(this.orientation);
    return { origin: through.addScaledVector(direction, -2), direction };
  }
}

/** @param {ArrayLike<number>} points @param {number} factor */
function scaled(points, factor) {
  return Float32Array.from(points, (part) => factor * part);
}
