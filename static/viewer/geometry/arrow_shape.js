/**
 * An arrow as a body turned round its axis: rings from its tail to its tip, each of two numbers that say where it stands and how
 * broad it is, to be filled in by whoever draws it, and of the two parts of its normal, away from the axis and along it.
 */

/** Where a ring stands: at the tail, at the neck (where the head begins), at the tip. How broad it is: not at all, as the shaft, as the head. */
export const STANDS = { tail: 0, neck: 1, tip: 2 };
export const BREADTHS = { none: 0, shaft: 1, head: 2 };

/** Slant of the head's normal: that of a head about three times as long as it is broad at one side. */
const AWAY = 0.95;
const ALONG = 0.31;

/** Two rings for each part of the body: end of the shaft, shaft, back of the head, head. */
const RINGS = [
  [STANDS.tail, BREADTHS.none, 0, -1],
  [STANDS.tail, BREADTHS.shaft, 0, -1],
  [STANDS.tail, BREADTHS.shaft, 1, 0],
  [STANDS.neck, BREADTHS.shaft, 1, 0],
  [STANDS.neck, BREADTHS.shaft, 0, -1],
  [STANDS.neck, BREADTHS.head, 0, -1],
  [STANDS.neck, BREADTHS.head, AWAY, ALONG],
  [STANDS.tip, BREADTHS.none, AWAY, ALONG],
];

/**
 * @param {number} sides of its section
 * @returns {{ rings: Float32Array, turns: Float32Array, index: Uint16Array }} 4 numbers per vertex, cosine and sine per vertex, and
 *   triangles that are counter-clockwise seen from outside
 */
export function arrowShape(sides) {
  const rings = new Float32Array(4 * RINGS.length * sides);
  const turns = new Float32Array(2 * RINGS.length * sides);
  const index = [];
  RINGS.forEach((ring, place) => {
    for (let side = 0; side < sides; side++) {
      const vertex = place * sides + side;
      const angle = (2 * Math.PI * side) / sides;
      rings.set(ring, 4 * vertex);
      turns.set([Math.cos(angle), Math.sin(angle)], 2 * vertex);
    }
  });
  for (let place = 0; place < RINGS.length; place += 2) {
    for (let side = 0; side < sides; side++) {
      const next = (side + 1) % sides;
      const [a, b] = [place * sides + side, place * sides + next];
      const [c, d] = [b + sides, a + sides];
      if (RINGS[place][1] !== BREADTHS.none) index.push(a, b, c);
      if (RINGS[place + 1][1] !== BREADTHS.none) index.push(a, c, d);
    }
  }
  return { rings, turns, index: Uint16Array.from(index) };
}
