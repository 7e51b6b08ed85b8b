import assert from "node:assert/strict";
import { test } from "node:test";
import { Box2, Vector2, Vector3 } from "three";

import { cornersOf } from "../../../../static/viewer/geometry/box.js";
import { CameraRig } from "../../../../static/viewer/scene/camera/camera_rig.js";
import { sizeBefore, sizeUpon, takenOf } from "../../../../static/viewer/scene/camera/portrait.js";
import { FRONT } from "./front.js";

/** @typedef {{ width: number, height: number }} Size */

const PICTURE = { width: 480, height: 320 };
const CANVASES = [
  { width: 960, height: 724 },
  { width: 360, height: 340 },
  { width: 1600, height: 900 },
  { width: 300, height: 900 },
  { width: 480, height: 320 },
];
const CAMERA = { ...FRONT, fit: true, direction: [-0.5, 0.8, -0.4], up: [0, 0, 1] };

/** @type {Record<string, ReturnType<typeof cornersOf>>} */
const BODIES = {
  cube: cornersOf({ low: [-0.29, -0.29, -0.29], high: [0.29, 0.29, 0.29] }),
  plate: cornersOf({ low: [-0.35, -0.35, -0.01], high: [0.35, 0.35, 0.01] }),
  tower: cornersOf({ low: [-0.1, -0.1, -0.48], high: [0.1, 0.1, 0.48] }),
  bar: cornersOf({ low: [-0.48, -0.1, -0.1], high: [0.48, 0.1, 0.1] }),
};

/** What a fitted camera makes a body take of a picture. @param {ArrayLike<number>} body @param {Size} picture @param {object} camera @returns {Size} from 0 to 1 */
function takenBy(body, { width, height }, camera) {
  const rig = new CameraRig(/** @type {any} */ (camera));
  rig.body = body;
  rig.aspect = width / height;
  rig.update();
  const box = new Box2();
  for (let k = 0; k < body.length; k += 3) {
    const { x, y } = new Vector3(body[k], body[k + 1], body[k + 2]).project(rig.camera);
    box.expandByPoint(new Vector2(x, y));
  }
  const size = box.getSize(new Vector2());
  return { width: size.x / 2, height: size.y / 2 };
}

/** What part of itself the body is off by, each way, when the picture lies that large on the canvas. @param {Size} size @param {Size} there @param {Size} here @param {Size} canvas */
function off(size, there, here, canvas) {
  return /** @type {const} */ (["width", "height"]).map(
    (side) => (size[side] * there[side]) / (canvas[side] * here[side]) - 1,
  );
}

for (const [name, body] of Object.entries(BODIES))
  for (const projection of ["orthographic", "perspective"])
    test(`C8: the portrait of a ${name} lies where the mesh will, ${projection}`, () => {
      const camera = { ...CAMERA, projection };
      const there = takenBy(body, PICTURE, camera);
      for (const canvas of CANVASES) {
        const here = takenBy(body, canvas, camera);
        const before = off(sizeBefore(PICTURE, there, canvas), there, here, canvas);
        const bent = projection === "perspective" ? 0.05 : 1e-6; // it changes its shape with the distance
        assert.ok(Math.max(...before.map(Math.abs)) < bent, `${JSON.stringify(canvas)}: off by ${before}`);
        assert.ok(
          Math.min(...before.map(Math.abs)) < 1e-3,
          "the tighter side is right whatever the distance",
        );
        const upon = sizeUpon(PICTURE, body, canvas, /** @type {any} */ (camera));
        const after = off(upon, there, here, canvas);
        assert.ok(Math.max(...after.map(Math.abs)) < 1e-6, `once the mesh is known, off by ${after}`);
      }
    });

test("C8: a portrait keeps its shape while the mesh is not known", () => {
  for (const canvas of CANVASES) {
    const { width, height } = sizeBefore(PICTURE, { width: 0.7, height: 0.95 }, canvas);
    assert.ok(Math.abs(width / height - 1.5) < 1e-9);
  }
});

test("C8: lines that stand out of the body make it no smaller", () => {
  const canvas = { width: 900, height: 600 };
  assert.deepEqual(sizeBefore(PICTURE, { width: 0.95, height: 0.6 }, canvas), canvas);
  assert.deepEqual(sizeBefore(PICTURE, { width: 0.98, height: 0.6 }, canvas), canvas);
});

/** @param {number} width @param {number} height @param {(x: number, y: number) => number} grey */
function picture(width, height, grey) {
  const data = new Uint8ClampedArray(4 * width * height);
  for (let y = 0, at = 0; y < height; y++)
    for (let x = 0; x < width; x++, at += 4) data.set([grey(x, y), 250, 250, 255], at);
  return { data, width, height };
}

test("C8: what is not backdrop is found, faint as it may be, and what compression leaves is none", () => {
  const silhouette = picture(20, 10, (x, y) => (x >= 4 && x < 14 && y >= 2 && y < 9 ? 240 : 250));
  assert.deepEqual(takenOf(silhouette), { width: 0.5, height: 0.7 });
  const noise = picture(20, 10, (x, y) => (x === 7 && y === 4 ? 10 : 250 + ((x + y) % 3)));
  assert.deepEqual(takenOf(noise), { width: 0.05, height: 0.1 });
});

test("C8: a picture of nothing takes all", () => {
  assert.deepEqual(takenOf(picture(6, 4, () => 250)), { width: 1, height: 1 });
});
