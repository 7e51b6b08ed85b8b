"""What a `.msh` file says elements belong to: volumes, surfaces, curves and points, with their physical groups."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..grouping import Grouping
from ..groups import Group
from ..mesh import Mesh
from .written_groups import names_of, tags_of

LARGEST_NUMBER = 2**31 - 1


@dataclass(frozen=True)
class Owners:
    """What the elements of one dimension belong to.

    Parameters
    ----------
    dimension : int
    entities : (n,) int64
        Tag of each element's entity.
    physicals : dict of int to list of int
        Physical groups of each entity.
    first : (n,) int64
        The one physical group of each element where a format has place for one: of several that of fewest members.
    several : int
        How many elements are in more than one.
    names : dict of int to str
        Names of the physical groups.
    """

    dimension: int
    entities: NDArray[np.int64]
    physicals: dict[int, list[int]]
    first: NDArray[np.int64]
    several: int
    names: dict[int, str]


def owners_of(dimension: int, count: int, entities: Array, groups: Sequence[Group]) -> Owners:
    """Part elements into entities in each of which all belong to the same groups.

    An entity keeps its tag where all of its elements do and tags are from 1 on; else all are counted.

    Parameters
    ----------
    dimension, count : int
    entities : (count,) int
        As the file that was read had them; 0 where it had none.
    groups : sequence of Group
        Which become physical groups.
    """
    tags, names = tags_of(groups), names_of(groups, clean)
    label = np.unique(entities, return_inverse=True)[1].reshape(-1).astype(np.int64)
    most = int(label.max(initial=0)) + 1
    for group in groups:
        found, inverse = np.unique(label[group.members], return_inverse=True)
        label[group.members] = most + inverse.reshape(-1)
        most += len(found)
    _, firsts, inverse = np.unique(label, return_index=True, return_inverse=True)
    own = np.asarray(entities)[firsts].astype(np.int64)
    if (own < 1).any() or len(np.unique(own)) < len(own):
        own = np.arange(1, len(own) + 1)
    physicals: dict[int, list[int]] = {int(tag): [] for tag in own}
    place = inverse.reshape(-1)
    for group, tag in zip(groups, tags, strict=True):
        for entity in np.unique(place[group.members]).tolist():
            physicals[int(own[entity])].append(tag)
    grouping = Grouping("", tuple(groups), count)
    labels = grouping.labels
    first = np.where(labels >= 0, np.array([*tags, 0], dtype=np.int64)[labels], 0)
    named = {
        tag: name for tag, name, group in zip(tags, names, groups, strict=True) if group.name != str(tag)
    }
    return Owners(dimension, own[place], physicals, first, grouping.in_several, named)


def physical_groups(mesh: Mesh) -> list[Group]:
    """The groups of cells that become physical groups: all named ones, else those of the attribute "physical"."""
    named = [group for group in mesh.groups if group.on == "cell"]
    if named or not is_owner(mesh, "physical"):
        return named
    values = mesh.cell_data["physical"]
    found = np.unique(values).tolist()
    return [
        Group(str(value), "physical", np.flatnonzero(values == value), number=value)
        for value in found
        if value
    ]


def owners(mesh: Mesh) -> list[Owners]:
    """What cells and features belong to; cells first."""
    out = [
        owners_of(3, mesh.cell_count, whole_owner(mesh, "entity"), physical_groups(mesh)),
    ]
    for features in mesh.features:
        entities = features.data.get("entity", features.data.get("reference"))
        if entities is None or int(np.min(entities)) < 0 or int(np.max(entities)) > LARGEST_NUMBER:
            entities = np.zeros(features.count, dtype=np.int64)
        out.append(owners_of(features.dimension, features.count, entities, features.groups))
    return out


def is_owner(mesh: Mesh, name: str) -> bool:
    """Whether the attribute of cells can be what cells belong to: an int32, not negative."""
    found = mesh.cell_data.get(name)
    if found is None or found.ndim != 1 or found.dtype.kind not in "iu" or not len(found):
        return False
    return bool(found.min() >= 0 and found.max() <= LARGEST_NUMBER)


def whole_owner(mesh: Mesh, name: str) -> NDArray[np.int64]:
    """(C,) what each cell belongs to, 0 where it is not known."""
    if not is_owner(mesh, name):
        return np.zeros(mesh.cell_count, np.int64)
    return mesh.cell_data[name].astype(np.int64)


def clean(name: str) -> str:
    """A name as it may stand between quotes on one line."""
    return " ".join(name.replace('"', "'").split())[:127] or "unnamed"
