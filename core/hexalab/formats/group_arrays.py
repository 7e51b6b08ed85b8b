"""Groups as arrays of 0 and 1, in formats that have no other place for them (VTK's).

The array of the group "elset:STEEL" is called "group:elset:STEEL".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from ..arrays import Array
from ..groups import Group, On
from ..mesh import Mesh
from .feature_blocks import FeatureBlock

MARK = "group:"


def group_arrays(mesh: Mesh, on: On) -> dict[str, Array]:
    """(n,) uint8 for each group of cells or vertices: 1 for its members."""
    count = mesh.cell_count if on == "cell" else mesh.vertex_count
    out: dict[str, Array] = {}
    for group in mesh.groups:
        if group.on == on:
            out[MARK + group.id] = mask = np.zeros(count, dtype=np.uint8)
            mask[group.members] = 1
    return out


def attach(features: list[FeatureBlock], arrays: Mapping[str, Array], kept: Array | None) -> dict[str, Array]:
    """Give features what a file's arrays of cells say of them; return the arrays of the cells that are kept.

    Features get whole numbers, one each. An array that says something of features alone, and 0 of all cells, is
    theirs only.

    Parameters
    ----------
    features : list of FeatureBlock
    arrays : dict of str to (n,) or (n, k) arrays
        A row for each of the file's cells, those that became features among them.
    kept : (C,) int or None
        Rows that became cells; None for all.
    """
    own = {name: values if kept is None else values[kept] for name, values in arrays.items()}
    for block in features:
        if block.rows is None:
            continue
        for name, values in arrays.items():
            if values.dtype.kind not in "iub" or values.size != len(values):
                continue
            said = values.reshape(-1)[block.rows]
            if said.any() and name in own and not own[name].any():
                del own[name]
            mark, _, id = name.partition(":")
            origin, _, called = id.partition(":")
            if mark + ":" != MARK or not called:
                block.data[name] = said.astype(np.int64)
            elif said.any():
                block.groups.append(Group(called, origin, np.flatnonzero(said)))
        block.rows = None
    return own


def taken_groups(data: dict[str, Array], on: On) -> Iterator[Group]:
    """The groups that arrays of 0 and 1 of such names tell; these are taken out of the data."""
    for array in [name for name in data if name.startswith(MARK)]:
        origin, _, name = array.removeprefix(MARK).partition(":")
        values = data[array]
        if name and values.ndim == 1 and ((values == 0) | (values == 1)).all():
            yield Group(name, origin, np.flatnonzero(values), on)
            del data[array]
