"""The points of a plot, and what of the catalogue is not among them."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from hexalab.words import counted

from ..model.catalogue import MeshEntry
from ..tables.families import family_names, method_of
from ..tables.field import Field
from .scales import SQUEEZE
from .table import UNMEASURED, Axis, Plot


@dataclass(frozen=True)
class Point:
    """A mesh in a plot.

    Parameters
    ----------
    x, y : float
        In the units of the axes.
    family : str
        Id of the family of methods, "" if it isn't told.
    title : str
        Mesh, source and values.
    page : str
        Address of the mesh's page below the site's root.
    """

    x: float
    y: float
    family: str
    title: str
    page: str


@dataclass(frozen=True)
class Chosen:
    """What a plot draws.

    Parameters
    ----------
    points : list of Point
        Family by family, that of the most points first: the few come to lie on the many.
    notes : list of str
        What is not drawn, and what is drawn otherwise than one would think: sentences.
    """

    points: list[Point]
    notes: list[str]


def points_of(plot: Plot, field: Field) -> Chosen:
    """The points of a plot out of the meshes of the field."""
    points, missing = [], Counter[str]()
    for mesh in field.meshes:
        x, y = plot.x.value(mesh), plot.y.value(mesh)
        if mesh.facts.sj_min is None:
            missing[UNMEASURED] += 1
        elif x is None or y is None:
            missing[plot.x.missing if x is None else plot.y.missing] += 1
        else:
            points.append(Point(x, y, method_of(mesh), _title(plot, mesh, x, y), mesh.page))
    order = {name: number for number, name in enumerate(family_names())}
    sizes = Counter(point.family for point in points)
    points.sort(key=lambda point: (-sizes[point.family], order[point.family]))
    return Chosen(points, list(_notes(plot, field, points, missing)))


def _title(plot: Plot, mesh: MeshEntry, x: float, y: float) -> str:
    values = [plot.y.word(y)] if plot.by_year else [plot.x.word(x), plot.y.word(y)]
    return f"{mesh.name}, {mesh.source.short}: {', '.join(values)}"


def _notes(plot: Plot, field: Field, points: list[Point], missing: Counter[str]) -> list[str]:
    notes = [f"{_meshes(len(points))} {_are(len(points))} drawn."]
    left = [f"{_meshes(number)} {why}" for why, number in missing.items()]
    if field.doubled:
        left.append(f"{counted(field.doubled, 'file')} that {_hold(field.doubled)} a mesh in another format")
    if field.own:
        left.append(f"{_meshes(field.own)} of our own making")
    if left:
        notes.append(f"Left out: {_listed(left)}.")
    for axis, values in ((plot.x, [point.x for point in points]), (plot.y, [point.y for point in points])):
        notes += _odd(axis, values)
    return notes


def _odd(axis: Axis, values: list[float]) -> list[str]:
    """What is said of values that a scale shows otherwise than the others."""
    below, none = sum(value <= 0 for value in values), sum(value == 0 for value in values)
    if axis.scale == "jacobian" and below:
        return [
            f"{_meshes(below)} {_are(below)} at 0 or below it, where the scale is {SQUEEZE} times smaller."
        ]
    if axis.scale == "share" and none:
        return [f"{_meshes(none)} {_are(none)} at 0, which has no logarithm."]
    return []


def _meshes(number: int) -> str:
    return f"{number:,} {'mesh' if number == 1 else 'meshes'}"


def _are(number: int) -> str:
    return "is" if number == 1 else "are"


def _hold(number: int) -> str:
    return "holds" if number == 1 else "hold"


def _listed(parts: list[str]) -> str:
    return parts[0] if len(parts) == 1 else f"{'; '.join(parts[:-1])}; and {parts[-1]}"
