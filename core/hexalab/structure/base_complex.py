"""The base complex: the coarsest blocks whose walls follow the mesh (SPEC T3; Gao et al. 2015, 2017)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Ids, tally
from ..topology.classes import classes
from .blocks import Blocks, measured
from .frame import Frame
from .graph import Chains, chain
from .walls import complex_edges, patches, separating_faces


@dataclass(eq=False)
class BaseComplex:
    """Blocks and the walls between them.

    Attributes
    ----------
    frame : Frame
        What it lies in.
    separating : (F,) bool
        Faces that walls pass, those of the boundary that touch an irregular edge among them.
    complex_faces : (F,) bool
        These and all of the boundary.
    of_cells : (N,) int32
        Block of each cell, numbered in the order of their first cells.
    count : int
        Number of blocks.
    """

    frame: Frame
    separating: NDArray[np.bool_]
    complex_faces: NDArray[np.bool_]
    of_cells: Ids
    count: int

    @cached_property
    def blocks(self) -> Blocks:
        """What the blocks are."""
        return measured(self.frame, self.complex_faces, self.of_cells, self.count)


def whole_complex(frame: Frame) -> BaseComplex:
    """The base complex that all irregular edges enforce."""
    return _complex(frame, frame.irregular)


def interior_complex(frame: Frame) -> BaseComplex:
    """The base complex that the inside alone enforces; its blocks need not be boxes."""
    return _complex(frame, frame.irregular & ~frame.edge_on_boundary)


def _complex(frame: Frame, start_at: NDArray[np.bool_]) -> BaseComplex:
    separating = separating_faces(frame, start_at)
    complex_faces = separating.copy()
    complex_faces[frame.paired :] = True
    labels, count = classes(frame.count, lambda: _links(frame, complex_faces))
    return BaseComplex(frame, separating, complex_faces, labels, count)


def _links(frame: Frame, complex_faces: NDArray[np.bool_]) -> Iterator[tuple[Ids, Ids]]:
    """Cells on both sides of faces that are not complex."""
    for start in range(0, frame.paired, CHUNK):
        part = slice(start, min(start + CHUNK, frame.paired))
        joined = np.flatnonzero(~complex_faces[part])
        yield frame.face_cells[0, part][joined], frame.face_cells[1, part][joined]


@dataclass(frozen=True)
class Skeleton:
    """Vertices, edges and faces of a base complex.

    Attributes
    ----------
    vertices : (V,) int32
        Vertices of the mesh where base edges end.
    edges : Chains
        Base edges, of rows of `mesh_edges`; those without a vertex come last.
    mesh_edges : (M,) int32
        Edges of the mesh all of whose faces are complex.
    face_rows, face_labels : (K,) int32
        The complex faces, and the base face that each is part of.
    faces : int
        Number of base faces.
    """

    vertices: Ids
    edges: Chains
    mesh_edges: Ids
    face_rows: Ids
    face_labels: Ids
    faces: int


def skeleton(frame: Frame, complex_faces: NDArray[np.bool_]) -> Skeleton:
    """What lies between the blocks."""
    on = complex_edges(frame, complex_faces)
    rows = np.flatnonzero(on).astype(np.int32)
    ends = frame.edge_vertices[:, rows]
    met = tally(ends, frame.topology.vertex_count)
    straight = (met == 2) & ~_bent(frame, on)
    labels, faces = patches(frame, complex_faces, on)
    return Skeleton(
        vertices=np.flatnonzero((met > 0) & ~straight).astype(np.int32),
        edges=chain(ends, straight),
        mesh_edges=rows,
        face_rows=np.flatnonzero(complex_faces).astype(np.int32),
        face_labels=labels,
        faces=faces,
    )


def _bent(frame: Frame, on: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """(V,) bool: whether some cell has two of the edges, (E,) bool, at the vertex."""
    out = np.zeros(frame.topology.vertex_count, dtype=bool)
    flags = [on[places] for places in frame.cell_edges]
    for corner in range(8):
        a, b, c = (flags[place] for place in AT_CORNER[corner])
        cells = np.flatnonzero((a & b) | (b & c) | (a & c))
        out[frame.topology.corners[corner][cells]] = True
    return out


AT_CORNER = [[0, 3, 8], [0, 1, 9], [1, 2, 10], [2, 3, 11], [4, 7, 8], [4, 5, 9], [5, 6, 10], [6, 7, 11]]
