"""The lattice of a rounded cell: its nodes, how each is displaced, and the faces between them.

Each face of a cell is cut into 3 x 3: a side in its middle, a strip along each edge, a piece at each
corner. For a hexahedron that is the surface of a 4 x 4 x 4 lattice. Told by the cell's own vertices, edges
and faces the same holds for any cell that collapses from it, and corners that coincide merge by themselves.
The nodes are

- one for each vertex: the tip of the rounded corner;
- one for each vertex and edge there: where the corner's rounding passes into the edge's;
- one for each vertex and face there: corner of the face's flat side.

A lattice node starts at its vertex. If that is exposed, it moves along the edges there by a multiple of the
radius: along both edges of its face by 1 each; along its own edge by 1, and along the two others of the
faces at that edge by `EDGE`; from the tip along all three by `TIP`. On a cube and at radius 1/2 all nodes
come to lie on the inscribed sphere. Where a cell has collapsed and a vertex has another number of edges,
the tip moves by three times the mean, and an edge's node by twice the mean of the others. The corners of a
flat side depend on nothing but the face's vertices, so that two cells agree on them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .collapse import Pattern, polygons

EDGE = 1 - 2**0.5 / 2
TIP = 1 - 3**0.5 / 3

THIRD = 1 / 3
"""A triangle's flat side has shrunk to its middle there; it goes no further."""


@dataclass(frozen=True)
class Lattice:
    """Nodes and faces for one pattern of collapse, and which of them each code of exposed corners keeps.

    Lists of nodes and of faces for the 256 codes stand one after the other; `*_start[code]` is where a
    code's begin.

    Attributes
    ----------
    faces_of_class : list of tuple of int
        Nodes that lie on the same faces of the cell share a normal; the faces of each such class.
    terms : (T, K) intp
        Corners of the cell that the nodes of the lists are combined from; the first is the node's own vertex.
    steps : (T, K) float32
        How far a node goes towards each of them, in radii.
    triangular : (K,) bool
        Nodes of the flat side of a triangle, where the radius is at most `THIRD`.
    classes : (K,) intp
        Class of each node.
    node_start : (257,) intp
    places : (4, L) intp
        For each face of the lists its nodes, as places in its own code's list of nodes; a triangle repeats
        the last.
    locals : (L,) uint32
        Face of the cell, an index into `FACES`.
    face_start : (257,) intp
    """

    faces_of_class: list[tuple[int, ...]]
    terms: NDArray[np.intp]
    steps: NDArray[np.float32]
    triangular: NDArray[np.bool_]
    classes: NDArray[np.intp]
    node_start: NDArray[np.intp]
    places: NDArray[np.intp]
    locals: NDArray[np.uint32]
    face_start: NDArray[np.intp]


@dataclass(frozen=True)
class _Node:
    """A node: its vertex, another whose exposure keeps it too, its steps to others, the faces it lies on."""

    vertex: int
    other: int
    steps: dict[int, float]
    faces: tuple[int, ...]
    triangular: bool = False


@cache
def lattice(pattern: Pattern) -> Lattice:
    """The lattice of the cells that collapse by a pattern."""
    rings = polygons(pattern)
    nodes = _nodes(rings)
    number = {name: i for i, name in enumerate(nodes)}
    exposed = np.arange(256)[:, None] >> np.arange(8) & 1 == 1
    keeps = np.array([exposed[:, node.vertex] | exposed[:, node.other] for node in nodes.values()])
    codes, kept = np.nonzero(keeps.T)
    vertex = np.array([node.vertex for node in nodes.values()])
    terms, steps = _terms(list(nodes.values()))

    pieces = [piece for face, ring in rings for piece in _pieces(face, ring, exposed, number)]
    face_codes, kept_faces = np.nonzero(np.array([when for _, _, when in pieces]).T)
    rank = np.cumsum(keeps.T, axis=1) - 1
    corners = np.array([piece for _, piece, _ in pieces])[kept_faces]
    local = np.array([face for face, _, _ in pieces], dtype=np.uint32)
    classes = sorted({node.faces for node in nodes.values()})
    return Lattice(
        faces_of_class=classes,
        terms=terms[:, kept],
        steps=steps[:, kept] * exposed[codes, vertex[kept]],
        triangular=np.array([node.triangular for node in nodes.values()])[kept],
        classes=np.array([classes.index(node.faces) for node in nodes.values()])[kept],
        node_start=np.searchsorted(codes, np.arange(257)),
        places=rank[face_codes, corners.T],
        locals=local[kept_faces],
        face_start=np.searchsorted(face_codes, np.arange(257)),
    )


