"""All pictures that stand in the gallery, the guide's pages and the manifest, and where each lies in the site."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass

from ..model.catalogue import Catalogue, MeshEntry
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
    """

    address: str
    title: str
    sentence: str
    shot: Shot
    settings: Status

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
    """

    def __init__(self, catalogue: Catalogue) -> None:
        here = {mesh.id: mesh for mesh in catalogue.meshes if mesh.local and mesh.sha256}
        self.gallery = [
            Section(section.id, section.title, section.text, tuple(figures.values()), section.more)
            for section in SECTIONS
            if (figures := _figures(section.recipes, f"gallery/{section.id}-", here))
        ]
        self.guide = _figures(FIGURES, "guide/", here)
        self.lessons = _figures(LESSONS, "guide/structure/", here)
        self.screens = _figures(SCREENS, "screens/", here)

    @property
    def figures(self) -> dict[str, Shot]:
        """Every picture by its address."""
        everything = [
            *(figure for section in self.gallery for figure in section.figures),
            *self.guide.values(),
            *self.lessons.values(),
            *self.screens.values(),
        ]
        return {figure.address: figure.shot for figure in everything}


def _figures(recipes: Mapping[str, Recipe], prefix: str, here: Mapping[str, MeshEntry]) -> dict[str, Figure]:
    return {
        name: Figure(
            f"{prefix}{name}.png",
            recipe.title,
            recipe.sentence,
            _shot(recipe, here[recipe.mesh]),
            recipe.settings,
        )
        for name, recipe in recipes.items()
        if recipe.mesh in here
    }


def _shot(recipe: Recipe, mesh: MeshEntry) -> Shot:
    status = recipe.status(view_of(mesh.facts))
    width, height = recipe.size
    return Shot(mesh, status, width, height, part=recipe.part, press=recipe.press)
