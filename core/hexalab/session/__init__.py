"""One open mesh: the only door between whoever shows it and the core.

What may be asked are the methods of `Session`; `door.Door` takes the questions of any transport. Results are dicts,
lists, numbers, texts, None and numpy arrays; what is not finite is None, but in arrays.

The settings of a view belong to the viewer, which holds the one status document. The session is told those that
concern the core (`hexalab.status.CORE_PATHS`), and of these only what has changed; it keeps them until another mesh is
opened, which starts with their defaults.
"""

from __future__ import annotations

import gc
from collections.abc import Callable, Mapping
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import attributes
from .. import status as documents
from ..errors import HexaLabError
from ..formats import read_bytes
from ..mesh import Mesh
from ..packing import jsonable
from ..reference import TriangleSurface
from . import going, inspection, known, measuring
from .comparing import Comparing
from .opened import DESCRIBED, Opened
from .picture import Picture, looked_at, quantity_of
from .preparing import prepared
from .preview import preview_of
from .tracing import Tracing
from .writing import Writing

__all__ = ["DESCRIBED", "Session", "prepared"]

Result = dict[str, Any]

SETTINGS = documents.core_part(documents.DEFAULTS)
"""The settings that a mesh is first drawn under."""

Offers = Mapping[str, Callable[[], Mesh]]
"""Meshes that whoever holds the session has at hand, by names of theirs; each `prepared`, when it is asked for."""

Sizes = Mapping[str, Callable[[], int | None]]
"""Bytes of the files that these were read from."""

Surfaces = Mapping[str, Callable[[], TriangleSurface]]
"""Reference surfaces that whoever holds the session has at hand."""


