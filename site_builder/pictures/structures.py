"""The structure of whole meshes, as gallery and guide show it: what is looked at, and what else is set to see it."""

from __future__ import annotations

from .recipe import Recipe
from .shot import Status

ROUND: Status = {"separation": {"mode": "rounded", "radius": 0.09}}
"""Cells that are told apart."""

WIRELESS: Status = {"irregular": {"mode": 0}}

COLOURED_BY = {"sheets": "chosen", "chords": "chosen", "blocks": "block"}
"""What the viewer colours cells by while things of a kind are looked at."""


def look(
    mesh: str,
    kind: str,
    *chosen: int,
    title: str = "",
    sentence: str = "",
    setting: Status | None = None,
    **more: object,
) -> Recipe:
    """A recipe that looks at things of a kind, at all or at some; `more` of the section `structure` is set."""
    settings: Status = {"structure": {"kind": kind, **({"chosen": list(chosen)} if chosen else {}), **more}}
    if kind in COLOURED_BY:
        settings["colour"] = {"by": COLOURED_BY[kind]}
    around = WIRELESS | ROUND | (setting or {})
    return Recipe(mesh, settings, around, title=title, sentence=sentence, offset=0)


def seen_from(*direction: float, context: float = 0.2) -> Status:
    """A camera that looks so, and how much is seen of what is not chosen."""
    return {"camera": {"direction": list(direction)}, "see_through": {"opacity": context}}


def cut(*normal: float, offset: float = 0.5) -> Status:
    """A plane that is not the one of the three-quarter view."""
    return {"filters": {"planes": {"items": [{"enabled": True, "normal": list(normal), "offset": offset}]}}}


DISTANCE: Status = {"colour": {"by": "attribute", "attribute": "structure:distance"}}

GALLERY = {
    "blocks": look(
        "shapes/gear",
        "blocks",
        title="Blocks",
        sentence="Grids that the walls from irregular edges enclose; neighbours never have like colours.",
    ),
    "apart": look(
        "structures/three-refinement",
        "blocks",
        explode=0.5,
        title="Blocks apart",
        sentence="Drawn apart, those inside are seen: here templates between a coarse and a fine grid.",
    ),
    "walls": look(
        "structures/three-refinement",
        "blocks",
        form="surfaces",
        curves=True,
        title="Walls and curves",
        sentence="The base complex itself: walls between blocks, the edges in which they meet, and their ends.",
    ),
    "crossing": look(
        "shapes/thick-shell",
        "sheets",
        6,
        23,
        setting=seen_from(-0.4, 0.75, -0.55),
        title="Two sheets",
        sentence="Two layers of cells, and dark the cells that both pass through.",
    ),
    "dual": look(
        "shapes/knot",
        "sheets",
        1,
        form="surfaces",
        title="A dual surface",
        sentence="A sheet as the surface through the middles of its cells, within the body.",
    ),
    "chords": look(
        "shapes/knot",
        "chords",
        2,
        16,
        12,
        7,
        title="Chords",
        sentence="Columns of cells; these run once around the knot and close.",
    ),
    "arcs": look(
        "structures/two-refinement",
        "arcs",
        title="Arcs and nodes",
        sentence="Chains of irregular edges, coloured by valence, and the vertices where they meet.",
    ),
    "distance": Recipe(
        "shapes/sphere",
        DISTANCE,
        ROUND | cut(0.0, 1.0, 0.0) | seen_from(-0.35, 0.85, -0.4),
        title="Distance to the nearest irregular edge",
        sentence="In cells, from the core's edges outwards.",
    ),
}
"""The gallery's section on structure."""
