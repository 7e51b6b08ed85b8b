"""SPEC R5: decks of random meshes in random layouts are the arrays that they were made of."""

from __future__ import annotations

import random

import numpy as np
import pytest

from hexalab.cells import CORNERS_OF_KIND
from hexalab.formats import read_bytes
from hexalab.formats.assembly import WEDGE_OF_OTHERS
from tests.core.formats.samples import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE

TYPES = {
    HEXAHEDRON: ("C3D8", "C3D8R", "C3D20", "C3D20R"),
    WEDGE: ("C3D6", "C3D15"),
    PYRAMID: ("C3D5",),
    TETRAHEDRON: ("C3D4", "C3D10M", "F3D4"),
}
OWN = {HEXAHEDRON: 8, WEDGE: 6, PYRAMID: 5, TETRAHEDRON: 4}


class Writer:
    """Writes nodes and elements in one of many layouts."""

    def __init__(self, seed: int) -> None:
        self.source = random.Random(seed)
        self.end = self.source.choice(["\n", "\n", "\r\n"])
        self.wild = self.source.random() < 0.7

    def pick(self, *options):
        """The first of the options in a plain deck, any of them in a wild one."""
        return self.source.choice(options) if self.wild else options[0]

    def keyword(self, text: str) -> str:
        """A keyword's line, which may go on over lines."""
        text = self.pick(text, text.lower(), text.replace(", ", f",{self.end} "), text.replace("=", " = "))
        return self.pick("", f"** comment, 1, 2{self.end}") + text + self.end

    def number(self, value: float) -> str:
        """A coordinate, which is read as it was."""
        text = repr(value)
        if value == 0:
            return self.pick(text, "", "0", "0.", "-0.0")
        return self.pick(text, text.replace("e", "D") if "e" in text else text, f"{value:.17E}", f" {text} ")

    def node(self, tag: int, point: list[float]) -> str:
        """A row; zeros at its end may be left out."""
        fields = [self.pick(str(tag), f"  {tag}", f"{tag}."), *map(self.number, point)]
        if self.pick(False, True):
            while len(fields) > 1 and not fields[-1].strip():
                fields.pop()
        return self.pick(", ", ",", " ,\t").join(fields) + self.pick("", ",", ",1.,0.,0.") * (
            len(fields) == 4
        )

    def element(self, tag: int, corners: list[int], size: int, surplus: bool) -> str:
        """A row, which may go on over lines where a comma ends them."""
        nodes = [*corners, *self.source.choices(corners, k=size - len(corners))]
        fields = [str(value) for value in (tag, *nodes)]
        lines = []
        while len(fields) > (step := self.pick(16, 4, 9, 100, 1)):
            lines.append(",".join(fields[:step]) + ",")
            fields = fields[step:]
        fields += ["1", "2"] * surplus
        return self.end.join([*lines, ", ".join(fields) + self.pick("", ",")])

    def lines(self, rows: list[str]) -> str:
        """The rows, with what may stand between them."""
        return "".join(self.pick("", "", "", self.end, f"** 7, 8{self.end}") + row + self.end for row in rows)

    def block(self, tags: list[int], points, cells) -> str:
        """*NODE and *ELEMENT of a scope, the nodes in several parts."""
        out, cut = "", self.source.randrange(len(tags) + 1)
        for part in (slice(0, cut), slice(cut, None)):
            rows = [
                self.node(tag, point) for tag, point in zip(tags[part], points[part].tolist(), strict=True)
            ]
            out += self.keyword(self.pick("*NODE", "*NODE, NSET=all")) + self.lines(rows)
        for kind, numbers, corners in cells:
            name = self.source.choice(TYPES[kind])
            size = int("".join(filter(str.isdigit, name.replace("3D", ""))))
            rows = [
                self.element(number, row, size, self.pick(False, False, True))
                for number, row in zip(numbers, corners, strict=True)
            ]
            out += self.keyword(f"*ELEMENT, TYPE={name}, ELSET=some") + self.lines(rows)
        return out


def random_scope(source: np.random.Generator):
    """Numbers and places of nodes, and elements of some kinds: (kind, numbers, nodes by their numbers)."""
    count = int(source.integers(8, 40))
    gaps = source.random() < 0.5
    tags = source.permutation(count * 7)[:count] + 1 if gaps else np.arange(count) + 1
    points = np.where(
        source.random((count, 3)) < 0.3, 0.0, source.normal(size=(count, 3)) * 10.0 ** source.integers(-9, 9)
    )
    cells, first = [], 1
    for kind in source.permutation(4)[: source.integers(1, 5)].tolist():
        n = int(source.integers(1, 6))
        rows = [source.permutation(tags)[: OWN[kind]].tolist() for _ in range(n)]
        cells.append((kind, list(range(first, first + 3 * n, 3)), rows))
        first += 3 * n
    return tags.tolist(), points, cells


