"""All pictures that stand in the gallery, the guide's pages and the manifest, and where each lies in the site."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..model.catalogue import Catalogue, MeshEntry
from ..model.stills import Still, StillSection
from .gallery import SECTIONS
from .guide import FIGURES
from .lessons import LESSONS
from .portrait import view_of
from .recipe import Recipe
from .screens import SCREENS
from .shot import Shot, Status


@dataclass(frozen=True)
class Figure:
    """A picture of gallery or guide.

    Parameters
    ----------
    address : str
        Of the picture, below the site's root.
    title, sentence : str
    shot : Shot
    settings : dict
        The part of the status that the picture is about.
    still : Path, optional
        The picture, where it lies in the repository.
    """

    address: str
    title: str
    sentence: str
    shot: Shot
    settings: Status
    still: Path | None = None

    @property
    def wide(self) -> bool:
        """Whether it is a row of pictures, which takes the page's width."""
        return len(self.settings.get("figure", {}).get("panels", {}).get("values", ())) > 1

    @property
    def words(self) -> str:
        """The settings in one line of JSON."""
        return json.dumps(self.settings, ensure_ascii=False) if self.settings else ""


@dataclass(frozen=True)
class Section:
    """Pictures of the gallery that are to be compared; `more`, a page of the site and what is said of it."""

    id: str
    title: str
    text: str
    figures: tuple[Figure, ...]
    more: tuple[str, str] = ("", "")


class Collection:
    """The gallery and the guide of a catalogue, as far as it has the meshes that they show.

    Parameters
    ----------
    catalogue : Catalogue
        Its own meshes are measured already.
    sections : list of StillSection
        Sections of the gallery whose pictures lie in the repository.
    """

    def __init__(self, catalogue: Catalogue, sections: Sequence[StillSection] = ()) -> None:
        here = {mesh.id: mesh for mesh in catalogue.meshes if mesh.local and mesh.sha256}
        self.gallery = [
            Section(section.id, section.title, section.text, tuple(figures.values()), section.more)
            for section in SECTIONS
            if (figures := _figures(section.recipes, f"gallery/{section.id}-", here))
        ]
        self.gallery += [
            Section(one.id, one.title, one.text, tuple(map(_still_figure, one.stills))) for one in sections
        ]
        self.guide = _figures(FIGURES, "guide/", here)
        self.lessons = _figures(LESSONS, "guide/structure/", here)
        self.screens = _figures(SCREENS, "screens/", here)

    @property
    def _everything(self) -> list[Figure]:
        return [
            *(figure for section in self.gallery for figure in section.figures),
            *self.guide.values(),
            *self.lessons.values(),
            *self.screens.values(),
        ]

    @property
    def figures(self) -> dict[str, Shot]:
        """Every picture that has to be taken, by its address."""
        return {figure.address: figure.shot for figure in self._everything if not figure.still}

    @property
    def stills(self) -> dict[str, Path]:
        """Every picture that lies in the repository, by its address."""
        return {figure.address: figure.still for figure in self._everything if figure.still}


def _figures(recipes: Mapping[str, Recipe], prefix: str, here: Mapping[str, MeshEntry]) -> dict[str, Figure]:
    return {
        name: Figure(
            f"{prefix}{name}.png",
            recipe.title,
            recipe.sentence,
            _shot(recipe, here[recipe.mesh], here.get(recipe.beside)),
            recipe.settings,
        )
        for name, recipe in recipes.items()
        if recipe.mesh in here and (not recipe.beside or recipe.beside in here)
    }


def _still_figure(still: Still) -> Figure:
    shot = Shot(still.mesh, still.status)
    return Figure(
        f"gallery/{still.file.name}", still.title, still.sentence, shot, told_of(still.status), still.file
    )


TOLD = ("structure", "colour")
"""Parts of a status that a picture from the repository is about; cameras and the rest are not told below it."""


def told_of(status: Status) -> Status:
    """What of a status is told below its picture."""
    return {name: status[name] for name in TOLD if name in status}


def _shot(recipe: Recipe, mesh: MeshEntry, beside: MeshEntry | None) -> Shot:
    status = recipe.status(view_of(mesh.facts))
    width, height = recipe.size
    return Shot(mesh, status, width, height, recipe.part, recipe.press, beside)
