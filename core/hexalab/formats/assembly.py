"""What every reader ends with: blocks of cells and their arrays become one checked mesh."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats, Ids
from ..cells import COLLAPSE, HEXAHEDRON, KINDS
from ..errors import MeshReadError, NoCellsError
from ..groups import Group
from ..mesh import Mesh
from .feature_blocks import FeatureBlock, joined_features, named_apart
from .file import File
from .group_arrays import taken_groups
from .ids import LARGEST_ID

WEDGE_OF_OTHERS = (0, 2, 1, 3, 5, 4)
"""VTK's wedge from the corners of Medit, Gmsh and Abaqus, which see triangle 0 1 2 from the other side."""


@dataclass
class CellBlock:
    """Cells of one kind, in file order.

    Parameters
    ----------
    kind : int
        Index into KINDS.
    corners : (8, n) or (k, n) integers
        Zero-based vertex ids; k rows are the kind's own corners in VTK's order, not yet collapsed.
    locate : callable
        Makes the error for a message about the corner of a cell: `locate(message, cell, corner)`; the cell is
        counted within the block, the corner is one of its own.
    base : int
        What the file counts vertices from, for messages.
    cells : (n,) ids, optional
        Their places in the mesh's order of cells, where blocks interleave; default: after the blocks before.
    numbers : (n,) integers, optional
        The file's own numbers of the cells.
    """

    kind: int
    corners: Ids
    locate: Callable[[str, int, int], MeshReadError]
    base: int = 0
    cells: Array | None = None
    numbers: Array | None = None


@dataclass
class Assembly:
    """Gathers what a reader finds.

    Parameters
    ----------
    file : File
        The file.
    format_id : str
        Row of the registry.
    first_number : int
        What cells and vertices are counted from where the file gives them no numbers.
    """

    file: File
    format_id: str
    coordinates: Floats | None = None
    vertex_numbers: Array | None = None
    blocks: list[CellBlock] = field(default_factory=list)
    point_data: dict[str, Array] = field(default_factory=dict)
    cell_data: dict[str, Array] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    left_out: dict[str, int] = field(default_factory=dict)
    groups: list[Group] = field(default_factory=list)
    features: list[FeatureBlock] = field(default_factory=list)
    first_number: int = 1
    cell_numbers: Array | None = None

    def note(self, sentence: str) -> None:
        """Add a note, once."""
        if sentence not in self.notes:
            self.notes.append(sentence)

    def leave_out(self, kind: str, count: int) -> None:
        """Count cells that are not of a volumetric kind that can be kept."""
        if count:
            self.left_out[kind] = self.left_out.get(kind, 0) + count

    def add_piece(self, block: CellBlock, vertex_count: int, first_vertex: int, first_cell: int) -> None:
        """Add a block whose vertices and cells are counted within a piece of the mesh."""
        if block.corners.shape[1]:
            check_ids(block, vertex_count)
        block.corners += np.int32(first_vertex)
        if block.cells is not None:
            block.cells = block.cells + first_cell
        self.blocks.append(block)

    def mesh(self) -> Mesh:
        """Check and join everything.

        Raises
        ------
        MeshReadError
            No vertices, a vertex id out of range.
        NoCellsError
            No cells.
        """
        if self.coordinates is None:
            raise self.file.error("no vertices were found, so there is no mesh to show")
        vertex_count = self.coordinates.shape[1]
        if vertex_count > LARGEST_ID:
            raise self.file.error(f"{vertex_count} vertices are more than 2,147,483,646")
        blocks = [block for block in self.blocks if block.corners.shape[1]]
        if not blocks:
            raise self.no_cells(self.coordinates)
        for block in blocks:
            check_ids(block, vertex_count)
        if self.left_out:
            self.note(
                f"Left out, as they are no volumetric cells that can be shown: {self.counts_left_out()}."
            )
        corners, kinds = joined(blocks)
        point_data = fitting(self.point_data, vertex_count)
        cell_data = fitting(self.cell_data, len(kinds))
        groups = [*self.groups, *taken_groups(cell_data, "cell"), *taken_groups(point_data, "vertex")]
        return Mesh(
            self.coordinates,
            corners,
            kinds,
            point_data=point_data,
            cell_data=cell_data,
            name=self.file.name,
            format=self.format_id,
            notes=self.notes,
            vertex_numbers=self.own_numbers(self.vertex_numbers, vertex_count),
            cell_numbers=self.own_numbers(
                joined_numbers(blocks) if self.cell_numbers is None else self.cell_numbers, len(kinds)
            ),
            first_number=self.first_number,
            groups=tuple(named_apart(groups)),
            features=joined_features(self.features, vertex_count, self.note),
        )

    def own_numbers(self, numbers: Array | None, count: int) -> NDArray[np.int64] | None:
        """The numbers if there is one for each entry and they say more than the rows, counted on, do; else None."""
        if numbers is None or len(numbers) != count:
            return None
        if (numbers == np.arange(self.first_number, self.first_number + count)).all():
            return None
        return numbers.astype(np.int64)

    def no_cells(self, coordinates: Floats) -> NoCellsError:
        """The error for a file without volumetric cells, with its vertices and features."""
        others = [f"Left out, as they are no faces: {self.counts_left_out()}."] if self.left_out else []
        message = self.nothing_to_show()
        return NoCellsError(
            message,
            file=self.file.name,
            coordinates=coordinates,
            features=joined_features(self.features, coordinates.shape[1], self.note),
            notes=self.notes + others,
            format=self.format_id,
        )

    def nothing_to_show(self) -> str:
        """The sentence for a file without volumetric cells."""
        wanted = "expected hexahedra, wedges, pyramids or tetrahedra"
        for block in self.features:
            self.leave_out(block.called, block.count)
        if not self.left_out:
            return f"the file has no cells: {wanted}" + (
                f" ({' '.join(self.notes[:2])})" if self.notes else ""
            )
        return f"the file has no volumetric cells, only {self.counts_left_out()}: {wanted}"

    def counts_left_out(self) -> str:
        """What is left out with its numbers: "lines (2), triangles (1)"."""
        return ", ".join(f"{kind} ({count:,})" for kind, count in sorted(self.left_out.items()))


