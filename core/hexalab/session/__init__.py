"""One open mesh and its status: the only door between the viewer and the core.

The worker calls the methods of `Session` by name. Results are dicts, lists, numbers, texts, None and numpy
arrays; what is not finite is None, but in arrays.
"""

from __future__ import annotations

from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import attributes
from .. import status as documents
from ..diagnosis import turn_round
from ..errors import HexaLabError
from ..formats import FORMATS, read_bytes
from ..packing import jsonable, pack
from . import inspection, measuring, sources
from .buffers import Buffers, source_of
from .opened import DESCRIBED, Opened

__all__ = ["DESCRIBED", "Session"]

Result = dict[str, Any]

MESH_BOUND = ("camera", "filters")
"""Sections of the status that belong to a mesh: another one starts with their defaults."""


class Session:
    """One open mesh and its status.

    >>> session = Session()
    >>> summary = session.open("cube.mesh", data)                                    # doctest: +SKIP
    >>> session.update({"filters": {"peel": {"depth": 1}}})["shown_cells"]           # doctest: +SKIP
    """

    def __init__(self) -> None:
        self.status: Result = documents.merge(documents.DEFAULTS, {})
        self._opened: Opened | None = None
        self._buffers: Buffers | None = None

    # -- what there is

    def formats(self) -> list[Result]:
        """List the file formats: id, name, extensions, and whether they can be written."""
        return [
            {
                "id": row.id,
                "name": row.name,
                "extensions": list(row.extensions),
                "writable": row.writer is not None,
            }
            for row in FORMATS
        ]

    def schema(self) -> Result:
        """Return the JSON Schema of the status and its defaults."""
        return {"schema": documents.SCHEMA, "defaults": documents.DEFAULTS}

    # -- the mesh

    def open(self, name: str, data: bytes | memoryview) -> Result:
        """Open a mesh and do no more than the first picture needs.

        Camera, filters and the colour map's range become the defaults; the rest of the status stays.

        Raises
        ------
        MeshReadError
            If it can't be read; the mesh that was open stays open.
        """
        began = perf_counter()
        mesh = read_bytes(data, name)
        read = perf_counter()
        mesh = turn_round(mesh)
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
            "extent": mesh.extent.tolist(),
            "centre": mesh.centre.tolist(),
            "diagonal": mesh.diagonal,
            "notes": list(mesh.notes),
            "attributes": attributes.described(mesh),
            "max_depth": None,
        }
        summary["timings"] = {
            "read": 1000 * (read - began),
            "topology": 1000 * (topology - read),
            "summary": 1000 * (perf_counter() - topology),
        }
        self._opened, self._buffers = opened, Buffers(opened)
        defaults = {section: documents.DEFAULTS[section] for section in MESH_BOUND}
        identity = {"name": mesh.name, "sha256": "", "cells": mesh.cell_count}
        fresh = {**defaults, "colour": {"range": None}, "mesh": identity}
        self.status = documents.merge(self.status, fresh)
        if self._lacks_attribute(opened):
            self._colour_by_sides()
        return summary

    def identify(self, sha256: str) -> Result:
        """Note the SHA-256 of the open mesh's file; returns the status' identity of the mesh."""
        clean, problems = documents.check({"mesh": {"sha256": sha256}})
        if problems:
            raise HexaLabError(str(problems[0]))
        self.status = documents.merge(self.status, clean)
        identity: Result = self.status["mesh"]
        return identity

    def describe(self, part: str = "") -> Result:
        """Return the slow part of the summary.

        Parameters
        ----------
        part : str
            One of `DESCRIBED`, so that other calls can come between; all of them by default.

        Returns
        -------
        dict
            Facts as `hexalab.summarise` names them, `max_depth`, and `findings` with their severity.
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
            `partial`, `problems` (list of {path, found, expected}), `form`: "hexalab" or "original".
        """
        if isinstance(document, str):
            document = documents.parse(document)
        opened = self._opened
        form = "original" if documents.is_original(document) else "hexalab"
        known = opened.for_original() if opened and form == "original" else None
        partial, problems = documents.read(document, known)
        identity = {"mesh": partial["mesh"]} if "mesh" in partial else {}
        partial, unknown = sources.checked(partial, opened)
        told = [problem.as_dict() for problem in problems + unknown]
        return {"partial": {**partial, **identity}, "problems": told, "form": form}

    def update(self, status: Any = None, lean: bool = False) -> Result:
        """Apply a status or a part of one and return the buffers that changed.

        Parameters
        ----------
        status : dict or str, optional
            As in `check`; None changes nothing.
        lean : bool
            Leave out edges and silhouette, as for drafts while something moves; the next update that is not
            lean brings them.

        Returns
        -------
        dict
            `shown_cells`, `shown_faces`, `status` (complete), `problems`, `max_depth` (None until it is
            known), `plane_ranges` (extent of the barycentres along each plane's normal, in drawing
            coordinates), `pending` (buffers that wait for `describe`), `timings` (ms), and of `surface`,
            `silhouette`, `irregular`, `colour` those that changed.
        """
        began = perf_counter()
        opened, buffers = self._open_mesh(), self._buffers
        assert buffers is not None
        checked = self.check({} if status is None else status)
        partial = {name: part for name, part in checked["partial"].items() if name != "mesh"}
        self.status = documents.merge(self.status, partial)
        problems = checked["problems"]
        if self._lacks_attribute(opened):
            problems.append(sources.no_attribute(self.status["colour"], opened).as_dict())
            self._colour_by_sides()
        parts = buffers.update(self.status, lean)
        return {
            "shown_cells": int(np.count_nonzero(buffers.shown)),
            "shown_faces": buffers.shown_faces(),
            "status": self.status,
            "problems": problems,
            "max_depth": opened.max_depth(self.status["filters"]["peel"]["depth"] > 0),
            "plane_ranges": opened.plane_ranges(self.status["filters"]["planes"]),
            **parts,
            "timings": {**buffers.timings, "update": 1000 * (perf_counter() - began)},
        }

    def redraw(self) -> Result:
        """Return all buffers once more, as after a lost graphics context."""
        if self._buffers:
            self._buffers.forget()
        return self.update()

    def preview(self, status: Any = None) -> bytes:
        """Pack summary, status and buffers into one block of bytes: what the catalogue shows first."""
        opened, buffers = self._open_mesh(), self._buffers
        assert buffers is not None
        buffers.forget()
        drawn = self.update(status)
        mesh = opened.mesh
        frame = {"extent": mesh.extent.tolist(), "centre": mesh.centre.tolist(), "diagonal": mesh.diagonal}
        summary = {"name": mesh.name, "cells": mesh.cell_count, "vertices": mesh.vertex_count, **frame}
        names = ("shown_cells", "shown_faces", "status", "surface", "silhouette", "colour")
        return pack({"summary": summary, **{name: drawn[name] for name in names if name in drawn}})

    # -- quality

    def quality(self, source: str) -> Result:
        """Return the statistics of a metric or an attribute; see `measuring.statistics_of`."""
        return measuring.statistics_of(self._open_mesh(), source)

    def histogram(self, source: str, bins: int = 100, shown_only: bool = False) -> Result:
        """Count the values of a metric or an attribute in bins; see `measuring.histogram_of`."""
        opened, buffers = self._open_mesh(), self._buffers
        colour = self.status["colour"]
        limits = colour["range"] if source_of(colour) == source else None
        shown = buffers.shown if shown_only and buffers else None
        return measuring.histogram_of(opened, source, int(bins), shown, limits)

    def validity(self) -> Result:
        """Return how many cells are certified valid, invalid or undecided, and which are invalid."""
        state = self._open_mesh().validity.state
        counts = np.bincount(state, minlength=len(inspection.STATES))
        told = {name: int(number) for name, number in zip(inspection.STATES, counts, strict=True)}
        return {**told, "invalid_cells": np.flatnonzero(state == 0).astype(np.uint32)}

    # -- cells

    def inspect(self, cell: int) -> Result:
        """Tell everything about a cell; see `inspection.inspect`."""
        found: Result = jsonable(inspection.inspect(self._open_mesh(), self._cell(cell)))
        return found

    def cell_view(self, cell: int) -> Result:
        """Return a cell's centre and size in drawing coordinates."""
        return inspection.where(self._open_mesh().mesh, self._cell(cell))

    def neighbour(self, face_tag: int) -> int:
        """Return the cell behind a face (cell times 8 plus local face), -1 outside."""
        cell, local = divmod(int(face_tag), 8)
        topology = self._open_mesh().mesh.topology
        return int(topology.neighbours_of(np.array([self._cell(cell)]))[local, 0])

    def finding_cells(self, finding: str) -> NDArray[np.uint32]:
        """Return the cells that a finding of the diagnosis concerns, or those around its vertices."""
        opened = self._open_mesh()
        for found in opened.findings:
            if found.id == finding:
                return inspection.cells_of(opened.mesh, found)
        raise HexaLabError(f"the diagnosis found no {finding!r}")

    # -- within

    def _open_mesh(self) -> Opened:
        if self._opened is None:
            raise HexaLabError("no mesh is open")
        return self._opened

    def _cell(self, cell: int) -> int:
        count = self._open_mesh().mesh.cell_count
        if not 0 <= cell < count:
            raise HexaLabError(f"there is no cell {cell}: the mesh has {count} cells, numbered from 0")
        return int(cell)

    def _lacks_attribute(self, opened: Opened) -> bool:
        colour = self.status["colour"]
        return colour["by"] == "attribute" and colour["attribute"] not in opened.attributes

    def _colour_by_sides(self) -> None:
        self.status = documents.merge(self.status, {"colour": {"attribute": "", "by": "sides"}})
