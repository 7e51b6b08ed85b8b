"""Certified validity: the sign of the Jacobian determinant over the whole of each cell.

A. Johnen, J.-C. Weill, J.-F. Remacle, "Robust and efficient validation of the linear hexahedral element", Procedia
Engineering 203 (2017): the least of the 27 Bezier coefficients is a lower bound of the determinant, its values at
corners are upper bounds of the minimum; where they disagree, the cell is cut into eight.

Three stages decide: floating point with a bound of its own rounding errors; floating point, subdivided; integers, for
what is closer to zero than rounding can tell. No answer but "undecided" rests on an unproven sign.

Five cubes, as they are decided: as it is; its top turned by a quarter; its top turned by a half; a corner pushed in
to the centre; a corner pushed into the plane of its neighbours.

>>> cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
>>> cells = np.stack([cube] * 5).astype(float)
>>> cells[1, 4:], cells[2, 4:] = cube[[5, 6, 7, 4]], cube[[6, 7, 4, 5]]
>>> cells[3, 6], cells[4, 6] = [0.5, 0.5, 0.5], [1, 0.5, 0.5]
>>> mesh = Mesh.from_cells(cells.reshape(-1, 3), np.arange(40).reshape(5, 8))
>>> block = BezierBlock()
>>> block.load(mesh.coordinates, mesh.corners)
>>> corners = block.corners()
>>> coefficients = block.coefficients(corners)

The least corner bounds the minimum from above, the least coefficient from below:

>>> corners.min(axis=(0, 1, 2)).tolist()
[1.0, 1.0, 1.0, -0.5, 0.0]
>>> coefficients.min(axis=(0, 1, 2)).tolist()
[1.0, 0.0, -1.0, -0.5, 0.0]

So the first cell is valid and the fourth invalid. The quarter turn is open, with corners of 1 and a coefficient of 0;
cut into eight, each of its pieces is positive by its coefficients. The half turn's pieces have corners in the middle
of the cell, where the determinant is 0; so has the last cell at its own corner. Rounding can't tell 0 from a little
more, integers can.

>>> octants(coefficients[..., 1:3], exact=False).min(axis=(0, 1, 2)).reshape(8, 2)[0].tolist()
[0.5, 0.0]
>>> certify(mesh).state.tolist()
[1, 1, 0, 0, 0]
>>> certify(mesh, depth=0).state.tolist()
[1, 2, 2, 0, 0]
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from ..cells import CORNERS_OF_KIND, EDGES, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from ..mesh import Mesh
from . import exact, other_kinds
from .arena import BLOCK
from .bezier import BezierBlock, octants

INVALID, VALID, UNDECIDED = range(3)

DEPTH = 10
"""Subdivisions before a cell is left undecided: pieces of a 1024th of its width."""

EPSILON = float(np.finfo(np.float64).eps)

CORNER_ERROR = 64 * EPSILON
"""Bound of the error of a determinant, as a multiple of `BezierBlock.magnitude`.

