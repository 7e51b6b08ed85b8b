"""The plots: what each shows, of which numbers, in a table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from hexalab.words import counted

from ..model.catalogue import MeshEntry
from ..tables.values import irregular_share


@dataclass(frozen=True)
class Axis:
    """An axis of a plot.

    Parameters
    ----------
    label : str
    scale : str
        One of `SCALES`.
    value : callable
        Of a mesh; None where it has none.
    missing : str
        What is said of measured meshes that have none: "whose blocks are not known".
    word : callable
        A value in words, in the title of its point.
    """

    label: str
    scale: str
    value: Callable[[MeshEntry], float | None]
    missing: str
    word: Callable[[float], str]


@dataclass(frozen=True)
class Plot:
    """A plot in which every mesh is a point.

    Parameters
    ----------
    id : str
        In its address on the page.
    title, text : str
        What it is called, and what is to be seen.
    x, y : Axis
    """

    id: str
    title: str
    text: str
    x: Axis
    y: Axis

    @property
    def by_year(self) -> bool:
        """Whether the meshes of a year stand above each other."""
        return self.x.scale == "year"


def _share(value: float) -> str:
    return f"{100 * value:.3g} %"


UNMEASURED = "that nobody has measured yet"
"""What is said of meshes of which there is nothing to draw."""

CELLS = Axis(
    "Cells", "count", lambda mesh: mesh.cells or None, "without cells", lambda n: counted(int(n), "cell")
)
WORST = Axis(
    "Smallest Scaled Jacobian",
    "jacobian",
    lambda mesh: mesh.facts.sj_min,
    "without a Scaled Jacobian",
    lambda value: f"min SJ {value:.3f}".replace("-", "−"),
)
MEAN = Axis(
    "Mean Scaled Jacobian",
    "mean",
    lambda mesh: mesh.facts.sj_mean,
    "without a Scaled Jacobian",
    lambda value: f"mean SJ {value:.3f}",
)
BLOCKS = Axis(
    "Blocks of the base complex",
    "count",
    lambda mesh: mesh.facts.blocks,
    "whose blocks are not known",
    lambda n: counted(int(n), "block"),
)
IRREGULAR = Axis(
    "Irregular edges, of those inside",
    "share",
    lambda mesh: irregular_share(mesh.facts),
    "whose edges inside are not known",
    lambda value: f"{_share(value)} irregular",
)
YEAR = Axis(
    "Year of publication", "year", lambda mesh: mesh.source.year, "without a year", lambda year: f"{year:.0f}"
)

PLOTS = (
    Plot(
        "size-and-worst-cell",
        "Size and worst cell",
        "Each point is a mesh; it opens the mesh's page. From 0.5 on a cell is acceptable, at 0 and below it is "
        "flat or turned inside out at a corner.",
        CELLS,
        WORST,
    ),
    Plot(
        "size-and-blocks",
        "Size and structure",
        "A mesh near the bottom is a coarse layout that was subdivided; one near the diagonal has a block for "
        "each cell, and no structure to be coarsened.",
        CELLS,
        BLOCKS,
    ),
    Plot(
        "years",
        "Year by year",
        "The columns count the meshes of a year's publications, the dark part those that are measured here. Below, "
        "each of these is a point; the bar is the middle half, the line in it the median.",
        YEAR,
        WORST,
    ),
    Plot(
        "irregularity-and-mean",
        "Irregularity and shape",
        "Irregular edges let a mesh follow its boundary, and bend the cells around them.",
        IRREGULAR,
        MEAN,
    ),
    Plot(
        "mean-and-worst-cell",
        "Mean and worst cell",
        "Much of what is published about a mesh is its mean; a simulation stops at the worst cell.",
        MEAN,
        WORST,
    ),
)
"""All plots, in their order on the page."""
