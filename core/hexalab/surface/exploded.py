"""Pieces of a mesh drawn apart ("exploded"): each has vertices of its own and moves away from the middle."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats, Ids
from ..mesh import Mesh
from .drawn_mesh import DrawnMesh
from .records import Floats32


class Pieces:
    """A mesh in pieces, made once for each way to part it.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    labels : (C,) int32
        Piece of each cell; those of -1 are one more piece.

    Attributes
    ----------
    source : (V',) int32
        The mesh's vertex that each vertex of the pieces stands for: first the mesh's own, which go to one of the
        pieces that share them, then copies for the others.
    piece : (V',) int32
        The piece that it belongs to.
    labels : (C,) int32
        Piece of each cell.

    Examples
    --------
    Two cells in a row, each a piece: the four vertices between them are there twice.

    >>> Pieces(two_cells, np.array([0, 1], np.int32)).source.tolist()                   # doctest: +SKIP
    [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 1, 2, 5, 6]
    """

    def __init__(self, drawn_mesh: DrawnMesh, labels: Ids) -> None:
        self.drawn_mesh = drawn_mesh
        mesh = drawn_mesh.mesh
        self.labels = np.where(labels < 0, labels.max(initial=-1) + 1, labels).astype(np.int32)
        owner = np.zeros(mesh.vertex_count, np.int32)
        for corner in mesh.corners:
            owner[corner] = self.labels  # the last writer has it
        foreign = [np.flatnonzero(owner[corner] != self.labels) for corner in mesh.corners]
        keys = [
            corner[cells].astype(np.int64) * self.count + self.labels[cells]
            for corner, cells in zip(mesh.corners, foreign, strict=True)
        ]
        copies, place = np.unique(np.concatenate(keys), return_inverse=True)
        place = place.reshape(-1).astype(np.int32) + np.int32(mesh.vertex_count)
        corners = mesh.corners.copy()
        begin = 0
        for corner, cells in zip(corners, foreign, strict=True):
            corner[cells] = place[begin : begin + len(cells)]
            begin += len(cells)
        self.source: Ids = np.concatenate(
            [np.arange(mesh.vertex_count, dtype=np.int32), (copies // self.count).astype(np.int32)]
        )
        self.piece: Ids = np.concatenate([owner, (copies % self.count).astype(np.int32)])
        self.mesh: Mesh = replace(
            mesh,
            coordinates=np.ascontiguousarray(mesh.coordinates[:, self.source]),
            corners=corners,
            point_data={},
            vertex_numbers=None,
            groups=(),
            features=(),
        )

    @property
    def count(self) -> int:
        """Number of pieces, one at least."""
        return int(self.labels.max(initial=0)) + 1

    @cached_property
    def middles(self) -> Floats:
        """(3, P) float64: the mean of each piece's barycentres in drawing coordinates; 0 where it is not finite."""
        cells = np.bincount(self.labels, minlength=self.count)
        frame = self.drawn_mesh.frame
        sums = [np.bincount(self.labels, axis, self.count) for axis in self.drawn_mesh.mesh.barycentres]
        with np.errstate(all="ignore"):
            means: Floats = np.stack(sums) / np.maximum(cells, 1)
            means = (means - frame.centre[:, None]) / frame.diagonal
        return np.where(np.isfinite(means), means, 0.0)


class ExplodedMesh(DrawnMesh):
    """A mesh in pieces, each moved from the middle by a share of its middle's distance.

    Parameters
    ----------
    pieces : Pieces
    share : float
        0 leaves them where they are.
    """

    def __init__(self, pieces: Pieces, share: float) -> None:
        self.pieces = pieces
        self.share = share
        self.whole = pieces.drawn_mesh.whole
        self.mesh = pieces.mesh

    @cached_property
    def coordinates(self) -> Floats32:
        """(3, V') float32 drawing coordinates, in the frame of the whole."""
        shift = (self.share * self.pieces.middles).astype(np.float32)
        out: Floats32 = self.pieces.drawn_mesh.coordinates[:, self.pieces.source]
        for axis in range(3):
            out[axis] += shift[axis][self.pieces.piece]
        return out

    def moved(self, cell: int) -> Floats:
        """(3,) float64: how far a cell is drawn from its place, in drawing coordinates."""
        return np.asarray(self.share * self.pieces.middles[:, self.pieces.labels[cell]])

    def exposed(self, rows: Array) -> NDArray[np.bool_]:
        """Which faces, by their rows, are not the whole mesh's own boundary."""
        faces, base = self.topology.faces, self.pieces.drawn_mesh
        return base.exposed(base.topology.cell_faces[faces.locals[0, rows], faces.cells[0, rows]])
