import { writeZip } from "../files/zip.js";
import { FRAMES, MOST_FRAMES, MOST_SECONDS, SECONDS } from "../state/leaving.js";
import { turntable } from "../state/turntable.js";
import { posed } from "./posing.js";
import { LARGEST_SIDE } from "./saving.js";

/**
 * @typedef {import("../state/leaving.js").Turn} Turn
 *
 * @typedef {object} Taker  takes pictures one by one, and makes a file of them
 * @property {(picture: Blob, frame: number) => Promise<void>} add
 * @property {() => Promise<Blob>} end
 */

/** Pictures of the mesh as it turns once about what is upright: single ones, or a video (SPEC A8). */
export class Turntable {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** @param {Turn} [turn] @returns {Promise<Blob>} */
  async file(turn = {}) {
    const { store, facts, scene, canvas, saving } = this.#app;
    const { frames, seconds, format, width, height } = checked(turn, canvas);
    const summary = facts.get("summary");
    if (!summary || !facts.get("shown")?.cells) throw new Error("no cell is shown: there is nothing to save");
    const cameras = turntable(store.status.camera, frames, {
      axis: summary.view.up,
      body: summary.outline,
      aspect: width / height,
    });
    const taker =
      format === "zip"
        ? pictures(saving.stem)
        : await (await import("../figure/video.js")).video({ format, frames, seconds, width, height });
    await posed(
      this.#app,
      cameras.map((camera) => ({ camera })),
      async (frame) => {
        turn.signal?.throwIfAborted();
        await taker.add(await scene.screenshot({ width, height }), frame);
        turn.report?.(frame + 1, frames);
      },
    );
    return taker.end();
  }
}

/** @param {Turn} turn @param {HTMLCanvasElement} canvas */
function checked({ frames = FRAMES, seconds = SECONDS, format = "zip", width, height }, canvas) {
  whole("frames", frames, 2, MOST_FRAMES);
  if (!(seconds > 0 && seconds <= MOST_SECONDS))
    throw new Error(`found ${seconds} seconds, expected a number up to ${MOST_SECONDS}`);
  if (!["zip", "webm", "mp4"].includes(format))
    throw new Error(`found the format ‘${format}’, expected zip, webm or mp4`);
  const even = (/** @type {number} */ side) => 2 * Math.max(1, Math.round(side / 2)); // as videos want it
  const size = { width: width ?? even(canvas.clientWidth), height: height ?? even(canvas.clientHeight) };
  for (const [side, pixels] of Object.entries(size)) whole(side, pixels, 1, LARGEST_SIDE);
  if (format !== "zip" && (size.width % 2 || size.height % 2))
    throw new Error(
      `found ${size.width} × ${size.height} pixels, expected even numbers: videos have no others`,
    );
  return { frames, seconds, format, ...size };
}

/** @param {string} name @param {number} value @param {number} least @param {number} most */
function whole(name, value, least, most) {
  if (!(Number.isInteger(value) && value >= least && value <= most))
    throw new Error(`${name}: found ${value}, expected a whole number from ${least} to ${most}`);
}

/** An archive of pictures. @param {string} stem @returns {Taker} */
function pictures(stem) {
  /** @type {{ name: string, bytes: Uint8Array<ArrayBuffer> }[]} */
  const files = [];
  return {
    async add(picture, frame) {
      const number = String(frame).padStart(3, "0");
      files.push({ name: `${stem}-${number}.png`, bytes: new Uint8Array(await picture.arrayBuffer()) });
    },
    end: async () => writeZip(files),
  };
}
