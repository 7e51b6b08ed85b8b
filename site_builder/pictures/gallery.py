"""The gallery: what is compared with what, and on which mesh."""

from __future__ import annotations

from dataclasses import dataclass

from .recipe import Recipe
from .shot import Status
from .structures import GALLERY

WIRELESS: Status = {"irregular": {"mode": 0}}
LATTICE, NOISY, PADDED = "shapes/lattice", "sizes/grid-1000", "structures/padded-cube"
WIDE_RANGE = "shapes/t-junction"

MODES = {
    "lines": (
        "Lines",
        {"mode": "lines"},
        "Every edge of the shown surface as a thin line: the plain wireframe, quick at any size.",
    ),
    "darkness-coded-edges": (
        "Darkness-coded edges",
        {"mode": "darkness_coded_edges", "line_opacity": 0.8},
        "An edge is the darker the more shown cells meet at it: edges between cells differ from edges of steps.",
    ),
    "fissure": (
        "Fissure",
        {"mode": "fissure", "gap": 0.15},
        "A crack parts each cell from its neighbours; the surface stays closed, and light falls into the cracks.",
    ),
    "rounded": (
        "Rounded",
        {"mode": "rounded", "radius": 0.09},
        "Every cell has rounded edges and corners, as if it were a thing of its own in a pile.",
    ),
}

LIGHTS = {
    "none": ("No light", "Pure colour: nothing tells one side from another."),
    "direct": ("Direct", "A lamp at the eye: sides differ by their slope, but a pit is as bright as a peak."),
    "screen_space_ao": (
        "Screen-space ambient occlusion",
        "Estimated from what the picture itself shows, at once: hollows darken near their edges.",
    ),
    "object_space_ao": (
        "Object-space ambient occlusion",
        "Light from 1,024 directions all around, gathered on the surface: the deeper a place lies, the darker it is.",
    ),
}


@dataclass(frozen=True)
class SectionRecipe:
    """A row of pictures, by the names of their files; `more`, a page of the site and what is said of it."""

    id: str
    title: str
    text: str
    recipes: dict[str, Recipe]
    more: tuple[str, str] = ("", "")


def _by_light(mode: str) -> SectionRecipe:
    title, separation, text = MODES[mode]
    recipes = {
        light.replace("_", "-"): Recipe(
            LATTICE,
            {"separation": separation, "lighting": {"mode": light}},
            title=name,
            sentence=sentence if mode == "lines" else "",
        )
        for light, (name, sentence) in LIGHTS.items()
    }
    return SectionRecipe(mode, title, text, recipes)


def _maps() -> dict[str, Recipe]:
    rows = {
        "parula": ("Parula", "From blue to yellow; the paper's first choice."),
        "viridis": ("Viridis", "Even steps for the eye, also for colour-blind readers and in print."),
        "jet": ("Jet", "The rainbow that older papers use, for comparing with them."),
        "red_blue": ("Red-Blue", "White in the middle: only both ends catch the eye."),
    }
    mode = {"separation": {"mode": "rounded", "radius": 0.06}}
    return {
        name.replace("_", "-"): Recipe(
            WIDE_RANGE,
            {"colour": {"by": "quality", "map": name, "range": [0.5, 1]}},
            mode,
            title=title,
            sentence=sentence,
        )
        for name, (title, sentence) in rows.items()
    }


COLOURS = {
    "sides": Recipe(
        "structures/mixed",
        {"colour": {"by": "sides", "outside": "#dfe7ee", "inside": "#e39a2d"}},
        title="Outside and inside",
        sentence="Two colours, free to choose: what was boundary, and what a filter has laid open.",
    ),
    "kind": Recipe(
        "structures/mixed",
        {"colour": {"by": "kind"}},
        title="Kind of cell",
        sentence="Hexahedra, wedges, pyramids and tetrahedra in a colour each.",
    ),
    "attribute": Recipe(
        "structures/heated-plate",
        {"colour": {"by": "attribute", "attribute": "point:temperature"}},
        title="Attribute",
        sentence="Any array that the file carries, here the temperature at the vertices of a plate.",
        offset=0,
    ),
}

SILHOUETTES = {
    name: Recipe("shapes/knot", {"silhouette": value}, title=title, sentence=sentence)
    for name, value, title, sentence in (
        ("none", 0, "None", "Only what is shown."),
        ("flat", 0.5, "Flat", "What is hidden leaves one even tint, as on a map."),
        ("shaded", 1, "Shaded", "The tint has a little light, so that the hidden half keeps its form."),
    )
}

STRUCTURES = {
    name: Recipe(PADDED, {"irregular": {"mode": mode}}, title=title, sentence=sentence, offset=0.55)
    for name, mode, title, sentence in (
        ("wires", 1, "Wires", "Irregular edges where nothing hides them; colour tells the valence."),
        ("wires-through", 2, "Wires, seen through", "The same, faint where cells stand before them."),
        (
            "barbed",
            3,
            "Barbed wires",
            "Barbs point along the edges that meet there, one for each sheet of faces.",
        ),
        ("barbed-through", 4, "Barbed wires, seen through", "All of them, through the cells."),
        ("paper", 5, "Paper", "Flaps of the faces around each irregular edge, like a paper model."),
        ("paper-through", 6, "Paper, seen through", "All flaps, through the cells."),
    )
}

ROW: Status = {"unit": "px", "width": 1440, "height": 430, "crop": True, "margin": 4}
"""A figure as broad as a page, of several panels."""

HALF: Status = {"unit": "px", "width": 960, "height": 540, "margin": 4}
"""A figure as broad as a column."""

ROUND: Status = {"mode": "rounded", "radius": 0.09}


def _panels(setting: str, *values: float) -> Status:
    return {"figure": {**ROW, "panels": {"setting": setting, "values": list(values)}}}


