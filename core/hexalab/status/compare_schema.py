"""The part of the settings document's schema about two meshes, or a mesh and a reference surface."""

from __future__ import annotations

from .words_of_schema import CELL_IDS, COLOUR, IDENTITY, ON, UNIT, choice, core, section

COMPARE = section(
    "Two meshes, or a mesh and a reference surface, beside each other. All other settings are those of both.",
    other=section("The second mesh that the view was made of; tells, and is not applied.", **IDENTITY),
    layout=choice(
        "beside", "curtain", description="Side by side, or one upon the other, parted by a curtain"
    ),
    divider={**UNIT, "default": 0.5, "description": "Where the two pictures meet"},
    camera=choice(
        "auto",
        "own",
        "same",
        description="Relative to each mesh's own frame, or at the same place for both; auto: at the same place "
        "where the frames are nearly the same",
    ),
    colours=choice("common", "own", description="Whether the map's range is that of both meshes together"),
    picking=section(
        "Cells of the second mesh hidden and shown by hand, where its cells are not those of the first.",
        isolated={"type": "boolean", "default": False, "description": "Hide all but the shown"},
        hidden=CELL_IDS,
        shown=CELL_IDS,
    ),
    reference=section(
        "The surface of what it is compared with, drawn over each mesh.",
        shown=core({"type": "boolean", "default": False}),
        opacity={**UNIT, "default": 0.3},
        colour={**COLOUR, "default": "#0e9aa7"},
    ),
    labels={**ON, "description": "Whether pictures tell the meshes' names"},
)
