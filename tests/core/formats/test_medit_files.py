"""SPEC R1, R2: Medit files that meshio and Gmsh write."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.formats import read
from tests.core.formats.gmsh_files import File, make
from tests.core.formats.samples import MESHIO_NAMES, Sample, check, grid, mixed, signed_volumes
from tests.tools import tool

meshio = tool("meshio")


@pytest.mark.parametrize("ending", [".mesh", ".meshb"])
@pytest.mark.parametrize("make", [mixed, lambda: grid(3, 2, 4)])
def test_R1_R2_files_of_meshio(tmp_path: Path, ending: str, make) -> None:
    sample: Sample = make().grouped()
    kinds = sorted({kind for kind, _ in sample.cells})
    blocks = [(MESHIO_NAMES[kind], sample.rows_of(kind)) for kind in kinds]
    if (ids := [name for name, _ in blocks]) and "wedge" in ids:
        number = ids.index("wedge")
        blocks[number] = ("wedge", blocks[number][1][:, [0, 2, 1, 3, 5, 4]])
    path = tmp_path / f"m{ending}"
    data = {
        "medit:ref": [np.arange(len(rows)) + 10 * kind for kind, (_, rows) in zip(kinds, blocks, strict=True)]
    }
    meshio.write(path, meshio.Mesh(sample.points, blocks, cell_data=data))
    mesh = read(path)
    assert mesh.format == ending[1:]
    check(mesh, sample, 1e-15)
    np.testing.assert_array_equal(mesh.cell_data["reference"], np.concatenate(data["medit:ref"]))


def test_R1_files_of_gmsh(tmp_path: Path) -> None:
    made = make(File(tmp_path / "m.mesh"), wedges=False)
    mesh = read(tmp_path / "m.mesh")
    assert mesh.cell_count == made.count(5) and mesh.vertex_count == len(made.points)
    np.testing.assert_allclose(signed_volumes(mesh).sum(), 1, rtol=1e-9)
    assert (signed_volumes(mesh) > 0).all()
