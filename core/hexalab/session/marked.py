"""What is drawn over the surface: features, sharp edges, sets of nodes, faces between groups (SPEC R12, R13)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..diagnosis import held_features
from ..group_facts import listed_features
from ..grouping import Grouping, feature_groups
from ..groups import Features, Group
from ..surface import DrawnMesh, sharp_edges
from ..surface.flat import interleave
from ..surface.records import Bytes, Marks
from ..topology.lookup import sides_of
from .grouped import PAIR_COLOURS, GroupBook

MARK_COLOURS = PAIR_COLOURS
"""The viewer's palette of marks has so many colours before it begins again."""

PLAIN, LOST = 6, 7
"""Of what is in no group, and of features that the mesh does not hold."""

MOST_ANGLE = 180
"""No two faces differ by more degrees."""

KINDS = ("corners", "edges", "faces")
"""Features by dimension, as the settings call them."""


@dataclass(eq=False)
class Drawn:
    """Features of one dimension as they are drawn.

    Parameters
    ----------
    features : Features
    held : (n,) bool
        Whether the mesh holds them.
    """

    features: Features
    held: NDArray[np.bool_]

    @cached_property
    def groups(self) -> tuple[Group, ...]:
        """All groups of them."""
        return feature_groups(self.features.data, self.features.groups)

    @cached_property
    def colouring(self) -> Grouping:
        """The groups that they are coloured by: of the first origin that says more than Medit's marks do."""
        origins = dict.fromkeys(group.origin for group in self.groups)
        origin = next((one for one in origins if one != "mark"), "mark")
        some = tuple(group for group in self.groups if group.origin == origin)
        return Grouping(origin, some, self.features.count)

    @cached_property
    def colours(self) -> Bytes:
        """(n,) colour of each."""
        labels = self.colouring.labels
        out = np.where(labels < 0, PLAIN, labels % MARK_COLOURS).astype(np.uint8)
        out[~self.held] = LOST
        return out

    def shown(self, hidden: frozenset[str]) -> NDArray[np.bool_]:
        """(n,) bool: which are in no hidden group; ids of these are those of the groups behind what they are of."""
        out = np.ones(self.features.count, dtype=bool)
        for group in self.groups:
            if f"{self.features.called}:{group.id}" in hidden:
                out[group.members] = False
        return out


