import { Box2, Vector2, Vector3 } from "three";
import { CameraRig } from "./camera_rig.js";
import { FILLED } from "./fit.js";

/** @typedef {{ width: number, height: number }} Size */

/** Most that a backdrop differs from its own corner, of 255: what compression leaves. */
const FAINT = 6;

/** Least part of a picture that a body takes: a plate may be seen edge on. */
const LEAST = 1e-6;

/**
 * What of a picture is not backdrop: the part of its width, and of its height, between the outermost such pixels.
 *
 * @param {Size & { data: ArrayLike<number> }} picture 4 numbers for each pixel, row by row; its corner is backdrop
 * @returns {Size} from 0 to 1; 1 where there is nothing but backdrop
 */
export function takenOf({ data, width, height }) {
  let [left, right, top, bottom] = [width, -1, height, -1];
  for (let y = 0, at = 0; y < height; y++)
    for (let x = 0; x < width; x++, at += 4) {
      const drawn =
        Math.abs(data[at] - data[0]) > FAINT ||
        Math.abs(data[at + 1] - data[1]) > FAINT ||
        Math.abs(data[at + 2] - data[2]) > FAINT;
      if (!drawn) continue;
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = y;
    }
  if (right < 0) return { width: 1, height: 1 };
  return { width: (right + 1 - left) / width, height: (bottom + 1 - top) / height };
}

/**
 * How large a picture that a fitted camera has taken is to lie in the middle of a canvas, so that the body in it stands where a
 * camera that is fitted to the canvas will draw it.
 *
 * A fitted body stands in the middle and fills a known part of the tighter side (`fitted`); what is drawn of it may stand out
 * a little. How much of the other side it fills is what the picture tells. Seen in perspective from nearer or further it
 * changes its shape by a few parts in a hundred; that is left out (`sizeUpon`).
 *
 * @param {Size} picture @param {Size} taken of it, by the body: from 0 to 1 @param {Size} canvas
 * @returns {Size} of the picture upon the canvas
 */
export function sizeBefore(picture, taken, canvas) {
  const [across, down] = [taken.width, taken.height].map((part) => Math.min(part, FILLED));
  const tight = Math.max(across, down);
  const scale = Math.min(
    (canvas.width / picture.width) * (tight / across),
    (canvas.height / picture.height) * (tight / down),
  );
  return { width: scale * picture.width, height: scale * picture.height };
}

/**
 * The same once the body itself is known: it has the very width and height there that a camera fitted to the canvas gives it.
 *
 * @param {Size} picture @param {ArrayLike<number>} body 3 coordinates for each of its points @param {Size} canvas
 * @param {import("../types.js").CameraStatus} camera that both are seen by
 * @returns {Size} of the picture upon the canvas
 */
export function sizeUpon(picture, body, canvas, camera) {
  const rig = new CameraRig({ ...camera, fit: true });
  rig.body = body;
  const [there, here] = [picture, canvas].map(({ width, height }) => spanOf(rig, width / height));
  return {
    width: (canvas.width * here.x) / there.x,
    height: (canvas.height * here.y) / there.y,
  };
}

/** How much of a picture of that shape the body takes, each way. @param {CameraRig} rig @param {number} aspect */
function spanOf(rig, aspect) {
  rig.aspect = aspect;
  rig.update();
  const { body, camera } = rig;
  const places = Array.from({ length: body.length / 3 }, (_, k) => {
    const { x, y } = new Vector3(body[3 * k], body[3 * k + 1], body[3 * k + 2]).project(camera);
    return new Vector2(x, y);
  });
  const { x, y } = new Box2().setFromPoints(places).getSize(new Vector2());
  return { x: Math.max(LEAST, x), y: Math.max(LEAST, y) };
}