Edges carry half an epsilon each, and each of six products 3 more roundings in the sum: under 6 * 8 halves."""

COEFFICIENT_ERROR = 4096 * EPSILON
"""The same of a Bezier coefficient: the centre weighs the errors of corners and edge middles with up to 22, and its
own sums and those of `DEPTH` subdivisions add less than as much again."""

BATCH = 1024
"""Cells decided exactly together."""

PIECES = 128
"""Open pieces of one cell before it is left undecided: its determinant vanishes along a surface or nearly."""


STATES = ("invalid", "valid", "undecided")
"""Words for the states of a cell; `Validity.state` holds indices into it."""


@dataclass(frozen=True)
class Validity:
    """What is known of each cell.

    Parameters
    ----------
    state : (C,) uint8
        0 invalid: the determinant is not positive somewhere, proven; 1 valid: positive everywhere, proven; 2 undecided.
    minimum : (C,) float64
        A lower bound of the determinant of the map from the unit cube (for an inverted cell a negative one); for kinds
        other than hexahedra its least value at the nodes. NaN where coordinates are not finite.
    """

    state: NDArray[np.uint8]
    minimum: Floats

    @property
    def counts(self) -> dict[str, int]:
        """Number of cells in each state."""
        found = np.bincount(self.state, minlength=len(STATES))
        return {name: int(count) for name, count in zip(STATES, found, strict=True)}


def certify(mesh: Mesh, depth: int = DEPTH) -> Validity:
    """Decide for each cell whether its Jacobian determinant is positive everywhere.

    Hexahedra are certified over the whole trilinear cell. One that repeats vertices is taken as it stands, with
    the trilinear map of its eight corners: where an edge has collapsed the determinant is zero, so it is invalid,
    as it is for an integration rule that does not know better. Of the other kinds the determinants at their own
    nodes decide (which is exact for tetrahedra; at a pyramid's apex none is taken).

    Parameters
    ----------
    mesh : Mesh
    depth : int
        Bound on subdivisions; what is open then is undecided.

    Returns
    -------
    Validity
    """
    state = np.full(mesh.cell_count, UNDECIDED, dtype=np.uint8)
    minimum = np.full(mesh.cell_count, np.nan)
    with np.errstate(all="ignore"):
        cells = np.flatnonzero(mesh.kinds == HEXAHEDRON)
        if cells.size:
            _hexahedra(mesh, cells, depth, state, minimum)
        for kind in (TETRAHEDRON, PYRAMID, WEDGE):
            cells = np.flatnonzero(mesh.kinds == kind)
            if cells.size:
                _other_kind(mesh, kind, cells, state, minimum)
    return Validity(state, minimum)


def _hexahedra(mesh: Mesh, cells: Array, depth: int, state: NDArray[np.uint8], minimum: Floats) -> None:
    every, block = cells.size == mesh.cell_count, BezierBlock()
    open_cells, open_coefficients, near = [], [], []
    for start in range(0, cells.size, BLOCK):
        ids = cells[start : start + BLOCK]
        part: Any = slice(start, start + BLOCK) if every else ids
        block.load(mesh.coordinates, mesh.corners[:, part])
        magnitude, corners = block.magnitude(), block.corners()
        coefficients = block.coefficients(corners)
        least, lowest = corners.min(axis=(0, 1, 2)), coefficients.min(axis=(0, 1, 2))
        lowest -= COEFFICIENT_ERROR * magnitude
        minimum[part] = lowest
        error = CORNER_ERROR * magnitude
        sound = magnitude > 1e-280
        valid, invalid = sound & (lowest > 0), sound & (least < -error)
        state[part] = np.where(valid, VALID, np.where(invalid, INVALID, UNDECIDED))
        left = np.flatnonzero(~(valid | invalid))
        if left.size:
            apart = sound[left] & (least[left] > error[left])
            near.append(ids[left[~apart]])
            further = left[apart]
            open_cells.append(ids[further])
            open_coefficients.append((coefficients[..., further], magnitude[further]))
    for ids, (values, magnitude) in zip(open_cells, open_coefficients, strict=True):
        near.append(ids[_subdivide(values, COEFFICIENT_ERROR * magnitude, ids, depth, state, minimum)])
    _exactly(mesh, np.concatenate(near) if near else cells[:0], depth, state)


def _subdivide(
    values: Floats, error: Floats, ids: Array, depth: int, state: NDArray[np.uint8], minimum: Floats
) -> Array:
    """Cut cells until each piece is positive or one is not; returns the places of those still open.

    Where a piece's corner is closer to zero than rounding can tell, cutting on is hopeless: the cell stays open.

    Of n pieces `values` holds the coefficients, (3, 3, 3, n), and `owner` the cells they are of, as places in `ids`.
    Cutting puts all first octants first, then all second ones: pieces of the cells [0, 1, 2] become pieces of
    [0, 1, 2, 0, 1, 2, ...]; of those only the ones still open are kept, say of [1, 1, 2].
    """
    owner: Array = np.arange(ids.size)
    lowest = np.full(ids.size, np.inf)
    invalid, hopeless = np.zeros(ids.size, dtype=bool), np.zeros(ids.size, dtype=bool)
    for _ in range(depth):
        values, owner = octants(values, exact=False), np.concatenate([owner] * 8)
        low = values.min(axis=(0, 1, 2)) - error[owner]
        corner = values[::2, ::2, ::2].min(axis=(0, 1, 2))
        invalid[owner[corner < -error[owner]]] = True
        hopeless[owner[corner <= error[owner]]] = True
        done = low > 0
        np.minimum.at(lowest, owner[done], low[done])
        keep = np.flatnonzero(~done & ~invalid[owner] & ~hopeless[owner])
        values, owner = values[..., keep], owner[keep]
        if not owner.size:
            break
    still_open = hopeless
    still_open[owner] = True
    still_open &= ~invalid
    valid = ~invalid & ~still_open
    state[ids[invalid]] = INVALID
    state[ids[valid]] = VALID
    minimum[ids[valid]] = lowest[valid]
    return np.flatnonzero(still_open)


def _exactly(mesh: Mesh, cells: Array, depth: int, state: NDArray[np.uint8]) -> None:
    """Decide cells in integer arithmetic; a determinant of exactly zero at a corner makes a cell invalid."""
    for start in range(0, cells.size, BATCH):
        ids = cells[start : start + BATCH]
        points = mesh.coordinates[:, mesh.corners[:, ids]]
        sound = np.isfinite(points).all(axis=(0, 1))
        state[ids[~sound]] = INVALID
        ids, points = ids[sound], points[:, :, sound]
        collapsed = _collapsed(points)
        state[ids[collapsed]] = INVALID
        ids, points = ids[~collapsed], points[:, :, ~collapsed]
        if ids.size:
            grid = exact.integers(points)[:, [0, 1, 3, 2, 4, 5, 7, 6]].reshape(3, 2, 2, 2, -1)
            _subdivide_exactly(grid, ids, depth, state)


def _collapsed(points: Floats) -> NDArray[np.bool_]:
    """Cells (3, 8, n) with an edge whose ends are the same point."""
    out = np.zeros(points.shape[-1], dtype=bool)
    for a, b in EDGES:
        out |= (points[:, a] == points[:, b]).all(axis=0)
    return out


def _subdivide_exactly(grid: Array, ids: Array, depth: int, state: NDArray[np.uint8]) -> None:
    values = exact.coefficients(grid)
    owner: Array = np.arange(ids.size)
    invalid, too_many = np.zeros(ids.size, dtype=bool), np.zeros(ids.size, dtype=bool)
    for level in range(depth + 1):
        if level:
            values, owner = octants(values, exact=True), np.concatenate([owner] * 8)
        invalid[owner[values[::2, ::2, ::2].min(axis=(0, 1, 2)) <= 0]] = True
        keep = np.flatnonzero((values.min(axis=(0, 1, 2)) <= 0) & ~invalid[owner])
        too_many |= np.bincount(owner[keep], minlength=ids.size) > PIECES
        keep = keep[~too_many[owner[keep]]]
        values, owner = values[..., keep], owner[keep]
        if not owner.size:
            break
    still_open = too_many
    still_open[owner] = True
    state[ids] = np.where(invalid, INVALID, np.where(still_open, UNDECIDED, VALID))


def _other_kind(mesh: Mesh, kind: int, cells: Array, state: NDArray[np.uint8], minimum: Floats) -> None:
    """Decide tetrahedra, pyramids or wedges by the determinants at their nodes."""
    block = other_kinds.BLOCKS[kind]()
    places = sorted(CORNERS_OF_KIND[kind])
    for start in range(0, cells.size, BLOCK):
        ids = cells[start : start + BLOCK]
        block.load(mesh.coordinates, mesh.corners[:, ids])
        least = block.determinants.min(axis=0)
        magnitude = np.prod(
            [np.abs(edges).max(axis=(0, 1)) for edges in zip(*block.vectors, strict=True)], axis=0
        )
        minimum[ids] = least
        state[ids] = np.where(least > 0, VALID, INVALID)
        near = np.flatnonzero(~(np.abs(least) > CORNER_ERROR * magnitude) | ~(magnitude > 1e-280))
        points = mesh.coordinates[:, mesh.corners[:, ids[near]]][:, places]
        sound = np.isfinite(points).all(axis=(0, 1))
        state[ids[near[~sound]]] = INVALID
        near, corners = near[sound], exact.integers(points[:, :, sound])
        if near.size:
            values = [
                exact.determinant(*(corners[:, node] - corners[:, corner] for node in nodes))
                for corner, *nodes in block.triples
            ]
            state[ids[near]] = np.where(np.min(values, axis=0) > 0, VALID, INVALID)
