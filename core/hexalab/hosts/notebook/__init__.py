"""The viewer in a notebook: a widget before the kernel's own core (SPEC A6)."""

from .widget import View, show

__all__ = ["View", "show"]
