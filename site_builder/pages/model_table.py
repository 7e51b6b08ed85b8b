"""The table of a body's meshes: its columns, what is best in each, and the same for LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from hexalab.quality import METRICS
from hexalab.quality.metrics import Metric

from ..citing.exports import tex
from ..model.catalogue import MeshEntry
from ..model.facts import Facts
from ..model.methods import METHODS
from .bodies import Body
from .words import NOT_KNOWN, count, number, percent, short_verdict

LOW = 0.3
"""Scaled Jacobian below which papers count cells."""


@dataclass(frozen=True)
class Column:
    """A column of numbers.

    Parameters
    ----------
    head, title : str
        What stands above it, and what that means.
    value : callable
        Gives the number of a mesh, None if it isn't known.
    write : callable
        Puts a number into words.
    better : {"high", "low", ""}
        Which of two numbers is better, "" for neither.
    place : str
        Where a metric that the reader chooses puts its numbers: "worst", "mean" or "" for nowhere.
    """

    head: str
    title: str
    value: Callable[[MeshEntry], float | None]
    write: Callable[[Any], str] = count
    better: str = ""
    place: str = ""


def _low_share(facts: Facts) -> float | None:
    """The share of cells whose Scaled Jacobian is below `LOW`, where the bins' edges tell it exactly."""
    if facts.histogram is None or not facts.cells:
        return None
    low, high, counts = facts.histogram["low"], facts.histogram["high"], facts.histogram["counts"]
    bins = (LOW - low) / (high - low) * len(counts)
    return sum(counts[: round(bins)]) / facts.cells if abs(bins - round(bins)) < 1e-9 else None


COLUMNS = (
    Column("Cells", "Number of cells", lambda mesh: mesh.cells),
    Column("Vertices", "Number of vertices", lambda mesh: mesh.facts.vertices),
    Column("min SJ", "Smallest Scaled Jacobian", lambda mesh: mesh.facts.sj_min, number, "high", "worst"),
    Column("mean SJ", "Mean Scaled Jacobian", lambda mesh: mesh.facts.sj_mean, number, "high", "mean"),
    Column(
        f"SJ < {LOW}",
        f"Share of cells with a Scaled Jacobian below {LOW}",
        lambda mesh: _low_share(mesh.facts),
        lambda part: percent(part).replace("under ", "< "),
        "low",
    ),
    Column(
        "Irregular",
        "Interior edges with other than four cells",
        lambda mesh: mesh.facts.irregular_edges,
        better="low",
    ),
    Column("Arcs", "Arcs and loops of irregular interior edges", lambda mesh: mesh.facts.arcs, better="low"),
    Column("Sheets", "Layers of cells, one thick", lambda mesh: mesh.facts.sheets, better="low"),
    Column("Blocks", "Blocks of the base complex", lambda mesh: mesh.facts.blocks, better="low"),
)

CHOICES: tuple[Metric, ...] = tuple(metric for metric in METRICS.values() if not metric.length_power)
"""Metrics that may be compared between meshes of any size."""


@dataclass(frozen=True)
class Cell:
    """A number of the table in words, and whether it is the best of its column."""

    text: str
    best: bool
    place: str


def rows(meshes: Sequence[MeshEntry], *, compared: bool = True) -> list[tuple[MeshEntry, list[Cell]]]:
    """Each mesh with its numbers; where they may be compared, the best of each column are marked."""
    rivals = [mesh for mesh in meshes if ranked(mesh)] if compared else []
    best = [_best(column, rivals) for column in COLUMNS]
    return [
        (mesh, [_cell(column, mesh, top) for column, top in zip(COLUMNS, best, strict=True)])
        for mesh in meshes
    ]


def ranked(mesh: MeshEntry) -> bool:
    """Whether a mesh may be the best in something: one that can't be computed with is not, however regular."""
    return short_verdict(mesh.facts)[0] != "invalid"


def _best(column: Column, meshes: Sequence[MeshEntry]) -> float | None:
    """The best number of a column; None if none is, as where all are the same."""
    known = {value for mesh in meshes if (value := column.value(mesh)) is not None}
    if len(known) < 2 or not column.better:
        return None
    return max(known) if column.better == "high" else min(known)


def _cell(column: Column, mesh: MeshEntry, best: float | None) -> Cell:
    value = column.value(mesh)
    text = NOT_KNOWN if value is None else column.write(value)
    return Cell(text, value is not None and value == best and ranked(mesh), column.place)


def method_name(mesh: MeshEntry) -> str:
    """The name of the family of methods that made a mesh."""
    return METHODS[mesh.method].name if mesh.method else NOT_KNOWN


def latex(body: Body) -> str:
    """The table of the meshes that fill a body, for a paper: booktabs, keys as in the site's BibTeX."""
    heads = ["Mesh", "Source", *(_math(column.head) for column in COLUMNS), "Validity"]
    lines = [
        rf"\begin{{tabular}}{{ll{'r' * len(COLUMNS)}l}}",
        r"\toprule",
        " & ".join(heads) + r" \\",
        r"\midrule",
        *(_latex_row(mesh, cells) for mesh, cells in rows(body.filling)),
        r"\bottomrule",
        r"\end{tabular}",
    ]
    return "\n".join(lines) + "\n"


def _latex_row(mesh: MeshEntry, cells: list[Cell]) -> str:
    numbers = [rf"\textbf{{{_math(cell.text)}}}" if cell.best else _math(cell.text) for cell in cells]
    verdict = _math(short_verdict(mesh.facts)[1])
    return " & ".join([tex(mesh.name), rf"\cite{{{mesh.source.slug}}}", *numbers, verdict]) + r" \\"


def _math(text: str) -> str:
    """A number or a head as TeX writes it."""
    plain = text.replace("−", "$-$").replace("<", "$<$").replace(">", "$>$").replace("%", r"\%")
    return "--" if plain == NOT_KNOWN else plain
