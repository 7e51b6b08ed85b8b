"""The stack: all filters together, and what can be kept between two settings.

A slider changes one filter at a time: the masks of the others are kept by their settings, and of the planes
also where the cells stand along each normal, so that a moved plane is one comparison per cell.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable, Mapping
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats, Ids
from ..mesh import Mesh
from ..quality import METRICS
from ..structure import Structure
from ..topology import Topology
from .peel import peel
from .picking import PickedCells, pick
from .plane import Places, any_corner_places, barycentre_places, plane
from .quality import Keep, band
from .regularisation import STRONGEST, Regulariser
from .structure import hidden_by_structure, traced_of

Hidden = NDArray[np.bool_]
Settings = Mapping[str, Any]
Planes = tuple[tuple[str, tuple[float, ...], float], ...]
"""Rule, normal and offset of each plane."""

Bands = tuple[tuple[str, Keep, float | None, float | None], ...]
"""Quantity, side that is kept, and both ends of each band."""

NORMALS_KEPT = 32
"""As many as a status may have planes."""

MOST_BYTES_OF_PLACES = 64 * 2**20
"""Eight bytes per cell for each normal: of large meshes fewer are kept."""


class FilterStack:
    """All filters over one mesh.

    Parameters
    ----------
    mesh : Mesh
    values : callable, str to (C,) float64
        Gives the values of a quantity, a metric or an attribute, by its id.
    topology : Topology, optional
        What peeling and regularisation walk over, if not the mesh's own.
    members : callable, str to (n,) int, optional
        Gives the rows of a group's cells, by its id; none by default.
    structure : callable, optional
        Gives the mesh's structure, if it is known already; it is traced here by default.
    lost : callable, str to float, optional
        What a cell without a value of a quantity that is no metric counts as; see `filters.quality.band`.
    signed : callable, str to bool, optional
        Whether a quantity is a change: then a band that ends at 0 leaves out what has not changed.

    Examples
    --------
    >>> stack = FilterStack(mesh, lambda id: quality(mesh, id))          # doctest: +SKIP
    >>> shown = stack.apply({"peel": {"depth": 1}})                              # doctest: +SKIP
    """

    def __init__(
        self,
        mesh: Mesh,
        values: Callable[[str], Floats],
        topology: Topology | None = None,
        members: Callable[[str], Ids] | None = None,
        structure: Callable[[], Structure] | None = None,
        lost: Callable[[str], float] = lambda quantity: np.nan,
        signed: Callable[[str], bool] = lambda quantity: False,
    ) -> None:
        self._mesh = mesh
        self._structure = structure or cache(lambda: Structure(mesh))
        self._members = members
        self._lost = lost
        self._signed = signed
        self._topology = topology or mesh.topology
        self._values = values
        self._places: OrderedDict[Hashable, Places] = OrderedDict()
        self._masks: dict[str, tuple[Hashable, Hidden]] = {}
        self._dug, self._undug = PickedCells(mesh.cell_count), PickedCells(mesh.cell_count)

    def apply(self, filters: Settings) -> Hidden:
        """Which cells are shown, (C,) bool, under the status document's section `filters`.

        A section that is missing hides nothing. The array is the caller's.
        """
        hidden = self._cut(filters)
        for by in (self._by_quality, self._by_parts, self._by_groups, self._by_structure):
            others = by(filters)
            if others is not None:
                hidden = hidden | others
        return ~self._picked(hidden, filters)

    def forget_quality(self) -> None:
        """Forget which cells were hidden by value: some quantities are others now."""
        self._masks.pop("quality", None)

    def hidden_by(self, group: str, filters: Settings) -> Hidden:
        """Which cells some of the filters would hide by themselves, (C,) bool.

        Parameters
        ----------
        group : str
            "cut" (planes and peel, regularised), "quality", "parts", "groups", "structure", "picking".
        filters : dict
            As `apply` takes them.
        """
        none = np.zeros(self._mesh.cell_count, dtype=bool)
        groups: dict[str, Callable[[], Hidden | None]] = {
            "cut": lambda: self._cut(filters),
            "quality": lambda: self._by_quality(filters),
            "parts": lambda: self._by_parts(filters),
            "groups": lambda: self._by_groups(filters),
            "structure": lambda: self._by_structure(filters),
            "picking": lambda: self._picked(none, filters),
        }
        hidden = groups[group]()
        return none if hidden is None else hidden

    def places(self, normal: Any, rule: str = "barycentre") -> Places:
        """Where the cells stand along a normal, and the ends of its slider, in the mesh's own unit.

        Parameters
        ----------
        normal : (3,) float
        rule : "barycentre" or "any_corner"
        """
        mesh = self._mesh
        key = (rule, *(float(part) for part in normal))
        if key not in self._places:
            if rule == "barycentre":
                self._places[key] = barycentre_places(mesh.barycentres, normal)
            else:
                self._places[key] = any_corner_places(mesh.coordinates, mesh.corners, mesh.referenced, normal)
            most = min(NORMALS_KEPT, MOST_BYTES_OF_PLACES // (8 * mesh.cell_count + 1) + 1)
            while len(self._places) > most:
                self._places.popitem(last=False)
        self._places.move_to_end(key)
        return self._places[key]

    def _by_quality(self, filters: Settings) -> Hidden | None:
        bands = _bands(filters.get("quality", {}))
        return self._kept("quality", bands, lambda: self._outside(bands)) if bands else None

    def _by_parts(self, filters: Settings) -> Hidden | None:
        parts = _chosen(filters.get("parts", {}))
        return self._kept("parts", parts, lambda: self._in_hidden_parts(*parts)) if parts else None

    def _by_groups(self, filters: Settings) -> Hidden | None:
        groups = _chosen(filters.get("groups", {}))
        return self._kept("groups", groups, lambda: self._in_hidden_groups(*groups)) if groups else None

    def _by_structure(self, filters: Settings) -> Hidden | None:
        traced = traced_of(filters.get("structure", {}))
        if traced is None:
            return None
        return self._kept("structure", traced, lambda: hidden_by_structure(self._structure(), traced))

    def _picked(self, hidden: Hidden, filters: Settings) -> Hidden:
        """What is hidden, and then what was hidden or shown by hand."""
        picking = filters.get("picking", {})
        if not picking.get("enabled", True):
            return hidden
        isolated, dug, undug = (picking.get(name, ()) for name in ("isolated", "hidden", "shown"))
        if not (isolated or len(dug) or len(undug)):
            return hidden
        return pick(hidden, bool(isolated), self._dug.of(dug), self._undug.of(undug))

    def _cut(self, filters: Settings) -> Hidden:
        """What planes and peel hide, regularised; not to be changed by the caller."""
        planes = _planes(filters.get("planes", {}))
        layers = _number(filters.get("peel", {}), "depth")
        strength = min(_number(filters.get("regularisation", {}), "strength"), STRONGEST)
        hidden = self._kept("planes", planes, lambda: self._behind(planes))
        if layers > 0:
            below = hidden
            hidden = below | self._kept("peel", layers, lambda: peel(self._topology.depth, layers))
        if strength > 0:
            cut = hidden
            key = (planes, layers, strength)
            hidden = self._kept("regularisation", key, lambda: self._regulariser.regularise(cut, strength))
        return hidden

    def _behind(self, planes: Planes) -> Hidden:
        """Cells behind any of the planes."""
        hidden = np.zeros(self._mesh.cell_count, dtype=bool)
        for rule, normal, offset in planes:
            hidden |= plane(self.places(normal, rule), offset)
        return hidden

    def _outside(self, bands: Bands) -> Hidden:
        """Cells that any of the bands does not keep."""
        hidden = np.zeros(self._mesh.cell_count, dtype=bool)
        for quantity, keep, minimum, maximum in bands:
            worst = METRICS[quantity].worst if quantity in METRICS else self._lost(quantity)
            values = self._values(quantity)
            hidden |= band(values, keep, minimum, maximum, worst)
            if 0 in (minimum, maximum) and self._signed(quantity):
                hidden |= values == 0
        return hidden

    def _in_hidden_parts(self, isolated: bool, hidden: tuple[int, ...], shown: tuple[int, ...]) -> Hidden:
        """Cells of parts that are hidden."""
        part, sizes = self._mesh.topology.parts
        count = len(sizes)
        some = (np.array([one for one in list if one < count], dtype=np.intp) for list in (hidden, shown))
        return np.asarray(pick(np.zeros(count, dtype=bool), isolated, *some)[part])

    def _in_hidden_groups(self, isolated: bool, hidden: tuple[str, ...], shown: tuple[str, ...]) -> Hidden:
        """Cells of groups that are hidden; one that is in a shown group too is shown."""
        none: Ids = np.zeros(0, dtype=np.int32)
        members = self._members or (lambda _: none)
        some = (np.concatenate([none, *map(members, ids)]).astype(np.intp) for ids in (hidden, shown))
        return pick(np.zeros(self._mesh.cell_count, dtype=bool), isolated, *some)

    def _kept(self, name: str, key: Any, make: Callable[[], Hidden]) -> Hidden:
        """A filter's mask, made anew only if its settings changed."""
        if name not in self._masks or self._masks[name][0] != key:
            self._masks[name] = (key, make())
        return self._masks[name][1]

    @cached_property
    def _regulariser(self) -> Regulariser:
        return Regulariser(self._topology)


