"""The settings document's JSON Schema (draft 2020-12): the only place of its names, limits and defaults.

Every property is optional, so that a part of a document is valid too. Lengths of the camera are in diagonals
of the mesh's frame and its target is relative to the frame's centre: a status moves between meshes.
"""

from __future__ import annotations

from typing import Any

from .compare_schema import COMPARE
from .figure_schema import FIGURE
from .structure_schema import STRUCTURE, STRUCTURE_FILTER
from .words_of_schema import (
    CELL_IDS,
    COLOUR,
    DIRECTION,
    GROUP_IDS,
    IDENTITY,
    NUMBERS,
    ON,
    OPEN_END,
    UNIT,
    VECTOR,
    Schema,
    choice,
    core,
    section,
)

VERSION = 2
"""Version 1 called the quantity of a band its `source`."""

MESH = section("The mesh that the view was made of; tells, and is not applied.", **IDENTITY)

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
        hidden=NUMBERS,
        shown=NUMBERS,
    ),
    groups=section(
        "The file's groups of cells, by id: ORIGIN:NAME.",
        enabled=ON,
        isolated={"type": "boolean", "default": False, "description": "Hide all but the shown"},
        hidden=GROUP_IDS,
        shown=GROUP_IDS,
    ),
    structure=STRUCTURE_FILTER,
    picking=section(
        "Cells hidden and shown by hand.",
        enabled=ON,
        isolated={"type": "boolean", "default": False, "description": "Hide all but the shown"},
        hidden=CELL_IDS,
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
    by=core(choice("sides", "quality", "attribute", "kind", "part", "group", "block", "chosen")),
    outside={**COLOUR, "default": "#ffffff", "description": "Faces of the boundary"},
    inside={**COLOUR, "default": "#ffff00", "description": "Faces that filters expose"},
    metric=core({"type": "string", "minLength": 1, "default": "scaled_jacobian"}),
    attribute=core(
        {
            "type": "string",
            "default": "",
            "description": "cell:NAME, point:NAME, structure:NAME, compare:NAME or change:METRIC",
        }
    ),
    grouping=core(
        {
            "type": "string",
            "maxLength": 500,
            "default": "",
            "description": "Origin of the groups; empty: the first",
        }
    ),
    map=choice("parula", "viridis", "jet", "red_blue", "diverging"),
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
    reach=core(
        {
            "type": ["array", "null"],
            "items": {"type": "number"},
            "minItems": 2,
            "maxItems": 2,
            "default": None,
            "description": "Smallest and largest value that the colours are made for; null: the mesh's own, or those "
            "of two that are compared",
        }
    ),
)

LENGTH_UNITS = ("none", "nm", "um", "mm", "cm", "m", "km", "in", "ft")
"""Units that a file's coordinates may be in; none: it was not named."""

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
                    "groups",
                    "structure",
                    "picking",
                    description="Which: all that are hidden, or those that some filters hide (cut: slice and peel)",
                )
            ),
            opacity={**UNIT, "default": 0.2},
        ),
        marks=core(
            section(
                "What is drawn over the mesh: the file's elements of lower dimension, sharp edges, sets of nodes, "
                "faces between groups.",
                corners=ON,
                edges=ON,
                faces={**ON, "default": False},
                hidden={**GROUP_IDS, "description": "Groups of these that are not drawn: edges:ORIGIN:NAME"},
                sharp_angle={
                    "type": "number",
                    "minimum": 0,
                    "maximum": 180,
                    "default": 180,
                    "description": "Edges of the boundary whose faces differ by more, in degrees; 180: none",
                },
                nodes={**GROUP_IDS, "description": "Sets of nodes that are drawn: nset:NAME"},
                interfaces={
                    "type": "string",
                    "maxLength": 500,
                    "default": "",
                    "description": "Origin of the groups whose common faces are drawn; empty: none",
                },
            )
        ),
        arrows=section(
            "Vectors of the file as arrows on the surface of the shown cells, a thousand at most.",
            attribute=core(
                {
                    "type": "string",
                    "default": "",
                    "description": "cell:NAME or point:NAME, of three components; empty: none",
                }
            ),
            length={
                "type": "number",
                "minimum": 0.001,
                "maximum": 0.5,
                "default": 0.05,
                "description": "Of the attribute's longest vector, in diagonals of the mesh's frame",
            },
            colour={**COLOUR, "default": "#1d1f23"},
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
        structure=STRUCTURE,
        compare=COMPARE,
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
