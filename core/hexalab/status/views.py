"""Where to look from, and how a first slice lies, so that a mesh shows itself: one rule for viewer and catalogue."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Floats

Vector = tuple[float, float, float]

FLAT = 0.35
"""A body lower than this part of its width is looked at from higher up."""

END_ON = 0.8
"""Cosine between the view and a long axis from which on the body is seen end on."""

MANY = 20_000
"""Cells from which on a slice stands along an axis: they are too small for its steps to show them."""


UPRIGHT = {
    "z": ((0, 1), (1, 1), (2, 1)),
    "y": ((0, 1), (2, -1), (1, 1)),
    "x": ((1, 1), (2, 1), (0, 1)),
    "-z": ((0, 1), (1, -1), (2, -1)),
    "-y": ((0, 1), (2, 1), (1, -1)),
    "-x": ((1, 1), (2, -1), (0, -1)),
}
"""By the axis that points up: which axis of the body, and its sign, is x, y and z once the body is turned upright."""


@dataclass(frozen=True)
class View:
    """Three quarters from above.

    Parameters
    ----------
    direction, up : (float, float, float)
        From the eye to the mesh, of length 1; and what is up.
    facing : (float, float, float)
        Normal of a plane that faces the eye: what is nearer than it is behind it.
    """

    direction: Vector
    up: Vector
    facing: Vector

    def slice(self, offset: float) -> dict[str, object]:
        """The part of a status that has one plane that faces the eye, gone in from 0, nowhere, to 1."""
        item = {"enabled": True, "normal": list(self.facing), "offset": offset}
        return {"planes": {"items": [item]}}

    @property
    def camera(self) -> dict[str, object]:
        """The part of a status that has the mesh looked at so, fitted to the picture."""
        return {"direction": list(self.direction), "up": list(self.up), "fit": True}


def three_quarters(
    sides: Sequence[float], cells: int = 0, long_axis: Floats | None = None, up: str = "z"
) -> View:
    """A view from the front, the side and above, and a plane along the body that faces it.

    The longer horizontal side of the body runs across the picture. The plane stands upright along it, turned a
    little, so that the cut steps from cell to cell and their shapes show; where cells are too small for that, it
    stands along an axis. A needle that would be seen end on is looked at from the other side.

    Parameters
    ----------
    sides : (3,) floats
        Of the box that is looked at.
    cells : int
        How many there are.
    long_axis : (3,) float64, optional
        Along a body that is much longer than wide.
    up : str
        The axis that points up, a key of `UPRIGHT`. A body whose y points up is seen from where its z points to.

    >>> three_quarters([4, 2, 1]).direction
    (-0.4783, 0.7652, -0.4305)
    >>> three_quarters([4, 1, 2], up="y").direction
    (-0.4783, -0.4305, -0.7652)
    """
    upright = UPRIGHT[up]
    x, y, z = (sides[axis] for axis, _ in upright)
    if long_axis is not None:
        long_axis = np.array([sign * long_axis[axis] for axis, sign in upright])
    down = -0.75 if z < FLAT * max(x, y) else -0.45
    direction, facing = (-0.5, 0.8, down), (-0.28, 1.0, -0.2)
    if y > x:
        direction, facing = (-0.8, 0.5, down), (-1.0, 0.28, -0.2)
    if long_axis is not None and abs(np.dot(_unit(direction), long_axis)) > END_ON:
        mirror = 0 if y <= x else 1
        direction, facing = _mirrored(direction, mirror), _mirrored(facing, mirror)
    facing = facing if cells <= MANY else nearest_axis(facing)
    return View(*(_laid_down(part, up) for part in (_unit(direction), (0.0, 0.0, 1.0), facing)))


def nearest_axis(normal: Vector) -> Vector:
    """The signed axis nearest to a normal."""
    largest = max(range(3), key=lambda axis: abs(normal[axis]))
    x, y, z = (float(np.sign(part)) if axis == largest else 0.0 for axis, part in enumerate(normal))
    return x, y, z


def _laid_down(vector: Vector, up: str) -> Vector:
    """A vector of the body turned upright, as the body lies."""
    laid = [0.0, 0.0, 0.0]
    for part, (axis, sign) in zip(vector, UPRIGHT[up], strict=True):
        laid[axis] = sign * part + 0.0  # no zero is negative
    return laid[0], laid[1], laid[2]


def _mirrored(vector: Vector, axis: int) -> Vector:
    x, y, z = (-part if at == axis else part for at, part in enumerate(vector))
    return x, y, z


def _unit(vector: Vector) -> Vector:
    length = float(np.sqrt(sum(part * part for part in vector)))
    x, y, z = (round(part / length, 4) for part in vector)
    return x, y, z
