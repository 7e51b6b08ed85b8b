"""The angles of faces: the smallest, the largest, and Verdict's equiangle skew.

See `hexahedron` for the source and the conventions. The largest angle of a quadrilateral that is not convex is beyond
180 degrees: 360 minus what its two edges span.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

import numpy as np

from ..arrays import Floats
from ..cells import TETRAHEDRON
from .arena import dot
from .block import BITS, QUADS, TOLERANCE, HexahedronBlock
from .cells import CellBlock, cross, times
from .other_kinds import FACES_OF_KINDS, TETRAHEDRON_FACES

SIGNS = ((1, 1, -1, -1, -1, -1, 1, 1), (1, -1, -1, 1, 1, -1, -1, 1), (1, -1, 1, -1, -1, 1, -1, 1))
"""For the pairs u v, v w, w u: sign between the cosine of two edges and that of the face's angle, at each corner."""

FACE_ROWS = (((0, 1, 4, 5), (2, 3, 6, 7)), ((0, 3, 5, 6), (1, 2, 4, 7)), ((0, 2, 4, 6), (1, 3, 5, 7)))
"""For the pairs u v, v w, w u: corners (rows of the block) of the two faces that the pair spans."""


IDEAL_DIHEDRAL = float(np.degrees(np.arccos(1 / 3)))


def hexahedron_equiangle_skew(block: HexahedronBlock, out: Floats) -> None:
    """Largest of (angle - 90) / 90 and (90 - angle) / 90 over the faces' angles, in degrees: up to 3.

    A face with an edge below 2.2e-15 of the cell's size has no angles (it counts as -1), but if its third and fourth
    corner (see `QUADS`) coincide it counts as a triangle, and as 1 if that is degenerate. VTK 9.6 compares edges with
    2.2e-15 in the file's unit: not taken over.
    """
    smallest, largest = hexahedron_angles(block)
    np.subtract(90, smallest, out=out)
    np.maximum(out, np.subtract(largest, 90, out=block.array("own_1")), out=out)
    out /= 90
    short = short_edges(block)
    if short.any():
        out[short] = _with_short_edges(block.points[:, BITS, :][..., short])


def hexahedron_smallest_angle(block: HexahedronBlock, out: Floats) -> None:
    """Smallest angle between two edges of a face, in degrees; -inf where a cell has no angles."""
    np.copyto(out, _all_angles(block)[0])
    out[np.isnan(out)] = -inf


def hexahedron_largest_angle(block: HexahedronBlock, out: Floats) -> None:
    """Largest angle between two edges of a face, in degrees; inf where a cell has no angles."""
    np.copyto(out, _all_angles(block)[1])
    out[np.isnan(out)] = inf


def short_edges(block: HexahedronBlock) -> Floats:
    """(n,) bool: whether an edge vanishes beside the cell's box."""
    return np.asarray(block.lengths.min(axis=0) <= TOLERANCE * block.size)


def _all_angles(block: HexahedronBlock) -> tuple[Floats, Floats]:
    """Smallest and largest angle; where edges vanish, of the faces without them."""
    smallest, largest = hexahedron_angles(block)
    short = short_edges(block)
    if short.any():
        smallest, largest = smallest.copy(), largest.copy()
        points = block.points[:, BITS, :][..., short]
        angles = [polygon_angles([points[:, corner] for corner in quad]) for quad in QUADS]
        smallest[short] = np.fmin.reduce([least for least, _ in angles])
        largest[short] = np.fmax.reduce([most for _, most in angles])
    return smallest, largest


def hexahedron_angles(block: HexahedronBlock) -> tuple[Floats, Floats]:
    """Smallest and largest angle of the six faces, in degrees, of cells whose edges all have a length."""
    if "angles" in block.known:
        known: tuple[Floats, Floats] = block.known["angles"]
        return known
    widest, reflex, narrowest = block.array("widest"), block.array("reflex"), block.array("narrowest")
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
    for cosine in (widest, narrowest):
        np.clip(cosine, -1, 1, out=cosine)
        np.arccos(cosine, out=cosine)
        np.degrees(cosine, out=cosine)
    bent_faces = reflex > -2
    if bent_faces.any():
        turned = 360 - np.degrees(np.arccos(np.clip(reflex[bent_faces], -1, 1)))
        widest[bent_faces] = np.maximum(widest[bent_faces], turned)
    block.known["angles"] = narrowest, widest
    return narrowest, widest


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


