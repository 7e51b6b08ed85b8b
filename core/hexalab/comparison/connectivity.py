"""Whether the cells of two meshes are the same, so that they can be compared one by one."""

from __future__ import annotations

import hashlib

import numpy as np

from ..mesh import Mesh
from ..words import count, counted


def difference_in_cells(a: Mesh, b: Mesh) -> str:
    """Say what tells the cells of two meshes apart; "" where there is nothing.

    They are the same where each cell has the same kind in both and names the same vertices in the same order: as before
    and after an optimisation that moves vertices alone.

    >>> difference_in_cells(cube, finer)                                          # doctest: +SKIP
    '8 vertices and 27'
    """
    counts = {"vertex": (a.vertex_count, b.vertex_count), "cell": (a.cell_count, b.cell_count)}
    for noun, (ours, theirs) in counts.items():
        if ours != theirs:
            return f"{counted(ours, noun)} and {count(theirs)}"
    differing = (a.corners != b.corners).any(axis=0) | (a.kinds != b.kinds)
    if not differing.any():
        return ""
    return f"{counted(int(np.count_nonzero(differing)), 'cell')} of {count(a.cell_count)} with other corners"


def fingerprint(mesh: Mesh) -> str:
    """SHA-256, in hexadecimal, of what `difference_in_cells` looks at: equal exactly where it finds nothing."""
    digest = hashlib.sha256(f"{mesh.vertex_count} {mesh.cell_count}".encode())
    digest.update(np.ascontiguousarray(mesh.corners, dtype="<i4").data)
    digest.update(mesh.kinds.data)
    return digest.hexdigest()
