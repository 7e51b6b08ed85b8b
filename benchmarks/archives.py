"""What the page's archives and pictures cost beside their contents: the checksum, in Node's V8."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

from .clock import table

SIZE = 64 * 2**20
"""Bytes, as of a batch of some pictures of 4,000 pixels."""

MODULE = Path("static/viewer/files/crc32.js")

SCRIPT = """
import { crc32 } from %s;
const bytes = new Uint8Array(%d).map((_, at) => at * 2654435761);
const single = new Uint32Array(256).map((_, n) => {
  for (let bit = 0; bit < 8; bit++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});
function byteByByte(bytes) {
  let code = -1;
  for (let at = 0; at < bytes.length; at++) code = single[(code ^ bytes[at]) & 255] ^ (code >>> 8);
  return (code ^ -1) >>> 0;
}
const times = {};
for (const [name, sum] of [["hexalab", crc32], ["byte by byte", byteByByte]]) {
  if (sum(bytes) >>> 0 !== byteByByte(bytes)) throw new Error(name);
  times[name] = [1, 2, 3].map(() => {
    const began = performance.now();
    sum(bytes);
    return performance.now() - began;
  });
}
console.log(JSON.stringify(times));
"""


def run(_folder: Path) -> None:
    """Print the table."""
    script = SCRIPT % (json.dumps(MODULE.resolve().as_uri()), SIZE)
    done = subprocess.run(
        ["node", "--input-type=module", "-e", script], check=True, capture_output=True, text=True
    )
    times: dict[str, list[float]] = json.loads(done.stdout)
    table(
        "viewer: CRC-32 of 64 MB [ms]", ["way", "median"], [[way, sorted(of)[1]] for way, of in times.items()]
    )
