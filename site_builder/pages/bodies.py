"""The meshes of each body that several sources mesh: which there are, and which of them fill it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..model.catalogue import Catalogue, MeshEntry, Source
from ..model.models import Model


@dataclass(frozen=True, eq=False)
class Body:
    """A model with its meshes.

    Parameters
    ----------
    model : Model
    meshes : tuple of MeshEntry
        Those that are measured first, the newest at the top; those that are another one in another format are left out.
    left_out : int
        How many were.
    """

    model: Model
    meshes: tuple[MeshEntry, ...]
    left_out: int

    @cached_property
    def filling(self) -> list[MeshEntry]:
        """Meshes of the body itself: these can be compared."""
        return [mesh for mesh in self.meshes if not mesh.domain]

    @cached_property
    def others(self) -> list[MeshEntry]:
        """Meshes of what is around it or stands for it."""
        return [mesh for mesh in self.meshes if mesh.domain]

    @cached_property
    def sources(self) -> list[Source]:
        """The sources of its meshes, the newest first."""
        return list(dict.fromkeys(mesh.source for mesh in self.meshes))

    @cached_property
    def measured(self) -> list[MeshEntry]:
        """Meshes of the body itself whose Scaled Jacobian is known, the best first."""
        known = [mesh for mesh in self.filling if mesh.facts.sj_min is not None]
        return sorted(known, key=lambda mesh: -(mesh.facts.sj_min or 0.0))

    def rival(self, mesh: MeshEntry) -> MeshEntry | None:
        """The mesh beside which another one is best seen: that of the highest minimum, or the next to it."""
        others = [one for one in self.measured if one is not mesh]
        return others[0] if others else None

    def portrait(self, pictures: set[str]) -> MeshEntry | None:
        """The mesh whose picture stands for the body: the best that has one."""
        ranked = [*self.measured, *self.filling, *self.others]
        return next((mesh for mesh in ranked if mesh.picture_address in pictures), None)


def bodies(catalogue: Catalogue) -> dict[str, Body]:
    """Every model of the catalogue that has meshes, by its id: those of most sources first."""
    found: dict[str, list[MeshEntry]] = {model.id: [] for model in catalogue.models}
    for mesh in catalogue.meshes:
        if mesh.model:
            found[mesh.model].append(mesh)
    made = [_body(model, found[model.id]) for model in catalogue.models if found[model.id]]
    made.sort(key=_rank)
    return {body.model.id: body for body in made}


def _rank(body: Body) -> tuple[int, bool, int, str]:
    """By number of sources; of as many, those that can be seen and compared first."""
    return -len(body.sources), not body.measured, -len(body.meshes), body.model.title.lower()


def _place(mesh: MeshEntry) -> tuple[bool, int]:
    return mesh.facts.sj_min is None, -mesh.source.year


def _body(model: Model, meshes: list[MeshEntry]) -> Body:
    shown = sorted((mesh for mesh in meshes if not mesh.same_as), key=_place)
    return Body(model, tuple(shown), len(meshes) - len(shown))
