"""What is kept of an open mesh: parts are computed when first asked for, and then stay."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats
from ..attributes import Attribute, attributes, cell_values, finite_range, own_vectors, vectors
from ..comparison import DISPLACEMENT
from ..comparison import QUANTITIES as COMPARED
from ..diagnosis import Finding, diagnose
from ..errors import HexaLabError
from ..filters.plane import unit
from ..filters.stack import FilterStack
from ..group_facts import group_measures
from ..mesh import Mesh
from ..quality import METRICS, Validity, certify, quality, statistics
from ..status import OpenMesh
from ..status.views import View, three_quarters
from ..structure.quantities import QUANTITIES, quantity_values
from ..summary import TOPOLOGY
from ..surface import (
    DrawnMesh,
    Irregular,
    VectorField,
    extract_irregular,
    long_axis,
    outline,
    skin,
    upward,
)
from ..topology.shapes import SHAPES, shapes
from .compared import ComparedBook
from .grouped import GroupBook
from .looking import Onlooker
from .marked import MarkBook
from .mean_volumes import MeanVolumes
from .traced import TracedBook

DESCRIBED = ("groups", *TOPOLOGY, "shapes", "parts", "findings")
"""Parts of a description, to be asked for one by one."""

CLEARANCE = 1e-9
"""Part of a plane's way by which it stays before a cell that it is to reach."""

MOST_PARTS = 100
"""So many parts are told one by one."""

MOST_BYTES_OF_VALUES = 96 * 2**20
"""Values per cell are kept up to this size, the least used leave first."""


class UnknownQuantity(HexaLabError):
    """There is no metric and no attribute of that id."""


