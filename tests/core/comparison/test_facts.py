"""The facts of a comparison (SPEC S7). Truths: closed formulas for boxes, VTK's distances, metrics of each alone."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from hexalab import METRICS, Mesh, quality, read, statistics
from hexalab.cells import TETRAHEDRON
from hexalab.comparison import (
    change_of,
    compare,
    counterpart_of,
    difference_in_cells,
    fingerprint,
    with_comparison,
)
from hexalab.reference import TriangleSurface, boundary_of
from tests.core.conftest import grid_points
from tests.published import file_of
from tests.tools import tool

vtk = tool("vtk")


def box(shape: tuple[int, int, int] = (3, 2, 1), **changes: Any) -> Mesh:
    """A grid of unit cubes."""
    return replace(Mesh.from_cells(*grid_points(shape), name="box"), **changes)


def moved(mesh: Mesh, vertex: int, way: tuple[float, float, float]) -> Mesh:
    """The mesh with one vertex elsewhere."""
    coordinates = mesh.coordinates.copy()
    coordinates[:, vertex] += way
    return replace(mesh, coordinates=coordinates, name="moved")


def test_S7_a_mesh_beside_itself_differs_in_nothing() -> None:
    facts = compare(box(), box())
    assert (facts["same_connectivity"], facts["connectivity"], facts["volume_ratio"]) == (True, "", 1)
    assert all(value == 0 for of in facts["difference"].values() for value in of.values())
    for way in ("a_to_b", "b_to_a"):
        told = facts["distance"][way]
        assert (told["max"], told["mean"], told["rms"], told["vertices"]) == (0, 0, 0, 24)
    assert facts["distance"]["hausdorff"] == facts["displacement"]["moved"] == 0
    assert all((of["worse"], of["better"], of["same"]) == (0, 0, 6) for of in facts["changes"].values())


def test_S7_a_box_beside_a_larger_one_has_the_distances_of_the_formula() -> None:
    """Corners of the larger are sqrt(3) away from the smaller; those of the smaller 1 from the larger's faces."""
    small = box((2, 2, 2))
    large = replace(box((4, 4, 4)), coordinates=box((4, 4, 4)).coordinates - 1)
    facts = compare(small, large)
    assert not facts["same_connectivity"]
    assert facts["connectivity"] == "27 vertices and 125"
    assert (facts["changes"], facts["displacement"]) == (None, None)
    apart, diagonal = facts["distance"], 12**0.5
    assert apart["a_to_b"] == {
        "vertices": 26, "max": 1, "mean": 1, "rms": 1, "max_percent": pytest.approx(100 / diagonal),
        "mean_percent": pytest.approx(100 / diagonal), "rms_percent": pytest.approx(100 / diagonal),
        "worst": apart["a_to_b"]["worst"],
    }  # fmt: skip
    assert apart["b_to_a"]["max"] == pytest.approx(3**0.5)
    assert apart["hausdorff"] == apart["b_to_a"]["max"]
    assert apart["hausdorff_percent"] == pytest.approx(50)
    by_hand = (
        [1.0] * 54 + [2**0.5] * 36 + [3**0.5] * 8
    )  # of 6 x 9 vertices within faces, 12 x 3 within edges, 8 corners
    assert apart["b_to_a"]["mean"] == pytest.approx(np.mean(by_hand))
    assert apart["b_to_a"]["rms"] == pytest.approx(np.mean(np.square(by_hand)) ** 0.5)
    assert facts["volume_ratio"] == pytest.approx(8)


def test_S7_differences_and_changes_are_those_of_the_metrics_of_both() -> None:
    first = box()
    second = moved(first, 0, (0.3, 0.2, 0.1))
    facts = compare(first, second)
    for metric in METRICS:
        one, other = quality(first, metric), quality(second, metric)
        for name in ("min", "mean", "max"):
            told = [statistics(values, metric)[name] for values in (one, other)]
            assert facts["difference"][metric][name] == pytest.approx(told[1] - told[0], abs=1e-15)
        gain = (other - one) * (1 if METRICS[metric].better == "high" else -1)
        counts = facts["changes"][metric]
        assert counts["worse"] == np.count_nonzero(gain < -1e-9 * np.maximum(abs(one), abs(other))), metric
        assert counts["worse"] + counts["better"] + counts["same"] == 6
        if counts["worse"]:
            assert counts["largest_loss"] == pytest.approx(-gain.min())
            assert counts["cells"][0] == int(gain.argmin())
    way = facts["displacement"]
    assert (way["moved"], way["max"]) == (1, pytest.approx(0.14**0.5))
    assert way["mean_percent"] == pytest.approx(100 * 0.14**0.5 / 24 / 14**0.5)


