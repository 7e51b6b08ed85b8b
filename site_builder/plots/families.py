"""How families of methods are told apart in a plot: by the shape of their points, and by a colour."""

from __future__ import annotations

from dataclasses import dataclass

from ..tables.families import family_names

SHAPES = (
    "M-3.4 0a3.4 3.4 0 1 0 6.8 0a3.4 3.4 0 1 0-6.8 0Z",
    "M0-4.2L3.9 2.9H-3.9Z",
    "M-3-3H3V3H-3Z",
    "M0 4.2L3.9-2.9H-3.9Z",
    "M0-4.5L4.2 0L0 4.5L-4.2 0Z",
    "M-1.3-4H1.3V-1.3H4V1.3H1.3V4H-1.3V1.3H-4V-1.3H-1.3Z",
    "M-3.7-3.2H3.7L-3.7 3.2H3.7Z",
    "M-1.9-3.7L0-1.9L1.9-3.7L3.7-1.9L1.9 0L3.7 1.9L1.9 3.7L0 1.9L-1.9 3.7L-3.7 1.9L-1.9 0L-3.7-1.9Z",
    "M0-4.6L1.2-1.4L4.4-1.4L1.9 .6L2.8 3.8L0 2L-2.8 3.8L-1.9 .6L-4.4-1.4L-1.2-1.4Z",
)
"""Outlines around the origin: disc, triangle, square, triangle, diamond, plus, hourglass, cross, star."""

COLOURS = 8
"""Of the style sheet (plots.css): as many as the colour-blind can tell apart. It shares no divisor with the shapes."""

UNTOLD = "M-2.4 0a2.4 2.4 0 1 0 4.8 0a2.4 2.4 0 1 0-4.8 0Z"
"""Of meshes whose method nobody has told."""


@dataclass(frozen=True)
class Look:
    """How a family looks.

    Parameters
    ----------
    number : int
        Its place among the families.
    outline : str
        Of its points, as a path of SVG.
    tone : str
        The class that gives them their colour.
    """

    number: int
    outline: str
    tone: str


def look_of(family: str) -> Look:
    """How a family of methods looks in every plot."""
    number = list(family_names()).index(family)
    if not family:
        return Look(number, UNTOLD, "tone-none")
    return Look(number, SHAPES[number % len(SHAPES)], f"tone-{number % COLOURS}")
