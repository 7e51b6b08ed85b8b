"""Opens every mesh of a folder in Chromium, slices it, and prints a row for each.

python -m benchmarks.open_all FOLDER [EXPECTED.json]

With a JSON file of facts (FOLDER/expected.json by default, where present) the counts and the Scaled Jacobian are
compared with it. Exit code 1 if a mesh fails, differs, or the console reports an error.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypedDict

from playwright.sync_api import Error, Page

from hexalab.formats import FORMATS

from .modes import DrawnCounts, ShownCounts
from .page import viewer

SENTINEL = 1e30
"""Verdict's value for a cell that it cannot measure; ours counts such a cell as not finite."""

OPEN = """async (url) => {
    const began = performance.now();
    await window.hexalab.open(url);
    const opened = performance.now() - began;
    const quality = await window.hexalab.quality("scaled_jacobian");
    const summary = await window.hexalab.summary();
    const whole = window.hexalab.drawn();
    await window.hexalab.setStatus({
        filters: { planes: { items: [{ enabled: true, normal: [1, 0, 0], offset: 0.5 }] } },
    });
    const sliced = window.hexalab.summary().shown;
    await window.hexalab.setStatus({ filters: { planes: { items: [] } } });
    return { opened, quality, summary, whole, sliced };
}"""

SAME = (
    "vertices", "cells", "boundary_faces", "faces", "edges", "unreferenced_vertices", "cells_repeating_a_vertex",
    "nonmanifold_faces", "interior_edge_valence", "boundary_edge_valence", "cells_per_depth",
)  # fmt: skip


class Opened(TypedDict):
    """What the page tells of a mesh: milliseconds to open it, its facts, and what it draws whole and half cut.

    Attributes
    ----------
    opened : float
        Milliseconds.
    quality, summary : dict
        Of the Scaled Jacobian, and the mesh's facts.
    whole : DrawnCounts
        With no filter.
    sliced : ShownCounts
        Cut at one half along x.
    """

    opened: float
    quality: dict[str, Any]
    summary: dict[str, Any]
    whole: DrawnCounts
    sliced: ShownCounts


def differences(found: Opened, expected: Mapping[str, Any]) -> list[str]:
    """Which facts of a mesh are not the expected ones."""
    summary, quality = found["summary"], found["quality"]
    wrong = [
        f"{key} is {summary.get(key)}, expected {expected[key]}"
        for key in SAME
        if key in expected and summary.get(key) != expected[key]
    ]
    truth = expected.get("verdict", {}).get("scaled_jacobian", {})
    for key in ("min", "mean", "max"):
        unmeasured = key != "min" and truth.get("max", 0) >= SENTINEL
        if (
            key in truth
            and not unmeasured
            and not math.isclose(quality[key], truth[key], rel_tol=1e-9, abs_tol=1e-12)
        ):
            wrong.append(f"scaled_jacobian {key} is {quality[key]}, expected {truth[key]}")
    if (truth.get("max", 0) >= SENTINEL) != (quality["not_finite"] > 0):
        wrong.append(f"{quality['not_finite']} cells without a finite scaled_jacobian")
    return wrong


def run(folder: Path, facts: Mapping[str, Mapping[str, Any]]) -> int:
    """Open every mesh of the folder; returns the number of meshes with a fault."""
    suffixes = tuple(suffix for row in FORMATS for suffix in row.extensions)
    files = sorted(path for path in folder.iterdir() if path.name.removesuffix(".gz").endswith(suffixes))
    failures = 0
    with viewer(folder) as (page, address, errors):
        for path in files:
            wrong = _try(page, f"{address}/bench/{path.name}", facts.get(path.name, {}), errors)
            failures += bool(wrong)
            print(f"{path.name:62} {wrong or 'ok'}", flush=True)
    print(f"{len(files) - failures} of {len(files)} meshes opened, sliced and found as expected")
    return failures


def _try(page: Page, address: str, expected: Mapping[str, Any], errors: list[str]) -> list[str]:
    errors.clear()
    try:
        found: Opened = page.evaluate(OPEN, address)
    except Error as error:
        return [error.message.splitlines()[0]]
    wrong = differences(found, expected)
    if found["whole"]["faces"] != found["summary"]["boundary_faces"]:
        wrong.append(
            f"{found['whole']['faces']} faces drawn, {found['summary']['boundary_faces']} on the boundary"
        )
    if not 0 < found["sliced"]["cells"] < found["summary"]["cells"]:
        wrong.append(f"{found['sliced']['cells']} cells shown after a slice at one half")
    if not wrong and not errors:
        quality = found["quality"]
        print(
            f"{found['opened']:8.0f} ms  {found['summary']['cells']:>9,} cells  SJ {quality['min']:+.4f} "
            f"{quality['mean']:+.4f}  ", end="",
        )  # fmt: skip
    return wrong + errors


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    place = Path(sys.argv[1])
    known = Path(sys.argv[2]) if len(sys.argv) == 3 else place / "expected.json"
    sys.exit(bool(run(place, json.loads(known.read_text()) if known.is_file() else {})))