def check_scope(mesh, places, cells, tags, points, scope_cells) -> None:
    """Compare a part of the mesh with the arrays that it was written from."""
    np.testing.assert_array_equal(mesh_numbers(mesh)[places], tags)
    np.testing.assert_array_equal(mesh.points[places], points)
    number = cells.start
    for kind, tags_of_cells, rows in scope_cells:
        for tag, row in zip(tags_of_cells, rows, strict=True):
            own = mesh.corners[list(CORNERS_OF_KIND[kind]), number]
            own = own[list(WEDGE_OF_OTHERS)] if kind == WEDGE else own
            assert mesh.kinds[number] == kind
            assert mesh_numbers(mesh)[own].tolist() == row
            assert ((own >= places.start) & (own < places.stop)).all()
            assert (mesh.cell_numbers[number] if mesh.cell_numbers is not None else number + 1) == tag
            number += 1
    assert number == cells.stop


def mesh_numbers(mesh) -> np.ndarray:
    return mesh.vertex_numbers if mesh.vertex_numbers is not None else np.arange(1, mesh.vertex_count + 1)


def size_of(scope) -> int:
    return sum(len(numbers) for _, numbers, _ in scope[2])


@pytest.mark.parametrize("seed", range(150))
def test_R5_a_flat_deck_in_any_layout(seed: int) -> None:
    scope = random_scope(np.random.default_rng(seed))
    writer = Writer(seed)
    mesh = read_bytes((writer.keyword("*HEADING") + writer.block(*scope)).encode(), "x.inp")
    assert (mesh.vertex_count, mesh.cell_count) == (len(scope[0]), size_of(scope))
    check_scope(mesh, slice(0, mesh.vertex_count), slice(0, mesh.cell_count), *scope)


@pytest.mark.parametrize("seed", range(100))
def test_R5_parts_and_their_instances_in_any_layout(seed: int) -> None:
    """The rotation's truth: a frame (u, v, axis) is taken to (u cos + v sin, v cos - u sin, axis)."""
    source = np.random.default_rng(1000 + seed)
    writer = Writer(seed)
    parts = [random_scope(source) for _ in range(2)]
    text = writer.keyword("*HEADING")
    for number, part in enumerate(parts):
        text += (
            writer.keyword(f"*PART, NAME=part{number}") + writer.block(*part) + writer.keyword("*END PART")
        )
    text += writer.keyword("*ASSEMBLY, NAME=all")
    placed = []
    for number in range(int(source.integers(1, 5))):
        which = int(source.integers(0, 2))
        shift, a, b = source.normal(size=(3, 3))
        angle = float(source.uniform(-400, 400))
        form = int(source.integers(0, 3))
        text += writer.keyword(f"*INSTANCE, NAME=i{number}, PART=part{which}")
        tags, points, cells = parts[which]
        if form:
            text += ", ".join(map(repr, shift.tolist())) + writer.end
            points = points + shift
        if form == 2:
            text += ", ".join(map(repr, [*a.tolist(), *b.tolist(), angle])) + writer.end
            axis = (b - a) / np.linalg.norm(b - a)
            u = np.cross(axis, [1.0, 0, 0])
            u /= np.linalg.norm(u)
            v = np.cross(axis, u)
            c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
            x, y, z = ((points - a) @ np.stack([u, v, axis], axis=1)).T
            points = a + np.outer(x, c * u + s * v) + np.outer(y, c * v - s * u) + np.outer(z, axis)
        text += writer.keyword("*END INSTANCE")
        placed.append((tags, points, cells, shift, form))
    mesh = read_bytes((text + writer.keyword("*END ASSEMBLY")).encode(), "x.inp")
    vertex = cell = 0
    for tags, points, cells, _, _ in placed:
        ends = vertex + len(tags), cell + sum(len(numbers) for _, numbers, _ in cells)
        scale = np.abs(points).max() + 1
        np.testing.assert_allclose(mesh.points[vertex : ends[0]] / scale, points / scale, atol=1e-13)
        found = mesh.points[vertex : ends[0]]
        check_scope(mesh, slice(vertex, ends[0]), slice(cell, ends[1]), tags, found, cells)
        vertex, cell = ends
    assert (mesh.vertex_count, mesh.cell_count) == (vertex, cell)