def test_S7_cells_are_the_same_where_they_name_the_same_vertices_in_order() -> None:
    one = box()
    turned = one.corners.copy()
    turned[:, 2] = turned[[1, 2, 3, 0, 5, 6, 7, 4], 2]
    for other, words in (
        (moved(one, 3, (1, 0, 0)), ""),
        (replace(one, corners=turned), "1 cell of 6 with other corners"),
        (box((2, 3, 1)), "6 cells of 6 with other corners"),
        (box((3, 2, 2)), "24 vertices and 36"),
        (Mesh.from_cells(one.points, one.cells[:5]), "6 cells and 5"),
        (replace(one, kinds=np.full(6, TETRAHEDRON, np.uint8)), "6 cells of 6 with other corners"),
    ):
        assert difference_in_cells(one, other) == words
        assert (fingerprint(one) == fingerprint(other)) == (words == "")


def test_S7_a_change_of_rounding_is_none_and_what_is_infinite_stays_so() -> None:
    first = np.array([1.0, 1.0, 0.5, np.inf, np.inf, 2.0, np.nan, -np.inf])
    second = np.array([1.0 + 1e-12, 1.0 + 1e-6, 0.25, np.inf, 1.0, -np.inf, np.nan, np.inf])
    change = change_of(first, second)
    assert change[[0, 3]].tolist() == [0, 0]
    assert change[1] == pytest.approx(1e-6)
    assert change[[2, 4, 5, 7]].tolist() == [-0.25, -np.inf, -np.inf, np.inf]
    assert np.isnan(change[6])


def test_S7_the_order_of_both_says_the_sign() -> None:
    before = box()
    after = moved(before, 0, (0.3, 0.2, 0.1))
    here = counterpart_of(before, after).change(before, "volume")
    there = counterpart_of(after, before, second=False).change(after, "volume")
    assert here.tolist() == there.tolist()
    assert here[0] < 0 == here[5]
    ways = (
        counterpart_of(before, after).displacement(before),
        counterpart_of(after, before, second=False).displacement(after),
    )
    assert np.allclose(ways[0], ways[1])
    assert ways[0][0].tolist() == pytest.approx([0.3, 0.2, 0.1])


def test_S7_a_reference_surface_has_distances_and_a_volume_if_it_is_closed() -> None:
    mesh = box((2, 2, 2))
    whole = boundary_of(replace(mesh, coordinates=mesh.coordinates * 2))
    facts = compare(mesh, whole)
    assert (facts["b"]["triangles"], facts["b"]["closed"], facts["b"]["area"]) == (
        48,
        True,
        pytest.approx(96),
    )
    assert (facts["difference"], facts["same_connectivity"]) == ({}, False)
    assert facts["volume_ratio"] == pytest.approx(8)
    assert facts["distance"]["b_to_a"]["max"] == pytest.approx(12**0.5)
    open_one = TriangleSurface(whole.points, whole.triangles[:, 1:])
    assert compare(mesh, open_one)["volume_ratio"] is None


def test_S7_a_mesh_gets_what_was_measured_as_attributes() -> None:
    first = box()
    second = moved(first, 0, (-1, 0, 0))
    told = with_comparison(first, second, ["volume"])
    assert set(told.point_data) == {"distance", "displacement"}
    assert told.point_data["displacement"][0].tolist() == [-1, 0, 0]
    assert told.cell_data["change_volume"].tolist() == pytest.approx(
        (quality(second, "volume") - quality(first, "volume")).tolist()
    )
    inner = with_comparison(box((2, 2, 2)), boundary_of(box((2, 2, 2)))).point_data["distance"]
    assert (np.flatnonzero(np.isnan(inner)).tolist(), np.nanmax(inner)) == ([13], 0)


def polydata(surface: TriangleSurface) -> Any:
    """The same triangles for VTK."""
    points, cells, out = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetDataTypeToDouble()
    for point in surface.points.T:
        points.InsertNextPoint(*point)
    for triangle in surface.triangles.T:
        cells.InsertNextCell(3, triangle.tolist())
    out.SetPoints(points)
    out.SetPolys(cells)
    return out


def test_S7_distances_of_published_meshes_are_those_of_vtk() -> None:
    names = [f"2015-practical-hex-mesh--armadillo-stresstest-{state}.mesh" for state in ("in", "out")]
    first, second = (read(file_of(name)) for name in names)
    apart = compare(first, second, ["scaled_jacobian"])["distance"]
    surfaces = boundary_of(first), boundary_of(second)
    for way, (one, other) in (("a_to_b", surfaces), ("b_to_a", surfaces[::-1])):
        implicit = vtk.vtkImplicitPolyDataDistance()
        implicit.SetInput(polydata(other))
        found = np.array([abs(implicit.EvaluateFunction(*point)) for point in one.points.T])
        assert apart[way]["max"] == pytest.approx(found.max(), rel=1e-9)
        assert apart[way]["mean"] == pytest.approx(found.mean(), rel=1e-9)
        assert apart[way]["rms"] == pytest.approx(np.square(found).mean() ** 0.5, rel=1e-9)
