"""Arrows: a vector attribute on faces of the shown surface, a thousand at most, spread evenly."""

from __future__ import annotations

from copy import copy
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from .drawn_mesh import DrawnMesh
from .flat import interleave
from .normals import quad_normals
from .records import Arrows, Bytes, Floats32
from .spreading import MOST, spread

NOTHING = 1e-9
"""Part of the longest vector's length from which on there is something to draw."""

SUNK = 1e-3
"""Part of its length by which an arrow may point below the face that it starts from: rounding is no direction."""


class VectorField:
    """A vector attribute, in the scale that it is drawn in.

    Parameters
    ----------
    values : (C, 3) or (V, 3)
        As the file has them, of any number type.
    on : "cell" or "point"

    Attributes
    ----------
    vectors : (3, C) or (3, V) float32
        Over the length of the longest finite one; NaN where a component is not finite.
    longest : float or None
        That length in the file's unit, whether the vector is shown or not; None if none is finite, or if it passes
        what a number holds.

    >>> arrows = extract_arrows(drawn_mesh, shown, VectorField(mesh.cell_data["flow"], "cell"))
    """

    def __init__(self, values: Array, on: Literal["cell", "point"]) -> None:
        self.on = on
        columns = np.ascontiguousarray(values.T, dtype=np.float64)
        sizes = np.maximum.reduce(np.abs(columns))
        finite = np.isfinite(sizes)
        largest = float(sizes.max(initial=0, where=finite))
        lengths = _lengths(
            columns / (largest or 1.0)
        )  # not of the columns: squares of theirs may pass all bounds
        ratio = float(lengths.max(initial=0, where=finite))
        length = largest * ratio
        self.longest = length if finite.any() and np.isfinite(length) else None
        self.vectors: Floats32 = np.empty(columns.shape, np.float32)
        for axis in range(3):
            self.vectors[axis] = columns[axis] / (largest or 1.0) / (ratio or 1.0)
        self.vectors[:, ~finite] = np.nan

    def of(self, vertices: Ids) -> VectorField:
        """The field of a mesh whose vertices stand for some of this one's; that of cells is the same."""
        if self.on == "cell":
            return self
        out = copy(self)
        out.vectors = self.vectors[:, vertices]
        return out

    def on_faces(self, cells: Ids, corners: Ids) -> Floats32:
        """Vectors of some faces: their cell's, or the mean of their own corners'.

        Parameters
        ----------
        cells : (N,) int32
        corners : (4, N) int32
            A triangle repeats its last corner.

        Returns
        -------
        (3, N) float32
            NaN where the value, or that of a corner, is not finite.
        """
        out = np.empty((3, len(cells)), np.float32)
        for axis, column in enumerate(self.vectors):
            out[axis] = column[cells] if self.on == "cell" else _mean(column[corners], corners)
        return out


def extract_arrows(
    drawn_mesh: DrawnMesh, shown: NDArray[np.bool_], field: VectorField, gap: float = 0.0
) -> Arrows:
    """Arrows on the surface of the shown cells.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    field : VectorField
        Made once for each attribute.
    gap : float
        Of fissures: how far faces have gone towards their cell's barycentre, 0 to 1; 0 in the other modes.
    """
    topology = drawn_mesh.topology
    interface = topology.interface(shown)
    corners = topology.corners_of(interface.cells, interface.locals)
    vectors = field.on_faces(interface.cells, corners)
    lengths = _lengths(vectors)
    finite, something = np.isfinite(lengths), lengths > NOTHING
    points = drawn_mesh.points(corners)
    middles = np.stack([_mean(axis, corners) for axis in points])
    rows = np.flatnonzero(something & np.isfinite(_lengths(middles)))
    cells = interface.cells[rows]
    normals = quad_normals(points[:, :, rows], lambda which: drawn_mesh.barycentres(cells[which]))
    chosen = spread(middles[:, rows], normals, MOST)
    rows, cells, normals = rows[chosen], cells[chosen], normals[:, chosen]
    places = middles[:, rows]
    if gap:
        places = (places + gap * (drawn_mesh.barycentres(cells) - places)).astype(np.float32)
    drawn = vectors[:, rows]
    outward = (drawn * normals).sum(axis=0)
    inward: Bytes = (outward < -SUNK * _lengths(drawn)).view(np.uint8)
    return Arrows(
        positions=interleave(places[:, None]),
        vectors=interleave(drawn[:, None]),
        inward=inward,
        cells=cells.astype(np.uint32),
        longest=field.longest,
        not_finite=int(np.count_nonzero(~finite)),
        zero=int(np.count_nonzero(finite & ~something)),
    )


def _lengths(vectors: Array) -> Array:
    """(N,) lengths of (3, N) vectors."""
    x, y, z = vectors
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(np.sqrt(x * x + y * y + z * z))


def _mean(values: Floats32, corners: Ids) -> Floats32:
    """(N,) means of (4, N) values over the own corners of faces: triangles repeat their last corner."""
    quads = corners[3] != corners[2]
    total = values[0] + values[1] + values[2]
    total += np.where(quads, values[3], np.float32(0))
    total /= np.where(quads, np.float32(4), np.float32(3))
    return np.asarray(total)
