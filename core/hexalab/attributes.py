"""The file's own attributes (SPEC R8): which there are, their ranges, and one value per cell of each.

An attribute's id is ``cell:NAME`` or ``point:NAME``; of an array with several components that is the
magnitude, and ``cell:NAME:0``, ``cell:NAME:1``, ... are the components.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .arrays import CHUNK, Array, Floats, Ids
from .cells import CORNERS_OF_KIND, HEXAHEDRON
from .errors import HexaLabError
from .mesh import Mesh

LARGEST_SUMMAND = float(np.finfo(np.float64).max) / 8
"""Eight numbers no larger than this add up to a number."""

AXES = "xyz"
SQUARES_HOLD = 500
"""Squares of numbers between 2^-500 and 2^500 neither vanish nor overflow."""

MOST_COMPONENTS = 9
"""Of an array with more components (a tensor has nine) only the magnitude is offered."""


@dataclass(frozen=True)
class Attribute:
    """One number per cell or per point, out of an array of the file.

    Parameters
    ----------
    id : str
        ``cell:NAME``, ``point:NAME`` or the same with ``:component``.
    name : str
        Name of the array, and of the component, for the screen.
    on : "cell" or "point"
        What the array belongs to.
    array : str
        The array's name in `Mesh.cell_data` or `Mesh.point_data`.
    component : int or None
        None for the array itself or its magnitude.
    components : int
        Numbers of which it is the magnitude: 3 for a vector; 1 for a number by itself.
    """

    id: str
    name: str
    on: Literal["cell", "point"]
    array: str
    component: int | None = None
    components: int = 1


def attributes(mesh: Mesh) -> dict[str, Attribute]:
    """List the attributes that can be coloured by, filtered by and plotted, by id."""
    found = {row.id: row for row in _rows(mesh) if row.component is None}
    for row in _rows(mesh):
        found.setdefault(row.id, row)
    return found


def components(mesh: Mesh, attribute: Attribute) -> list[Attribute]:
    """List the components of an attribute that is the magnitude of several; none of another."""
    if attribute.component is not None:
        return []
    rows = _rows_of({attribute.array: _data_of(mesh, attribute)[attribute.array]}, attribute.on)
    return [row for row in rows if row.component is not None]


def own_values(mesh: Mesh, attribute: Attribute) -> Floats:
    """Return an attribute's values where the file has them: (C,) or (V,) float64."""
    array = np.asarray(_data_of(mesh, attribute)[attribute.array])
    if array.ndim == 1:
        return array.astype(np.float64)
    if attribute.component is not None or array.shape[1] == 1:
        return np.asarray(array[:, attribute.component or 0], dtype=np.float64)
    return magnitudes(array)


def vectors(mesh: Mesh) -> dict[str, Attribute]:
    """List the attributes that have a direction: magnitudes of three components, by id."""
    return {id: row for id, row in attributes(mesh).items() if row.components == len(AXES)}


def own_vectors(mesh: Mesh, attribute: Attribute) -> Array:
    """Return a vector attribute as the file has it: (C, 3) or (V, 3), in the file's number type."""
    return np.asarray(_data_of(mesh, attribute)[attribute.array])


def magnitudes(array: Array) -> Floats:
    """Return the length of each row, (n,) float64, though squares pass what float64 holds."""
    low, high = finite_range(array.astype(np.float64, copy=False)) or (0.0, 0.0)
    exponent = int(np.frexp(max(high, -low))[1])
    exponent = exponent if abs(exponent) > SQUARES_HOLD else 0
    squares = np.zeros(len(array))
    with np.errstate(over="ignore"):
        for column in array.T:
            number = column.astype(np.float64)
            if exponent:
                number = np.ldexp(number, -exponent)
            squares += number * number
        lengths: Floats = np.sqrt(squares)
        return np.ldexp(lengths, exponent) if exponent else lengths


def cell_values(mesh: Mesh, attribute: str | Attribute) -> Floats:
    """Return one value per cell, (C,) float64; a point's attribute is averaged over the cell's own corners.

    Raises
    ------
    HexaLabError
        If the mesh has no attribute of that id.
    """
    if isinstance(attribute, str):
        known = attributes(mesh)
        if attribute not in known:
            raise HexaLabError(
                f"the mesh has no attribute {attribute!r}; it has {', '.join(known) or 'none'}"
            )
        attribute = known[attribute]
    values = own_values(mesh, attribute)
    return values if attribute.on == "cell" else average_corners(values, mesh.corners, mesh.kinds)


def average_corners(values: Floats, corners: Ids, kinds: NDArray[np.uint8]) -> Floats:
    """Average a number per vertex over each cell's own corners.

    Parameters
    ----------
    values : (V,) float64
    corners : (8, C) int32
    kinds : (C,) uint8

    Returns
    -------
    (C,) float64
        A hexahedron that repeats a vertex counts it as often as it names it.
    """
    out = np.empty(corners.shape[1])
    low, high = finite_range(values) or (0.0, 0.0)
    if max(high, -low) > LARGEST_SUMMAND:
        return 8 * average_corners(values / 8, corners, kinds)
    for start in range(0, corners.shape[1], CHUNK):
        part = slice(start, start + CHUNK)
        total = values[corners[0, part]]
        for corner in corners[1:]:
            total += values[corner[part]]
        out[part] = total / 8
    for kind in np.unique(kinds):
        if kind != HEXAHEDRON:
            which = np.flatnonzero(kinds == kind)
            own = corners[np.array(CORNERS_OF_KIND[kind])][:, which]
            out[which] = values[own].mean(axis=0)
    return out


def finite_range(values: Array) -> tuple[float, float] | None:
    """Return the smallest and the largest finite value, or None if there is none."""
    if not values.size:
        return None
    low, high = float(values.min()), float(values.max())
    if not (np.isfinite(low) and np.isfinite(high)):
        finite = values[np.isfinite(values)]
        if not finite.size:
            return None
        low, high = float(finite.min()), float(finite.max())
    return low, high


def described(mesh: Mesh) -> list[dict[str, Any]]:
    """Return the attributes with the ranges of the file's values, for the page: id, name, on, components, min, max."""
    rows = []
    for row in attributes(mesh).values():
        low, high = finite_range(own_values(mesh, row)) or (None, None)
        told = {"id": row.id, "name": row.name, "on": row.on, "components": row.components}
        rows.append({**told, "min": low, "max": high})
    return rows


def _data_of(mesh: Mesh, attribute: Attribute) -> dict[str, Array]:
    return mesh.cell_data if attribute.on == "cell" else mesh.point_data


def _rows(mesh: Mesh) -> Iterator[Attribute]:
    yield from _rows_of(mesh.cell_data, "cell")
    yield from _rows_of(mesh.point_data, "point")


def _rows_of(data: dict[str, Array], on: Literal["cell", "point"]) -> Iterator[Attribute]:
    for name, array in data.items():
        array = np.asarray(array)
        if array.dtype.kind not in "biuf" or array.ndim > 2:
            continue
        count = array.shape[1] if array.ndim == 2 else 1
        if not count:
            continue
        title = f"{name}, magnitude" if count > 1 else name
        yield Attribute(f"{on}:{name}", title, on, name, components=count)
        if 1 < count <= MOST_COMPONENTS:
            labels = AXES if count <= len(AXES) else [str(place) for place in range(count)]
            for place, label in zip(range(count), labels, strict=False):
                yield Attribute(f"{on}:{name}:{place}", f"{name}, {label}", on, name, place)
