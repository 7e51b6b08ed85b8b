"""From a status to what is drawn: each part is made anew only when what it depends on has changed."""

from __future__ import annotations

from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..surface import LINED, extract_silhouette, extract_surface
from .opened import Opened

Status = dict[str, Any]
Shown = NDArray[np.bool_]

BARBED = (3, 4)
PAPER = (5, 6)


class Buffers:
    """What was drawn last of an open mesh, and under which settings.

    Parameters
    ----------
    opened : Opened
    """

    def __init__(self, opened: Opened) -> None:
        self.opened = opened
        self.shown: Shown = np.ones(opened.mesh.cell_count, dtype=bool)
        self._filters: Status | None = None
        self._version = 0
        self._shown_faces = 0
        self._made: dict[str, Any] = {}
        self.timings: dict[str, float] = {}

    def update(self, status: Status, lean: bool = False) -> dict[str, Any]:
        """Return the buffers that differ from those of the last call; `pending` names those put off.

        A lean update leaves out what a draft does without, edges and silhouette; the next one that is not
        brings them.
        """
        self.timings = {}
        self._filter(status["filters"])
        parts: dict[str, Any] = {}
        separation = status["separation"]
        edges = separation["mode"] in LINED and not lean
        if self._is_new("surface", (self._version, separation["mode"], _size(separation), edges)):
            parts["surface"] = self._timed("surface", self._extract_surface, separation, edges)
        if status["silhouette"] > 0 and not lean and self._is_new("silhouette", self._version):
            parts["silhouette"] = self._timed("silhouette", self._extract_silhouette)
        irregular, pending = self._irregular_parts(status["irregular"])
        if irregular is not None and not pending and self._is_new("irregular", irregular):
            parts["irregular"] = self._timed("irregular", self._extract_irregular, *irregular)
        colour = status["colour"]
        source = source_of(colour)
        if self._is_new("colour", (source, _frozen(colour["range"]) if colour["by"] != "kind" else None)):
            parts["colour"] = self._timed("colour", self.colour, colour)
        parts["pending"] = ["irregular"] if pending else []
        return parts

    def forget(self) -> None:
        """Let the next update return everything."""
        self._made = {}

    def shown_faces(self) -> int:
        """Return the number of faces between shown cells and hidden ones or the outside."""
        if self._is_new("shown_faces", self._version):
            self._shown_faces = len(self.opened.mesh.topology.interface(self.shown).rows)
        return self._shown_faces

    def colour(self, colour: Status) -> dict[str, Any] | None:
        """Return each cell's place on the colour map and what the map means; None for sides."""
        opened, source = self.opened, source_of(colour)
        if source is None:
            return None
        if source == "kind":
            kinds = opened.mesh.kinds.astype(np.float32)
            return {"map_position": kinds, "source": source, "label": "Cell kind", "low": None, "high": None}
        positions = opened.map_positions(source, opened.values(source), colour["range"])
        low, high = colour["range"] or opened.range_of(source) or (None, None)
        return {
            "map_position": positions.astype(np.float32),
            "source": source,
            "label": opened.label_of(source),
            "low": low,
            "high": high,
        }

    def _filter(self, filters: Status) -> None:
        if filters == self._filters:
            return
        began = perf_counter()
        shown = self.opened.filters.apply(filters)
        self._filters = filters
        if self._version == 0 or not np.array_equal(shown, self.shown):
            self.shown = shown.copy()
            self._version += 1
        self.timings["filters"] = 1000 * (perf_counter() - began)

    def _extract_surface(self, separation: Status, edges: bool) -> dict[str, Any]:
        mode, sizes = separation["mode"], {name: separation[name] for name in ("gap", "radius")}
        return extract_surface(self.opened.drawing, self.shown, mode, **sizes, edges=edges).arrays()

    def _extract_silhouette(self) -> dict[str, Any]:
        return extract_silhouette(self.opened.drawing, self.shown).arrays()

    def _irregular_parts(self, irregular: Status) -> tuple[tuple[bool, bool] | None, bool]:
        """Which parts the mode draws, None for none; and whether they have to wait for the edges."""
        mode = irregular["mode"]
        if not mode:
            return None, False
        return (mode in BARBED, mode in PAPER), not self.opened.knows_edges

    def _extract_irregular(self, barbs: bool, paper: bool) -> dict[str, Any]:
        return self.opened.irregular(barbs, paper).arrays()

    def _is_new(self, name: str, made_from: Any) -> bool:
        if name in self._made and self._made[name] == made_from:
            return False
        self._made[name] = made_from
        return True

    def _timed(self, name: str, make: Any, *arguments: Any) -> Any:
        began = perf_counter()
        made = make(*arguments)
        self.timings[name] = 1000 * (perf_counter() - began)
        return made


def source_of(colour: Status) -> str | None:
    """Return what cells are coloured by: a metric's or an attribute's id, "kind", or None for sides."""
    by = colour["by"]
    return {"quality": colour["metric"], "attribute": colour["attribute"], "kind": "kind"}.get(by)


def _size(separation: Status) -> float | None:
    """Return the number that the mode's geometry depends on."""
    name = {"fissure": "gap", "rounded": "radius"}.get(separation["mode"])
    return separation[name] if name else None


def _frozen(limits: list[float] | None) -> tuple[float, ...] | None:
    return tuple(limits) if limits is not None else None
