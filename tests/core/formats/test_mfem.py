"""SPEC R5: MFEM meshes of version 1, straight and curved; others are named."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import Sample, check, mixed

GEOMETRIES = (5, 6, 7, 4)
NORMAL_UP = ((0, 1, 2, 3, 4, 5, 6, 7), (0, 2, 1, 3, 5, 4), (0, 1, 2, 3, 4), (0, 1, 2, 3))
"""MFEM's reference wedge is the prism over the triangle (0, 0), (1, 0), (0, 1): its first three vertices are seen
counter-clockwise from the last three, those of VTK's wedge clockwise."""


def mfem(sample: Sample, vertices: str = "", header: str = "MFEM mesh v1.0") -> bytes:
    """The text of a file, attributes 1, 2, 3, ...; `vertices` in place of the coordinates."""
    rows = [
        " ".join(map(str, [at + 1, GEOMETRIES[kind], *(ids[place] for place in NORMAL_UP[kind])]))
        for at, (kind, ids) in enumerate(sample.cells)
    ]
    places = "3\n" + "\n".join(" ".join(map(repr, point)) for point in sample.points.tolist())
    return (
        f"{header}\n\n# a comment: elements\ndimension\n3\n\nelements\n{len(rows)}\n" + "\n".join(rows)
        + f"\n\nboundary\n1\n7 3 0 1 2 3\n\nvertices\n{len(sample.points)}\n{vertices or places}\n"
    ).encode()  # fmt: skip


def nodes(values: np.ndarray, ordering: int, collection: str) -> str:
    """The section of a curved mesh's nodes: (n, 3) values."""
    table = values if ordering else values.T
    numbers = "\n".join(" ".join(map(repr, row)) for row in table.tolist())
    space = f"FiniteElementSpace\nFiniteElementCollection: {collection}\nVDim: 3\nOrdering: {ordering}\n"
    return f"\nnodes\n{space}\n{numbers}\n"


def test_R5_cells_of_all_kinds() -> None:
    sample = mixed()
    mesh = read_bytes(mfem(sample), "x.mesh")
    check(mesh, sample)
    assert mesh.format == "mfem" and mesh.cell_data["attribute"].tolist() == [1, 2, 3, 4, 5]
    assert mesh.notes == []
    (faces,) = mesh.features
    assert faces.corners.T.tolist() == [[0, 1, 2, 3]] and faces.data["attribute"].tolist() == [7]


@pytest.mark.parametrize("ordering", [0, 1])
@pytest.mark.parametrize(
    ("collection", "more"), [("Linear", 0), ("H1_3D_P1", 0), ("H1_3D_P3", 20), ("Quadratic", 9)]
)
def test_R5_vertices_of_a_curved_mesh_are_its_first_nodes(ordering: int, collection: str, more: int) -> None:
    """MFEM numbers a continuous function's values by vertices, edges, faces, interiors (class H1_FECollection)."""
    sample = mixed()
    values = np.concatenate([sample.points, np.full((more, 3), 99.0)])
    mesh = read_bytes(mfem(sample, nodes(values, ordering, collection)), "x.mesh")
    check(mesh, sample)
    assert any("by their corners" in note for note in mesh.notes) == (more > 0)


def test_R6_version_1_3_and_its_sets() -> None:
    sets = b'\nattribute_sets\n2\n"base" 2 1 2\n"the rest" 3 3 4 5\n\n'
    walls = b'\nbdr_attribute_sets\n1\n"wall" 2 7 8\n\nmfem_mesh_end\n'
    sample = mixed()
    text = mfem(sample, header="MFEM mesh v1.3")
    head, boundary = text.split(b"\nboundary")
    mesh = read_bytes(head + sets + b"boundary" + boundary + walls, "x.mesh")
    check(mesh, sample)
    assert {group.id: group.members.tolist() for group in mesh.groups} == {
        "attribute_set:base": [0, 1],
        "attribute_set:the rest": [2, 3, 4],
    }
    (faces,) = mesh.features
    assert [(group.name, group.members.tolist()) for group in faces.groups] == [("wall", [0])]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b"MFEM mesh v1.0", b"MFEM NC mesh v1.0", ["line 1", "NC mesh v1.0", "Mesh::Print"]),
        (b"MFEM mesh v1.0", b"MFEM NURBS mesh v1.1", ["NURBS mesh v1.1"]),
        (b"MFEM mesh v1.0", b"MFEM INLINE mesh v1.0", ["INLINE mesh v1.0"]),
        (b"dimension\n3", b"dimension\n2", ["line 5", "dimension is 2"]),
        (b"2 5 0", b"2 9 0", ["line 10", "elements"]),
        (b"2 5 0", b"2 5 13", ["line 10", "vertex 13"]),
        (b"elements\n5", b"elements\n4", ["elements should be 4 rows"]),
        (b"vertices\n13\n3", b"vertices\n13\n2", ["2 coordinates"]),
        (b"vertices\n13", b"vertices\n12", ["line 34", "more numbers than it announces"]),
    ],
)
def test_R10_faults_are_told_with_their_line(old: bytes, new: bytes, words: list[str]) -> None:
    text = mfem(mixed())
    assert text.count(old) == 1
    with pytest.raises(MeshReadError) as error:
        read_bytes(text.replace(old, new), "x.mesh")
    assert all(word in str(error.value) for word in words), error.value


def test_R6_nodes_without_vertices_of_their_own_are_refused() -> None:
    sample = mixed()
    text = mfem(sample, nodes(np.zeros((36, 3)), 1, "L2_T1_3D_P1"))
    with pytest.raises(MeshReadError, match="no place of their own"):
        read_bytes(text, "x.mesh")
