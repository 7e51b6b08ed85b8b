"""A picture described before the mesh is at hand: which mesh, how it is cut, what else of the status is set."""

from __future__ import annotations

from dataclasses import dataclass, field

from hexalab.status import merge
from hexalab.status.views import View

from .shot import HEIGHT, WIDTH, Status


@dataclass(frozen=True)
class Recipe:
    """How one picture of gallery or guide is made.

    Parameters
    ----------
    mesh : str
        ``source/mesh`` of the catalogue.
    settings : dict
        What the picture is about: this part of the status is what its text names.
    setting : dict
        What else is set, so that it can be seen.
    title, sentence : str
    offset : float
        How far the plane of the three-quarter view has gone in: 0 hides nothing.
    part, press : str
        As in `Shot`.
    beside : str
        ``source/mesh`` of the one that it is compared with; "" for none.
    size : (int, int)
        Width and height in pixels.
    """

    mesh: str
    settings: Status = field(default_factory=dict)
    setting: Status = field(default_factory=dict)
    title: str = ""
    sentence: str = ""
    offset: float = 0.5
    part: str = ""
    press: str = ""
    beside: str = ""
    size: tuple[int, int] = (WIDTH, HEIGHT)

    def status(self, view: View) -> Status:
        """The whole partial status, for the mesh's three-quarter view."""
        base: Status = {"camera": view.camera, "filters": view.slice(self.offset)}
        return merge(merge(base, self.setting), self.settings)
