"""Verdict's equiangle skew of hexahedra: how far the angles of the six faces are from right angles.

See `hexahedron` for the source and the conventions.
"""

from __future__ import annotations

from math import pi

import numpy as np

from ..arrays import Floats
from .arena import dot
from .block import BITS, QUADS, TOLERANCE, HexahedronBlock

SIGNS = ((1, 1, -1, -1, -1, -1, 1, 1), (1, -1, -1, 1, 1, -1, -1, 1), (1, -1, 1, -1, -1, 1, -1, 1))
"""For the pairs u v, v w, w u: sign between the cosine of two edges and that of the face's angle, at each corner."""

FACE_ROWS = (((0, 1, 4, 5), (2, 3, 6, 7)), ((0, 3, 5, 6), (1, 2, 4, 7)), ((0, 2, 4, 6), (1, 3, 5, 7)))
"""For the pairs u v, v w, w u: corners (rows of the block) of the two faces that the pair spans."""


def equiangle_skew(block: HexahedronBlock, out: Floats) -> None:
    """Largest of (angle - 90) / 90 and (90 - angle) / 90 over the faces' angles, in degrees.

    As VTK 9.6 computes it, the largest angle of a face that is not convex counts as 360 minus it, so that values up
    to 3 occur. A face with an edge below 2.2e-15 has no angles (it counts as -1), but if its third and fourth
    corner (see `QUADS`) coincide it counts as a triangle, and as 1 if that is degenerate.
    """
    widest, reflex, narrowest = block.array("widest"), block.array("reflex"), out
    widest.fill(1)
    reflex.fill(-2)
    narrowest.fill(-1)
    least, most, bent = block.array("own_1"), block.array("product_1"), block.array("scratch_1")
    for pair in range(3):
        cosines = _cosines(block, pair)
        for rows in FACE_ROWS[pair]:
            np.minimum(cosines[rows[0]], cosines[rows[1]], out=least)
            np.maximum(cosines[rows[0]], cosines[rows[1]], out=most)
            for row in rows[2:]:
                np.minimum(least, cosines[row], out=least)
                np.maximum(most, cosines[row], out=most)
            np.maximum(narrowest, most, out=narrowest)
            concave = _least_turn(block, pair, rows, bent) < 0
            if concave.any():
                np.copyto(reflex, np.maximum(reflex, least), where=concave)
                least[concave] = 1
            np.minimum(widest, least, out=widest)
    _to_skew(widest, reflex, narrowest, out)
    short = block.lengths.min(axis=0) <= TOLERANCE
    if short.any():
        out[short] = _with_short_edges(block.points[:, BITS, :][..., short])


def _to_skew(widest: Floats, reflex: Floats, narrowest: Floats, out: Floats) -> None:
    """Skew from the cosines of the widest angle, of the least wide of the reflex ones, of the narrowest angle."""
    for cosine in (widest, narrowest):
        np.clip(cosine, -1, 1, out=cosine)
        np.arccos(cosine, out=cosine)
        cosine *= 180 / pi
        cosine -= 90
        cosine /= 90
    np.negative(narrowest, out=out)
    np.maximum(out, widest, out=out)
    bent = reflex > -2
    if bent.any():
        turned = 360 - np.degrees(np.arccos(np.clip(reflex[bent], -1, 1)))
        out[bent] = np.maximum(out[bent], (turned - 90) / 90)


def _cosines(block: HexahedronBlock, pair: int) -> Floats:
    """(8, n) cosines of the angles that two directions span at the corners."""
    out, n = block.array("own_8", 8), block.count
    names = ("uvw"[pair], "uvw"[(pair + 1) % 3])
    lengths = [block.lengths[4 * "uvw".index(name) :][:4] for name in names]
    for odd in (False, True):
        half = out[4 * odd : 4 * odd + 4].reshape(2, 2, n)
        first, second = (block.at_corners(x, name, odd) for x, name in zip(lengths, names, strict=True))
        np.multiply(first, second, out=half)
    np.divide(block.dots[pair], out, out=out)
    for row, sign in enumerate(SIGNS[pair]):
        if sign < 0:
            np.negative(out[row], out=out[row])
    return out


def _least_turn(block: HexahedronBlock, pair: int, rows: tuple[int, ...], out: Floats) -> Floats:
    """Smallest product of a corner's normal with the face's: negative where the face is not convex."""
    normals = block.crosses[pair]
    centre, turn, scratch = block.array("centre_normal", 3), block.array("turn"), block.array("turn_scratch")
    np.add(normals[:, rows[0]], normals[:, rows[1]], out=centre)
    centre += normals[:, rows[2]]
    centre += normals[:, rows[3]]
    dot(centre, normals[:, rows[0]], out, scratch)
    for row in rows[1:]:
        dot(centre, normals[:, row], turn, scratch)
        np.minimum(out, turn, out=out)
    return out


def _with_short_edges(points: Floats) -> Floats:
    """Equiangle skew of cells (3, 8, m) some of whose edges vanish, face by face."""
    out = np.full(points.shape[-1], -1.0)
    for quad in QUADS:
        corners = [points[:, corner] for corner in quad]
        triangle = (corners[2] == corners[3]).all(axis=0)
        np.maximum(out, np.where(triangle, _as_quad(corners[:3]), polygon_skew(corners)), out=out)
    return out


def polygon_skew(corners: list[Floats]) -> Floats:
    """Equiangle skew of triangles (by 60 degrees) or quadrilaterals (by 90 degrees), corners (3, m) each."""
    widest, narrowest, shortest = _angles(corners)
    right = 60 if len(corners) == 3 else 90
    skew = np.maximum((widest - right) / (180 - right), (right - narrowest) / right)
    return np.where(shortest <= TOLERANCE, -1 if right == 90 else 1, skew)


def _as_quad(corners: list[Floats]) -> Floats:
    """Skew of a triangle that stands for a quadrilateral, by right angles."""
    widest, narrowest, shortest = _angles(corners)
    return np.where(shortest == 0, 1, np.maximum((widest - 90) / 90, (90 - narrowest) / 90))


def _angles(corners: list[Floats]) -> tuple[Floats, Floats, Floats]:
    """Widest (360 minus it where not convex) and narrowest angle in degrees, length of the shortest edge."""
    count = len(corners)
    edges = [corners[(i + 1) % count] - corners[i] for i in range(count)]
    lengths = [np.sqrt((edge * edge).sum(axis=0)) for edge in edges]
    cosines = [-(edges[i - 1] * edges[i]).sum(axis=0) / (lengths[i - 1] * lengths[i]) for i in range(count)]
    angles = np.degrees(np.arccos(np.clip(cosines, -1, 1)))
    widest, narrowest = angles.max(axis=0), angles.min(axis=0)
    if count == 4:
        normals = [np.cross(edges[i - 1], edges[i], axis=0) for i in range(4)]
        centre = np.sum(normals, axis=0)
        turned = np.min([(centre * normal).sum(axis=0) for normal in normals], axis=0) < 0
        widest = np.where(turned, 360 - widest, widest)
    return widest, narrowest, np.min(lengths, axis=0)
