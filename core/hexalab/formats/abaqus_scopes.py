"""Scopes of numbers in an Abaqus deck: the deck itself, parts, instances of parts, the assembly."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..arrays import Array, Floats
from .abaqus_rows import ElementRows
from .abaqus_sets import Definitions
from .abaqus_systems import HERE, Placement

DECK, PART, ASSEMBLY, INSTANCE = "deck", "part", "assembly", "instance"


@dataclass(eq=False)
class Scope:
    """What is defined in one place, under numbers of its own.

    Parameters
    ----------
    kind : str
        DECK, PART, ASSEMBLY or INSTANCE.
    name : str
    part : str
        What an instance is of.
    placement : Placement
        Where an instance lies.
    tags, points : lists of (n,) integers and (3, n) float64
        Numbers and coordinates of nodes, block by block.
    elements, lower : list of ElementRows
        Volumetric ones, and those of lower dimension.
    left_out : dict of str to int
        How many elements of other types there are.
    defined : Definitions
        Sets, surfaces, sections.
    """

    kind: str
    name: str = ""
    part: str = ""
    placement: Placement = HERE
    tags: list[Array] = field(default_factory=list)
    points: list[Floats] = field(default_factory=list)
    elements: list[ElementRows] = field(default_factory=list)
    left_out: dict[str, int] = field(default_factory=dict)
    defined: Definitions = field(default_factory=Definitions)
    lower: list[ElementRows] = field(default_factory=list)

    @property
    def empty(self) -> bool:
        """Whether nothing is defined here."""
        return not (self.tags or self.elements or self.left_out)

    @property
    def cell_count(self) -> int:
        """How many elements there are that can be shown."""
        return sum(len(rows.numbers) for rows in self.elements)

    def with_part(self, part: Scope | None) -> Scope:
        """The instance with what its part defines; what it defines itself comes after that."""
        if part is None:
            return self
        left_out = dict(part.left_out)
        for name, count in self.left_out.items():
            left_out[name] = left_out.get(name, 0) + count
        return Scope(
            INSTANCE, self.name, self.part, self.placement,
            part.tags + self.tags, part.points + self.points, part.elements + self.elements, left_out,
            part.defined + self.defined, part.lower + self.lower,
        )  # fmt: skip

    def nodes(self) -> tuple[Array, Floats, int]:
        """Numbers (n,) and coordinates (3, n), each number once; and how many had another place before.

        The last definition of a number counts (Abaqus' manual, *NODE; CalculiX' `nodes.f`).
        """
        tags = np.concatenate(self.tags)
        points = self.points[0] if len(self.points) == 1 else np.concatenate(self.points, axis=1)
        moved = 0
        if not (np.diff(tags) > 0).all():
            order = np.argsort(tags, kind="stable")
            begins = np.append(True, np.diff(tags[order]) != 0)
            if not begins.all():
                firsts = order[begins]
                lasts = order[np.append(np.flatnonzero(begins)[1:], len(tags)) - 1]
                moved = int((points[:, firsts] != points[:, lasts]).any(axis=0).sum())
                in_order = np.argsort(firsts)
                tags, points = tags[firsts[in_order]], points[:, lasts[in_order]]
        return tags, self.placement(points), moved

    def repeated_elements(self) -> int:
        """How many elements have the number of one before."""
        if not self.elements:
            return 0
        numbers = np.concatenate([rows.numbers for rows in self.elements])
        if (np.diff(numbers) > 0).all():
            return 0
        return len(numbers) - len(np.unique(numbers))


def model(scopes: list[Scope]) -> tuple[list[Scope], list[str]]:
    """What of a deck is in the model, in its order, and what is to be noted of the rest.

    Once any part is instanced, parts are in the model through their instances only; a deck without instances
    shows its parts where they lie.
    """
    instances = [scope for scope in scopes if scope.kind == INSTANCE]
    parts = {scope.name.upper(): scope for scope in scopes if scope.kind == PART}
    notes: list[str] = []
    if not instances:
        if any(not part.empty for part in parts.values()):
            notes.append("No part is instanced: parts are shown where they lie.")
        return scopes, notes
    used = {instance.part.upper() for instance in instances}
    for name, part in parts.items():
        if name not in used and not part.empty:
            cells = "its cell" if part.cell_count == 1 else f"its {part.cell_count:,} cells"
            notes.append(f"Part {part.name} is left out with {cells}: it is not instanced.")
    shown = []
    for scope in scopes:
        if scope.kind == INSTANCE:
            found = parts.get(scope.part.upper())
            if found is None and scope.empty:
                notes.append(f"Instance {scope.name} is left out: part {scope.part} is not in the file.")
            scope = scope.with_part(found)
        if scope.kind != PART:
            shown.append(scope)
    return shown, notes
