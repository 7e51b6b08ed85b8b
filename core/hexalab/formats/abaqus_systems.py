"""Where nodes of an Abaqus deck lie: local systems of coordinates, and the placement of an instance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..arrays import Floats


@dataclass(frozen=True)
class Placement:
    """A rigid motion: a point goes to `turn` @ point + `shift`.

    Parameters
    ----------
    turn : (3, 3) float64
    shift : (3,) float64
    """

    turn: Floats
    shift: Floats

    def __call__(self, points: Floats) -> Floats:
        """The (3, n) points at their places; products are written out, as WebAssembly has no BLAS."""
        if (self.turn == np.eye(3)).all():
            return points + self.shift[:, None] if self.shift.any() else points
        x, y, z = points
        rows = [row[0] * x + row[1] * y + row[2] * z for row in self.turn]
        return np.stack(rows) + self.shift[:, None]


HERE = Placement(np.eye(3), np.zeros(3))


def instance_placement(lines: list[list[float]]) -> Placement | None:
    """The placement that the data lines of *INSTANCE tell (Abaqus Keywords Guide, *INSTANCE).

    Parameters
    ----------
    lines : list of list of float
        The translation; then, for a rotation after it, the points a and b of its axis and the angle in degrees.

    Returns
    -------
    Placement or None
        None if the lines tell none: the axis has no length, or numbers are missing or not finite.
    """
    if not lines:
        return HERE
    shift = np.array((lines[0] + [0.0, 0.0, 0.0])[:3])
    if len(lines) == 1:
        return Placement(np.eye(3), shift) if np.isfinite(shift).all() else None
    row = np.array((lines[1] + [0.0] * 7)[:7])
    a, axis, angle = row[:3], row[3:6] - row[:3], np.radians(row[6])
    length = np.sqrt((axis * axis).sum())
    if not np.isfinite([*shift, *row, length]).all() or not length:
        return HERE if not row.any() and not shift.any() else None
    turn = rotation(axis / length, float(angle))
    turned = (turn * (shift - a)).sum(axis=1)
    return Placement(turn, turned + a)


def rotation(axis: Floats, angle: float) -> Floats:
    """The rotation about a unit axis by an angle in radians, counter-clockwise seen against it (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    along = axis[:, None] * axis[None, :]
    turn: Floats = np.cos(angle) * np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * along
    return turn


def node_system(lines: list[list[float]]) -> Placement | None:
    """The system that the data lines of *SYSTEM tell (Abaqus Keywords Guide, *SYSTEM).

    Parameters
    ----------
    lines : list of list of float
        The origin a and a point b on the first axis; then a point c on the side of the second. Without b only
        the origin moves, without c the third axis stays and the first is projected onto its plane; no line
        at all ends the system.

    Returns
    -------
    Placement or None
        From the system to the whole; None if the points don't span one.
    """
    if not lines:
        return HERE
    first = lines[0]
    a = np.array((first + [0.0] * 3)[:3])
    if not np.isfinite(a).all():
        return None
    if len(first) <= 3:
        return Placement(np.eye(3), a)
    x = np.array((first + [0.0] * 6)[3:6]) - a
    if len(lines) > 1:
        z = cross(x, np.array((lines[1] + [0.0] * 3)[:3]) - a)
    else:
        x[2], z = 0.0, np.array([0.0, 0.0, 1.0])
    lengths = np.sqrt([(x * x).sum(), (z * z).sum()])
    if not np.isfinite(lengths).all() or not lengths.all():
        return None
    x, z = x / lengths[0], z / lengths[1]
    return Placement(np.stack([x, cross(z, x), z], axis=1), a)


def cross(u: Floats, v: Floats) -> Floats:
    """The vector product of two vectors."""
    return np.array([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]])


def from_cylindrical(points: Floats) -> Floats:
    """(3, n) radius, angle in degrees, height to x, y, z."""
    radius, angle = points[0], np.radians(points[1])
    return np.stack([radius * np.cos(angle), radius * np.sin(angle), points[2]])


def from_spherical(points: Floats) -> Floats:
    """(3, n) radius, angle about the polar axis from x, angle above the plane of x and y, in degrees, to x, y, z.

    The second angle is counted from the equator: Abaqus Keywords Guide, *NODE and *NMAP.
    """
    radius, around, above = points[0], np.radians(points[1]), np.radians(points[2])
    level = radius * np.cos(above)
    return np.stack([level * np.cos(around), level * np.sin(around), radius * np.sin(above)])


COORDINATES = {"R": None, "C": from_cylindrical, "S": from_spherical}
"""By the first letter of the SYSTEM of *NODE."""
