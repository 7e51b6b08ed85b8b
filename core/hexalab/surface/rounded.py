"""Rounded: each cell is rounded around its exposed edges and corners, and smooth within itself."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..cells import FACES
from .collapse import by_pattern, polygons
from .drawn_mesh import DrawnMesh
from .exposure import ExposedCells, exposed_cells
from .flat import NO_EDGES
from .lattice import THIRD, Lattice, lattice
from .normals import pack, quad_normals, unit
from .records import Bytes, Floats32, Int16s, Surface, UInt32s

BLOCK = 2048
"""Cells in a block: the temporaries of its some 70,000 nodes stay in the second-level cache."""


class _Sheet(NamedTuple):
    """The arrays of a `Surface` with shared vertices, being filled."""

    positions: Floats32
    normals: Int16s
    cells: UInt32s
    inside: Bytes
    quads: UInt32s
    faces: UInt32s


def rounded(drawn_mesh: DrawnMesh, shown: NDArray[np.bool_], radius: float = 0.075) -> Surface:
    """Surface of rounded cells (the paper's section on mesh extraction in rounded mode).

    Where corners of a cell are not exposed, its rounding runs out towards them and the gaps close, so that
    the surface is closed.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    shown : (C,) bool
    radius : float
        Radius of the rounding over the length of the edge: 0 for none, 1/2 makes spheres of cubes. The
        original's slider gives 0.04 to 0.2.
    """
    found = exposed_cells(drawn_mesh, shown)
    groups = [
        (lattice(pattern), found.part(which))
        for pattern, which in by_pattern(found.corners)
        if polygons(pattern)
    ]
    vertex_count = sum(int(np.diff(shape.node_start)[part.codes].sum()) for shape, part in groups)
    quad_count = sum(int(np.diff(shape.face_start)[part.codes].sum()) for shape, part in groups)
    sheet = _Sheet(
        positions=np.empty((vertex_count, 3), np.float32),
        normals=np.empty((vertex_count, 4), np.int16),
        cells=np.empty(vertex_count, np.uint32),
        inside=np.empty(vertex_count, np.uint8),
        quads=np.empty((quad_count, 4), np.uint32),
        faces=np.empty(quad_count, np.uint32),
    )
    vertex = quad = 0
    for shape, part in groups:
        weights = _weights(shape, radius)
        for begin in range(0, len(part.cells), BLOCK):
            block = part.part(slice(begin, begin + BLOCK))
            vertex, quad = _fill(sheet, vertex, quad, drawn_mesh, shape, weights, block)
    return Surface(
        mode="rounded",
        positions=sheet.positions.reshape(-1),
        normals=sheet.normals.reshape(-1),
        cells=sheet.cells,
        inside=sheet.inside,
        quads=sheet.quads.reshape(-1),
        faces=sheet.faces,
        **NO_EDGES._asdict(),
    )


def _weights(shape: Lattice, radius: float) -> Floats32:
    """Weights of the corners that make a node, (T, K)."""
    weights = shape.steps * np.float32(radius)
    weights[:, shape.triangular] = shape.steps[:, shape.triangular] * np.float32(min(radius, THIRD))
    weights[0] = 1 - weights[1:].sum(axis=0)
    return weights


def _fill(
    sheet: _Sheet,
    vertex: int,
    quad: int,
    drawn_mesh: DrawnMesh,
    shape: Lattice,
    weights: Floats32,
    block: ExposedCells,
) -> tuple[int, int]:
    """Write nodes and faces of some cells from a vertex and a quad on; return where the next ones begin."""
    count = len(block.cells)
    owner, entry, first = _spread(shape.node_start, block.codes)
    nodes = slice(vertex, vertex + len(owner))
    sources = [shape.terms[t][entry] * count + owner for t in range(len(weights))]
    shares = [weights[t][entry] for t in range(len(weights))]
    for axis in range(3):
        corner = block.points[axis].reshape(-1)
        # A flat side's corner must come out the same from both cells: its two steps are added first.
        x = shares[1] * corner[sources[1]]
        for t in (*range(2, len(weights)), 0):
            x += shares[t] * corner[sources[t]]
        sheet.positions[nodes, axis] = x
    normals, inside = _faces_of_cells(drawn_mesh, shape, block)
    kind = shape.classes[entry] * count + owner
    sheet.normals.view(np.int64)[nodes, 0] = normals[kind]
    sheet.inside[nodes] = inside[kind]
    own = block.cells.astype(np.uint32)
    sheet.cells[nodes] = own[owner]

    owner, entry, _ = _spread(shape.face_start, block.codes)
    quads = slice(quad, quad + len(owner))
    base = (first + vertex)[owner]
    for i in range(4):
        sheet.quads[quads, i] = shape.places[i][entry] + base
    sheet.faces[quads] = own[owner] * np.uint32(8) + shape.locals[entry]
    return nodes.stop, quads.stop


def _spread(
    start: NDArray[np.intp], codes: Bytes
) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """Each cell's list, one after the other: which cell, which entry; and where each cell's list begins."""
    begin = start[codes]
    length = start[codes.astype(np.intp) + 1] - begin
    end = np.cumsum(length)
    owner = np.repeat(np.arange(len(codes)), length)
    entry = np.arange(len(owner))
    entry += (begin - (end - length))[owner]
    return owner, entry, end - length


def _faces_of_cells(
    drawn_mesh: DrawnMesh, shape: Lattice, block: ExposedCells
) -> tuple[NDArray[np.int64], Bytes]:
    """Normals, packed in eight bytes, and `inside` of each class of nodes of each cell, class after class."""
    count = len(block.cells)
    rows = drawn_mesh.topology.cell_faces[:, block.cells]
    within = drawn_mesh.exposed(rows).view(np.uint8) * np.uint8(255)
    faces = np.empty((6, 3, count), np.float32)
    for face in sorted({face for faces_of in shape.faces_of_class for face in faces_of}):
        faces[face] = quad_normals(
            block.points[:, list(FACES[face])], lambda which: drawn_mesh.barycentres(block.cells[which])
        )
    normals = np.empty((len(shape.faces_of_class), count), np.int64)
    inside = np.empty((len(shape.faces_of_class), count), np.uint8)
    for i, (first, *others) in enumerate(shape.faces_of_class):
        total = faces[first]
        inside[i] = within[first]
        if others:
            total = total.copy()
            for face in others:
                total += faces[face]
                inside[i] &= within[face]
            unit(total)
        normals[i] = pack(total).view(np.int64).reshape(-1)
    return normals.reshape(-1), inside.reshape(-1)