def _planes(settings: Settings) -> Planes:
    """The planes that hide something."""
    if not settings.get("enabled", True):
        return ()
    rule = settings.get("rule", "barycentre")
    return tuple(
        (rule, tuple(float(part) for part in item["normal"]), float(item.get("offset", 0)))
        for item in settings.get("items", ())
        if item.get("enabled", True) and item.get("offset", 0) > 0
    )


def _bands(settings: Settings) -> Bands:
    """The bands that hide something."""
    if not settings.get("enabled", True):
        return ()
    rows = (
        (item["quantity"], item.get("keep", "inside"), item.get("minimum"), item.get("maximum"))
        for item in settings.get("items", ())
    )
    return tuple(row for row in rows if row[2] is not None or row[3] is not None)


def _chosen(settings: Settings) -> tuple[bool, tuple[Any, ...], tuple[Any, ...]] | None:
    """Which parts or groups are hidden: all but the shown, or some; None for none."""
    isolated, hidden, shown = (settings.get(name, ()) for name in ("isolated", "hidden", "shown"))
    if not settings.get("enabled", True) or not (isolated or len(hidden)):
        return None
    return bool(isolated), tuple(hidden), tuple(shown)


def _number(settings: Settings, name: str) -> int:
    """A filter's number, 0 if it is off."""
    return int(settings.get(name, 0)) if settings.get("enabled", True) else 0
