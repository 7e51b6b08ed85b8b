"""Arrows on the shown surface, against faces found one by one and against distances between all pairs."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.cells import FACES
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, VectorField, extract_arrows, extract_surface
from hexalab.surface.records import Arrows
from hexalab.surface.spreading import MOST
from tests.core.surface.shapes import KINDS, grid, grid_cells, grid_points, mesh_of, random_mask, split_grid

Floats = NDArray[np.float64]


def arrows_of(
    mesh: Mesh, shown: NDArray[np.bool_], values: Any, on: Literal["cell", "point"] = "cell"
) -> Arrows:
    return extract_arrows(DrawnMesh(mesh), shown, VectorField(np.asarray(values), on))


def faces_of(mesh: Mesh, shown: NDArray[np.bool_]) -> list[tuple[int, list[int]]]:
    """Faces that one shown cell has, each with its cell and its own corners in order."""
    found = []
    for cell in np.flatnonzero(shown):
        for face in FACES:
            ring = list(dict.fromkeys(mesh.cells[cell, list(face)].tolist()))
            if len(ring) > 2:
                found.append((int(cell), ring))
    often = Counter(frozenset(ring) for _, ring in found)
    return [(cell, ring) for cell, ring in found if often[frozenset(ring)] == 1]


def drawn(mesh: Mesh, place: Any) -> Floats:
    """Drawing coordinates of a place in the file's."""
    return np.asarray((np.asarray(place) - mesh.centre) / mesh.diagonal)


def rows_at(places: Any, wanted: Any) -> NDArray[np.intp]:
    """Which of some places (N, 3) stand where each of others stands."""
    far = np.linalg.norm(np.asarray(wanted, float)[:, None] - np.asarray(places, float), axis=2)
    assert far.min(axis=1).max(initial=0) < 1e-6
    return far.argmin(axis=1)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("on", ["cell", "point"])
def test_R8_every_face_of_a_small_surface_has_the_files_vector(
    kind: str, on: Literal["cell", "point"]
) -> None:
    mesh = split_grid(kind, 3, jitter=0.15)
    shown = random_mask(mesh.cell_count, seed=3)
    count = mesh.cell_count if on == "cell" else mesh.vertex_count
    values = np.random.default_rng(5).normal(size=(count, 3))
    arrows = arrows_of(mesh, shown, values, on)
    expected = faces_of(mesh, shown)
    assert 0 < len(expected) == len(arrows.cells) < MOST
    longest = float(np.linalg.norm(values, axis=1).max())
    assert arrows.longest == pytest.approx(longest)
    middles = [drawn(mesh, mesh.points[ring].mean(axis=0)) for _, ring in expected]
    rows = rows_at(arrows.positions.reshape(-1, 3), middles)
    vectors = arrows.vectors.reshape(-1, 3)
    seen = set()
    for (cell, ring), middle, row in zip(expected, middles, rows, strict=True):
        value = values[cell] if on == "cell" else values[ring].mean(axis=0)
        assert arrows.cells[row] == cell
        assert np.allclose(vectors[row], value / longest, atol=1e-6)
        away = middle - drawn(mesh, mesh.points[np.unique(mesh.cells[cell])].mean(axis=0))
        a, b, c, *d = mesh.points[ring]
        normal = np.cross(c - a, d[0] - b) if d else np.cross(b - a, c - a)
        normal *= np.sign(normal @ away) / np.linalg.norm(normal)
        cosine = value @ normal / np.linalg.norm(value)
        if abs(cosine) > 0.01:
            assert arrows.inward[row] == (cosine < 0)
            seen.add(cosine < 0)
    assert seen == {True, False}
    assert (arrows.not_finite, arrows.zero) == (0, 0)


def box(side: int) -> Mesh:
    return grid(side, side, side, jitter=0.1)


def tilted(side: int) -> Mesh:
    turn = np.linalg.qr(np.random.default_rng(8).normal(size=(3, 3)))[0]
    mesh = grid(side, side, side)
    return replace(mesh, coordinates=np.ascontiguousarray(turn @ mesh.coordinates))


def plate(side: int) -> Mesh:
    points = grid_points(side, side, 1) * [1, 1, 0.05]
    return mesh_of(points, grid_cells(side, side, 1))