def _nodes(rings: list[tuple[int, Pattern]]) -> dict[tuple[str, int, int], _Node]:
    """All nodes by what they stand for: tip of a vertex, vertex and edge, vertex and face."""
    faces: dict[int, list[int]] = {}
    ends: dict[int, list[int]] = {}
    beside: dict[tuple[int, int], list[tuple[int, int]]] = {}
    nodes: dict[tuple[str, int, int], _Node] = {}
    for face, ring in rings:
        for i, vertex in enumerate(ring):
            before, after = ring[i - 1], ring[(i + 1) % len(ring)]
            faces.setdefault(vertex, []).append(face)
            for other, third in ((before, after), (after, before)):
                if other not in ends.setdefault(vertex, []):
                    ends[vertex].append(other)
                beside.setdefault((vertex, other), []).append((face, third))
            steps = {before: 1.0, after: 1.0}
            nodes["side", vertex, face] = _Node(vertex, vertex, steps, (face,), len(ring) == 3)
    for (vertex, other), around in beside.items():
        steps = {other: 1.0}
        for _, third in around:
            steps[third] = steps.get(third, 0.0) + EDGE * 2 / len(around)
        nodes["edge", vertex, other] = _Node(
            vertex, other, steps, tuple(sorted({face for face, _ in around}))
        )
    for vertex, others in ends.items():
        steps = dict.fromkeys(others, TIP * 3 / len(others))
        nodes["tip", vertex, vertex] = _Node(vertex, vertex, steps, tuple(sorted(set(faces[vertex]))))
    return nodes


def _terms(nodes: list[_Node]) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Corners and steps of each node as columns of two tables; the node's own vertex fills what is left."""
    depth = 1 + max((len(node.steps) for node in nodes), default=0)
    terms = np.array([[node.vertex] * depth for node in nodes], dtype=np.intp).reshape(-1, depth).T.copy()
    steps = np.zeros(terms.shape, np.float32)
    for i, node in enumerate(nodes):
        for j, (corner, step) in enumerate(node.steps.items(), start=1):
            terms[j, i], steps[j, i] = corner, step
    return terms, steps


def _pieces(
    face: int, ring: Pattern, exposed: NDArray[np.bool_], number: dict[tuple[str, int, int], int]
) -> list[tuple[int, tuple[int, int, int, int], Array]]:
    """Pieces of a face: the face, four nodes, and with which codes the piece is there."""
    out: list[tuple[int, tuple[int, int, int, int], Array]] = []
    side = [number["side", vertex, face] for vertex in ring]
    for i, vertex in enumerate(ring):
        j = (i + 1) % len(ring)
        before, after = ring[i - 1], ring[j]
        along, back = number["edge", vertex, after], number["edge", after, vertex]
        tip = number["tip", vertex, vertex]
        here, there = exposed[:, vertex], exposed[:, after]
        out.append((face, (tip, along, side[i], number["edge", vertex, before]), here))
        out.append((face, (along, back, side[j], side[i]), here & there))
        out.append((face, (along, back, side[i], side[i]), here & ~there))
        out.append((face, (along, back, side[j], side[j]), there & ~here))
    whole = np.logical_and.reduce(exposed[:, list(ring)], axis=1)
    out.append((face, (side[0], side[1], side[2], side[-1]), whole))
    return out
