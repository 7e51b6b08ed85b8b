"""The guide's pictures: one for each tool, by the name that the guide's text calls it."""

from __future__ import annotations

from .gallery import LATTICE, NOISY, PADDED, WIDE_RANGE
from .recipe import Recipe
from .shot import Status
from .structures import GALLERY

ROUNDED: Status = {"separation": {"mode": "rounded", "radius": 0.09}}
BY_QUALITY: Status = {"colour": {"by": "quality"}}
WHOLE: Status = {"irregular": {"mode": 0}}

CORNER = [
    199, 262, 263, 271, 325, 326, 327, 334, 335, 343, 388, 389, 390, 391, 397, 398, 399, 406, 407, 415,
    451, 452, 453, 454, 455, 460, 461, 462, 463, 469, 470, 471, 478, 479, 487,
]  # fmt: skip
"""Cells of shapes/cube around the corner that is nearest to the eye."""

WORST: Status = {"items": [{"quantity": "scaled_jacobian", "keep": "inside", "maximum": 0.8}]}

FIGURES = {
    "window": Recipe(WIDE_RANGE, setting=ROUNDED | WHOLE, part="body"),
    "slice": Recipe("shapes/nozzle", setting=ROUNDED),
    "peel": Recipe("shapes/sphere", {"filters": {"peel": {"depth": 2}}}, ROUNDED, offset=0),
    "quality": Recipe(NOISY, {"filters": {"quality": WORST}}, ROUNDED | BY_QUALITY, offset=0),
    "picking": Recipe("shapes/cube", {"filters": {"picking": {"hidden": CORNER}}}, ROUNDED, offset=0),
    "regularise": Recipe("shapes/cube", {"filters": {"regularisation": {"strength": 2}}}, ROUNDED),
    "separation": Recipe("structures/octree", setting=ROUNDED | WHOLE),
    "colour": Recipe(WIDE_RANGE, {"colour": {"by": "quality", "map": "viridis", "range": [0.5, 1]}}, ROUNDED),
    "silhouette": Recipe("shapes/gear", {"silhouette": 1}, ROUNDED),
    "see-through": Recipe("shapes/nozzle", {"see_through": {"cells": "cut", "opacity": 0.2}}, ROUNDED),
    "irregular": Recipe(PADDED, {"irregular": {"mode": 6}}, offset=0.55),
    "structure": GALLERY["crossing"],
    "lighting": Recipe(LATTICE, setting={"separation": {"mode": "fissure", "gap": 0.15}}),
    "histogram": Recipe(NOISY, setting=BY_QUALITY, part="#section-quality"),
    "diagnosis": Recipe("faults/negative-volume", part="#section-mesh", offset=0),
    "inspector": Recipe("structures/valence-8", setting=BY_QUALITY, part=".inspector", press="#canvas"),
    "compare": Recipe(
        "layouts/winding-walls",
        {"compare": {"layout": "beside"}, "colour": {"by": "quality", "metric": "volume"}},
        ROUNDED,
        part="#view",
        beside="layouts/straight-walls",
    ),
    "sharing": Recipe("shapes/bracket", setting=ROUNDED, offset=0.35),
}
"""What the guide shows, by the anchor of its section."""
