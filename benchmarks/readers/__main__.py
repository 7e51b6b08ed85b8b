"""Read every mesh of a folder with hexalab, VTK, meshio and gmsh, and print where they differ.

python -m benchmarks.readers FOLDER... [--patience SECONDS] [--json FILE]

Beside each other: cells per kind, the box and the sum of the cells' corners, attributes, volume and Scaled Jacobian.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from hexalab.formats import FORMATS

from .facts import close
from .workers import Answer, Worker

PEERS = ("VTK", "meshio", "gmsh")
ENDINGS = tuple(dict.fromkeys([*(ending for row in FORMATS for ending in row.extensions), ".ucd"]))


def main(words: list[str]) -> int:
    """Compare, file by file, then print the totals."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.readers", description=__doc__)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--patience", type=float, default=60)
    parser.add_argument("--json", type=Path, help="write all facts there")
    options = parser.parse_args(words)
    paths = [path for folder in options.folders for path in meshes(folder)]
    workers = {name: Worker(name, options.patience) for name in ("hexalab", *PEERS)}
    totals: Counter[str] = Counter()
    everything = {}
    for path in paths:
        for worker in workers.values():
            worker.ask(path)
        answers = {name: worker.answer() for name, worker in workers.items()}
        everything[str(path)] = answers
        for line in differences(answers, totals):
            print(f"{path}: {line}", flush=True)
    for worker in workers.values():
        worker.stop()
    print(f"\n{len(paths)} files")
    for what, count in sorted(totals.items()):
        print(f"{count:7d}  {what}")
    if options.json:
        options.json.write_text(json.dumps(everything, indent=1))
    return 0


def meshes(folder: Path) -> Iterator[Path]:
    """Files of a folder, and of those within it, whose ending is that of a mesh."""
    if folder.is_file():
        yield folder
        return
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name.lower().removesuffix(".gz").endswith(ENDINGS):
            yield path


def differences(answers: dict[str, Answer], totals: Counter[str]) -> Iterator[str]:
    """Lines about one file; equal readings are only counted."""
    ours = answers["hexalab"]
    totals["hexalab refuses" if "refused" in ours else "hexalab reads"] += 1
    readers = [peer for peer in PEERS if "refused" not in answers[peer] and answers[peer]["cells"]]
    if "refused" in ours:
        if readers:
            totals["hexalab refuses, another finds cells"] += 1
            yield f"refused, but {', '.join(readers)} found cells: {ours['refused']}"
        elif not ours["told"]:
            totals["hexalab fails with a traceback"] += 1
            yield ours["refused"]
        return
    for peer in readers:
        wrong = list(unlike(ours, answers[peer]))
        totals[f"{peer} {'differs' if wrong else 'agrees'}"] += 1
        for line in wrong:
            yield f"{peer}: {line}"


def unlike(ours: Answer, theirs: Answer) -> Iterator[str]:
    """What differs between two readings of one file."""
    if ours["cells"] != theirs["cells"]:
        yield f"cells {ours['cells']}, theirs {theirs['cells']}"
        return
    size = max(map(abs, ours["box"]), default=0.0)
    count = sum(ours["cells"].values())
    for fact, scale in (
        ("box", size),
        ("corner sum", 8 * size * count),
        ("volume", ours["size"]),
        ("SJ", 1.0),
    ):
        if not close(ours[fact], theirs[fact], scale):
            yield f"{fact} {_short(ours[fact])}, theirs {_short(theirs[fact])}"
    for kind in ("cell arrays", "point arrays"):
        for name in sorted(set(ours[kind]) & set(theirs[kind])):
            if not close(
                ours[kind][name], theirs[kind][name], max(map(abs, ours[kind][name][2:]), default=0.0)
            ):
                yield f"{kind[:-1]} {name}: {_short(ours[kind][name])}, theirs {_short(theirs[kind][name])}"
        missing = [
            name for name in sorted(set(theirs[kind]) - set(ours[kind])) if any(theirs[kind][name][1:])
        ]  # zeros alone say nothing: we drop references that are all 0
        if missing:
            yield f"{kind} that only they have: {', '.join(missing)[:120]}"


def _short(value: Any) -> str:
    numbers = value if isinstance(value, list) else [value]
    return "[" + ", ".join(f"{number:.9g}" for number in numbers) + "]"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