class Opened:
    """An open mesh and what is known of it so far.

    Parameters
    ----------
    mesh : Mesh
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self.knows_edges = False
        self.mean_volumes = MeanVolumes(mesh)
        self._values: OrderedDict[str, Floats] = OrderedDict()
        self._ranges: dict[str, tuple[float, float] | None] = {}
        self._statistics: dict[str, dict[str, Any]] = {}
        self._irregular: dict[tuple[bool, bool], Irregular] = {}
        self._fields: dict[str, VectorField] = {}
        self.compared: ComparedBook | None = None

    def compare(self, compared: ComparedBook | None) -> None:
        """Put the mesh beside a counterpart, or beside none; what was known of the one before is forgotten."""
        self.compared = compared
        for kept in (self._values, self._ranges, self._statistics, self._fields):
            for quantity in COMPARED.keys() & kept.keys():
                del kept[quantity]
        if "filters" in vars(self):
            self.filters.forget_quality()

    @cached_property
    def groups(self) -> GroupBook:
        """The file's groups, and those that its arrays make."""
        return GroupBook(self.mesh)

    @cached_property
    def marks(self) -> MarkBook:
        """What can be drawn over the surface."""
        return MarkBook(self.drawn_mesh, self.groups)

    @cached_property
    def traced(self) -> TracedBook:
        """The structure of the whole mesh."""
        return TracedBook(self.mesh)

    @cached_property
    def onlooker(self) -> Onlooker:
        """Draws what of the structure is looked at."""
        return Onlooker(self.drawn_mesh, self.traced.structure)

    @cached_property
    def attributes(self) -> dict[str, Attribute]:
        """The file's attributes by id."""
        return attributes(self.mesh)

    @cached_property
    def vectors(self) -> dict[str, Attribute]:
        """The attributes that arrows can be drawn of, by id."""
        return vectors(self.mesh)

    @cached_property
    def drawn_mesh(self) -> DrawnMesh:
        """What all surfaces of the mesh share."""
        return DrawnMesh(self.mesh)

    @cached_property
    def placed(self) -> dict[str, Any]:
        """Where the mesh lies, and where it is looked at from.

        `extent` ((2, 3), of all cells), `frame` ((2, 3), the box that drawing coordinates are made of), `centre`
        and `diagonal` of the frame, `framed_cells` (those within it), `view` (`direction`, `up`, `facing`),
        `outline` ((3 n,) float32, drawing coordinates of points that a camera is fitted to).
        """
        mesh, frame = self.mesh, self.drawn_mesh.frame
        return {
            "extent": mesh.extent.tolist(),
            "frame": [frame.low.tolist(), frame.high.tolist()],
            "centre": frame.centre.tolist(),
            "diagonal": frame.diagonal,
            "framed_cells": frame.cells,
            "view": {part: list(vector) for part, vector in vars(self.view()).items()},
            "outline": outline(self.skin).reshape(-1),
        }

    @cached_property
    def skin(self) -> Floats:
        """(3, n) float64 drawing coordinates of the boundary's vertices, or of some of them."""
        return skin(self.mesh, self.drawn_mesh.frame)

    def view(self, up: str = "") -> View:
        """Return where the mesh is looked at from; the axis that points up is guessed where none is given."""
        frame, points = self.drawn_mesh.frame, self.skin
        sides = (frame.high - frame.low).tolist()
        return three_quarters(sides, self.mesh.cell_count, long_axis(points), up or upward(points))

    @cached_property
    def shapes(self) -> NDArray[np.uint8]:
        """(C,) uint8: what each cell is, or has collapsed to, an index into `SHAPES`."""
        return shapes(self.mesh.kinds, self.mesh.corners, self.mesh.topology.repeating_cells)

    @cached_property
    def filters(self) -> FilterStack:
        """The filters, with what they keep between two settings."""
        topology, members = self.drawn_mesh.topology, self.groups.members
        return FilterStack(
            self.mesh,
            self.values,
            topology,
            members,
            lambda: self.traced.structure,
            self._lost,
            lambda quantity: quantity in COMPARED and COMPARED[quantity].metric != "",
        )

    @staticmethod
    def _lost(quantity: str) -> float:
        """What a cell without a value counts as: one that can't have changed is not among those that got worse."""
        row = COMPARED.get(quantity)
        if row is None or not row.metric:
            return np.nan
        return np.inf if row.better == "high" else -np.inf

    @cached_property
    def findings(self) -> list[Finding]:
        """The diagnosis."""
        return diagnose(self.mesh)

    @cached_property
    def validity(self) -> Validity:
        """Certified validity of every cell."""
        return certify(self.mesh)

    def group_table(self) -> list[dict[str, Any]]:
        """Return what there is to tell of each group of cells; see `hexalab.group_facts.group_measures`.

        With the group's `id`; invalid are cells whose Jacobian is somewhere not positive.
        """
        groups = list(self.groups.of_cells.values())
        invalid = self.validity.state == 0
        rows = group_measures(groups, self.values("volume"), self.values("scaled_jacobian"), invalid)
        return [{"id": group.id, **row} for group, row in zip(groups, rows, strict=True)]

    def described(self, part: str) -> dict[str, Any]:
        """Return one part of the mesh's description, a name of `DESCRIBED`."""
        if part == "findings":
            rows = [
                {
                    "id": found.id,
                    "severity": found.severity,
                    "message": found.message,
                    "count": found.count,
                    "has_cells": bool(len(found.cells) or len(found.vertices)),
                }
                for found in self.findings
            ]
            return {"findings": rows}
        if part == "groups":
            return {"groups": self.groups.listed(), "features": self.marks.listed()}
        if part == "shapes":
            counts = np.bincount(self.shapes, minlength=len(SHAPES))
            return {"shapes": {name: int(count) for name, count in zip(SHAPES, counts, strict=True) if count}}
        if part == "parts":
            return {"part_cells": self.mesh.topology.parts[1][:MOST_PARTS].tolist()}
        if part not in TOPOLOGY:
            raise HexaLabError(f"there is no part {part!r} of a description, but {', '.join(DESCRIBED)}")
        facts = TOPOLOGY[part](self.mesh)
        if part == "edges":
            self.knows_edges = True
        return {**facts, "max_depth": self.drawn_mesh.topology.max_depth} if part == "layers" else facts

    def values(self, quantity: str) -> Floats:
        """Return the value of a quantity, a metric or an attribute, for each cell, (C,) float64.

        Raises
        ------
        UnknownQuantity
            If there is neither a metric nor an attribute of that id.
        """
        if quantity in self._values:
            self._values.move_to_end(quantity)
            return self._values[quantity]
        if quantity in METRICS:
            values = quality(self.mesh, quantity)
        elif quantity in QUANTITIES:
            values = quantity_values(self.traced.structure, quantity)
        elif quantity in COMPARED:
            values = self._beside(quantity).values(quantity)
        else:
            values = cell_values(self.mesh, self.attribute(quantity))
        self._values[quantity] = values
        while len(self._values) > 1 and len(self._values) * values.nbytes > MOST_BYTES_OF_VALUES:
            self._values.popitem(last=False)
        return values

    def _beside(self, quantity: str) -> ComparedBook:
        """What the mesh is compared with; UnknownQuantity where that is nothing."""
        if self.compared is None:
            raise UnknownQuantity(f"{COMPARED[quantity].name}: the mesh is compared with nothing")
        return self.compared

    def known_values(self, quantity: str) -> Floats | None:
        """Return the values of a quantity if they are there, (C,) float64; None if they would have to be computed."""
        return self._values.get(quantity)

    def attribute(self, quantity: str) -> Attribute:
        """Return an attribute by its id.

        Raises
        ------
        UnknownQuantity
            If there is none of that id.
        """
        if quantity not in self.attributes:
            raise UnknownQuantity(f"there is no metric and no attribute {quantity!r}")
        return self.attributes[quantity]

    def field(self, attribute: str) -> VectorField:
        """Return a vector attribute as it is drawn; the last one is kept.

        Raises
        ------
        UnknownQuantity
            If there is no attribute of that id, or it has not three components.
        """
        if attribute == DISPLACEMENT and attribute not in self._fields:
            way = self._beside(attribute).counterpart.displacement(self.mesh)
            self._fields = {attribute: VectorField(way, "point")}
        elif attribute not in self.vectors and attribute != DISPLACEMENT:
            raise UnknownQuantity(f"there is no attribute {attribute!r} of three components")
        if attribute not in self._fields:
            row = self.vectors[attribute]
            self._fields = {attribute: VectorField(own_vectors(self.mesh, row), row.on)}
        return self._fields[attribute]

    def range_of(self, quantity: str) -> tuple[float, float] | None:
        """Return the smallest and largest finite value over the cells; None if there is none."""
        if quantity not in self._ranges:
            self._ranges[quantity] = finite_range(self.values(quantity))
        return self._ranges[quantity]

    def statistics_of(self, quantity: str) -> dict[str, Any]:
        """Return the statistics of a metric or an attribute over the cells."""
        if quantity not in self._statistics:
            self._statistics[quantity] = statistics(
                self.values(quantity), METRICS.get(quantity), self.mesh.kinds
            )
        return self._statistics[quantity]

    def label_of(self, quantity: str) -> str:
        """Return what a metric or an attribute is called on the screen."""
        tables: tuple[Mapping[str, Any], ...] = (METRICS, QUANTITIES, COMPARED, self.attributes)
        name: str = next(table for table in tables if quantity in table)[quantity].name
        return name

    def better_of(self, quantity: str) -> str:
        """Return which of two values of a quantity is better, "high" or "low"; of what nobody knows, "low"."""
        row = METRICS.get(quantity) or COMPARED.get(quantity)
        return row.better if row else "low"

    def irregular(self, barbs: bool, paper: bool) -> Irregular:
        """Return the irregular structure with the parts that a mode draws; it depends on no filter."""
        parts = (barbs, paper)
        if parts not in self._irregular:
            self._irregular = {parts: extract_irregular(self.drawn_mesh, barbs=barbs, paper=paper)}
        return self._irregular[parts]

    def max_depth(self, compute: bool) -> int | None:
        """Return the hop distance of the deepest cell; None if it is not known and not to be computed."""
        topology = self.drawn_mesh.topology
        return topology.max_depth if compute or "depth" in vars(topology) else None

    def plane_ranges(self, planes: dict[str, Any]) -> list[list[float] | None]:
        """Return where each plane's slider runs, as distances from the centre in diagonals of the frame.

        None for a plane that hides nothing: the first picture does not wait for barycentres.
        """
        return [self._plane_range(plane, planes["rule"]) for plane in planes["items"]]

    def _plane_range(self, plane: dict[str, Any], rule: str) -> list[float] | None:
        if not plane["offset"]:
            return None
        frame = self.drawn_mesh.frame
        middle = float((unit(plane["normal"]) * frame.centre).sum())
        places = self.filters.places(plane["normal"], rule)
        return [(end - middle) / frame.diagonal for end in (places.low, places.high)]

    def cut_to(self, cell: int, normal: list[float], rule: str) -> float:
        """Return where a plane's slider stands when the plane has just reached a cell."""
        places = self.filters.places(normal, rule)
        reach = float(places.high - places.low)
        share = (float(places.along[cell]) - places.low) / reach if reach > 0 else 0.0
        return float(min(max(share - CLEARANCE, 0.0), 1.0))

    def for_original(self) -> OpenMesh:
        """Return what the conversion of the original's documents must know of the mesh."""
        mesh, frame = self.mesh, self.drawn_mesh.frame
        low, high = mesh.coordinates.min(axis=1), mesh.coordinates.max(axis=1)
        return OpenMesh(
            centre=_triple(frame.centre),
            diagonal=frame.diagonal,
            whole_centre=_triple(low / 2 + high / 2),
            whole_diagonal=float(np.hypot.reduce(high - low)) or 1.0,
            native=self._native,
        )

    def _native(self, quantity: str, normal: float) -> float:
        reach = self.range_of(quantity) if quantity in METRICS else None
        if reach is None:
            return normal
        return float(METRICS[quantity].denormalise(np.array(normal), *reach))


def _triple(vector: Floats) -> tuple[float, float, float]:
    x, y, z = (float(part) for part in vector)
    return x, y, z
