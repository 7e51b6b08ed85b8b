"""The meshes of the field in a few numbers, for each family of methods and for each year."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean, median

from ..model.catalogue import MeshEntry
from .families import family_names, method_of
from .field import Field


@dataclass(frozen=True)
class Summary:
    """Some meshes in a few numbers; None where none of them is measured.

    Parameters
    ----------
    id, name : str
        The family's, or the year.
    sources, meshes, measured : int
        How many there are.
    cells : float or None
        Median number of cells of the meshes whose cells are known.
    lowest, middle, mean : float or None
        Smallest, median and mean of the meshes' smallest Scaled Jacobians.
    valid : float or None
        Part of the measured meshes in which every cell is certified valid, 0 to 1.
    """

    id: str
    name: str
    sources: int
    meshes: int
    measured: int
    cells: float | None
    lowest: float | None
    middle: float | None
    mean: float | None
    valid: float | None


def by_family(field: Field) -> list[Summary]:
    """A row for each family of methods that the field has meshes of, in the families' order."""
    names = family_names()
    groups: dict[str, list[MeshEntry]] = {name: [] for name in names}
    for mesh in field.meshes:
        groups.setdefault(method_of(mesh), []).append(mesh)
    return [_summary(name, names.get(name, name), group) for name, group in groups.items() if group]


def of_all(field: Field) -> Summary:
    """The whole field."""
    return _summary("", "all", field.meshes)


def by_year(field: Field) -> list[Summary]:
    """A row for each year in which a mesh was published, the oldest first."""
    years = sorted({mesh.source.year for mesh in field.meshes})
    return [
        _summary(str(year), str(year), [mesh for mesh in field.meshes if mesh.source.year == year])
        for year in years
    ]


def _summary(name: str, called: str, meshes: Sequence[MeshEntry]) -> Summary:
    worst = [mesh.facts.sj_min for mesh in meshes if mesh.facts.sj_min is not None]
    cells = [mesh.cells for mesh in meshes if mesh.cells is not None]
    certified = [mesh.facts.validity for mesh in meshes if mesh.facts.validity is not None]
    valid = sum(not counts["invalid"] and not counts["undecided"] for counts in certified)
    return Summary(
        id=name,
        name=called,
        sources=len({mesh.source.slug for mesh in meshes}),
        meshes=len(meshes),
        measured=len(worst),
        cells=median(cells) if cells else None,
        lowest=min(worst) if worst else None,
        middle=median(worst) if worst else None,
        mean=fmean(worst) if worst else None,
        valid=valid / len(certified) if certified else None,
    )