def polygon_skew(corners: Sequence[Floats]) -> Floats:
    """Equiangle skew of triangles (by 60 degrees) or quadrilaterals (by 90 degrees), corners (3, m) each."""
    narrowest, widest, vanishing = _angles(corners)
    right = 60 if len(corners) == 3 else 90
    skew = np.maximum((widest - right) / (180 - right), (right - narrowest) / right)
    return np.where(vanishing, -1 if right == 90 else 1, skew)


def _as_quad(corners: Sequence[Floats]) -> Floats:
    """Skew of a triangle that stands for a quadrilateral, by right angles."""
    narrowest, widest, vanishing = _angles(corners)
    return np.where(vanishing, 1, np.maximum((widest - 90) / 90, (90 - narrowest) / 90))


def polygon_angles(corners: Sequence[Floats]) -> tuple[Floats, Floats]:
    """Smallest and largest angle, in degrees, of triangles or quadrilaterals (3, m); NaN where none has edges.

    Where two neighbouring corners of a quadrilateral coincide it is taken for the triangle that it is.
    """
    narrowest, widest, vanishing = _angles(corners)
    if len(corners) == 4 and vanishing.any():
        for i in range(4):
            joined = vanishing & (corners[i] == corners[(i + 1) % 4]).all(axis=0)
            least, most, flat = _angles([corners[(i + step) % 4] for step in (1, 2, 3)])
            narrowest = np.where(joined, np.where(flat, np.nan, least), narrowest)
            widest = np.where(joined, np.where(flat, np.nan, most), widest)
            vanishing = vanishing & ~joined
    return np.where(vanishing, np.nan, narrowest), np.where(vanishing, np.nan, widest)


def _angles(corners: Sequence[Floats]) -> tuple[Floats, Floats, Floats]:
    """Smallest and largest angle in degrees, and whether an edge vanishes beside the longest."""
    count = len(corners)
    edges = [corners[(i + 1) % count] - corners[i] for i in range(count)]
    lengths = np.sqrt([times(edge, edge) for edge in edges])
    cosines = [-times(edges[i - 1], edges[i]) / (lengths[i - 1] * lengths[i]) for i in range(count)]
    angles = np.degrees(np.arccos(np.clip(cosines, -1, 1)))
    widest, narrowest = angles.max(axis=0), angles.min(axis=0)
    if count == 4:
        normals = [cross(edges[i - 1], edges[i]) for i in range(4)]
        centre = np.sum(normals, axis=0)
        turned = np.min([times(centre, normal) for normal in normals], axis=0) < 0
        widest = np.where(turned, 360 - widest, widest)
    return narrowest, widest, lengths.min(axis=0) <= TOLERANCE * lengths.max(axis=0)


def equiangle_skew(block: CellBlock, out: Floats) -> None:
    """Largest relative departure of a face's angle from 60 degrees (triangles) or 90 degrees (quadrilaterals).

    Of a tetrahedron also of a dihedral angle from 70.53 degrees.
    """
    out.fill(-1)
    for face in FACES_OF_KINDS[block.kind]:
        np.maximum(out, polygon_skew([block.corners[corner] for corner in face]), out=out)
    if block.kind == TETRAHEDRON:
        _with_dihedral_angles(block, out)


def _with_dihedral_angles(block: CellBlock, out: Floats) -> None:
    normals = []
    for a, b, c in TETRAHEDRON_FACES:
        normal = cross(block.corners[b] - block.corners[a], block.corners[c] - block.corners[a])
        normals.append(normal / np.sqrt(times(normal, normal)))
    cosines = [-times(normals[i], normals[j]) for i in range(4) for j in range(i)]
    angles = np.degrees(np.arccos(np.clip(cosines, -1, 1)))
    np.fmax(out, (angles.max(axis=0) - IDEAL_DIHEDRAL) / (180 - IDEAL_DIHEDRAL), out=out)
    np.fmax(out, (IDEAL_DIHEDRAL - angles.min(axis=0)) / IDEAL_DIHEDRAL, out=out)


def smallest_angle(block: CellBlock, out: Floats) -> None:
    """Smallest angle between two edges of a face, in degrees; -inf where a cell has no angles."""
    angles = [
        polygon_angles([block.corners[corner] for corner in face])[0] for face in FACES_OF_KINDS[block.kind]
    ]
    np.fmin.reduce(angles, axis=0, out=out)
    out[np.isnan(out)] = -inf


def largest_angle(block: CellBlock, out: Floats) -> None:
    """Largest angle between two edges of a face, in degrees; inf where a cell has no angles."""
    angles = [
        polygon_angles([block.corners[corner] for corner in face])[1] for face in FACES_OF_KINDS[block.kind]
    ]
    np.fmax.reduce(angles, axis=0, out=out)
    out[np.isnan(out)] = inf
