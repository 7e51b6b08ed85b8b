"""What holds for every surface, looked at from outside: by positions, one face at a time."""

from __future__ import annotations

from collections import Counter, defaultdict

import numpy as np
from numpy.typing import NDArray

from hexalab.surface import Surface


def points_of(surface: Surface) -> NDArray[np.float64]:
    """(N, 3) positions."""
    return surface.positions.reshape(-1, 3).astype(float)


def rings_of(surface: Surface) -> NDArray[np.int64]:
    """(Q, 4) vertices of each quad."""
    count = len(surface.cells)
    return (np.arange(count) if surface.quads is None else surface.quads.astype(np.int64)).reshape(-1, 4)


def by_position(surface: Surface) -> NDArray[np.int64]:
    """(Q, 4) quads by numbers that two vertices share if and only if they are in the same place."""
    _, number = np.unique(surface.positions.reshape(-1, 3) + np.float32(0), axis=0, return_inverse=True)
    return number.reshape(-1)[rings_of(surface)]


def sides(rings: NDArray[np.int64]) -> Counter[tuple[int, int]]:
    """How often the quads cross each edge, each direction by itself."""
    start, end = rings.reshape(-1), np.roll(rings, -1, axis=1).reshape(-1)
    real = start != end
    return Counter(zip(start[real].tolist(), end[real].tolist(), strict=True))


def check_form(surface: Surface) -> None:
    """Lengths, number types, ranges, unit normals; triangles repeat their last vertex, quads none."""
    rings = rings_of(surface)
    count = len(surface.cells)
    assert surface.positions.dtype == np.float32 and surface.positions.shape == (3 * count,)
    assert surface.normals.dtype == np.int16 and surface.normals.shape == (4 * count,)
    assert surface.cells.dtype == np.uint32 and surface.inside.dtype == np.uint8
    assert surface.inside.shape == (count,)
    assert surface.faces.dtype == np.uint32 and surface.faces.shape == (len(rings),)
    assert surface.edges.dtype == np.float32 and surface.edge_cells.dtype == np.uint8
    check_edge_faces(surface)
    assert np.isfinite(surface.positions).all() and np.isfinite(surface.edges).all()
    if surface.quads is not None:
        assert surface.quads.dtype == np.uint32
        assert set(rings.reshape(-1).tolist()) == set(range(count))
        assert all(len(set(ring)) == 4 or ring[2] == ring[3] for ring in rings.tolist())
    assert (surface.cells[rings] == (surface.faces // 8)[:, None]).all()
    assert (surface.faces % 8 < 6).all()
    normals = surface.normals.reshape(-1, 4)
    assert (normals[:, 3] == 0).all()
    assert np.allclose(np.linalg.norm(normals[:, :3] / 32767, axis=1), 1, atol=1e-4)


def check_edge_faces(surface: Surface) -> None:
    """The two faces that are named at each edge have both its ends; they differ where two faces meet there."""
    ends = surface.edges.reshape(-1, 2, 3).tolist()
    beside = surface.edge_faces.reshape(-1, 2)
    assert surface.edge_faces.dtype == np.uint32 and len(beside) == len(ends)
    around: dict[frozenset[tuple[float, ...]], set[int]] = defaultdict(set)
    points = surface.positions.reshape(-1, 3).tolist()
    for face, ring in enumerate(rings_of(surface).tolist()):
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
            around[frozenset((tuple(points[a]), tuple(points[b])))].add(face)
    for pair, faces in zip(ends, beside.tolist(), strict=True):
        meeting = around[frozenset(map(tuple, pair))]
        assert set(faces) <= meeting and (len(set(faces)) == 2 or len(meeting) == 1)


def check_closed(surface: Surface) -> None:
    """Every edge is crossed as often in one direction as in the other."""
    crossed = sides(by_position(surface))
    assert all(crossed[b, a] == n for (a, b), n in crossed.items())


def check_manifold(surface: Surface) -> None:
    """Every edge is crossed once in each direction."""
    crossed = sides(by_position(surface))
    assert all(n == 1 and crossed[b, a] == 1 for (a, b), n in crossed.items())


def volume(surface: Surface) -> float:
    """Volume within, each quad taken as its bilinear patch: the mean of its two triangulations."""
    a, b, c, d = (points_of(surface)[rings_of(surface)][:, i] for i in range(4))

    def tetrahedra(p: NDArray[np.float64], q: NDArray[np.float64], r: NDArray[np.float64]) -> float:
        return float((np.cross(p, q) * r).sum()) / 6

    return (tetrahedra(a, b, c) + tetrahedra(a, c, d) + tetrahedra(a, b, d) + tetrahedra(b, c, d)) / 2


def cell_volumes(points: NDArray[np.float64], cells: NDArray[np.int32]) -> NDArray[np.float64]:
    """Volumes of trilinear cells (C, 8), collapsed ones too: two Gauss points each way are exact."""
    total = np.zeros(len(cells))
    sign = np.array([(x, y, z) for x, y, z in _CORNERS]) * 2 - 1.0
    for at in (np.array(p) for p in np.ndindex(2, 2, 2)):
        u = (at * 2 - 1) / np.sqrt(3)
        factors = (1 + sign * u) / 2
        jacobian = []
        for axis in range(3):
            slope = sign[:, axis] / 2 * np.delete(factors, axis, axis=1).prod(axis=1)
            jacobian.append(np.einsum("k,ckx->cx", slope, points[cells]))
        total += np.einsum("cx,cx->c", np.cross(jacobian[0], jacobian[1]), jacobian[2])
    return total


_CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
