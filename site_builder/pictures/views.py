"""Where to look from, and where to cut, so that a mesh shows its inside."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .shot import HEIGHT, WIDTH, Status

Vector = Sequence[float]

FIELD_OF_VIEW = 30.0
MARGIN = 0.94
"""Part of the picture that the mesh's box may fill along each side."""

FLAT = 0.35
"""A body lower than this part of its width is looked at from higher up."""


def camera(extent: Sequence[Vector], direction: Vector, up: Vector = (0, 0, 1)) -> Status:
    """A perspective camera that holds the whole box of a mesh, as near as can be.

    Parameters
    ----------
    extent : (2, 3)
        Lowest and highest coordinates.
    direction : (3,)
        From the eye to the mesh.
    """
    corners = _corners(extent)
    ahead = _unit(direction)
    right = _unit(np.cross(ahead, np.asarray(up, float)))
    above = np.cross(right, ahead)
    seen = corners @ np.stack([right, above, ahead], axis=1)
    height = np.tan(np.radians(FIELD_OF_VIEW / 2)) * MARGIN
    room = np.array([height * WIDTH / HEIGHT, height])
    target = np.zeros(2)
    for _ in range(8):
        aside = np.abs(seen[:, :2] - target)
        distance = float((aside / room - seen[:, 2:]).max())
        on_screen = (seen[:, :2] - target) / (distance + seen[:, 2:])
        target += distance * (on_screen.max(axis=0) + on_screen.min(axis=0)) / 2
    centre = target[0] * right + target[1] * above
    return {
        "target": _rounded(centre),
        "direction": _rounded(ahead),
        "up": [float(x) for x in up],
        "distance": round(distance, 4),
    }


def three_quarter_view(extent: Sequence[Vector]) -> tuple[Status, Vector]:
    """A camera from the front, the side and above, and the normal of a plane along the body that faces it.

    The longer horizontal side of the body runs across the picture; the plane stands upright along it, turned
    a little, so that the cut steps from cell to cell and their shapes show.
    """
    size = np.ptp(np.asarray(extent, float), axis=0)
    flat = size[2] < FLAT * max(size[0], size[1])
    down = -0.75 if flat else -0.45
    if size[0] >= size[1]:
        return camera(extent, (-0.5, 0.8, down)), (-0.28, 1.0, -0.2)
    return camera(extent, (-0.8, 0.5, down)), (-1.0, 0.28, -0.2)


def cut(normal: Vector, offset: float = 0.5) -> Status:
    """The filters' part that hides what lies behind one plane."""
    return {"planes": {"items": [{"enabled": True, "normal": list(normal), "offset": offset}]}}


def along(normal: Vector) -> Vector:
    """The axis nearest to a normal."""
    largest = max(range(3), key=lambda axis: abs(normal[axis]))
    return tuple(float(np.sign(x)) if axis == largest else 0.0 for axis, x in enumerate(normal))


def _corners(extent: Sequence[Vector]) -> NDArray[np.float64]:
    """The box's corners (8, 3) about its centre, in diagonals."""
    low, high = np.asarray(extent, float)
    half = (high - low) / 2 / (np.linalg.norm(high - low) or 1)
    signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return np.asarray(signs * half, dtype=np.float64)


def _unit(vector: Vector | NDArray[Any]) -> NDArray[np.float64]:
    array = np.asarray(vector, dtype=np.float64)
    return np.asarray(array / np.linalg.norm(array), dtype=np.float64)


def _rounded(vector: NDArray[np.float64]) -> list[float]:
    return [round(float(x), 4) + 0.0 for x in vector]
