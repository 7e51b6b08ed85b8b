"""Meshes made ready to be opened."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..diagnosis import turn_round
from ..mesh import Mesh


def prepared(mesh: Mesh) -> Mesh:
    """Make a mesh ready to be opened: turned round where all its cells are inverted, and in a unit within reach.

    Where its coordinates are too large or too small for products, they are told in another unit, which a note names.
    """
    mesh = turn_round(mesh)
    near, exponent = mesh.within_reach
    if not exponent:
        return mesh
    tens = round(exponent * np.log10(2))
    note = f"Lengths are told in units of 2^{exponent} (about 1e{tens}) of the file's own, which is out of reach."
    return replace(near, notes=[*near.notes, note])
