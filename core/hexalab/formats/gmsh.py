"""Gmsh `.msh` 2.2 and 4.1, ASCII and binary (SPEC R5).

Nodes may carry any numbers, with gaps. Cells keep the attributes "physical" (group) and "entity" (of the
geometry), and what $NodeData and $ElementData hold by name.
"""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite, free_name
from .file import File
from .gmsh2 import Gmsh2
from .gmsh4 import Gmsh4
from .gmsh_data import read_data
from .gmsh_numbers import Numbers
from .gmsh_parts import Elements, Nodes
from .ids import Numbering
from .tokens import quoted


def read(file: File) -> Mesh:
    """Read the bytes of a `.msh` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the sections."""

    def __init__(self, file: File) -> None:
        self.numbers = Numbers(file)
        self.out = Assembly(file, "msh")
        version = self.numbers.version
        if version not in ("2", "2.0", "2.1", "2.2", "4.1"):
            raise self.numbers.error(f"the file has version {quoted(version.encode())}, expected 2.2 or 4.1")
        self.version: Gmsh2 | Gmsh4 = Gmsh2(self.numbers) if version.startswith("2") else Gmsh4(self.numbers)
        self.nodes: Nodes | None = None
        self.elements: list[Elements] = []
        self.data: list[tuple[str, str, Array, Array]] = []

    def read(self) -> Mesh:
        """Read section after section; cells come in the order of the file, whatever their types.

        Raises
        ------
        MeshReadError
            Something stands where a section should begin, or there are no nodes.
        """
        text = self.numbers.text
        while word := text.word():
            if not word.startswith(b"$"):
                raise self.numbers.error(
                    f"{quoted(word)} stands where a section such as $Nodes was expected",
                    text.position - len(word),
                )
            self.section(word)
        if self.nodes is None:
            raise self.numbers.error("the file has no section $Nodes")
        self.out.coordinates = self.nodes.coordinates
        self.out.vertex_numbers = self.nodes.tags
        self.cells(Numbering(self.nodes.tags))
        return self.out.mesh()

    def section(self, word: bytes) -> None:
        """Read or skip a section whose name has just been taken."""
        text = self.numbers.text
        start = text.position
        if word == b"$Nodes":
            if self.nodes is not None:
                raise self.numbers.error("a second section $Nodes, expected one")
            self.nodes = self.version.nodes()
            check_finite(
                self.nodes.coordinates, lambda message, _: self.numbers.error(f"in $Nodes, {message}", start)
            )
        elif word == b"$Elements":
            self.elements += self.version.elements(self.out)
        elif word == b"$Entities" and isinstance(self.version, Gmsh4):
            self.version.entities()
        elif word in (b"$NodeData", b"$ElementData"):
            self.values(word)
        else:
            end = text.data.find(b"$End" + word[1:], text.position)
            if end < 0:
                raise self.numbers.error(f"the file ends before $End{word[1:40].decode('latin-1')}", start)
            text.position = end
        end_word = text.word()
        if end_word != b"$End" + word[1:]:
            raise self.numbers.error(
                f"{quoted(end_word)} stands where $End{word[1:40].decode('latin-1')} was expected",
                text.position - len(end_word),
            )

    def values(self, word: bytes) -> None:
        """Read a section of values; what can't be read costs the values, not the mesh."""
        text = self.numbers.text
        end = text.data.find(b"$End" + word[1:], text.position)
        try:
            self.data.append(read_data(self.numbers, word))
        except MeshReadError as error:
            if end < 0:
                raise
            text.position = end
            self.out.note(f"Values were left out. {error}.")

    def cells(self, numbering: Numbering) -> None:
        """Turn elements into blocks of cells and hand over the attributes."""
        parts = [part for part in self.elements if len(part.tags)]
        if not parts:
            return
        ordinals = np.concatenate([part.ordinals for part in parts])
        place = np.argsort(np.argsort(ordinals, kind="stable"), kind="stable")
        start = 0
        for part in parts:
            corners = numbering.places(part.corners)
            self.check(part, corners)
            where = place[start : start + len(part.tags)]
            start += len(part.tags)
            self.out.blocks.append(CellBlock(part.kind, corners, self.locate, cells=where, numbers=part.tags))
        order = np.argsort(place)
        tags = np.concatenate([part.tags for part in parts])[order]
        for name, owners in (
            ("entity", [p.entities for p in parts]),
            ("physical", [p.physicals for p in parts]),
        ):
            values = np.concatenate(owners)[order]
            if values.any():
                self.out.cell_data[name] = values
        cells = Numbering(tags)
        for target, name, numbers, rows in self.data:
            on_cells = target == "$ElementData"
            entries = cells if on_cells else numbering
            arrays = self.out.cell_data if on_cells else self.out.point_data
            at = entries.places(numbers)
            out = np.full((entries.count, rows.shape[1]), np.nan)
            out[at[at >= 0]] = rows[at >= 0]
            arrays[free_name(arrays, name)] = out

    def locate(self, message: str, _cell: int, _corner: int) -> MeshReadError:
        """An error without a line; nodes that are missing have been found in `check`, with theirs."""
        return self.numbers.error(message)

    def check(self, part: Elements, corners: Array) -> None:
        """Raise if an element refers to a node that the file does not have."""
        missing = corners < 0
        if not missing.any():
            return
        cell = int(np.argmax(missing.any(axis=0)))
        corner = int(np.argmax(missing[:, cell]))
        raise self.numbers.error(
            f"element {int(part.tags[cell])} refers to node {int(part.corners[corner, cell])}: it is missing",
            part.begin,
        )
