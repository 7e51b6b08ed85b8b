import { MathUtils, Matrix4, OrthographicCamera, PerspectiveCamera, Quaternion, Vector3 } from "three";

/** Radius of a ball round the origin that holds all that is drawn: the mesh has diagonal 1. */
const SCENE_RADIUS = 0.52;

const EYE = new Vector3();
const MATRIX = new Matrix4();

/** @returns {import("../types.js").CameraStatus} */
export function defaultCamera() {
  return {
    target: [0, 0, 0],
    direction: [0, 0, -1],
    up: [0, 1, 0],
    distance: 1.5,
    projection: "perspective",
    field_of_view: 30,
  };
}

/**
 * Where the eye is: target, orientation as a quaternion (so that no direction is special), distance, projection.
 */
export class CameraRig {
  target = new Vector3();
  orientation = new Quaternion();
  distance = 1.5;
  fieldOfView = 30;
  /** @type {"perspective" | "orthographic"} */
  projection = "perspective";
  aspect = 1;

  #perspective = new PerspectiveCamera();
  #orthographic = new OrthographicCamera();

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
    return this.projection === "orthographic" || this.eye.length() > SCENE_RADIUS * 1.01;
  }

  /** @returns {import("../types.js").CameraStatus} */
  get status() {
    const direction = new Vector3(0, 0, -1).applyQuaternion(this.orientation);
    const up = new Vector3(0, 1, 0).applyQuaternion(this.orientation);
    return {
      target: this.target.toArray(),
      direction: direction.toArray(),
      up: up.toArray(),
      distance: this.distance,
      projection: this.projection,
      field_of_view: this.fieldOfView,
    };
  }

  /**
   * Takes what the status holds; a direction of length 0 is left out.
   *
   * @param {Partial<import("../types.js").CameraStatus>} status
   * @returns {boolean} whether anything changed
   */
  set(status) {
    const before = JSON.stringify(this.status);
    if (status.target) this.target.fromArray(status.target);
    if (status.distance && status.distance > 0) this.distance = status.distance;
    if (status.projection) this.projection = status.projection;
    if (status.field_of_view) this.fieldOfView = status.field_of_view;
    if (status.direction || status.up) {
      const present = this.status;
      this.#look(status.direction ?? present.direction, status.up ?? present.up);
    }
    return before !== JSON.stringify(this.status);
  }

  /**
   * @param {readonly number[]} direction
   * @param {readonly number[]} up
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

  /** Brings three's camera up to date; near and far enclose the scene, as tight as depth needs. */
  update() {
    const camera = this.camera;
    camera.position.copy(this.eye);
    camera.quaternion.copy(this.orientation);
    const depth = EYE.copy(this.target)
      .sub(camera.position)
      .normalize()
      .dot(MATRIX_ORIGIN.clone().sub(camera.position));
    const radius = SCENE_RADIUS;
    const far = Math.max(depth + radius, this.distance * 0.02);
    if (camera instanceof PerspectiveCamera) {
      camera.fov = this.fieldOfView;
      camera.aspect = this.aspect;
      camera.near = Math.max(depth - radius, Math.min(this.distance, far) * 0.004);
      camera.far = Math.max(far, camera.near * 1.1);
    } else {
      camera.top = this.halfHeight;
      camera.bottom = -camera.top;
      camera.right = camera.top * this.aspect;
      camera.left = -camera.right;
      camera.near = depth - radius;
      camera.far = depth + radius;
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld(true);
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
    return new Vector3(x * half * this.aspect, y * half, 0)
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

const MATRIX_ORIGIN = new Vector3();
