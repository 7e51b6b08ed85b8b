"""SPEC R5: OpenVolumeMesh `.ovm`, written by hand after its file format page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from hexalab.quality import quality
from tests.core.formats.samples import Sample, grid, mixed, signed_volumes

OUTWARD = (
    ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
    ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
)
"""Faces of VTK's cells, counter-clockwise seen from outside."""


CASES = Path(__file__).parent / "cases"


def ovm(sample: Sample, seed: int = 0, tail: str = "", inwards: bool = False) -> str:
    """The sample as an `.ovm` file; edges, faces and the half-faces of a cell begin anywhere and are shuffled.

    Normals of half-faces point outwards, as cinolib writes them, or inwards, as OpenVolumeMesh wants them.
    """
    random = np.random.default_rng(seed)
    edges: dict[tuple[int, int], int] = {}
    faces: dict[frozenset[int], tuple[int, tuple[int, ...]]] = {}
    face_rows, cell_rows = [], []
    for kind, ids in sample.cells:
        half_faces = []
        for local in OUTWARD[kind]:
            loop = tuple(ids[i] for i in local)
            turn = int(random.integers(len(loop)))
            loop = loop[turn:] + loop[:turn]
            known = faces.get(frozenset(loop))
            if known is None:
                half_edges = []
                for a, b in zip(loop, loop[1:] + loop[:1], strict=True):
                    if (b, a) not in edges and (a, b) not in edges:
                        edges[(a, b)] = len(edges)
                    half_edges.append(2 * edges[(a, b)] if (a, b) in edges else 2 * edges[(b, a)] + 1)
                known = faces[frozenset(loop)] = (len(face_rows), loop)
                face_rows.append(half_edges)
            same = any(loop[i:] + loop[:i] == known[1] for i in range(len(loop)))
            half_faces.append(2 * known[0] + (0 if same != inwards else 1))
        cell_rows.append(random.permutation(half_faces).tolist())
    lines = [
        "OVM ASCII",
        "Vertices",
        str(len(sample.points)),
        *(" ".join(map(repr, map(float, p))) for p in sample.points),
    ]
    lines += ["Edges", str(len(edges)), *(f"{a} {b}" for a, b in edges)]
    lines += ["Faces", str(len(face_rows)), *(" ".join(map(str, [len(row), *row])) for row in face_rows)]
    lines += ["Polyhedra", str(len(cell_rows)), *(" ".join(map(str, [len(row), *row])) for row in cell_rows)]
    return "\n".join(lines) + "\n" + tail


@pytest.mark.parametrize("inwards", [False, True])
@pytest.mark.parametrize("inverted", [0, 1, 4])
def test_R5_the_majority_tells_whether_normals_point_inwards(inwards: bool, inverted: int) -> None:
    sample = mixed()
    cells = sample.cells[:4] + grid(3, 1, 1).cells
    apart = [(kind, [i + len(sample.points) for i in ids]) for kind, ids in cells[4:]]
    sample = Sample(np.concatenate([sample.points, np.round(grid(3, 1, 1).points) + 20]), cells[:4] + apart)
    truth = np.array(sample_volumes(sample))
    lines = ovm(sample, inwards=inwards).split("\n")
    start = lines.index("Polyhedra") + 2
    for row in range(start, start + inverted):
        count, *half_faces = lines[row].split()
        lines[row] = " ".join([count, *(str(int(h) ^ 1) for h in half_faces)])
    truth[:inverted] *= -1
    if 2 * inverted > len(truth):
        truth *= -1
    mesh = read_bytes("\n".join(lines).encode(), "x.ovm")
    np.testing.assert_allclose(signed_volumes(mesh), truth, rtol=1e-12)
    turned = (2 * inverted > len(truth)) == inwards
    assert len(mesh.notes) == turned
    if turned:
        assert "normals of half-faces point out of" in mesh.notes[0]


def test_R5_a_tie_is_read_by_the_convention_of_the_format() -> None:
    sample = grid(2, 1, 1)
    sample.points = np.round(sample.points)
    lines = ovm(sample, inwards=True).split("\n")
    count, *half_faces = lines[-2].split()
    lines[-2] = " ".join([count, *(str(int(h) ^ 1) for h in half_faces)])
    mesh = read_bytes("\n".join(lines).encode(), "x.ovm")
    np.testing.assert_allclose(signed_volumes(mesh), [1, -1])


def test_R5_one_cube_of_three_is_inverted() -> None:
    mesh = read(CASES / "ovm-inward-one-inverted.ovm")
    np.testing.assert_allclose(signed_volumes(mesh), [1, 1, -1])
    assert quality(mesh, "scaled_jacobian").round(12).tolist() == [1, 1, -1]


def test_R5_half_faces_of_both_sides_in_one_cell() -> None:
    sample = grid(1, 1, 1)
    sample.points = np.round(sample.points)
    lines = ovm(sample).split("\n")
    count, first, *half_faces = lines[-2].split()
    lines[-2] = " ".join([count, str(int(first) ^ 1), *half_faces])
    mesh = read_bytes("\n".join(lines).encode(), "x.ovm")
    np.testing.assert_allclose(signed_volumes(mesh), 1)
    assert "some from outside: 1" in mesh.notes[0]


@pytest.mark.parametrize("case", ["ovm-ascii.ovm", "ovm-no-ascii.ovm"])
def test_R5_a_header_without_the_word_ascii(case: str) -> None:
    mesh = read(CASES / case)
    np.testing.assert_allclose(signed_volumes(mesh), 1 / 6)
    assert any("read as ASCII" in note for note in mesh.notes) == (case == "ovm-no-ascii.ovm")


