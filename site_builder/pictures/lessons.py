"""Pictures of the guide's page on structure: each by the name that the page's text calls it."""

from __future__ import annotations

from dataclasses import replace

from hexalab.status import merge

from .recipe import Recipe
from .shot import Status
from .structures import DISTANCE, ROUND, WIRELESS, cut, look, seen_from

BARBED: Status = {"irregular": {"mode": 3}}

ABOVE = (-0.45, 0.7, -0.75)
"""A look from higher up than usual."""

SIDE_BY_SIDE = (0, 3, 4, 5, 6, 7)
"""Sheets of shapes/sphere that pass the same blocks, one beside the other."""

BUNDLE = (0, 20, 41, 72, 80, 83, 96, 104, 107)
"""Chords of shapes/sphere that pass the same blocks, some way from each other."""


def around(valence: int, words: str) -> Recipe:
    """A straight irregular edge that comes out of a level cut."""
    near: Status = {
        "camera": {"fit": False, "direction": list(ABOVE), "target": [0, 0, 0.03], "distance": 0.9}
    }
    setting = ROUND | BARBED | near | cut(0.0, 0.0, -1.0, offset=0.55)
    return Recipe(
        f"structures/valence-{valence}", {}, setting, title=f"Valence {valence}", sentence=words, offset=0
    )


WINDOW = Recipe(
    "shapes/thick-shell",
    {"structure": {"kind": "sheets", "chosen": [1, 6]}, "colour": {"by": "chosen"}},
    ROUND | WIRELESS,
    part="body",
    press=".structure-table [role=columnheader]:first-child button",
    offset=0,
)
"""The whole window; what is pressed sorts the table as it is sorted, and brings the section into sight."""

IRREGULAR = {
    "valence-3": around(
        3, "Three cells around each edge of the red wire, where the grid has four everywhere else."
    ),
    "valence-5": around(5, "Five cells around each edge of the green wire."),
}

GRAPH = {
    "arcs": look(
        "shapes/sphere",
        "arcs",
        title="Arcs and nodes",
        sentence="Twenty arcs of valence 3: twelve around the core, and from each of its corners one to the boundary.",
    ),
    "loops": look(
        "layouts/hoops",
        "arcs",
        title="Loops",
        sentence="Four irregular edges that close upon themselves: no node, no end.",
    ),
    "nodes": look(
        "layouts/nodes",
        "arcs",
        setting=seen_from(-0.15, 0.6, -0.8),
        title="Eight types of nodes",
        sentence="Each in a part of its own, beside two arcs without one: red is valence 3, green 5.",
    ),
    "node": look(
        "layouts/nodes",
        "arcs",
        5,
        6,
        7,
        8,
        setting={
            "camera": {
                "fit": False,
                "direction": [-0.35, 0.75, -0.55],
                "target": [0, 0.102, 0],
                "distance": 0.4,
            },
            "silhouette": 0,
        },
        title="i 3 3 5 5",
        sentence="A node inside where two arcs of valence 3 and two of valence 5 meet.",
    ),
    "nodes-of-six": look(
        "layouts/nodes-of-six",
        "arcs",
        title="i 3 3 3 3 6 6 6 6",
        sentence="With edges of six cells (blue) there is no end to the types; beside it an arc of valence 6.",
    ),
}

SHEETS = {
    "layer": look(
        "shapes/bent-pipe",
        "sheets",
        0,
        title="A layer of cells",
        sentence="A sheet of 210 cells, as thick as one of them.",
    ),
    "dual": look(
        "shapes/bent-pipe",
        "sheets",
        0,
        form="surfaces",
        title="Its dual surface",
        sentence="The same sheet as the surface through the middles of its cells.",
    ),
    "closed": look(
        "structures/padded-cube",
        "sheets",
        15,
        form="surfaces",
        title="Closed",
        sentence="It goes around the core and never comes to the boundary.",
    ),
    "self-intersecting": look(
        "structures/self-crossing",
        "sheets",
        0,
        form="surfaces",
        title="Self-intersecting",
        sentence="It runs around the ring and passes through itself in the dark cells.",
    ),
    "self-touching": look(
        "layouts/self-touching",
        "sheets",
        0,
        form="surfaces",
        title="Self-touching",
        sentence="A roll: it lies on itself, but passes through no cell twice.",
    ),
    "one-sided": look(
        "layouts/one-sided",
        "sheets",
        3,
        form="surfaces",
        setting=seen_from(-0.4, 0.7, -0.85),
        title="One-sided",
        sentence="A Möbius strip: once around, top has become bottom.",
    ),
    "crossing": look(
        "shapes/thick-shell",
        "sheets",
        6,
        13,
        title="Two that cross",
        sentence="Teal, amber, and dark the two columns of cells where they cross.",
    ),
}

CHORDS = {
    "chord": look(
        "shapes/torus",
        "chords",
        2,
        39,
        200,
        300,
        title="Chords",
        sentence="Two close after 36 cells; two go from boundary to boundary.",
    ),
}

