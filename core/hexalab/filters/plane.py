"""The slicing plane (SPEC F1; the paper, Cell filters): hides what lies behind it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Floats, Ids

Vector = Sequence[float] | Floats


class Places(NamedTuple):
    """Where cells stand along a normal.

    Attributes
    ----------
    along : (C,) float64
        What is compared with the plane: each cell's barycentre, or its corner farthest behind.
    low, high : float
        Ends of the slider.
    """

    along: Floats
    low: float
    high: float


def unit(normal: Vector) -> Floats:
    """The normal with a length of 1, whatever its length was; zero if it had none."""
    direction = np.asarray(normal, dtype=np.float64)
    largest = float(np.abs(direction).max())
    if not largest:
        return np.zeros(3)
    direction = np.ldexp(direction, -int(np.frexp(largest)[1]))
    return np.asarray(direction / np.sqrt((direction * direction).sum()))


def project(points: Floats, normal: Vector) -> Floats:
    """Lengths of (3, N) points along the direction of a normal; zero along a normal of no length."""
    x, y, z = unit(normal).tolist()
    along: Floats = points[0] * x
    term = points[1] * y
    along += term
    np.multiply(points[2], z, out=term)
    along += term
    return along


def barycentre_places(barycentres: Floats, normal: Vector) -> Places:
    """The paper's rule: barycentres are compared, and the slider runs over their extent."""
    along = project(barycentres, normal)
    return Places(along, *_ends(along))


def any_corner_places(
    coordinates: Floats, corners: Ids, referenced: NDArray[np.bool_], normal: Vector
) -> Places:
    """The original application's rule: one corner behind is enough, and the slider runs over all vertices.

    Vertices that no cell uses (not `referenced`) do not stretch the slider.
    """
    along = project(coordinates, normal)
    low, high = _ends(along[referenced])
    farthest = np.empty(corners.shape[1])
    for start in range(0, corners.shape[1], CHUNK):
        part = slice(start, start + CHUNK)
        here = along[corners[0, part]]
        for corner in corners[1:]:
            np.minimum(here, along[corner[part]], out=here)
        farthest[part] = here
    return Places(farthest, low, high)


def plane(places: Places, offset: float) -> NDArray[np.bool_]:
    """Cells behind the plane, (C,) bool.

    Parameters
    ----------
    places : Places
        Where the cells stand along the plane's normal.
    offset : float
        Place on the slider: 0 and less hides nothing, 1 and more everything.
    """
    if offset <= 0:
        return np.zeros(len(places.along), dtype=bool)
    if offset >= 1:
        return np.ones(len(places.along), dtype=bool)
    hidden: NDArray[np.bool_] = places.along < places.low * (1 - offset) + places.high * offset
    return hidden


def _ends(along: Floats) -> tuple[float, float]:
    """Smallest and largest, of the finite ones."""
    low, high = along.min(initial=np.inf), along.max(initial=-np.inf)
    if not np.isfinite(high - low):
        along = along[np.isfinite(along)]
        low, high = (along.min(), along.max()) if len(along) else (0, 0)
    return float(low), float(high)
