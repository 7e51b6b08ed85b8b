"""The part of the settings document's schema about a figure for print."""

from __future__ import annotations

from .words_of_schema import ON, choice, section

OFF = {"type": "boolean", "default": False}
SIDE = {"type": ["number", "null"], "minimum": 1, "maximum": 8192, "default": None}
CORNER = ("bottom_left", "bottom_right", "top_left", "top_right")

FIGURE = section(
    "A figure for print: the picture, and what stands around it.",
    unit=choice("px", "mm", description="Of width and height"),
    width={**SIDE, "description": "null: as wide as the picture on the screen, in pixels"},
    height={**SIDE, "description": "null: as high as the picture on the screen, in pixels"},
    resolution={
        "type": "integer",
        "minimum": 36,
        "maximum": 2400,
        "default": 300,
        "description": "Dots per inch, of sizes in mm",
    },
    letters={"type": "number", "minimum": 4, "maximum": 72, "default": 8, "description": "Size in points"},
    margin={"type": "number", "minimum": 0, "maximum": 200, "default": 0, "description": "In points"},
    transparent={**OFF, "description": "Whether the background is"},
    crop={**OFF, "description": "Whether what is empty around the mesh is cut off"},
    legend=choice("none", "bar", "histogram", description="What the colours mean"),
    legend_place=choice("right", "left"),
    legend_title={"type": "string", "default": "", "description": "Empty: what is coloured by"},
    scale_bar={**OFF, "description": "A length in the file's unit; in perspective, at the target's distance"},
    scale_bar_place=choice(*CORNER),
    axes={**OFF, "description": "The directions of x, y and z"},
    axes_place=choice("bottom_right", "bottom_left", "top_left", "top_right"),
    caption={**OFF, "description": "A line below the picture"},
    caption_text={
        "type": "string",
        "maxLength": 1000,
        "default": "",
        "description": "Empty: the mesh's name and, if it is the catalogue's, its reference",
    },
    meshes=choice(
        "together", "apart", description="Two that are compared: in one picture, or each in its own file"
    ),
    panels=section(
        "Several pictures in a row, under settings that differ by one value.",
        setting=choice(
            "none",
            "peel",
            "regularisation",
            "irregular",
            "separation",
            "lighting",
            "slice",
            "silhouette",
            "line_opacity",
            description="What differs",
        ),
        values={
            "type": "array",
            "items": {"type": "number"},
            "maxItems": 6,
            "default": [],
            "description": "The setting's values; of words, their places in the list from 0",
        },
        labels={**ON, "description": "Whether they are called a), b), c), ..."},
    ),
)