BLOCKS = {
    "walls": look(
        "structures/o-grid",
        "blocks",
        form="surfaces",
        curves=True,
        setting=seen_from(-0.35, 0.6, -0.7),
        title="Walls",
        sentence="Four irregular edges run along the bar, and from each start three walls.",
    ),
    "five": look(
        "structures/o-grid",
        "blocks",
        setting=seen_from(-0.35, 0.6, -0.7),
        title="Blocks",
        sentence="The five grids that these walls enclose.",
    ),
    "apart": look(
        "shapes/sphere",
        "blocks",
        explode=0.6,
        title="Blocks, drawn apart",
        sentence="Seven boxes: a core of 6 × 6 × 6 cells, and six of 4 × 6 × 6.",
    ),
    "whole": look(
        "shapes/bracket",
        "blocks",
        title="All irregular edges",
        sentence="14 boxes: walls start at every irregular edge, also those of the boundary.",
    ),
    "interior": look(
        "shapes/bracket",
        "blocks",
        complex="interior",
        title="Those inside alone",
        sentence="6 blocks: two edges of valence 6 between holes leave these.",
    ),
    "ring": look(
        "layouts/hoops",
        "blocks",
        explode=0.5,
        title="Rings",
        sentence="Five blocks that close on themselves, four of them around the fifth.",
    ),
    "twisted": look(
        "structures/moebius",
        "blocks",
        title="A twisted ring",
        sentence="One block that closes on itself after half a turn.",
    ),
    "base-sheet": look(
        "shapes/sphere",
        "sheets",
        *SIDE_BY_SIDE,
        title="A base sheet",
        sentence="Six sheets that pass the same blocks side by side, a colour each.",
    ),
    "base-chord": look(
        "shapes/sphere",
        "chords",
        *BUNDLE,
        title="A base chord",
        sentence="Nine of the 36 chords that pass the same three blocks.",
    ),
    "winding": look(
        "layouts/winding-walls",
        "blocks",
        explode=0.6,
        title="57 blocks",
        sentence="Rows that come round one row further on: a wall from the notch passes all of them.",
    ),
    "straight": look(
        "layouts/straight-walls",
        "blocks",
        explode=0.6,
        title="7 blocks",
        sentence="Rows that close: a wall from the notch ends where it began.",
    ),
}

CLASSES = {
    "regular": look(
        "shapes/twisted-bar",
        "blocks",
        title="Regular",
        sentence="One grid, however it is bent.",
    ),
    "polycube": look(
        "structures/tunnels",
        "blocks",
        explode=0.4,
        title="Polycube",
        sentence="20 blocks, and no irregular edge inside.",
    ),
}

FOCUS = {
    "matrix": Recipe(
        "shapes/sphere",
        {"structure": {"kind": "sheets", "chosen": [4, 9]}, "colour": {"by": "chosen"}},
        title="The matrix",
        sentence="Of the sphere's 22 sheets; the pair that is chosen crosses in 14 cells.",
        part=".pair-matrix",
        offset=0,
    ),
    "context": look(
        "shapes/gear",
        "blocks",
        20,
        33,
        23,
        setting={"see_through": {"opacity": 0.08}},
        title="Context",
        sentence="Three blocks; the rest is hardly there.",
    ),
    "filtered": Recipe(
        "shapes/sphere",
        {
            "filters": {"structure": {"keep": "outside", "blocks": [1, 2, 6]}},
            "colour": {"by": "quality", "range": [0.5, 1]},
        },
        ROUND | WIRELESS,
        title="Without three blocks",
        sentence="Hidden by structure; the rest by its Scaled Jacobian.",
        offset=0,
    ),
    "distance": Recipe(
        "shapes/sphere",
        DISTANCE,
        ROUND | cut(0.0, 1.0, 0.0) | seen_from(-0.35, 0.85, -0.4),
        title="Distance",
        sentence="Faces to cross from each cell to the nearest one at an irregular edge inside.",
    ),
}

OCTREE = {
    "octree-blocks": look(
        "structures/octree",
        "blocks",
        title="524 blocks",
        sentence="Of 1,208 cells: the base complex is nearly as fine as the mesh.",
    ),
    "octree-sheets": look(
        "structures/octree",
        "sheets",
        3,
        17,
        title="2 of 26 sheets",
        sentence="They show how templates lead two layers of cells from coarse to fine.",
    ),
}

FAST: Status = {"lighting": {"mode": "screen_space_ao"}}
"""So many pictures are taken with the light that is there at once."""

ALL = IRREGULAR | GRAPH | SHEETS | CHORDS | BLOCKS | CLASSES | FOCUS | OCTREE

LESSONS = {"window": WINDOW} | {
    name: replace(recipe, setting=merge(FAST, recipe.setting)) for name, recipe in ALL.items()
}
"""All of them."""
