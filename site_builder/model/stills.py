"""Pictures that lie in the repository, since the meshes that they show do not."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .catalogue import MeshEntry


@dataclass(frozen=True)
class Still:
    """A picture that the viewer has taken before.

    Parameters
    ----------
    file : Path
        A PNG that carries its settings.
    mesh : MeshEntry
    status : dict
        These settings, checked.
    title, sentence : str
    """

    file: Path
    mesh: MeshEntry
    status: dict[str, Any]
    title: str
    sentence: str


@dataclass(frozen=True)
class StillSection:
    """A section of the gallery."""

    id: str
    title: str
    text: str
    stills: tuple[Still, ...]