def needle(side: int) -> Mesh:
    """Cells in a row that winds through space."""
    mesh = grid(side, 1, 1, turned=False)
    t = mesh.coordinates[0] / side * 6
    middle = np.stack([np.cos(t), np.sin(t), 0.3 * t])
    bent = middle * (1 + 0.01 * mesh.coordinates[1]) + np.stack([0 * t, 0 * t, 0.01 * mesh.coordinates[2]])
    return replace(mesh, coordinates=bent)


def ball(side: int) -> tuple[Mesh, NDArray[np.bool_]]:
    mesh = grid(side, side, side)
    return mesh, np.asarray(((mesh.barycentres - side / 2) ** 2).sum(axis=0) < (0.45 * side) ** 2)


def everything(mesh: Mesh) -> tuple[Mesh, NDArray[np.bool_]]:
    return mesh, np.ones(mesh.cell_count, bool)


SURFACES = {
    "box": lambda: everything(box(24)),
    "tilted": lambda: everything(tilted(34)),
    "plate": lambda: everything(plate(40)),
    "needle": lambda: everything(needle(600)),
    "stairs": lambda: ball(30),
    "dust": lambda: (grid(14, 14, 14), random_mask(14**3, seed=1, share=0.3)),
}


@pytest.mark.parametrize("name", SURFACES)
def test_R8_a_thousand_at_most_spread_evenly(name: str) -> None:
    mesh, shown = SURFACES[name]()
    arrows = arrows_of(mesh, shown, np.ones((mesh.cell_count, 3)))
    surface = extract_surface(DrawnMesh(mesh), shown)
    middles = surface.positions.reshape(-1, 4, 3).mean(axis=1)
    normals = surface.normals.reshape(-1, 4, 4)[:, 0, :3] / 32767
    assert len(middles) > 2 * MOST
    assert 0.35 * MOST < len(arrows.cells) <= MOST
    rows = rows_at(middles, arrows.positions.reshape(-1, 3))
    assert np.array_equal(surface.faces[rows] // 8, arrows.cells)
    assert len(np.unique(rows)) == len(rows)
    apart = np.linalg.norm(middles[rows][:, None] - middles[rows], axis=2)
    alike = normals[rows] @ normals[rows].T > -0.49
    np.fill_diagonal(alike, False)
    least = apart[alike].min()
    away = np.linalg.norm(middles[:, None] - middles[rows], axis=2).min(axis=1).max()
    assert away < 4.5 * least, f"a face is {away:.3f} from any arrow, and two arrows are {least:.3f} apart"


def test_R8_both_sides_of_a_thin_plate_have_arrows() -> None:
    mesh = plate(40)
    arrows = arrows_of(mesh, np.ones(mesh.cell_count, bool), np.ones((mesh.cell_count, 3)))
    height = arrows.positions.reshape(-1, 3)[:, 2]
    upper, lower = (int(np.count_nonzero(height * way > 0.9 * height.max())) for way in (1, -1))
    assert min(upper, lower) > 150 and 0.8 < upper / lower < 1.25


def test_R8_the_same_arrows_every_time_and_most_of_them_after_a_small_change() -> None:
    mesh = box(24)
    values = np.random.default_rng(2).normal(size=(mesh.vertex_count, 3))
    shown = np.ones(mesh.cell_count, bool)
    first, again = (arrows_of(mesh, shown, values, "point") for _ in range(2))
    for name, value in first.arrays().items():
        assert np.array_equal(value, again.arrays()[name]), name
    changed = shown.copy()
    changed[:10] = False
    after = arrows_of(mesh, changed, values, "point")
    before, now = (set(map(tuple, each.positions.reshape(-1, 3).tolist())) for each in (first, after))
    assert before != now and len(before & now) > 0.95 * len(before)


def test_R8_a_slice_does_not_change_the_scale() -> None:
    mesh = grid(3, 1, 1)
    values = [[1, 0, 0], [0, 2, 0], [0, 0, -8]]
    whole = arrows_of(mesh, np.ones(3, bool), values)
    part = arrows_of(mesh, np.array([True, False, False]), values)
    assert (whole.longest, part.longest) == (8, 8)
    assert np.linalg.norm(whole.vectors.reshape(-1, 3), axis=1).max() == pytest.approx(1)
    assert (part.vectors.reshape(-1, 3) == np.float32([0.125, 0, 0])).all() and len(part.cells) == 6


@pytest.mark.parametrize("on", ["cell", "point"])
def test_R8_faces_without_a_finite_vector_and_those_of_zero_are_counted(on: Literal["cell", "point"]) -> None:
    mesh = grid(4, 3, 2)
    shown = random_mask(mesh.cell_count, seed=4, share=0.8)
    count = mesh.cell_count if on == "cell" else mesh.vertex_count
    values = np.random.default_rng(6).normal(size=(count, 3))
    values[1::5, 1] = np.nan
    values[2::9, 2] = -np.inf
    values[3::4] = 0
    arrows = arrows_of(mesh, shown, values, on)
    kinds = Counter[str]()
    for cell, ring in faces_of(mesh, shown):
        value = values[cell] if on == "cell" else values[ring].mean(axis=0)
        kinds["not finite" if not np.isfinite(value).all() else "some" if value.any() else "zero"] += 1
    assert (len(arrows.cells), arrows.not_finite, arrows.zero) == (
        kinds["some"], kinds["not finite"], kinds["zero"],
    )  # fmt: skip
    assert kinds["not finite"] > 5 and kinds["some"] > 5 and (on == "point" or kinds["zero"] > 5)
    finite = np.isfinite(values).all(axis=1)
    assert arrows.longest == pytest.approx(float(np.linalg.norm(values[finite], axis=1).max()))
    assert np.isfinite(arrows.vectors).all()


@pytest.mark.parametrize(
    ("values", "longest", "not_finite", "zero"),
    [
        ([[0, 0, 0]], 0, 0, 6),
        ([[np.nan, 0, 0]], None, 6, 0),
        ([[1e-320, 0, 0]], 1e-320, 0, 0),
        ([[1e308, 1e308, -1e308]], 3**0.5 * 1e308, 0, 0),
        ([[1.7e308, 1.7e308, 0]], None, 0, 0),
        (np.array([[3, 0, 4]], np.uint8), 5, 0, 0),
        (np.array([[2**62, 0, 0]]), 2.0**62, 0, 0),
        (np.array([[True, False, False]]), 1, 0, 0),
    ],
)
def test_R8_vectors_of_any_size_and_number_type(
    values: Any, longest: Any, not_finite: int, zero: int
) -> None:
    arrows = arrows_of(grid(1, 1, 1), np.ones(1, bool), values)
    assert arrows.longest == (longest if longest is None else pytest.approx(longest))
    assert (arrows.not_finite, arrows.zero) == (not_finite, zero)
    if len(arrows.cells):
        assert np.allclose(np.linalg.norm(arrows.vectors.reshape(-1, 3), axis=1), 1, atol=1e-6)


def test_R8_along_a_face_is_not_inward() -> None:
    mesh = grid(6, 6, 6)
    turn = np.linalg.qr(np.random.default_rng(8).normal(size=(3, 3)))[0]
    turned = replace(mesh, coordinates=np.ascontiguousarray(turn @ mesh.coordinates))
    arrows = arrows_of(turned, np.ones(216, bool), np.tile(turn[:, 0], (216, 1)))
    along = arrows.positions.reshape(-1, 3) @ turn[:, 0]
    assert (arrows.inward == (along < along.min() + 1e-6)).all()
    assert arrows.inward.sum() == 36


def test_V1_in_fissures_arrows_stand_on_the_faces_as_they_are_drawn() -> None:
    mesh = grid(3, 3, 3, jitter=0.1)
    shown = random_mask(27, seed=2)
    drawn_mesh = DrawnMesh(mesh)
    field = VectorField(np.ones((27, 3)), "cell")
    arrows = extract_arrows(drawn_mesh, shown, field, gap=0.2)
    surface = extract_surface(drawn_mesh, shown, "fissure", gap=0.2)
    middles = surface.positions.reshape(-1, 4, 3).mean(axis=1)
    rows = rows_at(middles, arrows.positions.reshape(-1, 3))
    assert np.array_equal(surface.faces[rows] // 8, arrows.cells)
    assert len(rows) == len(faces_of(mesh, shown))


def test_R8_nothing_shown_has_no_arrows() -> None:
    arrows = arrows_of(grid(2, 2, 2), np.zeros(8, bool), np.ones((8, 3)))
    assert len(arrows.cells) == len(arrows.positions) == len(arrows.vectors) == len(arrows.inward) == 0
    assert (arrows.not_finite, arrows.zero, arrows.longest) == (0, 0, pytest.approx(3**0.5))
    assert arrows.positions.dtype == arrows.vectors.dtype == np.float32
    assert (arrows.inward.dtype, arrows.cells.dtype) == (np.uint8, np.uint32)
