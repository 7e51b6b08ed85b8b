"""What of the structure is looked at, and how it is drawn (SPEC T4, T5)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..structure import Structure
from ..structure.colouring import block_colours
from ..structure.members import base_of, cells_of, count_of, graph_of, known, labels_of, skeleton_of
from ..surface import DrawnMesh, ExplodedMesh, Pieces, Surface, dual_surface, extract_surface, walls
from ..surface.curves import Drawing
from ..surface.records import Curves

Settings = dict[str, Any]
Cells = NDArray[np.bool_]

MOST_AT_ONCE = 100_000
"""Shown cells up to which all sheets are drawn as surfaces, and all chords as curves, where none is chosen."""

BLOCK_COLOURS = 12
"""The viewer's palette of blocks has so many colours."""

CHOSEN_COLOURS = 6
"""So many colours the viewer has for what was chosen before it begins again."""

CROSSING, REST = CHOSEN_COLOURS, CHOSEN_COLOURS + 1
"""Colours of cells in several of the chosen, and in none."""


class Look(NamedTuple):
    """What of the structure settings (the status' section `structure`) look at.

    Attributes
    ----------
    kind : "none", "arcs", "sheets", "chords" or "blocks"
    chosen : tuple of int
    form : "cells" or "surfaces"
    variant : "whole", "interior" or ""
        Which arcs or blocks.
    base : "whole" or "interior"
        Which base complex.
    curves : bool
    explode : float
        0 unless blocks are drawn as cells.
    """

    kind: str
    chosen: tuple[int, ...]
    form: str
    variant: str
    base: str
    curves: bool
    explode: float

    @classmethod
    def of(cls, settings: Settings) -> Look:
        """What settings look at, without what does not matter to it."""
        kind, base = settings["kind"], settings["complex"]
        cells = settings["form"] == "cells" and kind != "arcs"
        variant = ("whole" if settings["boundary"] else "interior") if kind == "arcs" else base
        apart = kind == "blocks" and cells
        return cls(
            kind,
            () if kind == "none" else tuple(settings["chosen"]),
            "cells" if cells or kind == "none" else "surfaces",
            variant if kind in ("arcs", "blocks") else "",
            base,
            settings["curves"],
            settings["explode"] if apart else 0.0,
        )

    @property
    def drawn(self) -> Look:
        """What of it matters to cells and surfaces, but not to curves."""
        if self.form == "cells" and not (self.chosen or self.explode):
            return NOTHING  # all cells are drawn, where they are
        if self.form == "surfaces" and self.kind not in ("sheets", "blocks"):
            return NO_CELLS
        return self._replace(base="", curves=False)

    @property
    def lined(self) -> Look:
        """What of it matters to curves."""
        if self.kind == "arcs" or self.passing:
            return self
        return NOTHING._replace(base=self.base, curves=self.curves, explode=self.explode)

    @property
    def passing(self) -> bool:
        """Whether chords are drawn as curves, which pass the shown cells alone."""
        return self.kind == "chords" and self.form == "surfaces"

    @property
    def parted(self) -> Look:
        """What of it matters to which cells are faint."""
        return self.drawn if self.form == "cells" else NO_CELLS

    @property
    def told_apart(self) -> Look:
        """What of it matters to colours by what was chosen."""
        return NOTHING._replace(kind=self.kind, chosen=self.chosen, variant=self.variant)

    @property
    def curved(self) -> bool:
        """Whether there are curves or points to be drawn."""
        return self.curves or self.kind == "arcs" or self.passing


NOTHING = Look("none", (), "cells", "", "whole", False, 0.0)
"""Nothing of the structure is looked at."""

NO_CELLS = NOTHING._replace(form="surfaces")
"""What is looked at is not drawn as cells."""


def _too_many(look: Look, shown: Cells) -> bool:
    """Whether all sheets or chords at once would be too much for memory and eye."""
    return look.kind in ("sheets", "chords") and int(np.count_nonzero(shown)) > MOST_AT_ONCE


