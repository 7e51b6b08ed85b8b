import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  WebMOutputFormat,
} from "mediabunny";

const FORMATS = {
  webm: { make: () => new WebMOutputFormat(), type: "video/webm" },
  mp4: { make: () => new Mp4OutputFormat(), type: "video/mp4" },
};

/** Seconds between pictures that stand for themselves, so that a player can jump. */
const KEY = 1;

/**
 * A video of pictures that come one by one, encoded by the browser (WebCodecs).
 *
 * @param {{ format: "webm" | "mp4", frames: number, seconds: number, width: number, height: number }} wanted
 * @returns {Promise<{ add: (picture: Blob, frame: number) => Promise<void>, end: () => Promise<Blob> }>}
 * @throws {Error} the browser encodes no such video
 */
export async function video({ format, frames, seconds, width, height }) {
  const { make, type } = FORMATS[format];
  const container = make();
  const codec = await encodable(container, width, height);
  if (!codec)
    throw new Error(
      `this browser encodes no ${format} of ${width} × ${height} pixels: save the pictures instead, or in another format`,
    );
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext("2d", { alpha: false });
  if (!pen) throw new Error("this browser gives no canvas to draw the video on");
  const output = new Output({ format: container, target: new BufferTarget() });
  const source = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH, keyFrameInterval: KEY });
  output.addVideoTrack(source, { frameRate: frames / seconds });
  await output.start();
  const length = seconds / frames;
  return {
    async add(picture, frame) {
      const image = await createImageBitmap(picture);
      pen.drawImage(image, 0, 0, width, height);
      image.close();
      await source.add(frame * length, length);
    },
    async end() {
      await output.finalize();
      return new Blob([output.target.buffer ?? new ArrayBuffer(0)], { type });
    },
  };
}

/** @param {InstanceType<typeof WebMOutputFormat> | InstanceType<typeof Mp4OutputFormat>} container @param {number} width @param {number} height */
async function encodable(container, width, height) {
  if (typeof VideoEncoder === "undefined") return null;
  return getFirstEncodableVideoCodec(container.getSupportedVideoCodecs(), { width, height });
}
