"""The pictures of a report: what each shows, as settings for the viewer, and what stands below it."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Floats
from ..mesh import Mesh, cell_barycentres
from ..numbering import cell_numbers
from ..status import DEFAULTS, merge
from ..status.views import Vector, View
from ..surface.frame import Frame
from ..words import number

MIDDLE = 0.5
"""How far the cut goes in."""

ROOM = 1.1
"""Distance of the eye from a cell and its neighbours, as a multiple of that from which they just fill the picture."""

COLOURED = {
    "colour": {"by": "quality", "metric": "scaled_jacobian"},
    "lighting": {"shade": 0.5},
    "irregular": {"mode": 0},
    "figure": {"legend": "bar"},
}
FIGURE = {
    "unit": "mm", "width": 90, "height": 60, "resolution": 300, "letters": 7, "margin": 2, "scale_bar": True,
    "axes": True,
}  # fmt: skip
"""As large on every screen."""


@dataclass(frozen=True)
class Pose:
    """A picture that is to be taken.

    Parameters
    ----------
    title : str
        What stands below it.
    alt : str
        What is seen, for those who don't see it.
    status : dict
        All settings of the figure, but for mesh, version and unit.
    """

    title: str
    alt: str
    status: dict[str, Any]


@dataclass(frozen=True)
class ReportPicture:
    """A picture that was taken.

    Parameters
    ----------
    title, alt : str
        As its pose has them.
    address : str
        Where it lies, or itself as a data URI.
    """

    title: str
    alt: str
    address: str


def poses(
    mesh: Mesh, frame: Frame, view: View, scaled_jacobian: Floats, volume: Floats, unit: str
) -> list[Pose]:
    """The pictures of a report: the whole, a cut through the middle, the worst cell among its neighbours.

    Parameters
    ----------
    mesh : Mesh
    frame : Frame
        That it is drawn by.
    view : View
        That it opens under.
    scaled_jacobian, volume : (C,) float64
    unit : str
        Of length.
    """
    if not mesh.cell_count:
        return []
    camera = {"camera": view.camera, "unit": unit}
    cut = {"filters": view.slice(MIDDLE)}
    found = [
        Pose("The mesh as it opens.", "The whole mesh, seen three quarters from above.", _status(camera)),
        Pose(
            "Cut through the middle, coloured by Scaled Jacobian.",
            "The mesh without the half before a plane through its middle; colours tell the Scaled Jacobian.",
            _status(camera, COLOURED, cut),
        ),
    ]
    cell = _worst(mesh, scaled_jacobian, volume)
    if cell is not None:
        name, value = int(cell_numbers(mesh, [cell])[0]), float(scaled_jacobian[cell])
        told = number(value) if np.isfinite(value) else "not finite"
        found.append(
            Pose(
                f"Cell {name}, the worst by Scaled Jacobian ({told}), among its neighbours; "
                "those before it are left out.",
                f"Cell {name} and the cells beside and behind it; colours tell the Scaled Jacobian.",
                _status({"unit": unit}, COLOURED, _close_up(mesh, frame, view, cell)),
            )
        )
    return found


def _status(*parts: dict[str, Any]) -> dict[str, Any]:
    """The default settings with some others laid over; nothing of what was set by hand."""
    status = merge(DEFAULTS, {"figure": FIGURE})
    for part in parts:
        status = merge(status, part)
    return {name: part for name, part in status.items() if name not in ("mesh", "version")}


def _worst(mesh: Mesh, scaled_jacobian: Floats, volume: Floats) -> int | None:
    """The row of the worst cell that can be drawn: what is not finite is worse than anything, then volume tells."""
    rows = np.flatnonzero(_drawable(mesh))
    if not len(rows):
        return None
    lowest = rows[_least(scaled_jacobian[rows])]
    return int(lowest[_least(volume[lowest])[0]])


def _drawable(mesh: Mesh) -> NDArray[np.bool_]:
    """(C,) bool: whether all corners of a cell have finite coordinates."""
    finite = np.isfinite(mesh.coordinates[0] + mesh.coordinates[1] + mesh.coordinates[2])
    out = np.ones(mesh.cell_count, dtype=bool)
    for corner in mesh.corners:
        out &= finite[corner]
    return out


def _least(values: Floats) -> Array:
    """Places of the least values; of those that are not finite, where there are any."""
    odd = np.flatnonzero(~np.isfinite(values))
    return odd if len(odd) else np.flatnonzero(values == values.min())


def _close_up(mesh: Mesh, frame: Frame, view: View, cell: int) -> dict[str, Any]:
    """A cell before those of its neighbours that don't hide it."""
    around = _around(mesh, cell)
    centres = cell_barycentres(mesh.coordinates, mesh.corners[:, around], mesh.kinds[around])
    own = centres[:, np.flatnonzero(around == cell)[0]]
    beside = mesh.topology.neighbours_of(np.array([cell]))[:, 0]
    joined = centres[:, np.isin(around, beside)] - own[:, None]
    direction = _side(view.direction, joined)
    depth = (np.array(direction)[:, None] * (centres - own[:, None])).sum(axis=0)
    shown = around[(depth >= -1e-9 * frame.diagonal) | (around == cell)]
    points = mesh.coordinates[:, np.unique(mesh.corners[:, shown])]
    middle = points.min(axis=1) / 2 + points.max(axis=1) / 2
    radius = float(np.sqrt(((points - middle[:, None]) ** 2).sum(axis=0)).max()) / frame.diagonal
    half = np.radians(DEFAULTS["camera"]["field_of_view"] / 2)
    return {
        "camera": {
            "fit": False,
            "target": ((middle - frame.centre) / frame.diagonal).tolist(),
            "direction": list(direction),
            "up": list(view.up),
            "distance": max(ROOM * radius / float(np.sin(half)), 1e-9),
        },
        "filters": {
            "planes": {"items": []},
            "picking": {"isolated": True, "shown": shown.tolist()},
        },
        "silhouette": 0,
        "marks": {"corners": False, "edges": False},
    }


def _around(mesh: Mesh, cell: int) -> Array:
    """Rows of the cells that share a vertex with one, itself among them, rising; those that can be drawn."""
    own = np.zeros(mesh.vertex_count, dtype=bool)
    own[mesh.corners[:, cell]] = True
    around = np.zeros(mesh.cell_count, dtype=bool)
    for corner in mesh.corners:
        around |= own[corner]
    return np.flatnonzero(around & _drawable(mesh))


def _side(direction: Vector, joined: Floats) -> Vector:
    """Of a direction and its mirror images the one before which the fewest neighbours lie.

    A cell at the boundary is seen from outside. `joined`, (3, n), goes from the cell to the neighbours that share a
    face with it.
    """
    x, y, z = direction
    sides = [(x * a, y * b, z * c) for c, b, a in product((1, -1), repeat=3)]
    before = [np.count_nonzero((np.array(side)[:, None] * joined).sum(axis=0) < 0) for side in sides]
    return sides[int(np.argmin(before))]
