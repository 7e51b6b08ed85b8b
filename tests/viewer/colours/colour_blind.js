/**
 * How colours look to eyes that lack a kind of cone: Machado, Oliveira, Fernandes, "A physiologically-based model for simulation
 * of color vision deficiency", 2009, severity 1, on linear sRGB; and how far two colours are apart, in CIELAB (D65).
 */
const MATRICES = {
  deuteranope: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  protanope: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
};

/** @typedef {keyof typeof MATRICES | "usual"} Eyes */

/** @param {string} hex @param {Eyes} eyes */
function labOf(hex, eyes) {
  const value = Number.parseInt(hex.slice(1), 16);
  const linear = [value >> 16, (value >> 8) & 255, value & 255].map((byte) => {
    const part = byte / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  const seen =
    eyes === "usual"
      ? linear
      : MATRICES[eyes].map((row) =>
          Math.min(1, Math.max(0, row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2])),
        );
  const [r, g, b] = seen;
  const xyz = [
    (0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047,
    0.2126729 * r + 0.7151522 * g + 0.072175 * b,
    (0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883,
  ].map((t) => (t > 216 / 24389 ? Math.cbrt(t) : ((24389 / 27) * t + 16) / 116));
  return [116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])];
}

/** @param {string} one @param {string} other @param {Eyes} eyes */
export function apart(one, other, eyes) {
  const [a, b] = [labOf(one, eyes), labOf(other, eyes)];
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
