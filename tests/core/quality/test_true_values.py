"""SPEC Q7, Q8: no unit, no place; new metrics beside Gmsh and VTK."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from hexalab.cells import HEXAHEDRON, KINDS, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.diagnosis import diagnose
from hexalab.filters.plane import barycentre_places, plane, unit
from hexalab.mesh import Mesh
from hexalab.quality import METRICS, certify, histogram, quality_many, statistics
from hexalab.surface import DrawnMesh
from tests.core.quality.verdict import CUBE, IDEAL, mesh_of, samples
from tests.tools import tool

gmsh, vtk = tool("gmsh"), tool("vtk")

POWERS = st.integers(-1000, 1000)
KINDS_ALL = (HEXAHEDRON, WEDGE, PYRAMID, TETRAHEDRON)


def shaken(kind: int, seed: int, count: int = 6) -> np.ndarray:
    """Cells of one kind, some inverted, two at one place, on whole multiples of 2^-20: sums of them are exact."""
    random = np.random.default_rng(seed)
    cells = IDEAL[kind] + random.uniform(-0.4, 0.4, (count, *IDEAL[kind].shape))
    cells[-1] = cells[0]
    return np.round(cells * 2**20) / 2**20


def everything(mesh: Mesh) -> list[tuple[str, int, list[int]]]:
    """What is told and drawn of a mesh without a unit: findings, validity, what a plane hides, where vertices are."""
    found = [(one.id, one.count, [*one.cells.tolist(), *one.vertices.tolist()]) for one in diagnose(mesh)]
    assert "coincident_vertices" in [id for id, _, _ in found]
    found.append(("validity", 0, certify(mesh).state.tolist()))
    near, _ = mesh.within_reach
    found.append(("drawn", 0, DrawnMesh(near).coordinates.tolist()))
    for offset in (0.25, 0.5):
        hidden = plane(barycentre_places(near.barycentres, [1, 2, -1]), offset)
        found.append(("plane", 0, np.flatnonzero(hidden).tolist()))
    return found


def assert_alike(mesh: Mesh, other: Mesh, power: int) -> None:
    """All metrics are the same but for their unit, which is 2^power; so is what is found."""
    before, after = quality_many(mesh), quality_many(other)
    for id, metric in METRICS.items():
        with np.errstate(over="ignore", under="ignore"):
            expected = np.ldexp(before[id], metric.length_power * power)
        np.testing.assert_array_equal(after[id], expected, err_msg=id)
    assert everything(other) == everything(mesh)


@settings(max_examples=40, deadline=None)
@given(kind=st.sampled_from(KINDS_ALL), seed=st.integers(0, 2**32), power=POWERS)
def test_Q7_a_power_of_two_changes_nothing_but_units(kind: int, seed: int, power: int) -> None:
    cells = shaken(kind, seed)
    assert_alike(mesh_of(cells, kind), mesh_of(np.ldexp(cells, power), kind), power)


@settings(max_examples=40, deadline=None)
@given(kind=st.sampled_from(KINDS_ALL), seed=st.integers(0, 2**32), far=st.integers(0, 2**24))
def test_Q7_a_place_a_million_diagonals_away_changes_nothing(kind: int, seed: int, far: int) -> None:
    """Places and moves have so few binary digits that no coordinate is rounded: what is left is our own rounding."""
    cells = shaken(kind, seed)
    before, after = (
        quality_many(mesh_of(cells, kind)),
        quality_many(mesh_of(cells + far * np.array([1.0, -1, 1]), kind)),
    )
    for id in METRICS:
        np.testing.assert_allclose(after[id], before[id], rtol=1e-12, atol=1e-13, err_msg=id)
    assert [one.id for one in diagnose(mesh_of(cells + far, kind))] == [
        one.id for one in diagnose(mesh_of(cells, kind))
    ]


@pytest.mark.parametrize("scale", [1e-9, 1e-6, 1e9])
def test_Q7_cells_of_any_size_are_measured_alike(scale: float) -> None:
    cells = np.concatenate([samples()["sound"], samples()["wild"]])
    before, after = quality_many(mesh_of(cells)), quality_many(mesh_of(cells * scale))
    for id, metric in METRICS.items():
        np.testing.assert_allclose(
            after[id],
            before[id] * scale**metric.length_power,
            rtol=1e-7,
            atol=0 if metric.length_power else 1e-9,
        )


def test_Q7_micrometres_in_metres() -> None:
    """Cells of a micrometre have an Oddy, sizes and a nodal ratio."""
    values = quality_many(mesh_of(np.stack([CUBE, CUBE * 2, CUBE * [1, 1, 2]]) * 1e-6))
    assert values["oddy"].tolist() == pytest.approx(
        [0, 0, quality_many(mesh_of(CUBE[None] * [1, 1, 2]))["oddy"][0]]
    )
    assert values["nodal_jacobian_ratio"].tolist() == pytest.approx([1, 1, 1])
    assert (values["relative_size_squared"] > 0).all() and (values["shear_and_size"] > 0).all()


@pytest.mark.parametrize("kind", KINDS_ALL, ids=KINDS)
@pytest.mark.parametrize("sample", ["sound", "wild", "inverted", "tiny", "off the origin"])
def test_Q8_sicn_is_gmshs(kind: int, sample: str) -> None:
    """The triangle 0 1 2 of Gmsh's wedge is seen from the other side than VTK's."""
    cells = samples(kind, 100)[sample]
    count, corners = cells.shape[:2]
    order = (0, 2, 1, 3, 5, 4) if kind == WEDGE else range(corners)
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.model.add("cells")
        volume, numbers = gmsh.model.addDiscreteEntity(3), np.arange(1, count * corners + 1)
        gmsh.model.mesh.addNodes(3, volume, numbers, cells.reshape(-1))
        of_cells = numbers.reshape(count, corners)[:, list(order)]
        tags = np.arange(1, count + 1)
        gmsh.model.mesh.addElementsByType(volume, (5, 6, 7, 4)[kind], tags, of_cells.ravel())
        theirs = gmsh.model.mesh.getElementQualities(tags, "minSICN")
    finally:
        gmsh.finalize()
    np.testing.assert_allclose(
        quality_many(mesh_of(cells, kind), ["sicn"])["sicn"], theirs, rtol=1e-9, atol=1e-12
    )


QUADS = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def of_faces(cells: np.ndarray, name: str) -> np.ndarray:
    """(C, 6) what vtkMeshQuality tells of the faces of hexahedra; its warpage is what the manual subtracts from 1."""
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    points.SetData(numpy_to_vtk(cells.reshape(-1, 3).copy(), deep=1))
    grid.SetPoints(points)
    for cell in range(len(cells)):
        for quad in QUADS:
            grid.InsertNextCell(9, 4, [8 * cell + corner for corner in quad])
    measure = vtk.vtkMeshQuality()
    measure.SetInputData(grid)
    getattr(measure, f"SetQuadQualityMeasureTo{name}")()
    measure.Update()
    return vtk_to_numpy(measure.GetOutput().GetCellData().GetArray("Quality")).reshape(-1, 6)


@pytest.mark.parametrize("sample", ["sound", "wild", "off the origin"])
def test_Q8_faces_are_verdicts_quadrilaterals(sample: str) -> None:
    cells = samples(count=100)[sample]
    values = quality_many(mesh_of(cells), ["warpage", "smallest_face_angle", "largest_face_angle"])
    np.testing.assert_allclose(
        values["warpage"], 1 - of_faces(cells, "Warpage").min(axis=1), rtol=1e-9, atol=1e-12
    )
    np.testing.assert_allclose(
        values["smallest_face_angle"], of_faces(cells, "MinAngle").min(axis=1), rtol=1e-9
    )
    np.testing.assert_allclose(
        values["largest_face_angle"], of_faces(cells, "MaxAngle").max(axis=1), rtol=1e-9
    )


@pytest.mark.parametrize("length", [1e-320, 1e-200, 1e-10, 1.0, 1e200, 1e308])
def test_F1_a_normal_of_any_length_is_a_direction(length: float) -> None:
    np.testing.assert_allclose(unit([length, 0, -length]), np.array([1, 0, -1]) / np.sqrt(2), rtol=1e-3)


def test_Q3_values_over_the_whole_range_of_doubles() -> None:
    values = 1.7e308 * np.linspace(-1, 1, 101)
    told = statistics(values)
    assert told["min"] == -1.7e308 and told["max"] == 1.7e308 and told["variance"] is None
    assert told["mean"] == pytest.approx(0, abs=1e294) and told["median"] == pytest.approx(0, abs=1e294)
    edges, counts = histogram(values, -1.7e308, 1.7e308, 10)
    assert np.isfinite(edges).all() and counts.sum() == 101 and counts.max() <= 11
    edges, counts = histogram(np.array([5e-324, 1e-323, 1.5e-323]), 5e-324, 1.5e-323, 2)
    assert counts.tolist() == [1, 2]
    metric = METRICS["volume"]
    assert metric.normalise(values, -1.7e308, 1.7e308)[[0, 50, 100]].tolist() == pytest.approx([0, 0.5, 1])


def test_Q3_rounding_is_not_outside_of_the_acceptable_range() -> None:
    values = np.array([1 + 4e-16, 0.5 - 1e-16, 0.499])
    assert statistics(values, "scaled_jacobian")["outside_acceptable"] == 1
    assert statistics(np.array([-1e-300, 1]), "volume")["outside_acceptable"] == 1
