"""VTK's rows of cells become blocks of our kinds; the same for `.vtk` and `.vtu`.

Published habits are met here: rows of eight corners whose declared type has another number (eleven files of Symmetric
Moving Frames say tetrahedron), rows of more nodes than their type has, files without types, and voxels written in the
order of hexahedra.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Floats, Ids
from ..cells import KINDS, WEDGE
from ..errors import MeshReadError
from .assembly import Assembly, CellBlock, check_ids
from .byte_order import native, stretches
from .cell_orientation import Orientation
from .feature_blocks import FeatureBlock
from .half_faces import Rebuilt, rebuild
from .ids import as_int32, within_int32
from .row_chain import ErrorAt
from .vtk_polyhedra import stream_loops
from .vtk_types import (
    CELL_TYPES,
    HEXAHEDRON_TYPE,
    MAY_HAVE_EIGHT,
    POLYGON,
    POLYHEDRON,
    POLYLINE,
    VOXEL,
    CellType,
)
from .vtk_wedges import WedgeNumbering

VOXEL_SAMPLE = 4096
"""Voxels that tell in which order all of them were written."""


@dataclass
class Rows:
    """Cells as rows of vertex ids of differing length.

    Parameters
    ----------
    ids : (n,) integers
        All rows, one after the other; there may be other numbers between them.
    starts : (C,) intp or range
        Where each row begins in `ids`; a range if all have one size and stand at equal distances.
    sizes : (C,) integers
        How many corners each row has; already checked to lie within.
    types : (C,) integers or None
        VTK's cell types.
    error_at : callable
        `error_at(message, index)` makes the error for `ids[index]`.
    orientation : Orientation
        Gets the cells that are rebuilt from polyhedra; to be settled when the whole file is read.
    wedges : WedgeNumbering
        Gets the wedges, whose numbering may be another; to be settled, too.
    faces : callable, optional
        The loops of the faces of polyhedra, given their rows; by default the rows themselves are streams of faces.
    """

    ids: Array
    starts: Array | range
    sizes: Array
    types: Array | None
    error_at: ErrorAt
    orientation: Orientation = field(default_factory=lambda: Orientation(inwards=False, faces="faces"))
    wedges: WedgeNumbering = field(default_factory=WedgeNumbering)
    faces: Callable[[Array], Array] | None = None

    @property
    def uniform(self) -> int:
        """How many corners each row has if the rows stand at equal distances, else 0."""
        return int(self.sizes[0]) if isinstance(self.starts, range) and len(self.starts) else 0

    def begins(self, which: Array) -> Array:
        """Where the rows `which` begin in `ids`."""
        if isinstance(self.starts, range):
            return self.starts.start + self.starts.step * which
        return np.asarray(self.starts[which])

    def loops_of(self, which: Array) -> Array:
        """The (m, 6, 4) loops of the faces of the polyhedra `which`; see `half_faces.rebuild`."""
        if self.faces is not None:
            return self.faces(which)
        starts = np.asarray(self.begins(which))
        return stream_loops(self.ids, starts, starts + self.sizes[which])

    def all_of_type(self, number: int) -> bool:
        """Whether every row is declared to be of the type."""
        if self.types is None:
            return False
        return all((part == number).all() for _, part in stretches(self.types.reshape(-1, 1)))


def add_cells(out: Assembly, rows: Rows) -> NDArray[np.intp] | None:
    """Add the volumetric cells to the assembly, in file order.

    Returns
    -------
    kept : (n,) intp or None
        Rows that became cells, ascending; None if all did.
    """
    if rows.uniform == 8 and rows.all_of_type(HEXAHEDRON_TYPE):
        add_type(out, rows, CELL_TYPES[HEXAHEDRON_TYPE], HEXAHEDRON_TYPE, range(len(rows.starts)), None)
        return None
    types = declared_types(out, rows)
    chosen = {number: np.flatnonzero(types == number) for number in np.unique(types).tolist()}
    found = {number: which for number, which in chosen.items() if known_kind(number) is not None}
    solid = None
    if POLYHEDRON in chosen:
        solid = rebuild(lambda part: rows.loops_of(chosen[POLYHEDRON][part]), len(chosen[POLYHEDRON]))
        found[POLYHEDRON] = chosen[POLYHEDRON][solid.kinds >= 0]
    for number in [number for number in chosen if number in CELL_TYPES and CELL_TYPES[number].dimension < 3]:
        add_features(out, rows, CELL_TYPES[number], chosen.pop(number))
    if POLYLINE in chosen:
        add_polylines(out, rows, chosen.pop(POLYLINE))
    if POLYGON in chosen:
        chosen[POLYGON] = add_polygons(out, rows, chosen[POLYGON])
    for number, which in chosen.items():
        name = CELL_TYPES[number].name if number in CELL_TYPES else f"cells of type {number}"
        out.leave_out(name, len(which) - len(found.get(number, ())))
    whole = sum(map(len, found.values())) == len(types)
    kept = None if whole else np.sort(np.concatenate([np.empty(0, np.intp), *found.values()]))
    for number in sorted(found):
        which = found[number]
        places = which if kept is None else np.searchsorted(kept, which)
        if number == POLYHEDRON and solid is not None:
            add_rebuilt(out, rows, solid, which, places)
        else:
            add_type(out, rows, CELL_TYPES[number], number, which, places if len(found) > 1 else None)
    return kept


def add_features(out: Assembly, rows: Rows, cell_type: CellType, which: Array) -> None:
    """Add rows of lower dimension, all of one type, as features; those with too few nodes are left out."""
    corners = len(cell_type.order)
    enough = rows.sizes[which] >= corners
    out.leave_out(f"{cell_type.name} with too few nodes", int(np.count_nonzero(~enough)))
    which = which[enough]
    if cell_type.size > corners and len(which):
        out.note(f"Elements of higher order ({cell_type.name}) are kept by their corners.")
    out.features.append(FeatureBlock(cell_type.dimension, gathered(rows, which, cell_type.order), rows=which))


def add_polylines(out: Assembly, rows: Rows, which: Array) -> None:
    """Add polylines as the edges that they are made of."""
    pieces = np.maximum(rows.sizes[which].astype(np.intp) - 1, 0)
    first = np.repeat(rows.begins(which), pieces)
    first += np.arange(len(first)) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    ends = [within_int32(native(rows.ids[first + end])) for end in (0, 1)]
    out.features.append(FeatureBlock(1, np.stack(ends).astype(np.int32), rows=np.repeat(which, pieces)))


def add_polygons(out: Assembly, rows: Rows, which: Array) -> Array:
    """Add polygons of three and four corners; the rows of the others."""
    sizes = rows.sizes[which]
    for size in (3, 4):
        some = which[sizes == size]
        if len(some):
            out.features.append(FeatureBlock(2, gathered(rows, some, tuple(range(size))), rows=some))
    others: Array = which[(sizes != 3) & (sizes != 4)]
    return others


def known_kind(number: int) -> int | None:
    """Index into KINDS of the cells of a type, None if it is not kept."""
    return CELL_TYPES[number].kind if number in CELL_TYPES else None


def add_rebuilt(out: Assembly, rows: Rows, solid: Rebuilt, which: Array, places: Array) -> None:
    """Add the cells that were rebuilt from polyhedra, which are the rows `which`; `Rows.orientation` gets them too."""
    assert out.coordinates is not None
    order = np.cumsum(solid.kinds >= 0) - 1
    for kind in range(len(KINDS)):
        cells, own, agreeing = solid.of(kind)
        if not len(cells):
            continue

        def locate(message: str, cell: int, _: int, own_rows: Array = which[order[cells]]) -> MeshReadError:
            return rows.error_at(message, int(rows.begins(own_rows[cell : cell + 1])[0]))

        block = CellBlock(kind, own, locate, cells=places[order[cells]])
        rows.orientation.add(block, agreeing, out.coordinates)
        out.blocks.append(block)


def declared_types(out: Assembly, rows: Rows) -> Array:
    """(C,) types; rows of eight become hexahedra where the declared type cannot have eight nodes."""
    if rows.types is None:
        out.note(
            "The cells have no types: rows of 8, 6, 5 and 4 corners are taken as hexahedra, wedges, pyramids "
            "and tetrahedra."
        )
        guessed: Array = np.zeros(len(rows.sizes), dtype=np.uint8)
        for size, number in ((8, HEXAHEDRON_TYPE), (6, 13), (5, 14), (4, 10)):
            guessed[rows.sizes == size] = number
        return guessed
    types: Array = native(rows.types)
    eight = rows.sizes == 8
    for number in np.unique(types[eight]).tolist():
        if number not in MAY_HAVE_EIGHT:
            types = renamed(out, types, eight, number)
    return types


def renamed(out: Assembly, types: Array, eight: NDArray[np.bool_], number: int) -> Array:
    """The types with the rows of eight of that number made hexahedra, and a note."""
    wrong = eight & (types == number)
    name = CELL_TYPES[number].name if number in CELL_TYPES else "an unknown type"
    out.note(
        f"{int(wrong.sum()):,} cells have 8 corners but are declared as type {number} ({name}): "
        "they are taken as hexahedra."
    )
    return np.where(wrong, HEXAHEDRON_TYPE, types)


def add_type(
    out: Assembly, rows: Rows, cell_type: CellType, number: int, which: Array | range, places: Array | None
) -> None:
    """Add the rows `which`, all of one type."""
    assert cell_type.kind is not None
    check_sizes(out, rows, cell_type, number, which)
    order = cell_type.order

    def locate(message: str, cell: int, corner: int) -> MeshReadError:
        return rows.error_at(message, int(rows.starts[which[cell]]) + order[corner])

    block = CellBlock(cell_type.kind, gathered(rows, which, order), locate, cells=places)
    if number == VOXEL and out.coordinates is not None:
        check_ids(block, out.coordinates.shape[1])
        if written_as_hexahedra(block.corners, out.coordinates):
            block.corners = block.corners[[0, 1, 3, 2, 4, 5, 7, 6]]
            out.note("The voxels have their corners in the order of hexahedra and were read in that order.")
    if cell_type.kind == WEDGE and out.coordinates is not None:
        rows.wedges.add(number, block, out.coordinates)
    out.blocks.append(block)


def check_sizes(out: Assembly, rows: Rows, cell_type: CellType, number: int, which: Array | range) -> None:
    """Raise MeshReadError where a row has too few nodes for its corners; tell of nodes that are passed over.

    Corners stand first in every type. So a row that has more nodes than its type is read as VTK reads it: the
    type's own come first (a quadratic hexahedron that is declared as a linear one).
    """
    sizes = rows.sizes[which] if not rows.uniform else np.array([rows.uniform])
    corners = len(cell_type.order)
    if (sizes < corners).any():
        first = int(np.argmax(sizes < corners))
        expected = f"{cell_type.size}" if cell_type.size else f"at least {corners}"
        raise rows.error_at(
            f"cell {int(which[first])} is declared as type {number} ({cell_type.name}) but has "
            f"{int(sizes[first])} corners, expected {expected}",
            int(rows.starts[which[first]]),
        )
    odd = sizes != cell_type.size if cell_type.size else np.zeros(1, dtype=bool)
    if odd.any():
        count = len(which) if rows.uniform else int(odd.sum())
        first = int(sizes[np.argmax(odd)])
        out.note(
            f"Cells that are declared as type {number} ({cell_type.name}, {cell_type.size} nodes) and have another "
            f"number of nodes ({first}): {count:,}. Their first {corners} are taken as the corners."
        )
    elif (sizes > corners).any():
        out.note(f"Cells of higher order ({cell_type.name}) are shown by their corners.")


def gathered(rows: Rows, which: Array | range, order: tuple[int, ...]) -> Ids:
    """(k, n) int32 own corners of the rows `which`; ids that don't fit int32 stay out of range."""
    count = len(which)
    out = np.empty((len(order), count), dtype=np.int32)
    if isinstance(rows.starts, range) and count == len(rows.starts):
        step, before = rows.starts.step, rows.starts.step - rows.uniform
        first = rows.starts.start - before
        whole = order == tuple(range(rows.uniform))
        for part, stretch in stretches(rows.ids[first : first + step * count].reshape(count, step)):
            table = as_int32(stretch)[:, before:].T
            out[:, part] = table if whole else table[list(order)]
        return out
    for start in range(0, count, CHUNK):
        part = slice(start, start + CHUNK)
        begin = rows.begins(np.asarray(which[part]))
        for corner, own in zip(out, order, strict=True):
            corner[part] = within_int32(native(rows.ids[begin + own]))
    return out