class MarkBook:
    """What can be marked on an open mesh, each part found when it is first asked for.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    groups : GroupBook
    """

    def __init__(self, drawn_mesh: DrawnMesh, groups: GroupBook) -> None:
        self._drawn_mesh = drawn_mesh
        self._groups = groups

    @cached_property
    def features(self) -> dict[str, Drawn]:
        """Features by what they are called."""
        held = held_features(self._drawn_mesh.whole)
        return {part.called: Drawn(part, there) for part, there in held}

    @cached_property
    def _face_cells(self) -> Ids:
        """(n,) the cell of each feature face, -1 without."""
        mesh = self._drawn_mesh.whole
        return sides_of(mesh.corners, mesh.vertex_count, self.features["faces"].features.corners)[0]

    def wanted(self, settings: dict[str, Any]) -> bool:
        """Whether settings ask for anything that this mesh has."""
        features = any(settings[part.called] for part in self._drawn_mesh.whole.features)
        sharp = settings["sharp_angle"] < MOST_ANGLE
        return bool(features or sharp or settings["nodes"] or settings["interfaces"])

    def listed(self) -> dict[str, dict[str, Any]]:
        """What features there are; see `hexalab.group_facts.listed_features`; with the `colour` of each group.

        It is None of groups that none are coloured by.
        """
        facts = listed_features(self._drawn_mesh.whole)
        for name, drawn in self.features.items():
            coloured = {group.id: place for place, group in enumerate(drawn.colouring.groups)}
            for row in facts[name]["groups"]:
                place = coloured.get(row["id"])
                row["colour"] = None if place is None else place % MARK_COLOURS
        return facts

    def ids(self) -> set[str]:
        """Ids of all groups of features, behind what they are of: "edges:reference:5"."""
        return {f"{name}:{group.id}" for name, drawn in self.features.items() for group in drawn.groups}

    def marks(self, settings: dict[str, Any], shown: NDArray[np.bool_]) -> Marks:
        """Collect what settings (the status' section `marks`) ask for, on the shown cells.

        Features that the mesh does not hold are drawn wherever they are.
        """
        hidden = frozenset(settings["hidden"])
        near = None
        faces: list[tuple[Array, Bytes]] = []
        edges: list[tuple[Array, Bytes]] = []
        points: list[tuple[Array, Bytes]] = []
        counts: dict[str, int] = {}
        sharp = settings["sharp_angle"]
        if sharp < MOST_ANGLE:
            near = self._near(shown) if near is None else near
            found = self._sharp(sharp)
            found = found[:, near[found].all(axis=0)]
            edges.append((found, np.full(found.shape[1], PLAIN, dtype=np.uint8)))
            counts["sharp"] = found.shape[1]
        for name in KINDS:
            if not settings[name] or name not in self.features:
                continue
            near = self._near(shown) if near is None else near
            drawn = self.features[name]
            corners = drawn.features.corners
            if name == "faces":
                cells = self._face_cells
                seen = (cells < 0) | shown[cells]
            else:
                seen = ~drawn.held | near[corners].all(axis=0)
            which = np.flatnonzero(seen & drawn.shown(hidden))
            {"corners": points, "edges": edges, "faces": faces}[name].append(
                (corners[:, which], drawn.colours[which])
            )
            counts[name] = len(which)
        for place, id in enumerate(settings["nodes"]):
            group = self._groups.of_vertices.get(id)
            if group is not None:
                colour = np.full(group.count, place % MARK_COLOURS, dtype=np.uint8)
                points.append((group.members[None], colour))
                counts["nodes"] = counts.get("nodes", 0) + group.count
        if settings["interfaces"] in self._groups.groupings:
            corners, colours = self._interface_faces(settings["interfaces"], shown)
            faces.append((corners, colours))
            counts["interfaces"] = len(colours)
        return self._record(faces, edges, points, counts)

    def _near(self, shown: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(V,) bool: whether a shown cell has the vertex."""
        mesh = self._drawn_mesh.whole
        near = np.zeros(mesh.vertex_count, dtype=bool)
        if shown.all():
            return np.asarray(mesh.referenced)
        cells = np.flatnonzero(shown)
        for corner in mesh.corners:
            near[corner[cells]] = True
        return near

    def _sharp(self, degrees: float) -> Ids:
        """(2, n) edges of the boundary whose faces meet at more than an angle."""
        return sharp_edges(self._drawn_mesh.mesh, degrees)

    def _interface_faces(self, origin: str, shown: NDArray[np.bool_]) -> tuple[Ids, Bytes]:
        """(4, n) faces between groups of an origin that a shown cell has, and the colour of each pair of groups."""
        topology = self._drawn_mesh.whole.topology
        found = self._groups.interfaces(origin)
        rows = np.concatenate([np.zeros(0, dtype=np.intp), *found.values()])
        sizes = [len(some) for some in found.values()]
        colours = np.repeat(np.arange(len(found)) % MARK_COLOURS, sizes).astype(np.uint8)
        seen = shown[topology.face_cells[:, rows]].any(axis=0)
        rows, colours = rows[seen], colours[seen]
        return topology.corners_of(topology.face_cells[0, rows], topology.face_locals[0, rows]), colours

    def _record(
        self,
        faces: list[tuple[Array, Bytes]],
        edges: list[tuple[Array, Bytes]],
        points: list[tuple[Array, Bytes]],
        counts: dict[str, int],
    ) -> Marks:
        def joined(parts: list[tuple[Array, Bytes]], rows: int) -> tuple[Any, Bytes]:
            none = np.zeros((rows, 0), dtype=np.int32), np.zeros(0, dtype=np.uint8)
            corners = np.concatenate([none[0], *(some for some, _ in parts)], axis=1)
            return interleave(self._drawn_mesh.points(corners)), np.concatenate(
                [none[1], *(c for _, c in parts)]
            )

        face_positions, face_colours = joined(faces, 4)
        edge_positions, edge_colours = joined(edges, 2)
        point_positions, point_colours = joined(points, 1)
        return Marks(
            faces=face_positions,
            face_colours=face_colours,
            edges=edge_positions,
            edge_colours=edge_colours,
            points=point_positions,
            point_colours=point_colours,
            counts=counts,
        )
