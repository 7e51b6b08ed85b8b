import { Group, Vector3 } from "three";
import { boxOf } from "../../geometry/box.js";
import { FlatLayer } from "./flat_layer.js";
import { LinesLayer } from "./lines_layer.js";
import { planeExtent } from "./plane_extent.js";

/**
 * The slicing plane as a translucent square with a rim.
 */
export class PlaneLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #square = new FlatLayer("#56bbbb", 0.1);
  #rim = new LinesLayer([{ colour: "#0b6e74", ink: 0.7 }]);

  constructor() {
    this.group.add(this.#square.mesh, this.#rim.group);
    this.group.visible = false;
  }

  /**
   * @param {import("../types.js").Plane | null} plane
   * @param {import("../../geometry/records.js").MeshFrame} mesh that it runs through, from one end to the other
   */
  set(plane, mesh) {
    this.group.visible = plane !== null;
    this.box = null;
    if (!plane) return;
    const [low, high] = plane.extent ?? planeExtent(mesh, plane.normal);
    const n = new Vector3().fromArray(plane.normal).normalize();
    const least = Math.min(Math.abs(n.x), Math.abs(n.y), Math.abs(n.z));
    const aside = new Vector3(
      +(Math.abs(n.x) === least),
      +(Math.abs(n.y) === least),
      +(Math.abs(n.z) === least),
    );
    const u = aside.cross(n).normalize().multiplyScalar(0.5);
    const v = new Vector3().crossVectors(n, u);
    const middle = n.clone().multiplyScalar(low + plane.offset * (high - low));
    const [a, b, c, d] = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([s, t]) => middle.clone().addScaledVector(u, s).addScaledVector(v, t).toArray());
    this.#square.set(new Float32Array([a, b, c, a, c, d].flat()));
    this.box = boxOf([a, b, c, d].flat());
    this.#rim.set(new Float32Array([a, b, b, c, c, d, d, a].flat()), null);
    this.#rim.group.visible = true;
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    this.#rim.view(view);
  }

  dispose() {
    this.#square.dispose();
    this.#rim.dispose();
  }
}
