"""One cell at a time: what the inspector shows, and where a cell lies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import attributes
from ..arrays import Array, Floats
from ..attributes import average_corners, cell_values
from ..cells import CORNERS_OF_KIND, EDGES, KINDS
from ..comparison import QUANTITIES as COMPARED
from ..diagnosis import Finding
from ..errors import HexaLabError
from ..mesh import Mesh
from ..numbering import cell_numbers, vertex_numbers
from ..quality import METRICS, certify, quality_many
from ..quality.sizes import NEEDS as SIZED
from ..quality.validity import STATES
from ..structure.quantities import QUANTITIES
from ..surface import DrawnMesh, Frame
from .opened import Opened


def inspect(opened: Opened, cell: int) -> dict[str, Any]:
    """Tell everything about a cell.

    Returns
    -------
    dict
        `cell` (its row), `number` (the file's), `kind`, `corners` (rows of its own corners), `nodes` (the file's
        numbers of them), `coordinates` (one [x, y, z] for each), `groups` (ids of those that it is in),
        `metrics` (id to value, None where it is not finite; only those that the kind has), `pending` (metrics
        that compare with the mesh's mean volume and wait for it, None among `metrics`), `attributes` (name to value
        or list), `neighbours` (six cells, -1 outside), `structure` (see
        `TracedBook.at`; None until it is traced), `validity` ("valid", "invalid" or "undecided").
    """
    mesh = opened.mesh
    kind = int(mesh.kinds[cell])
    corners = mesh.corners[np.array(CORNERS_OF_KIND[kind]), cell]
    own = [metric.id for metric in METRICS.values() if kind in metric.kinds]
    metrics = cell_metrics(opened, cell, own)
    return {
        "cell": cell,
        "number": int(cell_numbers(mesh, [cell])[0]),
        "kind": KINDS[kind],
        "corners": corners.tolist(),
        "nodes": vertex_numbers(mesh, corners).tolist(),
        "groups": [id for id, group in opened.groups.of_cells.items() if group.has(cell)],
        "coordinates": mesh.coordinates[:, corners].T.tolist(),
        "metrics": {id: metrics.get(id) for id in own},
        "pending": [id for id in own if id not in metrics],
        "attributes": cell_attributes(mesh, cell),
        "neighbours": mesh.topology.neighbours_of(np.array([cell]))[:, 0].tolist(),
        "structure": structure_at(opened, cell),
        "validity": STATES[int(certify(alone(mesh, cell)).state[0])],
    }


def structure_at(opened: Opened, cell: int) -> dict[str, Any] | None:
    """What a cell is part of; None until it is traced, which is not done for this."""
    return opened.traced.at(cell) if "traced" in vars(opened) else None


def value(opened: Opened, cell: int, quantity: str) -> dict[str, Any]:
    """Tell one value of a cell, as it is coloured by.

    Parameters
    ----------
    opened : Opened
    cell : int
    quantity : str
        Id of a metric or an attribute.

    Returns
    -------
    dict
        `cell`, `kind`, `structure` (see `TracedBook.at`; None until it is traced),
        `value` (None where it is not finite, or the kind has no such metric), `components` (of an
        attribute with several, whose magnitude the value is; else None), `pending` (whether the value waits for the
        mesh's mean volume).

    Raises
    ------
    UnknownQuantity
        If there is neither a metric nor an attribute of that id.
    """
    told = {
        "cell": cell,
        "kind": KINDS[opened.mesh.kinds[cell]],
        "structure": structure_at(opened, cell),
        "components": None,
        "pending": False,
    }
    if quantity in METRICS:
        metrics = cell_metrics(opened, cell, [quantity])
        return {**told, "value": metrics.get(quantity), "pending": quantity not in metrics}
    if quantity in QUANTITIES or quantity in COMPARED:
        return {**told, "value": _finite(opened.values(quantity)[cell])}
    attribute = opened.attribute(quantity)
    one = alone(opened.mesh, cell, attribute.array)
    components = [_finite(cell_values(one, part)[0]) for part in attributes.components(one, attribute)]
    return {**told, "value": _finite(cell_values(one, attribute)[0]), "components": components or None}


def alone(mesh: Mesh, cell: int, array: str = "") -> Mesh:
    """Return a mesh of one cell of another, with the attributes of one name."""
    corners = mesh.corners[:, cell]
    own, places = np.unique(corners, return_inverse=True)
    data = {name: np.asarray(of)[cell : cell + 1] for name, of in mesh.cell_data.items() if name == array}
    at_points = {name: np.asarray(of)[own] for name, of in mesh.point_data.items() if name == array}
    return Mesh(
        mesh.coordinates[:, own],
        places.astype(np.int32).reshape(8, 1),
        mesh.kinds[cell : cell + 1],
        point_data=at_points,
        cell_data=data,
    )


def cell_metrics(opened: Opened, cell: int, metrics: list[str]) -> dict[str, float | None]:
    """Measure one cell, None where a value is not finite; metrics that wait for the mesh's mean volume are left out.

    No more than this cell is measured: what is known of the whole mesh is looked up.
    """
    means = opened.mean_volumes.known
    known = {id: values for id in metrics if (values := opened.known_values(id)) is not None}
    others = [id for id in metrics if id not in known and (means is not None or id not in SIZED)]
    measured = quality_many(alone(opened.mesh, cell), others, means) if others else {}
    found = {id: measured[id][0] if id in measured else known[id][cell] for id in (*others, *known)}
    return {id: _finite(number) for id, number in found.items()}


def _finite(number: float) -> float | None:
    return float(number) if np.isfinite(number) else None


def cell_attributes(mesh: Mesh, cell: int) -> dict[str, Any]:
    """Return the file's values for one cell; those of points as the mean of its corners."""
    found = {name: _plain(np.asarray(array)[cell]) for name, array in mesh.cell_data.items()}
    corners = mesh.corners[:, cell]
    for name, array in mesh.point_data.items():
        own = np.asarray(array)[corners]
        if own.dtype.kind in "biuf" and own.ndim <= 2:
            columns = own.reshape(8, -1).T.astype(np.float64)
            eight, kind = np.arange(8, dtype=np.int32).reshape(8, 1), mesh.kinds[cell : cell + 1]
            means = [float(average_corners(column, eight, kind)[0]) for column in columns]
            found[f"{name} (mean of corners)"] = means[0] if len(means) == 1 else means
    return found


def where(drawn_mesh: DrawnMesh, cell: int) -> dict[str, Any]:
    """Tell where a cell is drawn, in drawing coordinates.

    Returns
    -------
    dict
        `centre` ([x, y, z]), `size` (of its box's diagonal), `edges` ((6 n,) float32: both ends of each edge that
        has not vanished).
    """
    mesh, frame, moved = drawn_mesh.whole, drawn_mesh.frame, drawn_mesh.moved(cell)
    own = mesh.coordinates[:, mesh.corners[:, cell]]
    low, high = own.min(axis=1), own.max(axis=1)
    centre = (low / 2 + high / 2 - frame.centre) / frame.diagonal + moved
    return {
        "centre": centre.tolist(),
        "size": float(np.sqrt(((high - low) ** 2).sum())) / frame.diagonal,
        "edges": _edges(mesh, frame, cell, moved),
    }


def _edges(mesh: Mesh, frame: Frame, cell: int, moved: Floats) -> NDArray[np.float32]:
    """Both ends of a cell's edges in drawing coordinates, each edge once."""
    corners = mesh.corners[:, cell]
    pairs = {tuple(sorted((int(corners[a]), int(corners[b])))) for a, b in EDGES if corners[a] != corners[b]}
    ends = mesh.points[np.array(sorted(pairs), dtype=np.intp).reshape(-1)]
    return np.asarray((ends - frame.centre) / frame.diagonal + moved, dtype=np.float32).reshape(-1)


def finding_cells(opened: Opened, finding: str) -> NDArray[np.uint32]:
    """Return the cells that a finding of the diagnosis concerns; see `cells_of`.

    Raises
    ------
    HexaLabError
        The diagnosis found nothing of that id.
    """
    for found in opened.findings:
        if found.id == finding:
            return cells_of(opened.mesh, found)
    raise HexaLabError(f"the diagnosis found no {finding!r}")


def cells_of(mesh: Mesh, finding: Finding) -> NDArray[np.uint32]:
    """Return the cells that a finding concerns; those around its vertices where it names no cells."""
    if len(finding.cells):
        return np.asarray(finding.cells).astype(np.uint32)
    named = np.zeros(mesh.vertex_count, dtype=bool)
    named[np.asarray(finding.vertices, dtype=np.int64)] = True
    around = np.zeros(mesh.cell_count, dtype=bool)
    for corner in mesh.corners:
        around |= named[corner]
    return np.flatnonzero(around).astype(np.uint32)


def _plain(value: Array | Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value
