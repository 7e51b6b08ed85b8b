"""Drawing a plot with Matplotlib: its artists carry the names by which `svg.py` finds them again."""

from __future__ import annotations

import io
import math
from collections import Counter
from collections.abc import Sequence
from statistics import median, quantiles
from typing import Any

from matplotlib import rc_context, rcdefaults, rcParams
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ..tables.field import Field
from .points import Point
from .scales import SCALES
from .table import Axis, Plot

WIDTH, HEIGHT = 820, 480
"""Of a plot, in units of its own."""

LEFT, RIGHT, TOP, BOTTOM = 62, 12, 30, 50
"""Margins around what is plotted."""

COLUMNS, GAP = 96, 40
"""Height of the columns over the plot by year, and of what parts both."""

SETTINGS: Any = {"svg.hashsalt": "hexalab", "svg.fonttype": "none", "figure.dpi": 72, "path.simplify": False}
"""So that the same numbers give the same bytes, and text stays text."""

ACCEPTABLE = 0.5
"""Scaled Jacobian from which on a cell is acceptable."""

BINS, HALF_WIDTH = 25, 0.4
"""By year: heights in which points are put beside each other, and how far they may go from their year."""

NARROWEST = 0.09
"""Years between points that have room."""

FEWEST = 5
"""Meshes of a year from which on its middle half is drawn."""


def draw(plot: Plot, points: Sequence[Point], field: Field) -> str:
    """The plot as Matplotlib writes it, its points in their order, in a group ``c-points``."""
    with rc_context():
        rcdefaults()
        rcParams.update(SETTINGS)
        figure = Figure(figsize=(WIDTH / 72, HEIGHT / 72), dpi=72)
        FigureCanvasSVG(figure)
        top = TOP + COLUMNS + GAP if plot.by_year else TOP
        axes = _axes(figure, top, HEIGHT - BOTTOM)
        xs = [mesh.source.year for mesh in field.meshes] if plot.by_year else [point.x for point in points]
        _scaled(axes, plot.x, "x", xs)
        _scaled(axes, plot.y, "y", [point.y for point in points])
        if plot.by_year:
            _columns(figure, axes, field)
            _halves(axes, points)
        places = _beside(points) if plot.by_year else [point.x for point in points]
        axes.plot(places, [point.y for point in points], "o", clip_on=False, gid="c-points")
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None})
        return text.getvalue()


def _axes(figure: Figure, top: float, bottom: float) -> Axes:
    """A place for something that is plotted, between two heights from above, without frame and background."""
    width, height = (WIDTH - LEFT - RIGHT) / WIDTH, (bottom - top) / HEIGHT
    axes = figure.add_axes((LEFT / WIDTH, 1 - bottom / HEIGHT, width, height))
    figure.patch.set_visible(False)
    axes.patch.set_visible(False)
    axes.minorticks_off()
    for spine in axes.spines.values():
        spine.set_visible(False)
    return axes


def _scaled(axes: Axes, axis: Axis, which: str, values: Sequence[float]) -> None:
    """Give an axis its scale, grid and labels; lines that mean something are drawn stronger."""
    scale = SCALES[axis.scale]
    low, high = scale.limits(values)
    getattr(axes, f"set_{which}scale")(scale.name, **scale.options)
    getattr(axes, f"set_{which}lim")(low, high)
    ticks = scale.ticks(low, high)
    part: Any = getattr(axes, f"{which}axis")
    part.set_ticks([value for value, _ in ticks], labels=[label for _, label in ticks])
    part.minorticks_off()
    for tick, (value, _) in zip(part.get_major_ticks(), ticks, strict=True):
        tick.tick1line.set_visible(False)
        tick.gridline.set_visible(True)
        strong = axis.scale == "jacobian" and value in (0, ACCEPTABLE)
        tick.gridline.set_gid("c-guide" if strong else "c-grid")
        tick.label1.set_gid("c-tick")
    if which == "x":
        _named(axes, axis.label, (0, 0), (0, 14 - BOTTOM))
    else:
        _named(axes, axis.label, (0, 1), (2 - LEFT, 12))


def _named(axes: Axes, text: str, corner: tuple[float, float], shift: tuple[float, float]) -> None:
    """Write what an axis is of, beside a corner of the plot."""
    axes.annotate(text, corner, shift, "axes fraction", "offset pixels", gid="c-label")


def _columns(figure: Figure, below: Axes, field: Field) -> None:
    """How many meshes each year has, and how many of them are measured."""
    all_of = Counter(mesh.source.year for mesh in field.meshes)
    measured = Counter(mesh.source.year for mesh in field.meshes if mesh.facts.sj_min is not None)
    axes = _axes(figure, TOP, TOP + COLUMNS)
    axes.set_xlim(below.get_xlim())
    axes.set_ylim(0, max(all_of.values()) * 1.16)
    axes.xaxis.set_visible(False)
    axes.yaxis.set_visible(False)
    for year in sorted(all_of):
        for counts, name in ((all_of, "c-column"), (measured, "c-column-measured")):
            axes.bar([year], [counts[year]], width=0.62, gid=name)
        axes.annotate(
            f"{all_of[year]:,}", (year, all_of[year]), (0, 4), textcoords="offset pixels", ha="center", gid="c-tick"
        )  # fmt: skip
    axes.axhline(0, gid="c-base")
    _named(axes, "Meshes", (0, 1), (2 - LEFT, 12))


def _halves(axes: Axes, points: Sequence[Point]) -> None:
    """The middle half of each year, and the median."""
    for year in sorted({point.x for point in points}):
        values = [point.y for point in points if point.x == year]
        if len(values) >= FEWEST:
            low, _, high = quantiles(values, method="inclusive")
            axes.add_patch(Rectangle((year - HALF_WIDTH, low), 2 * HALF_WIDTH, high - low, gid="c-half"))
            axes.plot([year - HALF_WIDTH, year + HALF_WIDTH], [median(values)] * 2, gid="c-median")


def _beside(points: Sequence[Point]) -> list[float]:
    """Places of points along the years: those of like height stand beside each other."""
    heaps: dict[tuple[float, int], list[int]] = {}
    for number, point in enumerate(points):
        heaps.setdefault((point.x, math.floor(point.y * BINS)), []).append(number)
    places = [0.0] * len(points)
    for (year, _), heap in heaps.items():
        step = min(NARROWEST, 2 * HALF_WIDTH / len(heap))
        for place, number in enumerate(heap):
            places[number] = year + (place - (len(heap) - 1) / 2) * step
    return places
