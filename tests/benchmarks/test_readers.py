"""The script that lays four programs' readings beside each other finds what differs, and outlives what crashes."""

from __future__ import annotations

import os
import signal
from collections import Counter
from pathlib import Path

from hexalab.formats import write
from tests.core.filters.boxes import box
from tests.tools import tool

for name in ("vtk", "meshio", "gmsh"):
    tool(name)

from benchmarks.readers.__main__ import differences, main  # noqa: E402
from benchmarks.readers.workers import Worker  # noqa: E402


def test_equal_readings_are_counted_and_a_file_that_none_reads_is_no_difference(
    tmp_path: Path, capsys
) -> None:
    for name in ("grid.vtk", "grid.mesh"):
        write(box(3, 2, 1), tmp_path / name)
    (tmp_path / "no.mesh").write_text("MeshVersionFormatted 2\nDimension 3\n")
    assert main([str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "", "no difference is printed before the totals"
    totals = {line[9:]: int(line[:7]) for line in lines if line[:7].strip().isdigit() and line[7:9] == "  "}
    assert totals == {
        "hexalab reads": 2,
        "hexalab refuses": 1,
        "VTK agrees": 1,
        "meshio agrees": 2,
        "gmsh agrees": 1,
    }


def test_another_volume_orientation_or_array_is_told() -> None:
    ours = {
        "cells": {"hexahedron": 1}, "box": [0, 0, 0, 1, 1, 1], "corner sum": [4, 4, 4], "volume": -1.0, "size": 1.0,
        "SJ": [-1.0, -1.0], "cell arrays": {"q": [1, 0, 2.0, 2.0, 2.0]}, "point arrays": {},
    }  # fmt: skip
    theirs = ours | {"volume": 1.0, "SJ": [1.0, 1.0], "cell arrays": {"q": [1, 0, 3.0, 3.0, 3.0]}}
    totals: Counter[str] = Counter()
    nothing = {"refused": "NotRead: no reader"}
    told = list(differences({"hexalab": ours, "VTK": theirs, "meshio": nothing, "gmsh": nothing}, totals))
    assert [line.split()[1] for line in told] == ["volume", "SJ", "cell"]
    assert totals == {"hexalab reads": 1, "VTK differs": 1}


def test_a_process_that_dies_is_an_answer_and_the_next_file_is_read(tmp_path: Path) -> None:
    write(box(1, 1, 1), tmp_path / "cube.mesh")
    worker = Worker("hexalab", 60)
    os.kill(worker.process.pid or 0, signal.SIGKILL)
    worker.process.join()
    assert worker.answer() == {"refused": "the process died", "told": False}
    worker.ask(tmp_path / "cube.mesh")
    assert worker.answer()["cells"] == {"hexahedron": 1}
    worker.stop()
