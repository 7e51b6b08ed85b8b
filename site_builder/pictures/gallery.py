"""The gallery: what is compared with what, and on which mesh."""

from __future__ import annotations

from dataclasses import dataclass

from .recipe import Recipe

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
    """A row of pictures, by the names of their files."""

    id: str
    title: str
    text: str
    recipes: dict[str, Recipe]


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

SECTIONS = (
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
)
"""Sections of the gallery in their order."""
