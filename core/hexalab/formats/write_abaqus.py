"""Writes Abaqus and CalculiX `.inp`."""

from __future__ import annotations

import numpy as np

from ..arrays import CHUNK, Array, Floats
from ..grouping import groups_by_value
from ..mesh import Mesh
from .abaqus_written_sets import set_lines
from .writing import formatted, numbers_written, own_corners, runs

LARGEST_NUMBER = 999_999_999
"""Of a node or an element (Abaqus Analysis User's Guide, *NODE)."""

LONGEST = 20
"""Characters of a number: Abaqus reads no more ("Input syntax rules"), nor does CalculiX."""

TYPES = ("C3D8", "C3D6", "C3D5", "C3D4")
"""The element of each kind."""


def write(mesh: Mesh) -> bytes:
    """The bytes of an `.inp` file: nodes and elements, in the mesh's order, with their own numbers, then sets.

    Coordinates have as many digits as fit into twenty characters: at least thirteen, mostly all.
    """
    nodes = numbers_written(mesh.vertex_numbers, mesh.vertex_count, LARGEST_NUMBER)
    elements = numbers_written(mesh.cell_numbers, mesh.cell_count, LARGEST_NUMBER)
    title = " ".join((mesh.name or "mesh").split()).encode("ascii", "replace")[:80].replace(b"*", b"-")
    parts = [b"*HEADING\n" + title + b"\n*NODE\n"]
    for start in range(0, mesh.vertex_count, CHUNK):
        part = slice(start, start + CHUNK)
        texts = [shortened(axis) for axis in mesh.coordinates[:, part]]
        rows = zip(nodes[part].tolist(), *texts, strict=True)
        parts.append("".join(f"{number}, {x}, {y}, {z}\n" for number, x, y, z in rows).encode())
    for which in runs(mesh.kinds):
        kind = int(mesh.kinds[which.start])
        corners = [nodes[corner] for corner in own_corners(mesh, kind, which)]
        parts.append(f"*ELEMENT, TYPE={TYPES[kind]}\n".encode())
        parts += formatted(", ".join(["%d"] * (len(corners) + 1)) + "\n", [elements[which], *corners])
    return b"".join([*parts, *set_lines(mesh, nodes, elements)])


def keeps(on: str, name: str, values: Array) -> bool:
    """Whether an attribute has a place: one of few whole numbers, as sets of cells."""
    return on == "cell" and next(groups_by_value(name, values), None) is not None


def shortened(values: Floats) -> list[str]:
    """The numbers as text, each in at most twenty characters, as exact as they allow."""
    texts = [repr(value) for value in np.asarray(values).tolist()]
    return [text if len(text) <= LONGEST else rounded(float(text)) for text in texts]


def rounded(value: float) -> str:
    """The number with as many digits as fit.

    >>> rounded(-1.2345678901234567e-05)
    '-1.2345678901235e-05'
    """
    return next(text for digits in range(16, 0, -1) if len(text := f"{value:.{digits}g}") <= LONGEST)
