"""Facts of groups and features: what they are, how large and how good (SPEC R12, R13), and where groups meet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .arrays import Array, Floats
from .diagnosis import held_features
from .grouping import Grouping, feature_groups, groups_of
from .groups import DIMENSIONS, Group
from .mesh import Mesh
from .topology import Topology

MOST_PAIRS = 4_000_000
"""Of so many possible pairs of groups those that meet are counted in a table."""

KINDS_OF_GROUP = {"cell": "cells", "vertex": "vertices"}
"""What the members of groups are, in facts."""


def listed_groups(groups: Sequence[Group]) -> list[dict[str, Any]]:
    """What groups there are: `id`, `name`, `kind` ("cells" or "vertices"), `origin`, `number`, `count` of each."""
    return [
        {
            "id": group.id,
            "name": group.name,
            "kind": KINDS_OF_GROUP[group.on],
            "origin": group.origin,
            "number": group.number,
            "count": group.count,
        }
        for group in groups
    ]


def called(group: dict[str, Any]) -> str:
    """Write what a listed group is called: of one that is known by a number alone, with its origin."""
    if group["name"] == str(group["number"]):
        return f"{group['origin']} {group['name']}"
    return f"{group['name']} ({group['origin']})"


def listed_features(mesh: Mesh) -> dict[str, dict[str, Any]]:
    """What features there are: for "corners", "edges" and "faces" each `count`, `lost`, `groups`.

    Lost are those that are no vertex, edge or face of a cell. Of each group the `id`, `name`, `origin`, `number`,
    `count`.
    """
    facts: dict[str, dict[str, Any]] = {name: {"count": 0, "lost": 0, "groups": []} for name in DIMENSIONS}
    for part, there in held_features(mesh):
        rows = listed_groups(feature_groups(part.data, part.groups))
        for row in rows:
            del row["kind"]
        facts[part.called] = {
            "count": part.count,
            "lost": int(np.count_nonzero(~there)),
            "groups": rows,
        }
    return facts


def group_measures(
    groups: Sequence[Group], volume: Floats, scaled_jacobian: Floats, invalid: NDArray[np.bool_]
) -> list[dict[str, Any]]:
    """Measure groups of cells.

    Parameters
    ----------
    groups : sequence of Group
        Of cells.
    volume, scaled_jacobian : (C,) float64
    invalid : (C,) bool

    Returns
    -------
    list of dict
        For each group: `volume` (sum of the finite ones), `scaled_jacobian_min`, `scaled_jacobian_mean` (of the
        finite ones; None if there are none), `invalid` (number of cells).
    """
    sizes = np.array([group.count for group in groups], dtype=np.int64)
    full = np.flatnonzero(sizes)
    out: list[dict[str, Any]] = [
        {"volume": 0.0, "scaled_jacobian_min": None, "scaled_jacobian_mean": None, "invalid": 0}
        for _ in groups
    ]
    if not len(full):
        return out
    members = np.concatenate([groups[place].members for place in full])
    starts = np.append(0, np.cumsum(sizes[full])[:-1]).astype(np.intp)  # of 32 bits in a browser
    volumes = _sums(volume[members], starts)[0]
    quality = scaled_jacobian[members]
    finite = np.isfinite(quality)
    least = np.minimum.reduceat(np.where(finite, quality, np.inf), starts)
    total, counted = _sums(quality, starts)
    bad = np.add.reduceat(invalid[members].astype(np.int64), starts)
    for place, row in enumerate(full.tolist()):
        has = counted[place] > 0
        out[row] = {
            "volume": float(volumes[place]),
            "scaled_jacobian_min": float(least[place]) if has else None,
            "scaled_jacobian_mean": float(total[place] / counted[place]) if has else None,
            "invalid": int(bad[place]),
        }
    return out


def _sums(values: Floats, starts: Array) -> tuple[Floats, Array]:
    """Sum and number of the finite values of each stretch."""
    finite = np.isfinite(values)
    return (
        np.add.reduceat(np.where(finite, values, 0.0), starts),
        np.add.reduceat(finite.astype(np.int64), starts),
    )


def interfaces(grouping: Grouping, topology: Topology) -> dict[tuple[int, int], Array]:
    """Find the faces between two groups.

    Parameters
    ----------
    grouping : Grouping
        Of cells that are in several groups the one that `labels` tells counts.
    topology : Topology

    Returns
    -------
    dict of (int, int) to (n,) intp
        Rows of the faces for each pair of groups that meet, the places of both among the groups, the smaller first;
        -1 stands for cells in no group.
    """
    rows, keys, count = _parting(grouping, topology)
    if not len(rows):
        return {}
    order = np.argsort(keys, kind="stable")
    found, starts = np.unique(keys[order], return_index=True)
    return {
        (key // count - 1, key % count - 1): rows[part]
        for key, part in zip(found.tolist(), np.split(order, starts[1:]), strict=True)
    }


def meeting(grouping: Grouping, topology: Topology) -> list[tuple[int, int]]:
    """Pairs of groups that have a face in common, as in `interfaces`, without the faces."""
    _, keys, count = _parting(grouping, topology)
    few = count * count < MOST_PAIRS
    found = np.flatnonzero(np.bincount(keys, minlength=1)) if few else np.unique(keys)
    return [(key // count - 1, key % count - 1) for key in found.tolist()]


def _parting(grouping: Grouping, topology: Topology) -> tuple[NDArray[np.intp], Array, int]:
    """Rows of the faces between cells of different labels, a key of each pair, and what keys are made with.

    A pair's key is the smaller label, times the count, plus the larger one, both counted from 1 on. Keys are short
    where they can be: short numbers are sorted by their digits, in one pass.
    """
    labels, faces = grouping.labels, topology.faces
    left, right = labels[faces.cells[0, : faces.paired]], labels[faces.cells[1, : faces.paired]]
    rows = np.flatnonzero(left != right)
    one, other = np.minimum(left[rows], right[rows]), np.maximum(left[rows], right[rows])
    count = len(grouping.groups) + 1
    short = np.uint16 if count * count < 2**16 else np.int64
    return rows, ((one + 1).astype(np.int64) * count + other + 1).astype(short), count


def all_groups(mesh: Mesh) -> list[dict[str, Any]]:
    """What groups a mesh has; see `listed_groups`."""
    return listed_groups(groups_of(mesh))
