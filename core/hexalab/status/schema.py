"""The settings document's JSON Schema (draft 2020-12): the only place of its names, limits and defaults.

Every property is optional, so that a part of a document is valid too. Lengths of the camera are in diagonals
of the mesh's frame and its target is relative to the frame's centre: a status moves between meshes.
"""

from __future__ import annotations

from typing import Any

Schema = dict[str, Any]

VERSION = 2
"""Version 1 called the quantity of a band its `source`."""

UNIT = {"type": "number", "minimum": 0, "maximum": 1}
COLOUR = {"type": "string", "pattern": "^#[0-9a-fA-F]{6}$", "maxLength": 7}
VECTOR = {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
DIRECTION = {**VECTOR, "contains": {"not": {"const": 0}}}
OPEN_END = {"type": ["number", "null"], "default": None}
CELL_IDS = {"type": "array", "items": {"type": "integer", "minimum": 0}, "default": []}
ON = {"type": "boolean", "default": True}


def section(description: str, /, *required: str, **properties: Schema) -> Schema:
    """Build the schema of an object whose properties are these and no others."""
    schema: Schema = {
        "type": "object",
        "description": description,
        "properties": properties,
        "additionalProperties": False,
    }
    return {**schema, "required": list(required)} if required else schema


def core(schema: Schema) -> Schema:
    """Mark a setting that the core acts on; all others concern the viewer alone."""
    return {**schema, "core": True}


def choice(default: str, *others: str, description: str = "") -> Schema:
    """Build the schema of one word out of several; the first is the default."""
    return {"enum": [default, *others], "default": default, "description": description}


MESH = section(
    "The mesh that the view was made of; tells, and is not applied.",
    name={"type": "string", "default": ""},
    sha256={"type": "string", "pattern": "^([0-9a-f]{64})?$", "maxLength": 64, "default": ""},
    cells={"type": "integer", "minimum": 0, "default": 0},
)

CAMERA = section(
    "Where the eye is. Lengths in diagonals of the mesh's frame: its extent, or that of its largest part if it has "
    "strayed from the others.",
    fit={
        **ON,
        "description": "Target and distance follow from the frame and the picture's shape, so that all of it is seen; "
        "off where a document gives one of them",
    },
    target={**VECTOR, "default": [0, 0, 0], "description": "Relative to the frame's centre"},
    direction={**DIRECTION, "default": [0, 0, -1], "description": "From the eye to the target"},
    up={**DIRECTION, "default": [0, 1, 0]},
    distance={"type": "number", "exclusiveMinimum": 0, "maximum": 1_000_000, "default": 1.5},
    projection=choice("perspective", "orthographic"),
    field_of_view={
        "type": "number",
        "minimum": 1,
        "maximum": 120,
        "default": 30,
        "description": "Vertical, in degrees",
    },
)

PLANE = section(
    "Hides the cells behind it.",
    "normal",
    enabled=ON,
    normal={**DIRECTION, "default": [1, 0, 0]},
    offset={**UNIT, "default": 0, "description": "0 hides nothing, 1 everything"},
)

QUALITY_BAND = section(
    "Hides the cells whose value is not kept. A missing end of the band is open.",
    "quantity",
    quantity={
        "type": "string",
        "minLength": 1,
        "default": "scaled_jacobian",
        "description": "A metric's id, cell:NAME or point:NAME",
    },
    keep=choice("inside", "outside"),
    minimum=OPEN_END,
    maximum=OPEN_END,
)

FILTERS = section(
    "Which cells are hidden.",
    planes=section(
        "Slices.",
        enabled=ON,
        rule=choice("barycentre", "any_corner", description="What of a cell must lie behind the plane"),
        items={
            "type": "array",
            "items": PLANE,
            "maxItems": 32,
            "default": [{"enabled": True, "normal": [1, 0, 0], "offset": 0}],
        },
    ),
    peel=section(
        "Hides cells nearer to the boundary than a number of hops over faces.",
        enabled=ON,
        depth={"type": "integer", "minimum": 0, "default": 0},
    ),
    regularisation=section(
        "Smooths the set that plane and peel hide.",
        enabled=ON,
        strength={"type": "integer", "minimum": 0, "maximum": 5, "default": 0},
    ),
    quality=section(
        "Hides by value.",
        enabled=ON,
        items={"type": "array", "items": QUALITY_BAND, "maxItems": 32, "default": []},
    ),
    parts=section(
        "Parts that share no face, by number: 0 is the one of most cells.",
        enabled=ON,
        isolated={"type": "boolean", "default": False, "description": "Hide all but the shown"},
        hidden=CELL_IDS,
        shown=CELL_IDS,
    ),
    picking=section(
        "Cells hidden and shown by hand.",
        enabled=ON,
        isolated={"type": "boolean", "default": False, "description": "Hide all but the shown"},
        hidden={**CELL_IDS, "description": "Cells by number, from 0 in the file's order"},
        shown=CELL_IDS,
    ),
)

SEPARATION = section(
    "How the cells are told apart.",
    mode=core(choice("lines", "darkness_coded_edges", "fissure", "rounded")),
    line_opacity={**UNIT, "default": 0.45},
    gap=core({"type": "number", "minimum": 0.01, "maximum": 0.5, "default": 0.15}),
    radius=core({"type": "number", "minimum": 0.01, "maximum": 0.5, "default": 0.075}),
    line_width={"type": "number", "minimum": 0.25, "maximum": 8, "default": 1, "description": "In pixels"},
)

COLOUR_BY = section(
    "What the faces are coloured by.",
    by=core(choice("sides", "quality", "attribute", "kind", "part")),
    outside={**COLOUR, "default": "#ffffff", "description": "Faces of the boundary"},
    inside={**COLOUR, "default": "#ffff00", "description": "Faces that filters expose"},
    metric=core({"type": "string", "minLength": 1, "default": "scaled_jacobian"}),
    attribute=core({"type": "string", "default": "", "description": "cell:NAME or point:NAME"}),
    map=choice("parula", "viridis", "jet", "red_blue"),
    reversed={"type": "boolean", "default": False, "description": "Whether the map runs the other way"},
    steps={
        "type": "integer",
        "minimum": 0,
        "maximum": 32,
        "default": 0,
        "description": "Colours of a map in steps; 0 and 1: it runs smoothly",
    },
    missing={**COLOUR, "default": "#8c8c8c", "description": "Cells without a finite value"},
    beyond={
        "type": "boolean",
        "default": False,
        "description": "Whether values above and below a range that was set have colours of their own",
    },
    above={**COLOUR, "default": "#d6409f"},
    below={**COLOUR, "default": "#3c3c3c"},
    range=core(
        {
            "type": ["array", "null"],
            "items": {"type": "number"},
            "minItems": 2,
            "maxItems": 2,
            "default": None,
            "description": "Values at the ends of the map; null: the mesh's own",
        }
    ),
)

OFF = {"type": "boolean", "default": False}
SIDE = {"type": ["number", "null"], "minimum": 1, "maximum": 8192, "default": None}
LENGTH_UNITS = ("none", "nm", "um", "mm", "cm", "m", "km", "in", "ft")
"""Units that a file's coordinates may be in; none: it was not named."""

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

SCHEMA: Schema = {
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    "title": "HexaLab status",
    **section(
        "All settings of a view. A part of a document applies what it holds.",
        version={"const": VERSION, "default": VERSION},
        mesh=MESH,
        unit=choice(
            *LENGTH_UNITS,
            description="Of the file's coordinates: told beside numbers, which stay the file's own; none: not named",
        ),
        camera=CAMERA,
        filters=core(FILTERS),
        separation=SEPARATION,
        colour=COLOUR_BY,
        silhouette=core(
            {**UNIT, "default": 1, "description": "Of what is hidden: 0 none, 0.5 flat, 1 shaded"}
        ),
        see_through=section(
            "Hidden cells drawn before what is shown, so that it is seen through them.",
            cells=core(
                choice(
                    "none",
                    "all",
                    "cut",
                    "quality",
                    "parts",
                    "picking",
                    description="Which: all that are hidden, or those that some filters hide (cut: slice and peel)",
                )
            ),
            opacity={**UNIT, "default": 0.2},
        ),
        irregular=section(
            "Edges of irregular valence.",
            mode=core(
                {
                    "type": "integer",
                    "minimum": 0,
                    "maximum": 6,
                    "default": 1,
                    "description": "0 off, 1 wires, 3 barbed wires, 5 paper; 2, 4, 6 seen through the mesh too",
                }
            ),
            boundary={"type": "boolean", "default": False, "description": "Edges of the boundary too"},
            palette=choice(
                "standard", "colour_blind", description="Of valences; the second differs in width too"
            ),
        ),
        lighting=section(
            "Light.",
            mode=choice("object_space_ao", "screen_space_ao", "direct", "none"),
            shade={
                **UNIT,
                "default": 1,
                "description": "Strength of what it darkens: 1 all, 0 nothing, as where colours are to be read off",
            },
        ),
        background={**COLOUR, "default": "#ffffff"},
        histogram=section(
            "How the histogram is laid out.",
            orientation=choice("horizontal", "vertical"),
            scale=choice("linear", "log"),
            bins={"type": "integer", "minimum": 1, "maximum": 1000, "default": 100},
            title={
                "type": "string",
                "maxLength": 200,
                "default": "",
                "description": "Of the saved one; empty: its metric and its mesh",
            },
            width={
                "type": "number",
                "minimum": 20,
                "maximum": 600,
                "default": 85,
                "description": "In mm, saved",
            },
            height={
                "type": "number",
                "minimum": 20,
                "maximum": 600,
                "default": 60,
                "description": "In mm, saved",
            },
            letters={
                "type": "number",
                "minimum": 4,
                "maximum": 72,
                "default": 8,
                "description": "In points, saved",
            },
            font=choice("sans", "serif", description="Of the saved one"),
        ),
        figure=FIGURE,
    ),
}
"""JSON Schema of the settings document."""


def copied(value: Any) -> Any:
    """Copy a JSON value; quicker than `copy.deepcopy`, for lists of many cells."""
    if isinstance(value, dict):
        return {name: copied(part) for name, part in value.items()}
    if isinstance(value, list):
        return [copied(part) if isinstance(part, dict | list) else part for part in value]
    return value


def default_of(schema: Schema) -> Any:
    """Return the default that a schema names, or for an object the one that its properties name."""
    if "default" in schema:
        return copied(schema["default"])
    return {name: default_of(part) for name, part in schema["properties"].items()}


DEFAULTS: dict[str, Any] = default_of(SCHEMA)
"""The complete document that a fresh viewer starts from."""


def core_paths(schema: Schema, path: tuple[str, ...] = ()) -> list[str]:
    """Return the dotted paths of the settings that the core acts on, as the schema marks them."""
    if schema.get("core"):
        return [".".join(path)]
    parts = schema.get("properties", {})
    return [found for name, part in parts.items() for found in core_paths(part, (*path, name))]


CORE_PATHS = tuple(core_paths(SCHEMA))
"""What of a status goes to the core: the viewer reads it here too."""


def core_part(status: dict[str, Any]) -> dict[str, Any]:
    """Return the part of a whole status that the core acts on; not copied."""
    part: dict[str, Any] = {}
    for path in CORE_PATHS:
        *sections, name = path.split(".")
        here, there = part, status
        for section_name in sections:
            here, there = here.setdefault(section_name, {}), there[section_name]
        here[name] = there[name]
    return part