def _mapped(name: str) -> Status:
    return {
        "colour": {"by": "quality", "map": name, "range": [0.5, 1]},
        "figure": {**HALF, "legend": "histogram"},
    }


def _compared(caption: str) -> Status:
    """Under one status: the same view, cut and range of colours."""
    return {
        "colour": {"by": "quality", "range": [0.5, 1]},
        "irregular": {"mode": 3},
        "figure": {**HALF, "legend": "histogram", "caption": True, "caption_text": caption},
    }


UNDUG = [3, 4, 11, 12, 19, 20, 27, 28, 35, 36, 43, 44, 51, 52, 59, 60]
"""Cells of shapes/cube that stand before the cut: two columns of them."""

FIGURES = {
    "separation": Recipe(
        "shapes/knot",
        _panels("separation", 0, 1, 2, 3),
        WIRELESS,
        title="Separation",
        sentence="Lines, darkness-coded edges, fissures, rounded cells: one cut, four ways to tell cells apart.",
    ),
    "lighting": Recipe(
        LATTICE,
        _panels("lighting", 3, 2, 1, 0),
        {"separation": {"mode": "fissure", "gap": 0.15}},
        title="Light",
        sentence="None, a lamp at the eye, ambient occlusion from the picture, and from 1,024 directions.",
    ),
    "peeling": Recipe(
        "shapes/torus",
        _panels("peel", 0, 1, 2, 3),
        {"separation": ROUND, **WIRELESS},
        title="Peeling",
        sentence="Nothing, one, two and three layers of cells taken off from the boundary.",
        offset=0,
    ),
    "regularisation": Recipe(
        "shapes/sphere",
        _panels("regularisation", 0, 1, 2, 3),
        {"separation": ROUND, **WIRELESS},
        title="Regularisation",
        sentence="The ragged edge of a cut becomes cleaner with each step.",
    ),
    "undigging": Recipe(
        "shapes/cube",
        {"filters": {"picking": {"shown": UNDUG}}, "figure": HALF},
        {"separation": ROUND, **WIRELESS},
        title="Undigging",
        sentence="A few hidden cells brought back by hand tell how the mesh goes on before the cut.",
    ),
    "combined": Recipe(
        "shapes/nozzle",
        {
            "filters": {"quality": {"items": [{"quantity": "scaled_jacobian", "maximum": 0.97}]}},
            "see_through": {"cells": "quality", "opacity": 0.15},
            "figure": {**HALF, "legend": "bar", "scale_bar": True, "axes": True, "caption": True},
        },
        {"separation": ROUND, "colour": {"by": "quality", "range": [0.8, 1]}, **WIRELESS},
        title="Filters combined",
        sentence="Cut, and only the worse cells, seen through the better ones; with scale bar, axes and caption.",
    ),
    "silhouettes": Recipe(
        "shapes/gear",
        _panels("silhouette", 0, 0.5, 1),
        {"separation": ROUND, **WIRELESS},
        title="Silhouettes",
        sentence="What is hidden leaves nothing, a flat tint, or a shaded shape.",
    ),
    "irregular": Recipe(
        PADDED,
        _panels("irregular", 1, 3, 5),
        title="Irregular structure",
        sentence="Irregular edges as wires, barbed wires and paper: each tells more of how cells meet there.",
        offset=0.55,
    ),
    "map-parula": Recipe(
        WIDE_RANGE,
        _mapped("parula"),
        {"separation": ROUND, **WIRELESS},
        title="Colour map with histogram, Parula",
        sentence="Bars and cells have the same colours; the bracket is the acceptable range.",
    ),
    "map-red-blue": Recipe(
        WIDE_RANGE,
        _mapped("red_blue"),
        {"separation": ROUND, **WIRELESS},
        title="Colour map with histogram, Red-Blue",
        sentence="White in the middle: the ends stand out.",
    ),
    "comparison-grid": Recipe(
        "shapes/cube",
        _compared("A grid: no irregular edge, all cells alike."),
        {"separation": ROUND},
        title="Comparison, a grid",
        sentence="Two meshes of a cube under one status: the same view, cut and range of colours.",
    ),
    "comparison-padded": Recipe(
        PADDED,
        _compared("Padded: twelve irregular edges run from the corners to an inner cube."),
        {"separation": ROUND},
        title="Comparison, a padded grid",
        sentence="What the layer along the boundary costs stands in the histogram.",
    ),
}

SECTIONS = (
    SectionRecipe(
        "figures",
        "Figures for papers",
        "What “Save a picture” makes of a view: several panels in a row, a legend or a histogram, scale bar, axes, "
        "caption; as PNG, SVG or PDF. A click opens the view with all of that set: press Image.",
        FIGURES,
    ),
    *(_by_light(mode) for mode in MODES),
    SectionRecipe(
        "maps",
        "Quality in colour",
        "Cells by their Scaled Jacobian, from 0.5 to 1. In each map the first colour, blue or nearly, is the best.",
        _maps(),
    ),
    SectionRecipe("colours", "Other colours", "What else the faces can tell.", COLOURS),
    SectionRecipe(
        "silhouette",
        "What is hidden",
        "The part that filters hide can stay as a silhouette behind the rest.",
        SILHOUETTES,
    ),
    SectionRecipe(
        "structure",
        "Irregular edges",
        "Interior edges with other than four cells around them: red for three, green for five, blue for six and more.",
        STRUCTURES,
    ),
    SectionRecipe(
        "global-structure",
        "Structure",
        "What a mesh consists of as a whole: blocks, sheets, chords, arcs.",
        GALLERY,
        more=("guide/structure/", "The guide explains the words."),
    ),
)
"""Sections of the gallery in their order."""
