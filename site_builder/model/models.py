"""Input models that many papers mesh, and how the meshes of one are recognised by their names."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from .names import without_ending

AFFIXES = (
    (r"hex|tri|remesh", "what kind of mesh it is"),
    (r"hh|sat", "what the CAD file ended in"),
    (r"in|out|input|output|model|polycube|opt|ours", "before or after what the paper does"),
    (r"gp|sp|nopadding|octree|polycut|takayama|fu2016|liu18", "whose method, or which variant of it"),
    (r"cut|padded|graded|stresstest|slivers|raw|subd?", "what was done to it"),
    (r"coarse|fine|refine|small|largel|[sml]", "how fine it is"),
    (r"\d{1,2}|size\d|rd\d|refine\d|a\d|[a-f]|[gn]", "which of several results"),
    (r"pone|0177603|s\d{3}", "where a journal keeps it"),
)
"""Words around a model's name in a file's, and what they say."""

_AFFIX = re.compile("|".join(words for words, _ in AFFIXES))


@dataclass(frozen=True)
class Model:
    """A body that several papers mesh.

    Parameters
    ----------
    id : str
        Part of its page's address.
    title : str
    origin : str
        Where it comes from, in a sentence; "" if that is not certain.
    names : tuple of str
        By which its meshes are recognised, in any spelling.
    """

    id: str
    title: str
    origin: str = ""
    names: tuple[str, ...] = ()

    @property
    def page(self) -> str:
        """Address of the model's page below the site's root."""
        return f"models/{self.id}/"

    @property
    def table(self) -> str:
        """Address of the table of its meshes as CSV."""
        return f"{self.page}{self.id}.csv"


def joined(name: str) -> str:
    """A name in one spelling: letters and digits alone, in lower case.

    >>> joined("Rocker_arm"), joined("rockerArm")
    ('rockerarm', 'rockerarm')
    """
    return "".join(_words(name))


def spellings(path: str) -> Iterator[str]:
    """What a mesh's model may be called, by its file's path: the whole name, then without one affix after another.

    Where nothing but affixes is left, the folder has the name.

    >>> list(spellings("hex_mesh/bunny/bunny_1.mesh"))
    ['bunny1', 'bunny']
    >>> list(spellings("anc101/hex.vtk"))
    ['hex', 'anc101']
    """
    for part in reversed(without_ending(path).split("/")):
        words = _words(part)
        while words:
            yield "".join(words)
            if _AFFIX.fullmatch(words[-1]):
                words = words[:-1]
            elif _AFFIX.fullmatch(words[0]):
                words = words[1:]
            else:
                return


def model_of(path: str, names: Mapping[str, str]) -> str:
    """The model of a mesh by its file's path: that of the longest spelling which `names` has, "" if it has none.

    Parameters
    ----------
    names : mapping of str to str
        Names as `joined` gives them, to ids of models.
    """
    return next((names[name] for name in spellings(path) if name in names), "")


def _words(name: str) -> list[str]:
    return re.findall(r"[a-z0-9]+", name.lower())
