"""The guide's pictures: one for each tool, by the name that the guide's text calls it."""

from __future__ import annotations

from .gallery import LATTICE, NOISY, PADDED
from .recipe import Recipe
from .shot import Status

ROUNDED: Status = {"separation": {"mode": "rounded", "radius": 0.09}}
BY_QUALITY: Status = {"colour": {"by": "quality"}}
WHOLE: Status = {"irregular": {"mode": 0}}

FIGURES = {
    "window": Recipe("shapes/bent-pipe", setting=ROUNDED | BY_QUALITY, part="body"),
    "slice": Recipe("shapes/nozzle", setting=ROUNDED),
    "peel": Recipe("shapes/sphere", {"filters": {"peel": {"depth": 2}}}, ROUNDED, offset=0),
    "quality": Recipe(
        NOISY,
        {
            "filters": {
                "quality": {"items": [{"source": "scaled_jacobian", "keep": "inside", "maximum": 0.75}]}
            }
        },
        ROUNDED | BY_QUALITY,
        offset=0,
    ),
    "picking": Recipe(
        "structures/valence-5", {"filters": {"picking": {"hidden": [999, 989, 998, 899]}}}, ROUNDED, offset=0
    ),
    "regularise": Recipe(
        "shapes/sphere", {"filters": {"regularisation": {"strength": 2}}}, ROUNDED, offset=0.5
    ),
    "separation": Recipe("structures/octree", setting=ROUNDED | WHOLE),
    "colour": Recipe(NOISY, {"colour": {"by": "quality", "map": "viridis"}}, ROUNDED),
    "silhouette": Recipe("shapes/gear", {"silhouette": 1}, ROUNDED),
    "irregular": Recipe(PADDED, {"irregular": {"mode": 6}}, offset=0.55),
    "lighting": Recipe(LATTICE, setting={"separation": {"mode": "fissure", "gap": 0.15}}),
    "histogram": Recipe(NOISY, setting=BY_QUALITY, part="#section-quality"),
    "diagnosis": Recipe("faults/negative-volume", part="#section-mesh", offset=0),
    "sharing": Recipe("shapes/bracket", setting=ROUNDED, offset=0.35),
}
