/**
 * The box that a mesh's drawing coordinates are made of, in these: its middle is the origin, its diagonal 1.
 *
 * @param {import("../geometry/records.js").MeshFrame} mesh
 * @returns {import("../geometry/box.js").Box} a cube where nothing is known
 */
export function frameOf({ frame, diagonal }) {
  const half = (/** @type {number} */ axis) =>
    frame && diagonal ? (frame[1][axis] / 2 - frame[0][axis] / 2) / diagonal : 0.5 / Math.sqrt(3);
  const [x, y, z] = [half(0), half(1), half(2)];
  return { low: [-x, -y, -z], high: [x, y, z] };
}
