"""Groups of an open mesh: what there is, their colours, how good they are, where they meet."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..contacts import contacts
from ..errors import HexaLabError
from ..group_facts import interfaces, listed_groups, meeting
from ..grouping import Grouping, groupings, groups_of
from ..groups import Group
from ..mesh import Mesh

GROUP_COLOURS = 12
"""The viewer's palette of groups has so many colours before it begins again."""

PAIR_COLOURS = 6
"""So many colours the viewer has for faces between groups; `marked` counts on."""

NO_ROWS = np.zeros(0, dtype=np.int32)


class GroupBook:
    """The groups of a mesh, each part found when it is first asked for.

    Parameters
    ----------
    mesh : Mesh
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._colours: dict[str, NDArray[np.int32]] = {}
        self._interfaces: dict[str, dict[tuple[int, int], Array]] = {}
        self._tables: dict[str, list[dict[str, Any]]] = {}

    @cached_property
    def every(self) -> tuple[Group, ...]:
        """All groups, of cells and of vertices."""
        return groups_of(self._mesh)

    @cached_property
    def of_cells(self) -> dict[str, Group]:
        """Groups of cells by id."""
        return {group.id: group for group in self.every if group.on == "cell"}

    @cached_property
    def of_vertices(self) -> dict[str, Group]:
        """Groups of vertices by id."""
        return {group.id: group for group in self.every if group.on == "vertex"}

    @cached_property
    def groupings(self) -> dict[str, Grouping]:
        """Groups of cells, by origin."""
        return groupings(self._mesh, self.every)

    def members(self, id: str) -> Ids:
        """Rows of the cells of a group; none where there is no such group."""
        group = self.of_cells.get(id)
        return NO_ROWS if group is None else group.members

    def grouping(self, origin: str) -> Grouping:
        """Groups of one origin.

        Raises
        ------
        HexaLabError
            There is no group of cells of that origin.
        """
        if origin not in self.groupings:
            known = ", ".join(self.groupings) or "none"
            raise HexaLabError(f"the mesh has no groups of the origin {origin!r}; it has {known}")
        return self.groupings[origin]

    def interfaces(self, origin: str) -> dict[tuple[int, int], Array]:
        """Rows of the faces between groups; see `hexalab.group_facts.interfaces`."""
        if origin not in self._interfaces:
            self._interfaces[origin] = interfaces(self.grouping(origin), self._mesh.topology)
        return self._interfaces[origin]

    def colours(self, origin: str) -> NDArray[np.int32]:
        """Colour of each group of an origin, (G,): those that meet have different ones as far as colours go."""
        if origin not in self._colours:
            grouping = self.grouping(origin)
            pairs = [pair for pair in meeting(grouping, self._mesh.topology) if pair[0] >= 0]
            self._colours[origin] = apart(len(grouping.groups), pairs, GROUP_COLOURS)
        return self._colours[origin]

    def interface_table(self, origin: str) -> list[dict[str, Any]]:
        """Tell where the groups of an origin meet.

        Returns
        -------
        list of dict
            For each pair `groups` (two ids; None stands for cells in no group), `faces` (those that both share),
            `apart` (faces of the one that lie on the other
            and are not joined to it; see `hexalab.contacts`), `colour` of the faces.
        """
        if origin not in self._tables:
            self._tables[origin] = self._interface_table(origin)
        return self._tables[origin]

    def _interface_table(self, origin: str) -> list[dict[str, Any]]:
        grouping, shared = self.grouping(origin), self.interfaces(origin)
        apart_too = contacts(self._mesh, grouping.labels)
        colours = {pair: place % PAIR_COLOURS for place, pair in enumerate(shared)}

        def name(place: int) -> str | None:
            return grouping.groups[place].id if place >= 0 else None

        return [
            {
                "groups": [name(place) for place in pair],
                "faces": len(shared.get(pair, ())),
                "apart": apart_too.get(pair, 0),
                "colour": colours.get(pair),
            }
            for pair in dict.fromkeys([*shared, *apart_too])
        ]

    def listed(self) -> list[dict[str, Any]]:
        """What groups there are; see `hexalab.group_facts.listed_groups`."""
        return listed_groups(self.every)


def apart(count: int, pairs: list[tuple[int, int]], colours: int) -> NDArray[np.int32]:
    """Colour things so that those of a pair differ.

    In their order each takes the colour least used by its neighbours, of these the one least used at all.

    >>> apart(4, [(0, 1), (1, 2)], 3).tolist()
    [0, 1, 2, 0]
    """
    neighbours: list[list[int]] = [[] for _ in range(count)]
    for one, other in pairs:
        neighbours[one].append(other)
        neighbours[other].append(one)
    out = np.full(count, -1, dtype=np.int32)
    used = np.zeros(colours, dtype=np.int64)
    for thing in range(count):
        near = np.zeros(colours, dtype=np.int64)
        for other in neighbours[thing]:
            if out[other] >= 0:
                near[out[other]] += 1
        colour = int(np.lexsort((np.arange(colours), used, near))[0])
        out[thing] = colour
        used[colour] += 1
    return out