def check_ids(block: CellBlock, vertex_count: int) -> None:
    """Raise MeshReadError if a corner is no vertex of the mesh."""
    if in_range(block.corners, vertex_count):
        return
    wrong = (block.corners < 0) | (block.corners >= vertex_count)
    cell = int(np.argmax(wrong.any(axis=0)))
    corner = int(np.argmax(wrong[:, cell]))
    found = int(block.corners[corner, cell]) + block.base
    expected = f"expected {block.base} to {vertex_count - 1 + block.base}"
    # ids that int32 does not hold have been moved to its ends: the file's own number is not known here
    name = f"vertex {found}" if abs(found) < LARGEST_ID - 1 else "a vertex of more than nine digits"
    raise block.locate(
        f"a {KINDS[block.kind]} refers to {name}, which is not there: {expected}", cell, corner
    )


def in_range(corners: Array, vertex_count: int) -> bool:
    """Whether all ids are those of vertices."""
    if corners.dtype == np.int32 and corners.flags.c_contiguous:
        return bool(corners.view(np.uint32).max() < vertex_count)  # the negative ones are the largest
    return bool(corners.min() >= 0 and corners.max() < vertex_count)


def joined(blocks: list[CellBlock]) -> tuple[Ids, NDArray[np.uint8]]:
    """(8, C) int32 corners of all blocks, collapsed, and (C,) kinds."""
    count = sum(block.corners.shape[1] for block in blocks)
    kinds = np.full(count, blocks[0].kind, dtype=np.uint8)
    if len(blocks) == 1 and blocks[0].kind == HEXAHEDRON:
        return np.ascontiguousarray(blocks[0].corners, dtype=np.int32), kinds
    out = np.empty((8, count), dtype=np.int32)
    start = 0
    for block in blocks:
        part: slice | Array = slice(start, start + block.corners.shape[1])
        start += block.corners.shape[1]
        if block.cells is not None:
            part = block.cells
        kinds[part] = block.kind
        for place, own in enumerate(COLLAPSE[block.kind]):
            out[place, part] = block.corners[own]
    return out, kinds


def joined_numbers(blocks: list[CellBlock]) -> Array | None:
    """(C,) the file's own numbers of all cells, or None if a block has none."""
    numbers = [block.numbers for block in blocks if block.numbers is not None]
    if len(numbers) < len(blocks):
        return None
    if all(block.cells is None for block in blocks):
        return np.concatenate(numbers)
    out = np.empty(sum(map(len, numbers)), dtype=np.int64)
    start = 0
    for block, own in zip(blocks, numbers, strict=True):
        out[slice(start, start + len(own)) if block.cells is None else block.cells] = own
        start += len(own)
    return out


def fitting(arrays: Mapping[str, Array], count: int) -> dict[str, Array]:
    """The arrays that hold one row for each of so many entries; a single column becomes 1-d."""
    out = {}
    for name, values in arrays.items():
        if len(values) == count and values.dtype.kind in "iufb":
            out[name] = values[:, 0] if values.ndim == 2 and values.shape[1] == 1 else values
    return out


def free_name(arrays: Mapping[str, Array], name: str) -> str:
    """The name, with a number added if it is taken."""
    name = name or "unnamed"
    if name not in arrays:
        return name
    number = 2
    while f"{name}_{number}" in arrays:
        number += 1
    return f"{name}_{number}"


def check_finite(coordinates: Floats, locate: Callable[[str, int], MeshReadError]) -> None:
    """Raise `locate(message, vertex)` for the first vertex of (3, n) coordinates that is not finite."""
    with np.errstate(over="ignore", invalid="ignore"):
        if np.isfinite(coordinates.sum()):  # what is not finite spoils the sum
            return
    finite = np.isfinite(coordinates)
    if finite.all():
        return
    vertex = int(np.argmin(finite.all(axis=0)))
    axis = int(np.argmin(finite[:, vertex]))
    value = coordinates[axis, vertex]
    raise locate(
        f"the {'xyz'[axis]} coordinate of vertex {vertex + 1} is {value}, not a finite number", vertex
    )
