import { RGBAFormat, UnsignedByteType, WebGLRenderTarget } from "three";
import { encodePng } from "../../files/png_encoder.js";

/** Sides of the pieces that a picture is drawn in, and pixels drawn to one of the picture along each side. */
const TILE = 2048;
const SCALE = 2;

/** Largest side of a picture. */
export const LARGEST = 8192;

/**
 * Draws a picture of any size by tiles, four samples to a drawn pixel and four drawn pixels to one of the picture.
 *
 * @param {import("./painter.js").Painter} painter
 * @param {{ width: number, height: number, transparent: boolean,
 *   draw: (piece: Piece) => void }} job
 * @returns {Promise<Blob>} PNG
 * @typedef {{ target: WebGLRenderTarget, tile: { x: number, y: number, width: number, height: number }, scale: number,
 *   background: string | null }} Piece  background: null for that of the drawing
 */
export async function takePicture(painter, { width, height, transparent, draw }) {
  if (!(width >= 1 && height >= 1 && width <= LARGEST && height <= LARGEST)) {
    throw new RangeError(`A picture has 1 to ${LARGEST} pixels along each side, not ${width} x ${height}`);
  }
  const pixels = new Uint8ClampedArray(4 * width * height);
  const side = Math.min(TILE, SCALE * Math.max(width, height));
  const target = new WebGLRenderTarget(side, side, {
    format: RGBAFormat,
    type: UnsignedByteType,
    samples: 4,
    generateMipmaps: false,
  });
  const backgrounds = transparent ? ["#000000", "#ffffff"] : [null];
  const drawn = backgrounds.map(() => new Uint8Array(4 * side * side));
  const step = side / SCALE;
  try {
    for (let y = 0; y < height; y += step) {
      for (let x = 0; x < width; x += step) {
        const size = { width: Math.min(step, width - x), height: Math.min(step, height - y) };
        const tile = { x: x * SCALE, y: y * SCALE, width: side, height: side };
        backgrounds.forEach((background, k) => {
          draw({ target, tile, scale: SCALE, background });
          painter.renderer.readRenderTargetPixels(target, 0, 0, side, side, drawn[k]);
        });
        reduce(drawn, side, pixels, { x, y, width }, size);
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
  } finally {
    target.dispose();
    painter.renderer.setRenderTarget(null);
  }
  return new Blob([await encodePng(width, height, pixels)], { type: "image/png" });
}

/**
 * Averages blocks of drawn pixels into the picture, top row first. What was drawn on black and on white tells how much of the
 * background shows: that is how transparent it is, whatever was blended how.
 *
 * @param {Uint8Array[]} drawn a square tile, bottom row first; on black and on white for a transparent picture
 * @param {number} side of the tile
 * @param {Uint8ClampedArray} pixels the picture
 * @param {{ x: number, y: number, width: number }} at place of the tile, width of the picture
 * @param {{ width: number, height: number }} size of the tile in the picture
 */
function reduce([drawn, onWhite], side, pixels, at, size) {
  const share = 1 / (SCALE * SCALE);
  for (let j = 0; j < size.height; j++) {
    let to = 4 * ((at.y + j) * at.width + at.x);
    for (let i = 0; i < size.width; i++, to += 4) {
      let [r, g, b, shows] = [0, 0, 0, 0];
      for (let n = 0; n < SCALE; n++) {
        let from = 4 * ((side - 1 - (j * SCALE + n)) * side + i * SCALE);
        for (let m = 0; m < SCALE; m++, from += 4) {
          r += drawn[from];
          g += drawn[from + 1];
          b += drawn[from + 2];
          if (onWhite)
            shows +=
              (onWhite[from] -
                drawn[from] +
                onWhite[from + 1] -
                drawn[from + 1] +
                onWhite[from + 2] -
                drawn[from + 2]) /
              3;
        }
      }
      const cover = 255 - shows * share;
      const part = cover > 0 ? (share * 255) / cover : 0;
      pixels[to] = r * part;
      pixels[to + 1] = g * part;
      pixels[to + 2] = b * part;
      pixels[to + 3] = cover;
    }
  }
}
