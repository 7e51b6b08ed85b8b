"""The viewer in a notebook: a widget before the kernel's own core (SPEC A6)."""

from .meshes import offer_of
from .widget import View

__all__ = ["View", "offer_of"]