class Session(Tracing, Comparing, Writing):
    """One open mesh, and the settings that it is drawn under.

    Parameters
    ----------
    offers : mapping of str to callable, optional
        Meshes that can be opened without their bytes being sent.
    sizes : mapping of str to callable, optional
        Bytes of the files that these are, for reports.
    surfaces : mapping of str to callable, optional
        Reference surfaces that the mesh can be compared with, by names like those of offers.

    >>> session = Session()
    >>> summary = session.open("cube.mesh", data)                                    # doctest: +SKIP
    >>> session.update({"filters": {"peel": {"depth": 1}}})["shown_cells"]           # doctest: +SKIP
    """

    def __init__(
        self, offers: Offers | None = None, sizes: Sizes | None = None, surfaces: Surfaces | None = None
    ) -> None:
        self._offers: Offers = offers or {}
        self._surfaces: Surfaces = surfaces or {}
        self._sizes: Sizes = sizes or {}
        self._size: int | None = None
        self._settings: Result = SETTINGS
        self._opened: Opened | None = None
        self._picture: Picture | None = None

    # -- the mesh

    def open(
        self, name: str, data: bytes | memoryview, companions: dict[str, bytes | memoryview] | None = None
    ) -> Result:
        """Open a mesh and do no more than the first picture needs; all settings become the defaults.

        Parameters
        ----------
        name : str
            The file's name, or its path within a folder that was opened.
        data : bytes
            The file.
        companions : dict of str to bytes, optional
            Files that were opened with it and that it may include, by name or path.

        Raises
        ------
        MeshReadError
            If it can't be read; the mesh that was open stays open.
        """
        began = perf_counter()
        mesh = read_bytes(data, name, companions)
        read = perf_counter()
        summary = self._begin(prepared(mesh), began, read)
        self._size = len(data)
        return summary

    def open_offered(self, name: str) -> Result:
        """Open a mesh that whoever holds the session offers; as `open`.

        Parameters
        ----------
        name : str
            One of the session's offers.

        Raises
        ------
        MeshReadError
            If it is a file that can't be read, or is not there; the mesh that was open stays open.
        HexaLabError
            If nothing is offered by that name.
        """
        if name not in self._offers:
            raise HexaLabError(f"nothing is offered by the name of {name!r}")
        began = perf_counter()
        mesh = self._offers[name]()
        summary = self._begin(mesh, began, perf_counter())
        self._size = self._sizes[name]() if name in self._sizes else None
        return summary

    def _begin(self, mesh: Mesh, began: float, read: float) -> Result:
        """Make a mesh the open one; the summary tells how long it took since `began`, and reading until `read`."""
        faces = mesh.topology.boundary_face_count
        topology = perf_counter()
        opened = Opened(mesh)
        summary = {
            "name": mesh.name,
            "format": mesh.format,
            "vertices": mesh.vertex_count,
            "cells": mesh.cell_count,
            "kinds": mesh.kind_counts,
            "boundary_faces": faces,
            **opened.placed,
            "notes": list(mesh.notes),
            "attributes": attributes.described(mesh),
        }
        summary["timings"] = {
            "read": 1000 * (read - began),
            "topology": 1000 * (topology - read),
            "summary": 1000 * (perf_counter() - topology),
        }
        self._opened, self._picture, self._settings = opened, Picture(opened), SETTINGS
        gc.collect()  # a mesh and its topology know each other; a browser's memory only ever grows
        return summary

    def describe(self, part: str = "") -> Result:
        """Return the slow part of the summary.

        Parameters
        ----------
        part : str
            One of `DESCRIBED`, so that other calls can come between; all of them by default.

        Returns
        -------
        dict
            Facts as `hexalab.summarise` names them, `max_depth`, `findings` with their severity, `shapes` (cells by
            what they are or have collapsed to), `part_cells` (of the largest parts, at most `MOST_PARTS`).
        """
        opened = self._open_mesh()
        facts: Result = {}
        for name in (part,) if part else DESCRIBED:
            facts.update(opened.described(name))
        described: Result = jsonable(facts)
        return described

    # -- the picture

    def check(self, document: Any) -> Result:
        """Make any settings document a clean part of the present version, without applying it.

        Parameters
        ----------
        document : object or str
            Parsed from JSON, or its text; ours of any version, or the original's.

        Returns
        -------
        dict
            `partial`, `rejections` (list of {path, found, expected}), `form`: "hexalab" or "original".
        """
        return known.read(document, self._opened)

    def update(self, changed: Result | None = None, lean: bool = False, whole: bool = False) -> Result:
        """Take on settings that changed and return what is drawn otherwise than before.

        Parameters
        ----------
        changed : dict, optional
            A part of the settings that concern the core, which has been checked where it entered; lists are kept, and
            known again by their identity, so that the caller doesn't change them.
        lean : bool
            Leave out edges, silhouette, arrows and what is seen through, as for drafts while something moves; the
            next update that is not lean brings them.
        whole : bool
            Return every record: the last answer got lost on its way, or could not be drawn.

        Returns
        -------
        dict
            `shown_cells`, `shown_faces`, `max_depth` (None until it is known), `plane_ranges` (extent of the
            barycentres along each plane's normal, in drawing coordinates), `pending` (records that wait for
            `describe`), `timings` (ms), and of the records `surface`, `silhouette`, `see_through`, `irregular`,
            `arrows`, `marks`, `curves`, `colour` those that changed.

        Raises
        ------
        HexaLabError
            If the settings name a quantity or a vector attribute that the mesh has not got. After this or any other
            failure they stay as they were, and the next update returns every record.
        """
        began = perf_counter()
        opened, picture = self._open_mesh(), self._drawn()
        if whole:
            picture.forget()
        settings = documents.merge(self._settings, changed or {})
        try:
            records = picture.update(settings, lean)
            answer = {
                "shown_cells": int(np.count_nonzero(picture.shown)),
                "shown_faces": picture.shown_faces(),
                "max_depth": opened.max_depth(settings["filters"]["peel"]["depth"] > 0),
                "plane_ranges": opened.plane_ranges(settings["filters"]["planes"]),
                **records,
                "timings": {**picture.timings, "update": 1000 * (perf_counter() - began)},
            }
        except Exception:
            picture.forget()
            raise
        self._settings = settings
        return answer

    def preview(self, settings: Result | None = None) -> bytes:
        """Pack summary and first picture into one block of bytes: what the catalogue shows before Python runs.

        Parameters
        ----------
        settings : dict, optional
            A checked part of a status: what it is drawn under, where that is not the default.
        """
        return preview_of(self._open_mesh(), settings)

    # -- quality

    def quality(self, quantity: str) -> Result:
        """Return the statistics of a metric or an attribute; see `measuring.statistics_of`."""
        return measuring.statistics_of(self._open_mesh(), quantity)

    def worst(self, quantity: str, count: int = 50) -> Result:
        """Return the worst cells by a metric, or the highest by an attribute; see `measuring.worst_of`."""
        return measuring.worst_of(self._open_mesh(), quantity, int(count))

    def values(self, quantity: str) -> NDArray[np.float64]:
        """Return the value of every cell, (C,) float64, not finite where a cell has none."""
        return self._open_mesh().values(quantity)

    def histogram(self, quantity: str, bins: int = 100, shown_only: bool = False) -> Result:
        """Count the values of a metric or an attribute in bins; see `measuring.histogram_of`."""
        opened = self._open_mesh()
        colour = self._settings["colour"]
        limits = colour["range"] if quantity_of(colour) == quantity else None
        reach = colour["reach"] if looked_at(colour) == quantity else None
        shown = self._drawn().shown if shown_only else None
        return measuring.histogram_of(opened, quantity, int(bins), shown, limits, reach)

    def group_table(self) -> list[Result]:
        """Measure the groups of cells: `id`, `volume`, `scaled_jacobian_min` and `_mean`, `invalid` of each."""
        rows: list[Result] = jsonable(self._open_mesh().group_table())
        return rows

    def interfaces(self, origin: str) -> list[Result]:
        """Tell where the groups of an origin meet; see `grouped.GroupBook.interface_table`."""
        return self._open_mesh().groups.interface_table(origin)

    def validity(self) -> Result:
        """Return how many cells are certified valid, invalid or undecided, and which are invalid."""
        found = self._open_mesh().validity
        return {**found.counts, "invalid_cells": np.flatnonzero(found.state == 0).astype(np.uint32)}

    # -- cells

    def inspect(self, cell: int) -> Result:
        """Tell everything about a cell; see `inspection.inspect`."""
        found: Result = jsonable(inspection.inspect(self._open_mesh(), self._cell(cell)))
        return found

    def value(self, cell: int, quantity: str) -> Result:
        """Tell one value of a cell, as it is coloured by; see `inspection.value`."""
        return inspection.value(self._open_mesh(), self._cell(cell), quantity)

    def measure_sizes(self) -> bool:
        """Measure a share of the cells for the mean volume that size metrics compare with.

        Returns
        -------
        bool
            Whether it is known; if not, ask again when nothing else waits.
        """
        return self._open_mesh().mean_volumes.step()

    def numbers(self) -> Result:
        """Tell how the file numbers cells; see `going.numbers_of`."""
        return going.numbers_of(self._open_mesh())

    def find(self, kind: str, number: int, direction: list[float] | None = None) -> Result:
        """Find a cell or a vertex by the file's number, and what lies around it; see `going.find`."""
        return going.find(self._open_mesh(), kind, int(number), direction)

    def cell_view(self, cell: int) -> Result:
        """Return the centre, size and edges of a cell as it is drawn; see `inspection.where`."""
        return inspection.where(self._drawn().drawn_mesh, self._cell(cell))

    def cut_to(self, cell: int, normal: list[float], rule: str = "barycentre") -> float:
        """Return how far a plane has to go in, 0 to 1, to hide what is before a cell, which stays.

        Parameters
        ----------
        cell : int
        normal : (3,) float
            Away from the eye.
        rule : "barycentre" or "any_corner"
        """
        return self._open_mesh().cut_to(self._cell(cell), normal, rule)

    def neighbour(self, face_tag: int) -> int:
        """Return the cell behind a face (cell times 8 plus local face), -1 outside."""
        cell, local = divmod(int(face_tag), 8)
        topology = self._open_mesh().drawn_mesh.topology
        return int(topology.neighbours_of(np.array([self._cell(cell)]))[local, 0])

    def finding_cells(self, finding: str) -> NDArray[np.uint32]:
        """Return the cells that a finding of the diagnosis concerns, or those around its vertices."""
        return inspection.finding_cells(self._open_mesh(), finding)

    # -- within

    def _open_mesh(self) -> Opened:
        if self._opened is None:
            raise HexaLabError("no mesh is open")
        return self._opened

    def _drawn(self) -> Picture:
        if self._picture is None:
            raise HexaLabError("no mesh is open")
        return self._picture

    def _cell(self, cell: int) -> int:
        count = self._open_mesh().mesh.cell_count
        if not 0 <= cell < count:
            raise HexaLabError(f"there is no cell {cell}: the mesh has {count} cells, numbered from 0")
        return int(cell)
