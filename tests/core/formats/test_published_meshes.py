"""SPEC R1, R3 on published meshes, where they are present."""

from __future__ import annotations

import gzip
from pathlib import Path
from typing import Any

import numpy as np

from hexalab.formats import read, read_bytes, write_bytes


def test_R1_R3_published_meshes_have_the_expected_counts(meshes: Path, expected: dict[str, Any]) -> None:
    files = [path for path in sorted(meshes.iterdir()) if path.suffix in (".mesh", ".vtk")]
    assert len(files) >= len(expected) > 0
    for path in files:
        mesh = read(path)
        facts = expected[path.name]
        assert (mesh.vertex_count, mesh.cell_count) == (facts["vertices"], facts["cells"]), path.name
        assert mesh.kind_counts == {"hexahedron": facts["cells"]}
        assert int((~mesh.referenced).sum()) == facts["unreferenced_vertices"]
        ordered = np.sort(mesh.corners, axis=0)
        repeating = (ordered[1:] == ordered[:-1]).any(axis=0)
        assert int(repeating.sum()) == facts["cells_repeating_a_vertex"]


def test_A1_published_meshes_survive_every_format(meshes: Path) -> None:
    names = ("2021-at-most-hexa--cylinder-n-slivers.mesh", "2019-symmetric-moving-frames--hex-fanpart.vtk")
    for name in names:
        if not (meshes / name).exists():
            continue
        mesh = read(meshes / name)
        for format_id in ("mesh", "vtk", "vtu"):
            back = read_bytes(gzip.compress(write_bytes(mesh, format_id), 1), f"x.{format_id}.gz")
            np.testing.assert_array_equal(back.coordinates, mesh.coordinates)
            np.testing.assert_array_equal(back.corners, mesh.corners)
