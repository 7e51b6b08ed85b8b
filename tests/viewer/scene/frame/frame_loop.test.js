import assert from "node:assert/strict";
import { afterEach, beforeEach, test } from "node:test";
import { FrameLoop } from "../../../../static/viewer/scene/frame/frame_loop.js";

/** The screen: turns that were asked for, run by hand. @type {Map<number, (now: number) => void>} */
const asked = new Map();
let drawn = 0;

const loop = () =>
  new FrameLoop(
    () => drawn++,
    () => ({ again: false, draw: false }),
  );

/** The screen is ready for the next picture. */
function turn() {
  const turns = [...asked.values()];
  asked.clear();
  for (const one of turns) one(0);
}

beforeEach(() => {
  asked.clear();
  drawn = 0;
  let last = 0;
  globalThis.requestAnimationFrame = (then) => {
    asked.set(++last, then);
    return last;
  };
  globalThis.cancelAnimationFrame = (number) => asked.delete(number);
});

afterEach(() => {
  Reflect.deleteProperty(globalThis, "requestAnimationFrame");
  Reflect.deleteProperty(globalThis, "cancelAnimationFrame");
});

test("many askings make one picture", () => {
  const frames = loop();
  frames.invalidate();
  frames.invalidate();
  turn();
  turn();
  assert.equal(drawn, 1);
});

test("at rest nothing is drawn, and what was asked for is drawn after it", () => {
  const frames = loop();
  frames.invalidate();
  frames.resting = true;
  frames.invalidate();
  frames.flush();
  turn();
  assert.equal(drawn, 0);
  assert.ok(frames.stale);
  frames.resting = false;
  turn();
  assert.equal(drawn, 1);
});

test("a rest that nobody disturbed ends without a picture", () => {
  const frames = loop();
  frames.resting = true;
  frames.resting = false;
  turn();
  assert.equal(drawn, 0);
});
