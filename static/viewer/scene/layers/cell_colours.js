import { DataTexture, FloatType, NearestFilter, RedFormat, RGBAFormat, UnsignedByteType } from "three";
import { DARK, luminance } from "../../colours/luminance.js";
import { paletteBytes } from "../../colours/palettes.js";
import { CELL_COLUMNS } from "../../geometry/texel.js";

/** Place on the map of what has none: below all that are beyond its ends. */
const MISSING = -9;

/**
 * Colour of every cell as a position in a colour map, in a texture looked up by cell number: another metric is one upload
 * here and no new geometry, another map is 1 KB.
 */
export class CellColours {
  /** @type {DataTexture} */
  values = oneTexel();
  /** @type {DataTexture} */
  palette;
  /** Whether any colour of the map is dark. */
  dark = true;
  #map = "";

  constructor() {
    this.palette = new DataTexture(paletteBytes("parula"), 256, 1, RGBAFormat, UnsignedByteType);
    this.palette.minFilter = this.palette.magFilter = NearestFilter;
    this.palette.needsUpdate = true;
  }

  /** @param {Float32Array | null} positions (C,) in [0, 1]; NaN for a value that is not finite */
  setPositions(positions) {
    this.values.dispose();
    if (!positions || positions.length === 0) {
      this.values = oneTexel();
      return;
    }
    const rows = Math.ceil(positions.length / CELL_COLUMNS);
    const whole = new Float32Array(rows * CELL_COLUMNS);
    // A shader may assume that no NaN exists; a position far below says the same and survives.
    for (let k = 0; k < positions.length; k++)
      whole[k] = Number.isFinite(positions[k]) ? positions[k] : MISSING;
    this.values = new DataTexture(whole, CELL_COLUMNS, rows, RedFormat, FloatType);
    this.values.needsUpdate = true;
  }

  /** @param {string} map a row of the palettes, or what cells are categorised by @param {import("../../colours/palettes.js").Reading} [reading] */
  setMap(map, reading = {}) {
    const key = JSON.stringify([map, reading.reversed, reading.steps]);
    if (key === this.#map) return;
    this.#map = key;
    const bytes = paletteBytes(map, reading);
    /** @type {Uint8Array} */ (this.palette.image.data).set(bytes);
    this.palette.needsUpdate = true;
    this.dark = hasDark(bytes);
  }

  dispose() {
    this.values.dispose();
    this.palette.dispose();
  }
}

/** @param {Uint8Array} bytes of a palette */
function hasDark(bytes) {
  for (let k = 0; k < bytes.length; k += 4)
    if (luminance([...bytes.subarray(k, k + 3)].map((byte) => byte / 255)) < DARK) return true;
  return false;
}

/** @returns {DataTexture} */
function oneTexel() {
  const texture = new DataTexture(new Float32Array([MISSING]), 1, 1, RedFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
