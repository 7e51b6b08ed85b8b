"""Groups and features of a mesh as *ELSET, *NSET and *SURFACE."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from ..arrays import Array
from ..cells import COLLAPSE, CORNERS_OF_KIND, FACES, KINDS, WEDGE
from ..grouping import feature_groups, groups_of
from ..groups import Features, Group
from ..mesh import Mesh
from ..topology.lookup import sides_of
from .abaqus_elements import FACES as FACES_OF_ABAQUS
from .assembly import WEDGE_OF_OTHERS
from .writing import formatted
from .written_groups import names_of

PER_LINE = 16
"""Entries of a line of *ELSET and *NSET (Abaqus Keywords Guide)."""

LONGEST = 80
PLAIN = re.compile(r"[A-Za-z_][\w.-]*")


def set_lines(mesh: Mesh, nodes: Array, elements: Array) -> Iterator[bytes]:
    """The sets and surfaces of a mesh, given the numbers of its nodes and elements."""
    groups = groups_of(mesh)
    for on, keyword, numbers in (("cell", "ELSET", elements), ("vertex", "NSET", nodes)):
        some = [group for group in groups if group.on == on and group.count]
        for group, name in zip(some, names_of(some, clean), strict=True):
            yield f"*{keyword}, {keyword}={name}\n".encode()
            yield from entries(numbers[group.members])
    for features in mesh.features:
        if features.dimension == 2:
            yield from surfaces(mesh, features, elements)


def entries(numbers: Array) -> Iterator[bytes]:
    """Numbers, sixteen on a line."""
    whole = len(numbers) // PER_LINE * PER_LINE
    rows = numbers[:whole].reshape(-1, PER_LINE)
    if len(rows):
        yield from formatted(", ".join(["%d"] * PER_LINE) + "\n", [*rows.T])
    if whole < len(numbers):
        yield (", ".join(map(str, numbers[whole:].tolist())) + "\n").encode()


def surfaces(mesh: Mesh, features: Features, elements: Array) -> Iterator[bytes]:
    """A *SURFACE for each group of faces; those that no cell has are left out."""
    groups = [group for group in surface_groups(features) if group.count]
    cells, local = sides_of(mesh.corners, mesh.vertex_count, features.corners)
    labels = numbers_of_sides(mesh, cells, local)
    for group, name in zip(groups, names_of(groups, clean), strict=True):
        members = group.members[labels[group.members] > 0]
        yield f"*SURFACE, NAME={name}, TYPE=ELEMENT\n".encode()
        yield from formatted("%d, S%d\n", [elements[cells[members]], labels[members]]) if len(members) else ()


def surface_groups(features: Features) -> tuple[Group, ...]:
    """The groups of faces; all of them as one where they are in none."""
    groups = feature_groups(features.data, features.groups)
    if groups:
        return groups
    return (Group("FACES", "surface", np.arange(features.count)),)


def numbers_of_sides(mesh: Mesh, cells: Array, local: Array) -> Array:
    """(n,) what Abaqus calls the faces of cells: 1 for S1; 0 where there is no cell."""
    out = np.zeros(len(cells), dtype=np.int64)
    kinds = mesh.kinds[cells]
    for kind in range(len(KINDS)):
        own = CORNERS_OF_KIND[kind]
        order = WEDGE_OF_OTHERS if kind == WEDGE else tuple(range(len(own)))
        for number, face in enumerate(FACES_OF_ABAQUS[kind]):
            places = {own[order[node]] for node in face}
            for side, corners in enumerate(FACES):
                if places == collapsed(kind, corners):
                    out[(cells >= 0) & (kinds == kind) & (local == side)] = number + 1
    return out


def collapsed(kind: int, corners: tuple[int, ...]) -> set[int]:
    """The places of a side among a kind's own corners, of which a cell of fewer corners repeats some."""
    own = CORNERS_OF_KIND[kind]
    return {own[COLLAPSE[kind][corner]] for corner in corners}


def clean(name: str) -> str:
    """A name as Abaqus takes it: eighty characters, in quotes where it is not of letters, digits and few signs."""
    text = " ".join(re.sub(r'[",=*]', "_", name).split())[:LONGEST] or "unnamed"
    return text if PLAIN.fullmatch(text) else f'"{text}"'
