"""One value is asked for one value: the cell that is pointed at is measured, and no other."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hexalab import Mesh
from hexalab.cells import CORNERS_OF_KIND, HEXAHEDRON, WEDGE
from hexalab.errors import HexaLabError
from hexalab.formats import write_bytes
from hexalab.quality import METRICS, compute, quality_many
from hexalab.quality.sizes import NEEDS as SIZED
from hexalab.session import Session, mean_volumes
from tests.core.session.checks import plain


@pytest.fixture(scope="module")
def mesh() -> Mesh:
    """Hexahedra of random corners, one wedge, a number and a vector for each cell and each point."""
    seeded = np.random.default_rng(17)
    points = seeded.normal(size=(40, 3))
    cells = np.array([seeded.choice(40, 8, replace=False) for _ in range(11)])
    kinds = np.zeros(11, dtype=np.uint8)
    kinds[4] = WEDGE
    cells[4, [3, 7]] = cells[4, [2, 6]]  # a wedge repeats these
    data = {"load": seeded.normal(size=11), "flow": seeded.normal(size=(11, 3)), "part": np.arange(11) % 3}
    at_points = {"heat": seeded.normal(size=40), "moved": seeded.normal(size=(40, 3)).astype(np.float32)}
    return Mesh(points.T, cells.T, kinds, cell_data=data, point_data=at_points)


@pytest.fixture
def open_mesh(mesh: Mesh) -> Session:
    session = Session()
    session.open("random.vtk", write_bytes(mesh, "vtk"))
    return session


@pytest.fixture
def measured(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Numbers of cells that went through the metrics' kernels."""
    counts: list[int] = []
    run = compute._run

    def counting(mesh: Mesh, cells: Any, *rest: Any) -> None:
        counts.append(cells.size)
        run(mesh, cells, *rest)

    monkeypatch.setattr(compute, "_run", counting)
    return counts


def test_V7_the_inspector_measures_the_one_cell(open_mesh: Session, measured: list[int]) -> None:
    told = open_mesh.inspect(3)
    assert measured == [1]
    assert set(told["pending"]) == set(SIZED)
    assert [told["metrics"][metric] for metric in SIZED] == [None] * len(SIZED)
    for metric in METRICS:
        measured.clear()
        open_mesh.value(3, metric)
        assert sum(measured) <= 1, metric


@pytest.mark.parametrize("share", [1, 4, 11, 100])
def test_V7_sizes_are_known_after_a_share_of_the_cells_at_a_time(
    open_mesh: Session, mesh: Mesh, measured: list[int], monkeypatch: pytest.MonkeyPatch, share: int
) -> None:
    monkeypatch.setattr(mean_volumes, "SHARE", share)
    values = quality_many(mesh)
    measured.clear()
    steps = 1
    while not open_mesh.measure_sizes():
        steps += 1
    assert steps == -(-11 // share)
    assert sum(measured) == 11, "each cell once"
    assert open_mesh.measure_sizes() is True
    for cell in range(11):
        told = open_mesh.inspect(cell)
        assert told["pending"] == []
        for metric, number in told["metrics"].items():
            whole = values[metric][cell]
            assert number == (pytest.approx(whole, rel=1e-12) if np.isfinite(whole) else None), metric


def test_V7_a_size_is_told_at_once_where_the_mesh_was_measured_by_it(open_mesh: Session, mesh: Mesh) -> None:
    open_mesh.quality("relative_size_squared")
    told = open_mesh.inspect(2)
    assert set(told["pending"]) == set(SIZED) - {"relative_size_squared"}
    expected = quality_many(mesh, ["relative_size_squared"])["relative_size_squared"][2]
    assert told["metrics"]["relative_size_squared"] == pytest.approx(expected)
    assert open_mesh.value(2, "relative_size_squared")["value"] == pytest.approx(expected)


def test_V7_the_value_of_an_attribute_is_that_which_its_colour_shows(open_mesh: Session, mesh: Mesh) -> None:
    for cell in (0, 4, 10):
        own = mesh.corners[list(CORNERS_OF_KIND[mesh.kinds[cell]]), cell]
        flow, moved = mesh.cell_data["flow"][cell], mesh.point_data["moved"][own].astype(float)
        truths = {
            "cell:load": (mesh.cell_data["load"][cell], None),
            "cell:part": (cell % 3, None),
            "cell:flow": (np.linalg.norm(flow), flow),
            "cell:flow:1": (flow[1], None),
            "point:heat": (mesh.point_data["heat"][own].mean(), None),
            "point:moved": (np.linalg.norm(moved, axis=1).mean(), moved.mean(axis=0)),
            "point:moved:2": (moved[:, 2].mean(), None),
        }
        for quantity, (number, components) in truths.items():
            told = open_mesh.value(cell, quantity)
            assert plain(told)
            assert told["kind"] == ("wedge" if cell == 4 else "hexahedron")
            assert told["value"] == pytest.approx(number, rel=1e-12), quantity
            if components is None:
                assert told["components"] is None
            else:
                assert told["components"] == pytest.approx(components.tolist(), rel=1e-12)


def test_V7_a_metric_that_the_kind_has_not_got_has_no_value(open_mesh: Session, mesh: Mesh) -> None:
    assert mesh.kinds[4] != HEXAHEDRON
    assert open_mesh.value(4, "skew")["value"] is None
    with pytest.raises(HexaLabError, match="no metric and no attribute 'cell:none'"):
        open_mesh.value(0, "cell:none")
    with pytest.raises(HexaLabError, match="no cell 11"):
        open_mesh.value(11, "skew")