def written_as_hexahedra(corners: Ids, coordinates: Floats) -> bool:
    """Whether voxels, put into hexahedral order, have less volume than as they were written.

    A voxel in the wrong order is a bow tie: its Jacobian at the centre is zero.
    """
    corners = corners[:, :VOXEL_SAMPLE]
    as_voxels = np.abs(central_jacobian(corners, coordinates)).sum()
    as_written = np.abs(central_jacobian(corners[[0, 1, 3, 2, 4, 5, 7, 6]], coordinates)).sum()
    return bool(as_written > as_voxels)


def central_jacobian(corners: Ids, coordinates: Floats) -> Floats:
    """(C,) determinant of the trilinear map's derivatives at each cell's centre, times 64."""
    p = coordinates[:, corners]
    u = p[:, [1, 2, 5, 6]].sum(axis=1) - p[:, [0, 3, 4, 7]].sum(axis=1)
    v = p[:, [2, 3, 6, 7]].sum(axis=1) - p[:, [0, 1, 4, 5]].sum(axis=1)
    w = p[:, 4:].sum(axis=1) - p[:, :4].sum(axis=1)
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(
            u[0] * (v[1] * w[2] - v[2] * w[1])
            + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0])
        )


def spans(offsets: Array, size: int, error_at: ErrorAt) -> tuple[Array | range, Array]:
    """Starts and sizes of rows from their n+1 offsets, checked against the connectivity's size."""
    count = len(offsets) - 1
    if count < 0:
        return np.empty(0, np.intp), np.empty(0, np.int32)
    step = int(offsets[1]) if count else 0
    if 0 < step * count <= size and evenly(offsets, step):
        return range(0, step * count, step), np.broadcast_to(np.int32(step), count)
    offsets = native(offsets).astype(np.int64, copy=False)
    sizes = np.diff(offsets)
    wrong = np.concatenate([[offsets[0] != 0], (sizes < 0) | (offsets[1:] > size)])
    if wrong.any():
        index = int(np.argmax(wrong))
        raise error_at(
            f"offset {index} is {int(offsets[index])}, expected them to rise from 0 to the {size} values of "
            "the connectivity",
            index,
        )
    return offsets[:-1].astype(np.intp, copy=False), sizes.astype(np.int32)


def evenly(offsets: Array, step: int) -> bool:
    """Whether the numbers are 0, step, 2 step, ..."""
    return all(
        (native(part).reshape(-1) == np.arange(step * which.start, step * which.stop, step)).all()
        for which, part in stretches(offsets.reshape(-1, 1))
    )
