"""The shown cells as a file; truth: meshio reads it, the cells one by one, and quality measured of the whole."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab import WRITERS, HexaLabError, Mesh, quality
from hexalab.formats import read_bytes
from hexalab.session import Session
from hexalab.session.warm_up import grid

HALF = {"filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": 0.5}]}}}


@pytest.fixture
def mesh() -> Mesh:
    """A block of 27 bricks, bent so that no two are alike, with attributes."""
    block = grid(3)
    x, y, z = block.coordinates
    bent = np.stack([x * (1 + 0.1 * y), y + 0.2 * z * z, z * (1 + 0.3 * x)])
    return Mesh(
        bent, block.corners, block.kinds,
        {"height": np.arange(64.0)}, {"load": np.arange(27), "stretch": np.full(27, 7.0)}, name="block.vtu",
    )  # fmt: skip


@pytest.fixture
def session(mesh: Mesh) -> Session:
    session = Session({"block": lambda: mesh})
    session.open_offered("block")
    return session


def shown_rows(mesh: Mesh) -> list[int]:
    """Cells whose barycentre is beyond the middle of all along x."""
    along = mesh.points[mesh.cells].mean(axis=1)[:, 0]
    return np.flatnonzero(along > (along.min() + along.max()) / 2).tolist()


@pytest.mark.parametrize("row", WRITERS, ids=lambda row: row.id)
def test_A8_the_shown_cells_come_back_in_every_format(session: Session, mesh: Mesh, row: Any) -> None:
    session.update(HALF)
    saved = session.save_cells(row.id, ["scaled_jacobian"])
    rows = shown_rows(mesh)
    assert 0 < len(rows) < 27 and saved["cells"] == len(rows)
    found = read_bytes(saved["data"].tobytes(), f"part{row.extension}")
    assert found.vertex_count == saved["vertices"] == len(np.unique(mesh.cells[rows]))
    assert np.allclose(found.points[found.cells], mesh.points[mesh.cells[rows]], rtol=1e-15)
    carried = "scaled_jacobian" in found.cell_data
    assert carried == (not any("scaled_jacobian" in note for note in saved["notes"]))
    if carried:
        measured = quality(mesh, "scaled_jacobian")[rows]
        assert found.cell_data["scaled_jacobian"].tolist() == measured.tolist()
        assert found.cell_data["original_cell"].tolist() == rows
    if row.largest_number:
        assert found.cell_numbers is not None and found.cell_numbers.tolist() == [place + 1 for place in rows]


def test_A8_meshio_reads_what_was_saved(session: Session, mesh: Mesh, tmp_path: Path) -> None:
    meshio = pytest.importorskip("meshio")
    session.update(HALF)
    (tmp_path / "part.vtu").write_bytes(session.save_cells("vtu", ["volume"])["data"].tobytes())
    found = meshio.read(tmp_path / "part.vtu")
    rows = shown_rows(mesh)
    assert found.cells_dict["hexahedron"].shape == (len(rows), 8)
    assert np.array_equal(found.cell_data["volume"][0].ravel(), quality(mesh, "volume")[rows])
    assert np.array_equal(found.cell_data["load"][0].ravel(), rows)
    assert np.array_equal(found.points[found.cells_dict["hexahedron"]], mesh.points[mesh.cells[rows]])


def test_A8_sizes_compare_with_the_whole_meshs_mean_and_names_do_not_clash(
    session: Session, mesh: Mesh
) -> None:
    session.update(HALF)
    saved = session.save_cells("vtu", ["relative_size_squared", "stretch"], ["cell:stretch"])
    found = read_bytes(saved["data"].tobytes(), "part.vtu")
    rows = shown_rows(mesh)
    whole = quality(mesh, "relative_size_squared")[rows]
    assert found.cell_data["relative_size_squared"].tolist() == whole.tolist()
    alone = quality(replace(found, cell_data={}), "relative_size_squared")
    assert not np.allclose(whole, alone), "a part has another mean volume"
    assert set(found.cell_data) == {"relative_size_squared", "stretch", "stretch (measured)", "original_cell"}
    assert found.cell_data["stretch"].tolist() == [7.0] * len(rows)
    assert found.cell_data["stretch (measured)"].tolist() == quality(mesh, "stretch")[rows].tolist()
    assert not found.point_data


def test_A8_the_whole_mesh_is_saved_as_it_is(session: Session, mesh: Mesh) -> None:
    session.update({})
    saved = session.save_cells("vtu")
    found = read_bytes(saved["data"].tobytes(), "whole.vtu")
    assert found.cells.tolist() == mesh.cells.tolist()
    assert set(found.cell_data) == {"load", "stretch"} and set(found.point_data) == {"height"}


def test_A8_what_can_not_be_saved_is_told(session: Session) -> None:
    session.update({})
    with pytest.raises(HexaLabError, match="no metric 'none'"):
        session.save_cells("vtu", ["none"])
    with pytest.raises(
        HexaLabError, match="no attribute 'cell:none'; it has cell:load, cell:stretch, point:height"
    ):
        session.save_cells("vtu", [], ["cell:none"])
    with pytest.raises(hexalab.MeshWriteError, match="can't be written as ‘stl’"):
        session.save_cells("stl")
    session.update({"filters": {"peel": {"depth": 9}}})
    with pytest.raises(HexaLabError, match="no cell is shown"):
        session.save_cells("vtu")