class Onlooker:
    """Draws what is looked at.

    Parameters
    ----------
    drawn_mesh : DrawnMesh
    structure : Structure
    """

    def __init__(self, drawn_mesh: DrawnMesh, structure: Structure) -> None:
        self._drawn_mesh = drawn_mesh
        self.structure = structure
        self._pieces: dict[str, Pieces] = {}
        self._apart: ExplodedMesh | None = None
        self._members: dict[tuple[Any, ...], Cells] = {}
        self._colours: dict[str, NDArray[np.uint8]] = {}

    def chosen(self, look: Look) -> NDArray[np.int32]:
        """Those of the chosen that there are."""
        return known(look.chosen, count_of(self.structure, look.kind, look.variant))

    def members(self, kind: str, number: tuple[int, ...], variant: str) -> Cells:
        """(C,) bool: the cells of some things; the last are kept."""
        key = (kind, number, variant)
        if key not in self._members:
            self._members = {key: cells_of(self.structure, kind, number, variant)}
        return self._members[key]

    def solid(self, look: Look, shown: Cells) -> Cells:
        """(C,) bool: which of the shown cells are drawn as cells; the same array for all of them."""
        if look.form == "surfaces":
            return np.zeros_like(shown)
        return shown & self.members(look.kind, look.chosen, look.variant) if look.chosen else shown

    def drawn_mesh(self, look: Look) -> DrawnMesh:
        """The mesh as it is drawn: in pieces, if blocks are drawn apart."""
        if not look.explode:
            return self._drawn_mesh
        if look.variant not in self._pieces:
            blocks = base_of(self.structure, look.variant).of_cells
            labels = self.structure.frame.in_mesh(blocks, self.structure.mesh.cell_count)
            self._pieces = {look.variant: Pieces(self._drawn_mesh, labels)}
        pieces = self._pieces[look.variant]
        if self._apart is None or (self._apart.pieces, self._apart.share) != (pieces, look.explode):
            self._apart = ExplodedMesh(pieces, look.explode)
        return self._apart

    def surface(self, look: Look, shown: Cells) -> Surface:
        """What is drawn instead of cells: dual surfaces of sheets, walls between blocks, or nothing."""
        structure, frame = self.structure, self.structure.frame
        if look.kind not in ("sheets", "blocks"):
            return extract_surface(self._drawn_mesh, np.zeros_like(shown), "lines")
        chosen = np.zeros(count_of(structure, look.kind, look.variant), dtype=bool)
        chosen[self.chosen(look) if look.chosen or _too_many(look, shown) else slice(None)] = True
        if look.kind == "sheets":
            return dual_surface(self._drawn_mesh, frame, structure.sheets, chosen, shown)
        return walls(self._drawn_mesh, frame, base_of(structure, look.variant), chosen, shown)

    def curves(self, look: Look, shown: Cells, drawn_mesh: DrawnMesh) -> Curves:
        """Arcs, chords and edges of the base complex, as far as they are looked at."""
        drawing, frame = Drawing(), self.structure.frame
        if look.kind == "arcs":
            graph = graph_of(self.structure, look.variant)
            chosen = np.full(graph.count, not look.chosen)
            chosen[self.chosen(look)] = True
            drawing.arcs(self._drawn_mesh, graph, chosen)
        if look.passing:
            chords = self.structure.chords
            every = not (look.chosen or _too_many(look, shown))
            some = np.arange(chords.count, dtype=np.int32) if every else self.chosen(look)
            drawing.chords(self._drawn_mesh, frame, chords, some, shown)
        if look.curves:
            drawing.base_complex(drawn_mesh, frame, skeleton_of(self.structure, look.base))
        return drawing.record()

    def block_places(self, variant: str) -> Array:
        """(C,) float32: each cell's colour by its block; NaN where there is none."""
        if variant not in self._colours:
            base = base_of(self.structure, variant)
            self._colours = {variant: block_colours(self.structure.frame, base, BLOCK_COLOURS)}
        blocks = base_of(self.structure, variant).of_cells
        found = self.structure.frame.in_mesh(
            self._colours[variant][blocks].astype(np.int32), self.structure.mesh.cell_count
        )
        return np.where(found < 0, np.nan, found).astype(np.float32)

    def chosen_places(self, look: Look) -> Array:
        """(C,) float32: each cell's colour by what was chosen.

        `CROSSING` where it is in several, or twice in one; `REST` where it is in none.
        """
        if look.kind in ("none", "arcs"):
            return np.full(self.structure.mesh.cell_count, REST, np.float32)
        labels = labels_of(self.structure, look.kind, look.variant)
        place = np.full(count_of(self.structure, look.kind, look.variant), -1, np.int32)
        chosen = self.chosen(look)
        place[chosen] = np.arange(len(chosen), dtype=np.int32)
        found = place[labels]
        places = found.max(axis=0) % CHOSEN_COLOURS
        places[found.max(axis=0) < 0] = REST
        places[np.count_nonzero(found >= 0, axis=0) > 1] = CROSSING
        whole = self.structure.frame.in_mesh(places, self.structure.mesh.cell_count)
        return np.where(whole < 0, REST, whole).astype(np.float32)