def test_R7_six_quadrilaterals_that_are_no_hexahedron_are_left_out() -> None:
    lines = ovm(grid(2, 1, 1)).split("\n")
    count, *half_faces = lines[-2].split()
    lines[-2] = " ".join([count, half_faces[1], *half_faces[1:]])
    mesh = read_bytes("\n".join(lines).encode(), "x.ovm")
    assert mesh.cell_count == 1 and "polyhedra (1)" in mesh.notes[-1]


def same_cells(text: str, sample: Sample) -> None:
    mesh = read_bytes(text.encode(), "x.ovm")
    assert mesh.kinds.tolist() == [kind for kind, _ in sample.cells]
    np.testing.assert_array_equal(mesh.points, sample.points)
    for cell, (_, ids) in enumerate(sample.cells):
        assert set(mesh.cells[cell].tolist()) == set(ids)
    reference = sample_volumes(sample)
    np.testing.assert_allclose(signed_volumes(mesh), reference, rtol=1e-12, atol=1e-12)


def sample_volumes(sample: Sample) -> list[float]:
    out = []
    for kind, ids in sample.cells:
        p = sample.points[ids]
        total = 0.0
        for face in OUTWARD[kind]:
            for i in range(1, len(face) - 1):
                total += np.dot(p[face[0]], np.cross(p[face[i]], p[face[i + 1]])) / 6
        out.append(total)
    return out


@pytest.mark.parametrize("seed", range(5))
def test_R5_all_kinds_from_shuffled_half_faces(seed: int) -> None:
    sample = mixed()
    # planar faces, so that the volume does not depend on how they are split
    same_cells(ovm(Sample(sample.points, sample.cells[:4]), seed), Sample(sample.points, sample.cells[:4]))


def test_R5_a_grid_of_hexahedra() -> None:
    flat = grid(3, 4, 2)
    flat.points = np.round(flat.points)
    same_cells(ovm(flat), flat)


@pytest.mark.parametrize(
    "change",
    [
        lambda s: s.replace("\n", "\r\n"),
        lambda s: s.replace(" ", "\n"),
        lambda s: s.lower(),
        lambda s: s.replace("OVM ASCII", "OVM ASCII # made by hand").replace("Edges", "# here\nEdges"),
        lambda s: s.rstrip(),
        lambda s: "\ufeff" + s,
    ],
)
def test_R5_spellings_of_the_same_file(change) -> None:
    flat = grid(2, 1, 2)
    flat.points = np.round(flat.points)
    same_cells(change(ovm(flat)), flat)


def test_R8_properties_become_attributes() -> None:
    sample = grid(1, 1, 2)
    tail = 'VProp double "height"\n' + "\n".join(str(i / 2) for i in range(12))
    tail += (
        '\nEProp int "skipped"\n'
        + "\n".join("1" for _ in range(20))
        + '\nCProp vec3d "flow it"\n1 2 3\n4 5 6\n'
    )
    tail += 'CProp string "names"\nCProposal\nb\nCProp int "chart"\n7\n-8\n'
    mesh = read_bytes(ovm(sample, tail=tail).encode(), "x.ovm")
    assert mesh.point_data["height"].tolist() == [i / 2 for i in range(12)]
    assert mesh.cell_data["flow it"].tolist() == [[1, 2, 3], [4, 5, 6]]
    assert mesh.cell_data["chart"].tolist() == [7, -8]


def test_R7_other_polyhedra_are_left_out() -> None:
    text = ovm(grid(1, 1, 2)).split("\n")
    at = text.index("Polyhedra")
    text[at + 2] = "5 " + " ".join(text[at + 2].split()[1:6])
    mesh = read_bytes("\n".join(text).encode(), "x.ovm")
    assert mesh.cell_count == 1 and "polyhedra (1)" in mesh.notes[-1]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("OVM ASCII", "OVM BINARY", ["‘BINARY’", "expected ASCII"]),
        ("OVM ASCII", "OMV", ["OVM"]),
        ("Edges\n12", "Edges\n13", ["line 26", "‘Faces’"]),
        ("Edges\n12", "Edges\n12000000000", ["line 13", "12000000000 edges"]),
        ("Edges", "Hedges", ["Edges was expected"]),
        ("Faces\n6", "Faces\n7", ["Faces should be 7 rows"]),
        ("Faces\n6\n4 ", "Faces\n6\n4 99", ["line 28", "half-edge"]),
        ("Polyhedra\n1\n6 ", "Polyhedra\n1\n6 99", ["line 36", "half-face"]),
        ("Polyhedra\n1\n6 ", "Polyhedra\n1\n7 ", ["does not fit"]),
        ("Polyhedra\n1\n6 ", "Polyhedra\n1\n-6 ", ["does not fit"]),
        ("Vertices\n8\n", "Vertices\n8\nnan ", ["vertex 1 is nan"]),
    ],
)  # fmt: skip
def test_R10_bad_ovm_files(old: str, new: str, words: list[str]) -> None:
    text = ovm(grid(1, 1, 1))
    assert old in text
    with pytest.raises(MeshReadError) as caught:
        read_bytes(text.replace(old, new, 1).encode(), "bad.ovm")
    for word in ["bad.ovm", *words]:
        assert word in str(caught.value)
