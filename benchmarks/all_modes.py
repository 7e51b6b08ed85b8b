"""Runs every mesh of a folder through all modes, filters, colours and lights in Chromium: a row for each.

python -m benchmarks.all_modes FOLDER

After each change the cells shown and the faces, edges and cells drawn must be those that the core finds natively. Exit
code 1 if any differs, a mesh fails, or the console reports an error.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

from playwright.sync_api import Error, Page

import hexalab
from hexalab.formats import FORMATS

from .modes import WALK, differences, steps
from .page import viewer


def run(folder: Path) -> int:
    """Walk through all modes of every mesh; returns the number of meshes with a fault."""
    suffixes = tuple(suffix for row in FORMATS for suffix in row.extensions)
    files = sorted(path for path in folder.iterdir() if path.name.removesuffix(".gz").endswith(suffixes))
    failures = 0
    with viewer(folder) as (page, address, errors):
        page.set_viewport_size({"width": 480, "height": 360})
        for path in files:
            errors.clear()
            began = time.perf_counter()
            count, wrong = _walk(page, f"{address}/bench/{path.name}", path)
            wrong += [f"console: {error}" for error in errors]
            failures += bool(wrong)
            took = time.perf_counter() - began
            print(
                f"{path.name:62} {count:3} changes {took:6.1f} s  {'DIFFERS' if wrong else 'ok'}", flush=True
            )
            for line in wrong:
                print(f"    {line}", flush=True)
    print(f"{len(files) - failures} of {len(files)} meshes drawn as the core says in all modes")
    return failures


def _walk(page: Page, address: str, path: Path) -> tuple[int, list[str]]:
    mesh = hexalab.read(path)
    walk = list(steps(mesh))
    try:
        page.evaluate("url => window.hexalab.open(url)", address)
        answers = page.evaluate(WALK, [step.partial for step in walk])
    except Error as error:
        return 0, [error.message.splitlines()[0]]
    return len(walk), differences(mesh, walk, answers)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(bool(run(Path(sys.argv[1]))))
