"""Vertices at which irregular edges meet: for each triangle on a sphere around them, a block of cells."""

import numpy as np

from .solid import box, outward, unite

THIRD = 2 * np.pi / 3


def around(count, height, start=0.0):
    """So many points of the unit sphere, evenly round a circle of latitude."""
    angle = start + 2 * np.pi * np.arange(count) / count
    radius = np.sqrt(1 - height * height)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(count, height)], axis=1)


def capped(points, *triangles):
    """Points, and one more above each of some triangles of theirs, low enough to leave the triangles' sides."""
    middles = [points[list(triangle)].sum(axis=0) for triangle in triangles]
    return np.concatenate([points, [0.9 * middle / np.linalg.norm(middle) for middle in middles]])


POLES = np.array([[0, 0, 1.0], [0, 0, -1.0]])
TETRAHEDRON = np.concatenate([POLES[:1], around(3, -1 / 3)])
BIPYRAMID = np.concatenate([POLES, around(3, 0.0)])
OCTAHEDRON = np.concatenate([POLES, around(4, 0.0)])

SPHERES = {
    "3 3 3 3": TETRAHEDRON,
    "3 3 4 4 4": BIPYRAMID,
    "3 3 4 4 5 5": capped(BIPYRAMID, (0, 2, 3)),
    "3 4 4 4 5 5 5": capped(OCTAHEDRON, (0, 2, 3)),
    "4 4 4 4 4 5 5": np.concatenate([POLES, around(5, 0.0)]),
    "3 3 5 5 5 5 5 5": np.concatenate([POLES, around(3, 0.4), around(3, -0.4, THIRD / 2)]),
    "4 4 4 4 5 5 5 5": np.concatenate(
        [around(2, 0.85), around(2, -0.85, np.pi / 2), around(2, 0.2, np.pi / 2), around(2, -0.2)]
    ),
    "4 4 4 5 5 5 5 5 5": np.concatenate([around(3, 0.6), around(3, -0.6), around(3, 0.0, THIRD / 2)]),
    "4 4 5 5 5 5 5 5 5 5": np.concatenate([POLES, around(4, 0.4), around(4, -0.4, np.pi / 4)]),
    "5 5 5 5 5 5 5 5 5 5 5 5": np.concatenate([POLES, around(5, 5**-0.5), around(5, -(5**-0.5), np.pi / 5)]),
}
"""Points of the unit sphere by the valences of the edges that lead to them: all ten singular vertices inside a
mesh whose edges have three, four or five cells around them (the eleventh, six edges of four cells, is regular)."""

SPHERES_OF_SIX = {
    "4 4 4 4 4 4 6 6": np.concatenate([POLES, around(6, 0.0)]),
    "3 3 3 3 6 6 6 6": capped(TETRAHEDRON, (0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)),
}
"""Two of the endless many with edges of six cells."""


def triangles_of(points):
    """The triangles of the convex hull of points: all others lie on one side of theirs."""
    found = []
    for a in range(len(points)):
        for b in range(a + 1, len(points)):
            for c in range(b + 1, len(points)):
                normal = np.cross(points[b] - points[a], points[c] - points[a])
                side = np.delete((points - points[a]) @ normal, [a, b, c])
                if (side < -1e-9).all() or (side > 1e-9).all():
                    found.append((a, b, c))
    return found


def node(points, steps):
    """steps^3 cells for each triangle: from the centre out, its three points, and what lies between them."""
    parts = []
    grid, cells = box(steps, steps, steps)
    x, y, z = grid.T[:, :, None]
    ends = points / np.linalg.norm(points, axis=1, keepdims=True)
    for a, b, c in triangles_of(points):
        p, q, r = ends[a], ends[b], ends[c]
        pq, qr, pr = (_between(1.0, 1.3, *pair) for pair in ((p, q), (q, r), (p, r)))
        pqr = _between(1.2, 1.5, p, q, r)
        parts.append((
            x * (1 - y) * (1 - z) * p + y * (1 - x) * (1 - z) * q + z * (1 - x) * (1 - y) * r
            + x * y * (1 - z) * pq + y * z * (1 - x) * qr + x * z * (1 - y) * pr + x * y * z * pqr,
            cells,
        ))  # fmt: skip
    return outward(*unite(*parts))


def _between(least, most, *points):
    total = np.sum(points, axis=0)
    length = np.linalg.norm(total)
    return total / length * np.clip(length, least, most)
