"""From settings to what is drawn: each part is made anew only when what it depends on has changed."""

from __future__ import annotations

import json
from collections.abc import Callable
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..surface import (
    LINED,
    NO_SILHOUETTE,
    DrawnMesh,
    ExplodedMesh,
    extract_arrows,
    extract_silhouette,
    extract_surface,
)
from ..surface.curves import Drawing
from .compared import ComparedBook
from .looking import NOTHING, Look
from .mapping import map_ends, map_positions
from .opened import Opened

Settings = dict[str, Any]
Shown = NDArray[np.bool_]

CATEGORIES: dict[str, tuple[str, Callable[[Opened, Look], NDArray[Any]]]] = {
    "kind": ("Cell kind", lambda opened, _: opened.shapes),
    "part": ("Part", lambda opened, _: opened.mesh.topology.parts[0]),
    "block": ("Block", lambda opened, look: opened.onlooker.block_places(look.base)),
    "chosen": ("Chosen", lambda opened, look: opened.onlooker.chosen_places(look)),
}
"""What cells are coloured by that has no scale: its name, and the number of each cell's category."""

GROUP = "group:"
"""What the quantity begins with where cells are coloured by group; the groups' origin follows."""

COLOURS = 256
"""The viewer's palettes have so many entries."""

GOING = ("see_through", "marks", "curves", "reference")
"""Records that are sent empty when they are switched off."""

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
        self._look = NOTHING
        self._solid: Shown = self.shown
        self._drawn_mesh = opened.drawn_mesh
        self._version = 0
        self._shown_faces = (-1, 0)
        self._looked: tuple[Any, ...] | None = None
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
        self._look_at(Look.of(settings["structure"]))
        parts: dict[str, Any] = {}
        separation = settings["separation"]
        edges = separation["mode"] in LINED and not lean
        surface = (self._version, separation["mode"], _size(separation), edges, self._look.drawn)
        self._renew(parts, "surface", surface, self._extract_surface, separation, edges)
        if not lean:
            self._renew_around(parts, settings)
            self._renew_over(parts, settings)
        irregular, pending = self._irregular_parts(settings["irregular"])
        if irregular is not None and not pending:
            self._renew(parts, "irregular", irregular, self._extract_irregular, *irregular)
        self._renew(parts, "colour", self._colour_key(settings["colour"]), self.colour, settings["colour"])
        parts["pending"] = ["irregular"] if pending else []
        return parts

    def _renew_around(self, parts: dict[str, Any], settings: Settings) -> None:
        """What is drawn of cells that are hidden, or faint beside what is looked at."""
        if settings["silhouette"] > 0:
            silhouette = (self._version, self._look.explode and self._look.drawn)
            self._renew(parts, "silhouette", silhouette, self._extract_silhouette)
        cells = settings["see_through"]["cells"]
        seen = (
            self._version,
            cells,
            self._filters if cells not in ("none", "all") else None,
            self._look.parted,
        )
        wanted = cells != "none" or self._solid is not self.shown
        self._renew_wanted(parts, "see_through", wanted, seen, self._extract_see_through, cells)

    def _renew_over(self, parts: dict[str, Any], settings: Settings) -> None:
        """What is drawn over the surface."""
        attribute, separation, marks = (
            settings["arrows"]["attribute"],
            settings["separation"],
            settings["marks"],
        )
        if attribute:
            gap = separation["gap"] if separation["mode"] == "fissure" else 0.0
            arrows = (self._version, attribute, gap, self._look.drawn)
            self._renew(parts, "arrows", arrows, self._extract_arrows, attribute, gap)
        marked = (self._version, json.dumps(marks, sort_keys=True))
        self._renew_wanted(
            parts, "marks", self.opened.marks.wanted(marks), marked, self._extract_marks, marks
        )
        reference = self.opened.compared if settings["compare"]["reference"]["shown"] else None
        self._renew_wanted(
            parts, "reference", reference is not None, reference, self._extract_reference, reference
        )
        curves = (self._version if self._look.passing else None, self._look.lined)
        self._renew_wanted(parts, "curves", self._look.curved, curves, self._extract_curves)

    @property
    def drawn_mesh(self) -> DrawnMesh:
        """The mesh as it is drawn: in pieces, if blocks are drawn apart."""
        return self._drawn_mesh

    def forget(self) -> None:
        """Let the next update return every record: what was made last has not come to whoever draws it."""
        self._made = {name: object() for name in GOING}  # those that were switched off have to go, too
        self._filters = None

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
            places = categories(opened, self._look).astype(np.float32)
            places %= COLOURS
            return {
                "map_position": places,
                "quantity": quantity,
                "label": label,
                "low": None,
                "high": None,
                "high_first": False,
            }
        limits, reach = colour["range"], colour["reach"]
        positions = map_positions(opened, quantity, opened.values(quantity), limits, reach)
        low, high = limits or map_ends(opened, quantity, reach) or (None, None)
        return {
            "map_position": positions.astype(np.float32),
            "quantity": quantity,
            "label": opened.label_of(quantity),
            "low": low,
            "high": high,
            "high_first": opened.better_of(quantity) == "high",
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

    def _colour_key(self, colour: Settings) -> tuple[Any, ...]:
        """What the colours are made from."""
        quantity, mapped = quantity_of(colour), colour["by"] in ("quality", "attribute")
        look = {"block": self._look.base, "chosen": self._look.told_apart}.get(colour["by"])
        ends = (_frozen(colour["range"]), _frozen(colour["reach"])) if mapped else None
        return quantity, ends, look

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

    def _look_at(self, look: Look) -> None:
        """Which of the shown cells are drawn as such, `_solid`, and where they are."""
        key = (self._version, look.drawn)
        if self._looked != key:
            onlooker = self.opened.onlooker if look.kind != "none" else None
            self._solid = onlooker.solid(look, self.shown) if onlooker else self.shown
            self._drawn_mesh = onlooker.drawn_mesh(look) if onlooker else self.opened.drawn_mesh
            self._looked = key
        self._look = look

    def _extract_surface(self, separation: Settings, edges: bool) -> dict[str, Any]:
        if self._look.kind != "none" and self._look.form == "surfaces":
            return self.opened.onlooker.surface(self._look, self.shown).arrays()
        mode, sizes = separation["mode"], {name: separation[name] for name in ("gap", "radius")}
        return extract_surface(self._drawn_mesh, self._solid, mode, **sizes, edges=edges).arrays()

    def _extract_silhouette(self) -> dict[str, Any]:
        return extract_silhouette(self._drawn_mesh, self.shown).arrays()

    def _extract_see_through(self, cells: str) -> dict[str, Any]:
        faint = self.shown & ~self._solid
        if cells != "none":
            hidden = ~self.shown
            if cells != "all":
                hidden &= self.opened.filters.hidden_by(cells, self._filters or {})
            faint |= hidden
        return extract_surface(self._drawn_mesh, faint, "lines").arrays()

    def _extract_marks(self, marks: Settings) -> dict[str, Any]:
        return self.opened.marks.marks(marks, self.shown).arrays()

    def _extract_curves(self) -> dict[str, Any]:
        if not self._look.curved:
            return Drawing().record().arrays()
        return self.opened.onlooker.curves(self._look, self.shown, self._drawn_mesh).arrays()

    def _extract_reference(self, compared: ComparedBook | None) -> dict[str, Any]:
        drawn = compared.drawn(self.opened.drawn_mesh.frame) if compared else NO_SILHOUETTE
        return drawn.arrays()

    def _extract_arrows(self, attribute: str, gap: float) -> dict[str, Any]:
        field = self.opened.field(attribute)
        if isinstance(self._drawn_mesh, ExplodedMesh):
            field = field.of(self._drawn_mesh.pieces.source)
        return extract_arrows(self._drawn_mesh, self._solid, field, gap).arrays()

    def _irregular_parts(self, irregular: Settings) -> tuple[tuple[bool, bool] | None, bool]:
        """Which parts the mode draws, None for none; and whether they have to wait for the edges."""
        mode = irregular["mode"]
        if not mode:
            return None, False
        return (mode in BARBED, mode in PAPER), not self.opened.knows_edges

    def _extract_irregular(self, barbs: bool, paper: bool) -> dict[str, Any]:
        return self.opened.irregular(barbs, paper).arrays()

    def _renew_wanted(
        self,
        parts: dict[str, Any],
        name: str,
        wanted: bool,
        made_from: Any,
        make: Callable[..., Any],
        *arguments: Any,
    ) -> None:
        """Renew a record that is switched on, or send it once more, empty, after it was switched off."""
        if wanted or name in self._made:
            self._renew(parts, name, made_from if wanted else None, make, *arguments)

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
        "block": "block",
        "chosen": "chosen",
        "group": GROUP + colour["grouping"],
    }.get(by)


def looked_at(colour: Settings) -> str:
    """Return the metric or attribute that is plotted: what cells are coloured by, or would be."""
    by_attribute = colour["by"] == "attribute" and colour["attribute"]
    return str(colour["attribute"] if by_attribute else colour["metric"])


def _size(separation: Settings) -> float | None:
    """Return the number that the mode's geometry depends on."""
    name = {"fissure": "gap", "rounded": "radius"}.get(separation["mode"])
    return separation[name] if name else None


def _frozen(limits: list[float] | None) -> tuple[float, ...] | None:
    return tuple(limits) if limits is not None else None
