"""What the pages of models are filled with."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..model.domains import DOMAINS
from .bodies import Body
from .model_table import CHOICES, COLUMNS, latex, method_name, ranked, rows
from .words import plural

GROUPS = (
    (6, "Six sources and more"),
    (3, "Three to five"),
    (2, "Two"),
    (1, "One source, three meshes and more"),
)
"""Parts of the list of models: from how many sources on, and its heading."""

STRIP = 12
"""Pictures above a model's table."""


def model_values(body: Body, pictures: set[str]) -> dict[str, Any]:
    """Values of a model's template."""
    pictured = [mesh for mesh in [*body.filling, *body.others] if mesh.picture_address in pictures]
    return {
        "heading": f"{body.model.title}, meshed {len(body.meshes)} times",
        "description": f"{body.model.title}: {summary(body)}",
        "body": body,
        "model": body.model,
        "summary": summary(body),
        "left_out": left_out(body),
        "pictured": pictured[:STRIP],
        "filling": rows(body.filling),
        "others": rows(body.others, compared=False),
        "columns": COLUMNS,
        "choices": CHOICES,
        "domains": DOMAINS,
        "method": method_name,
        "ranked": ranked,
        "latex": latex(body),
    }


def summary(body: Body) -> str:
    """How many meshes there are, of how many sources, of which years."""
    years = sorted(source.year for source in body.sources)
    span = f"of {years[0]}" if years[0] == years[-1] else f"of the years {years[0]} to {years[-1]}"
    return f"{plural(len(body.meshes), 'mesh', 'meshes')} of {plural(len(body.sources), 'source')} {span}."


def left_out(body: Body) -> str:
    """What is said of meshes that are there in another format, too."""
    one = body.left_out == 1
    files = f"{plural(body.left_out, 'file')} more {'holds a mesh' if one else 'hold meshes'} of this list"
    return f"{files} in another format; {'its page is' if one else 'their pages are'} linked from the mesh's own."


def models_values(found: Sequence[Body]) -> dict[str, Any]:
    """Values of the list's template; models of most sources come first."""
    groups: list[tuple[str, list[Body]]] = [(label, []) for _, label in GROUPS]
    for body in found:
        place = next(number for number, (least, _) in enumerate(GROUPS) if len(body.sources) >= least)
        groups[place][1].append(body)
    meshes = sum(len(body.meshes) for body in found)
    return {
        "heading": "Models",
        "description": (
            f"{plural(len(found), 'body', 'bodies')} that several papers mesh, or one paper in several ways, "
            f"with {meshes:,} meshes: each has a page on which they stand side by side, measured alike."
        ),
        "groups": [group for group in groups if group[1]],
    }
