import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { pack, unpack } from "../../../static/viewer/files/packing.js";

const ROOT = join(dirname(fileURLToPath(import.meta.url)), "../../..");
const PYTHON =
  [join(ROOT, ".venv/bin/python"), "python3"].find((path) => path === "python3" || existsSync(path)) ??
  "python3";

/** @typedef {import("../../../static/viewer/geometry/records.js").Surface} Surface */

/** What `hexalab.packing` writes. @param {string} expression @returns {ArrayBuffer} */
function packed(expression) {
  const program = `import sys, numpy as np\nfrom hexalab.packing import pack\nsys.stdout.buffer.write(pack(${expression}))`;
  const { stdout, stderr, status } = spawnSync(PYTHON, ["-c", program], {
    env: { ...process.env, PYTHONPATH: join(ROOT, "core") },
  });
  assert.equal(status, 0, String(stderr));
  return stdout.buffer.slice(stdout.byteOffset, stdout.byteOffset + stdout.length);
}

test("O2: what the core packs is read back, arrays of every kind in their places", () => {
  const found = /** @type {{ summary: object, surface: Surface }} */ (
    unpack(
      packed(
        '{"summary": {"name": "grösse", "cells": 3}, "surface": {"mode": "lines", "positions": np.arange(6, dtype=np.float32), "normals": np.array([-1, 7], dtype=np.int16), "cells": np.array([1, 2**32 - 1], dtype=np.uint32), "inside": np.array([0, 255, 3], dtype=np.uint8), "quads": None}}',
      ),
    )
  );
  assert.deepEqual(found.summary, { name: "grösse", cells: 3 });
  assert.deepEqual(found.surface.positions, Float32Array.of(0, 1, 2, 3, 4, 5));
  assert.deepEqual(found.surface.normals, Int16Array.of(-1, 7));
  assert.deepEqual(found.surface.cells, Uint32Array.of(1, 4294967295));
  assert.deepEqual(found.surface.inside, Uint8Array.of(0, 255, 3));
  assert.equal(found.surface.quads, null);
});

test("O2: what is no packed file is named", () => {
  assert.throws(
    () => unpack(new TextEncoder().encode("<!doctype html>").buffer),
    /found "<!do".*expected HXB1/,
  );
  assert.throws(() => unpack(new ArrayBuffer(3)), /expected HXB1/);
});

test("A7: what is packed here is read back, here and by the core", () => {
  const record = {
    about: { name: "grösse", none: null, list: [1, "two", true] },
    shots: [
      { points: Float32Array.of(0.5, -1), cells: Uint32Array.of(7, 4294967295), flags: new Uint8Array(0) },
    ],
    view: new Int16Array(Int16Array.of(1, 2, 3, 4).buffer, 2, 2), // of a part of its buffer
  };
  const bytes = pack(record);
  const found = unpack(bytes.buffer);
  assert.deepEqual(found, { ...record, view: Int16Array.of(2, 3) });
  const program = `import sys
from hexalab.packing import unpack
found = unpack(sys.stdin.buffer.read())
shot = found["shots"][0]
print(found["about"], shot["points"].tolist(), shot["cells"].tolist(), shot["flags"].shape, found["view"].tolist())`;
  const { stdout, stderr } = spawnSync(PYTHON, ["-X", "utf8", "-c", program], {
    input: bytes,
    env: { ...process.env, PYTHONPATH: join(ROOT, "core") },
  });
  assert.equal(String(stderr), "");
  const about = "{'name': 'grösse', 'none': None, 'list': [1, 'two', True]}";
  assert.equal(String(stdout).trim(), `${about} [0.5, -1.0] [7, 4294967295] (0,) [2, 3]`);
});
