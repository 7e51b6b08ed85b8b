"""Gmsh `.msh` 1, 2, 3, 4.0 and 4.1, ASCII and binary (SPEC R5).

Nodes may carry any numbers, with gaps. Cells keep the attributes "physical" (group), "entity" (of the geometry) and
"partition", and what $NodeData and $ElementData hold by name; elements of lower dimension are features. Physical groups
are groups, with their names.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from ..mesh import Mesh
from .assembly import Assembly, CellBlock, check_finite, free_name
from .file import File
from .gmsh1 import Gmsh1
from .gmsh2 import Gmsh2
from .gmsh3 import Gmsh3
from .gmsh4 import LAYOUTS, Gmsh4
from .gmsh_data import names_of_groups, read_data, title_of
from .gmsh_groups import add_features, groups_of_cells
from .gmsh_numbers import Numbers
from .gmsh_parts import Elements, Nodes
from .ids import Numbering, narrowed
from .tokens import RUN_OF_NUMBERS, quoted

Version = Gmsh1 | Gmsh2 | Gmsh3 | Gmsh4

VERSIONS: tuple[tuple[str, Callable[[Numbers, Assembly], Version]], ...] = (
    (r"1(\.0)?", Gmsh1),
    (r"2(\.[012])?", Gmsh2),
    (r"3(\.0)?", Gmsh3),
    (r"4(\.0)?", lambda numbers, out: Gmsh4(numbers, out, LAYOUTS["4.0"])),
    (r"4\.1", lambda numbers, out: Gmsh4(numbers, out, LAYOUTS["4.1"])),
)
"""What a version is called in files, and what reads its sections."""

NODES = (b"$Nodes", b"$NOD", b"$NOE")
ELEMENTS = (b"$Elements", b"$ELM")


def read(file: File) -> Mesh:
    """Read the bytes of a `.msh` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass over the sections."""

    def __init__(self, file: File) -> None:
        self.out = Assembly(file, "msh")
        self.numbers = Numbers(file, self.out.note)
        version = self.numbers.version
        readers = [reader for pattern, reader in VERSIONS if re.fullmatch(pattern, version)]
        if not readers:
            raise self.numbers.error(
                f"the file has version {quoted(version.encode())}, expected 1, 2, 3, 4.0 or 4.1"
            )
        self.version = readers[0](self.numbers, self.out)
        self.nodes: Nodes | None = None
        self.elements: list[Elements] = []
        self.data: list[tuple[str, str, Array, Array]] = []
        self.names: dict[tuple[int, int], str] = {}

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
        text, version = self.numbers.text, self.version
        start = text.position
        mark = (b"$END" if word in (b"$NOD", b"$NOE", b"$ELM") else b"$End") + word[1:]
        if word in NODES:
            if self.nodes is not None:
                raise self.numbers.error(f"a second section {word.decode()}, expected one")
            self.nodes = version.nodes()
            check_finite(
                self.nodes.coordinates,
                lambda message, _: self.numbers.error(f"in {word.decode()}, {message}", start),
            )
        elif word in ELEMENTS:
            self.elements += version.elements()
        elif word == b"$Entities" and isinstance(version, Gmsh3 | Gmsh4):
            version.entities()
        elif word == b"$PartitionedEntities" and isinstance(version, Gmsh4):
            version.partitioned_entities()
        elif word in (b"$NodeData", b"$ElementData"):
            self.values(word)
        else:
            end = text.data.find(mark, text.position)
            if end < 0:
                raise self.numbers.error(f"the file ends before {quoted(mark)[1:-1]}", start)
            self.others(word, text.data[start:end])
            text.position = end
        self.end(word, mark)

    def end(self, word: bytes, mark: bytes) -> None:
        """Take the mark of a section's end; numbers that stand before it are passed over, as by Gmsh.

        Raises
        ------
        MeshReadError
            Something else stands there.
        """
        text = self.numbers.text
        position = text.position
        found = text.word()
        if found == mark:
            return
        end = text.data.find(mark, position)
        surplus = text.data[position:end] if end >= 0 and not self.numbers.binary else b"$"
        if not RUN_OF_NUMBERS.fullmatch(surplus):
            raise self.numbers.error(
                f"{quoted(found)} stands where {quoted(mark)[1:-1]} was expected", text.position - len(found)
            )
        text.position = end + len(mark)
        self.out.note(
            f"{quoted(word)[1:-1]} holds more than it announces, {len(surplus.split()):,} numbers: passed over."
        )

    def others(self, word: bytes, content: bytes) -> None:
        """Take the names of groups; say what is lost of a section that is not read, where a mesh has a use for it."""
        if word == b"$PhysicalNames":
            self.names = names_of_groups(content)
        elif word == b"$ElementNodeData":
            self.out.note(
                f"Values at the nodes of each element were left out: {title_of(content)} ($ElementNodeData)."
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
        parts = [part for part in self.elements if len(part.tags) and part.dimension == 3]
        add_features(self.out, self.elements, numbering, self.names)
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
            ("partition", [p.partitions for p in parts]),
        ):
            values = np.concatenate(owners)[order]
            if values.any():
                self.out.cell_data[name] = narrowed(values)
        self.out.groups += groups_of_cells(parts, place, self.names)
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
