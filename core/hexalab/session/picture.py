"""From settings to what is drawn: each part is made anew only when what it depends on has changed."""

from __future__ import annotations

import json
from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..quality import METRICS
from ..surface import LINED, extract_arrows, extract_silhouette, extract_surface
from .opened import Opened

Settings = dict[str, Any]
Shown = NDArray[np.bool_]

CATEGORIES: dict[str, tuple[str, Callable[[Opened], NDArray[Any]]]] = {
    "kind": ("Cell kind", lambda opened: opened.shapes),
    "part": ("Part", lambda opened: opened.mesh.topology.parts[0]),
}

GROUP = "group:"
"""What the quantity begins with where cells are coloured by group; the groups' origin follows."""

"""What cells are coloured by that has no scale: its name, and the number of each cell's category."""

COLOURS = 256
"""The viewer's palettes have so many entries."""

BARBED = (3, 4)
PAPER = (5, 6)


class Picture:
    """What was drawn last of an open mesh, and under which settings.

    Parameters
    ----------
    opened : Opened
    """

    def __init__(self, opened: Opened) -> None:
        self.opened = opened
        self.shown: Shown = np.ones(opened.mesh.cell_count, dtype=bool)
        self._filters: Settings | None = None
        self._version = 0
        self._shown_faces = (-1, 0)
        self._made: dict[str, Any] = {}
        self.timings: dict[str, float] = {}

    def update(self, settings: Settings, lean: bool = False) -> dict[str, Any]:
        """Return the records that differ from those of the last call; `pending` names those put off.

        The settings are those that concern the core (`hexalab.status.CORE_PATHS`), all of them.

        A lean update leaves out what a draft does without, edges, silhouette, arrows and what is seen through; the
        next one that is not brings them.
        """
        self.timings = {}
        self._filter(settings["filters"])
        parts: dict[str, Any] = {}
        separation = settings["separation"]
        edges = separation["mode"] in LINED and not lean
        surface = (self._version, separation["mode"], _size(separation), edges)
        self._renew(parts, "surface", surface, self._extract_surface, separation, edges)
        if settings["silhouette"] > 0 and not lean:
            self._renew(parts, "silhouette", self._version, self._extract_silhouette)
        cells = settings["see_through"]["cells"]
        if cells != "none" and not lean:
            seen = (self._version, self._filters if cells != "all" else None, cells)
            self._renew(parts, "see_through", seen, self._extract_see_through, cells)
        attribute = settings["arrows"]["attribute"]
        if attribute and not lean:
            gap = separation["gap"] if separation["mode"] == "fissure" else 0.0
            self._renew(
                parts, "arrows", (self._version, attribute, gap), self._extract_arrows, attribute, gap
            )
        marks = settings["marks"]
        wanted = self.opened.marks.wanted(marks)
        if not lean and (wanted or "marks" in self._made):
            asked = (self._version, json.dumps(marks, sort_keys=True)) if wanted else None
            self._renew(parts, "marks", asked, self._extract_marks, marks)
        irregular, pending = self._irregular_parts(settings["irregular"])
        if irregular is not None and not pending:
            self._renew(parts, "irregular", irregular, self._extract_irregular, *irregular)
        colour = settings["colour"]
        mapped = colour["by"] in ("quality", "attribute")
        coloured = (quantity_of(colour), _frozen(colour["range"]) if mapped else None)
        self._renew(parts, "colour", coloured, self.colour, colour)
        parts["pending"] = ["irregular"] if pending else []
        return parts

    def forget(self) -> None:
        """Let the next update return every record: what was made last has not come to whoever draws it."""
        self._made = {"marks": object()}  # those that were switched off have to go, too

    def shown_faces(self) -> int:
        """Return the number of faces between shown cells and hidden ones or the outside."""
        version, faces = self._shown_faces
        if version != self._version:
            faces = len(self.opened.drawn_mesh.topology.interface(self.shown).rows)
            self._shown_faces = (self._version, faces)
        return faces

    def colour(self, colour: Settings) -> dict[str, Any] | None:
        """Return each cell's place on the colour map and what the map means; None for sides."""
        opened, quantity = self.opened, quantity_of(colour)
        if quantity is None:
            return None
        if quantity.startswith(GROUP):
            return self._colour_by_group(quantity.removeprefix(GROUP))
        if quantity in CATEGORIES:
            label, categories = CATEGORIES[quantity]
            places = categories(opened).astype(np.float32)
            places %= COLOURS
            return {
                "map_position": places,
                "quantity": quantity,
                "label": label,
                "low": None,
                "high": None,
                "high_first": False,
            }
        positions = opened.map_positions(quantity, opened.values(quantity), colour["range"])
        low, high = colour["range"] or opened.range_of(quantity) or (None, None)
        return {
            "map_position": positions.astype(np.float32),
            "quantity": quantity,
            "label": opened.label_of(quantity),
            "low": low,
            "high": high,
            "high_first": quantity in METRICS and METRICS[quantity].better == "high",
        }

    def _colour_by_group(self, origin: str) -> dict[str, Any] | None:
        """Return each cell's colour by its group of an origin, the first one by default; None without groups."""
        book = self.opened.groups
        origin = origin if origin in book.groupings else next(iter(book.groupings), "")
        if not origin:
            return None
        grouping, colours = book.grouping(origin), book.colours(origin)
        places = np.append(colours, 0).astype(np.float32)[grouping.labels]
        places[grouping.labels < 0] = np.nan
        return {
            "map_position": places,
            "quantity": GROUP + origin,
            "label": origin,
            "low": None,
            "high": None,
            "high_first": False,
            "groups": [
                {"id": group.id, "colour": colour}
                for group, colour in zip(grouping.groups, colours.tolist(), strict=True)
            ],
            "without": int(np.count_nonzero(grouping.labels < 0)),
            "in_several": grouping.in_several,
        }

    def _filter(self, filters: Settings) -> None:
        if filters == self._filters:
            return
        began = perf_counter()
        shown = self.opened.filters.apply(filters)
        if self._version == 0 or not np.array_equal(shown, self.shown):
            self.shown = shown
            self._version += 1
        self._filters = filters
        self.timings["filters"] = 1000 * (perf_counter() - began)

    def _extract_surface(self, separation: Settings, edges: bool) -> dict[str, Any]:
        mode, sizes = separation["mode"], {name: separation[name] for name in ("gap", "radius")}
        return extract_surface(self.opened.drawn_mesh, self.shown, mode, **sizes, edges=edges).arrays()

    def _extract_silhouette(self) -> dict[str, Any]:
        return extract_silhouette(self.opened.drawn_mesh, self.shown).arrays()

    def _extract_see_through(self, cells: str) -> dict[str, Any]:
        hidden = ~self.shown
        if cells != "all":
            hidden &= self.opened.filters.hidden_by(cells, self._filters or {})
        return extract_surface(self.opened.drawn_mesh, hidden, "lines").arrays()

    def _extract_marks(self, marks: Settings) -> dict[str, Any]:
        return self.opened.marks.marks(marks, self.shown).arrays()

    def _extract_arrows(self, attribute: str, gap: float) -> dict[str, Any]:
        opened = self.opened
        return extract_arrows(opened.drawn_mesh, self.shown, opened.field(attribute), gap).arrays()

    def _irregular_parts(self, irregular: Settings) -> tuple[tuple[bool, bool] | None, bool]:
        """Which parts the mode draws, None for none; and whether they have to wait for the edges."""
        mode = irregular["mode"]
        if not mode:
            return None, False
        return (mode in BARBED, mode in PAPER), not self.opened.knows_edges

    def _extract_irregular(self, barbs: bool, paper: bool) -> dict[str, Any]:
        return self.opened.irregular(barbs, paper).arrays()

    def _renew(
        self, parts: dict[str, Any], name: str, made_from: Any, make: Callable[..., Any], *arguments: Any
    ) -> None:
        """Add a record to `parts` if it is made from something else than the last one; noted when it is made."""
        if name in self._made and self._made[name] == made_from:
            return
        began = perf_counter()
        parts[name] = make(*arguments)
        self.timings[name] = 1000 * (perf_counter() - began)
        self._made[name] = made_from


def quantity_of(colour: Settings) -> str | None:
    """Return what cells are coloured by: a metric's or an attribute's id, a category, or None for sides."""
    by = colour["by"]
    return {
        "quality": colour["metric"],
        "attribute": colour["attribute"],
        "kind": "kind",
        "part": "part",
        "group": GROUP + colour["grouping"],
    }.get(by)


def _size(separation: Settings) -> float | None:
    """Return the number that the mode's geometry depends on."""
    name = {"fissure": "gap", "rounded": "radius"}.get(separation["mode"])
    return separation[name] if name else None


def _frozen(limits: list[float] | None) -> tuple[float, ...] | None:
    return tuple(limits) if limits is not None else None
