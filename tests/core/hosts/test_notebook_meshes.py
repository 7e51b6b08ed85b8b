"""What `hexalab.show` takes. SPEC A6."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab.hosts.notebook.meshes import offer_of
from hexalab.hosts.notebook.pieces import Pieces
from hexalab.hosts.notebook.still import still

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")
POINTS = np.array([(x, y, z) for x in (0, 1, 2) for y in (0, 1) for z in (0, 1)], dtype=float)
CELLS = np.array([[0, 4, 6, 2, 1, 5, 7, 3], [4, 8, 10, 6, 5, 9, 11, 7]])


def volume(offer: Any) -> float:
    """Of unit cubes: how many there are."""
    return float(hexalab.quality(offer.mesh(), "volume").sum())


def test_A6_a_mesh_and_arrays_and_a_path_are_taken(tmp_path: Path):
    mesh = hexalab.Mesh.from_cells(POINTS, CELLS, name="two")
    assert (offer_of(mesh).name, volume(offer_of(mesh))) == ("two", 2)
    assert volume(offer_of((POINTS, CELLS))) == 2
    hexalab.write(mesh, tmp_path / "two.vtk")
    for path in (tmp_path / "two.vtk", str(tmp_path / "two.vtk")):
        offer = offer_of(path)
        assert (offer.name, volume(offer)) == ("two.vtk", 2)
        assert len(offer.hasher()()) == 64


def test_A6_a_mesh_of_meshio_is_taken_with_its_attributes():
    meshio = pytest.importorskip("meshio")
    wedge = np.array([[0, 4, 2, 1, 5, 3]])
    given = meshio.Mesh(
        POINTS,
        [("hexahedron", CELLS[1:]), ("wedge", wedge)],
        point_data={"height": POINTS[:, 2]},
        cell_data={"load": [np.array([3.0]), np.array([4.0])]},
    )
    mesh = offer_of(given).mesh()
    assert mesh.kind_counts == {"hexahedron": 1, "wedge": 1}
    assert set(mesh.cell_data) == {"load"} and set(mesh.point_data) == {"height"}
    assert sorted(mesh.cell_data["load"].ravel()) == [3, 4]


def test_R12_sets_and_lower_cells_of_meshio_become_groups_and_features():
    meshio = pytest.importorskip("meshio")
    given = meshio.Mesh(
        POINTS,
        [("quad", CELLS[:1, :4]), ("hexahedron", CELLS)],
        cell_sets={"right": [np.array([], dtype=int), np.array([1])], "floor": [np.array([0]), None]},
        point_sets={"fixed": np.array([0, 3])},
    )
    mesh = offer_of(given).mesh()
    assert {group.id: group.members.tolist() for group in mesh.groups} == {
        "set:right": [1],
        "set:fixed": [0, 3],
    }
    (faces,) = mesh.features
    assert faces.corners.T.tolist() == [CELLS[0, :4].tolist()]
    assert [(group.name, group.members.tolist()) for group in faces.groups] == [("floor", [0])]
    assert not mesh.cell_data and not given.cell_data, "what was given stays as it is"


def test_A6_a_mesh_of_pyvista_is_taken_with_its_attributes():
    pyvista = pytest.importorskip("pyvista")
    cells = np.hstack([np.full((2, 1), 8), CELLS]).ravel()
    grid = pyvista.UnstructuredGrid(cells, np.full(2, 12), POINTS)
    grid.cell_data["load"] = [3.0, 4.0]
    mesh = offer_of(grid).mesh()
    assert (mesh.cell_count, list(mesh.cell_data)) == (2, ["load"])
    assert volume(offer_of(grid)) == 2
    box = pyvista.ImageData(dimensions=(4, 3, 2))
    assert offer_of(box).mesh().cell_count == 6, "whatever can be cast to an unstructured grid"


@pytest.mark.parametrize(
    ("thing", "said"),
    [
        (3, "found builtins.int, expected a Mesh, a path"),
        ((POINTS[:, :2], CELLS), "points: found an array of shape (12, 2), expected (V, 3)"),
        ((POINTS, CELLS[:, :4]), "cells: found an array of shape (2, 4), expected (C, 8)"),
        ((POINTS, CELLS / 2), "cells: found numbers of type float64, expected integers"),
        ("missing.mesh", "missing.mesh: the file can't be read"),
    ],
)
def test_A6_what_is_not_taken_is_said(thing: Any, said: str):
    with pytest.raises(hexalab.HexaLabError) as error:
        offer_of(thing)
    assert said in str(error.value)


def test_A6_pieces_are_put_together_each_message_by_itself():
    pieces = Pieces()

    def add(view: str, number: int, part: int, parts: int, data: bytes, kind: str = "ask") -> Any:
        message = {"view": view, "kind": kind, "number": number, "part": part, "parts": parts}
        return pieces.add(message, [memoryview(data)])

    assert add("a", 1, 0, 1, b"whole") == b"whole"
    assert add("a", 2, 0, 2, b"first ") is None
    assert add("b", 2, 0, 2, b"other ") is None
    assert add("a", 2, 0, 2, b"a picture's ", kind="still") is None
    assert add("a", 2, 1, 2, b"second") == b"first second"
    assert add("a", 2, 1, 2, b"end", kind="still") == b"a picture's end"
    pieces.forget("b")
    assert add("b", 2, 0, 2, b"anew ") is None
    assert add("b", 2, 1, 2, b"whole") == b"anew whole"
    assert pieces.add({"view": "a", "kind": "ask", "number": 3}, []) == b""


def test_A6_pieces_come_in_any_order():
    """Of marimo's requests, one for each piece, the small last one may overtake."""
    for order in itertools.permutations(range(3)):
        pieces = Pieces()
        told = [
            pieces.add({"view": "a", "kind": "ask", "number": 1, "part": n, "parts": 3}, [bytes((n, n + 3))])
            for n in order
        ]
        assert told == [None, None, bytes((0, 3, 1, 4, 2, 5))]


def test_A6_the_still_picture_can_hold_no_markup_of_the_mesh():
    page = still(b"png", 'a "<script>" & b', 300)
    assert "<script>" not in page and "&lt;script&gt;" in page and "data:image/png;base64,cG5n" in page
    assert "<img" not in still(b"", "a", 300)


def test_A6_without_the_widget_s_packages_show_says_what_to_install(monkeypatch: pytest.MonkeyPatch):
    for name in [name for name in sys.modules if name.startswith("hexalab.hosts.notebook")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "anywidget", None)
    with pytest.raises(ImportError, match=r"hexalab\[notebook\]"):
        hexalab.show((POINTS, CELLS))
