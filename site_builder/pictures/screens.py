"""Pictures of the whole window, by its form: what stores and desktops show of an application before it is installed."""

from __future__ import annotations

from .gallery import WIDE_RANGE
from .guide import ROUNDED, WHOLE
from .recipe import Recipe

SCREENS = {
    "wide": Recipe(
        WIDE_RANGE,
        setting=ROUNDED | WHOLE,
        title="A mesh, cut open, and its quality",
        part="body",
        size=(1280, 800),
    ),
    "narrow": Recipe(
        WIDE_RANGE, setting=ROUNDED | WHOLE, title="The viewer on a phone", part="body", size=(412, 824)
    ),
}
