"""Filters: which cells are hidden (SPEC F1 to F5). One module for each, and the stack that combines them.

A filter is a function from arrays and settings to (C,) bool, True where it hides a cell. Order: planes and
peel, the regularisation of the two; quality, parts, groups, structure; hand-picking.
"""

from .peel import peel
from .picking import PickedCells, pick
from .plane import plane
from .quality import band
from .regularisation import Regulariser
from .stack import FilterStack

__all__ = [
    "FilterStack",
    "PickedCells",
    "Regulariser",
    "band",
    "peel",
    "pick",
    "plane",
]
