"""Questions about the open mesh beside another, or beside a reference surface (SPEC S6, S7): a part of `Session`.

Each of two meshes that are compared has a session of its own. What the other must know of a mesh is handed over
(`hand_over`, `compare_with`) by whoever holds both sessions.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ..comparison import CHANGE, Counterpart, counterpart_of, fingerprint, moved, volume_of
from ..errors import HexaLabError, NoCellsError
from ..mesh import Mesh
from ..packing import jsonable
from ..quality import METRICS
from ..reference import TriangleSurface, boundary_of, faces_alone, read_reference_bytes
from .compared import ComparedBook
from .opened import Opened
from .picture import Picture

Result = dict[str, Any]
Block = bytes | bytearray | memoryview


class Comparing(ABC):
    """What a session is asked about two meshes, or a mesh and a reference surface."""

    _offers: Mapping[str, Callable[[], Mesh]]
    _surfaces: Mapping[str, Callable[[], TriangleSurface]]

    @abstractmethod
    def _open_mesh(self) -> Opened:
        """The open mesh; HexaLabError if there is none."""

    @abstractmethod
    def _drawn(self) -> Picture:
        """What was drawn of it last; HexaLabError if there is none."""

    def fingerprint(self) -> str:
        """Tell what is equal exactly for meshes of the same cells; see `hexalab.comparison.fingerprint`."""
        return fingerprint(self._open_mesh().mesh)

    def hand_over(self, to: str = "") -> Result:
        """Tell what a session of another mesh has to know of this one to compare it.

        Parameters
        ----------
        to : str
            The other mesh's `fingerprint`.

        Returns
        -------
        dict
            `name`, `vertices`, `cells`, `volume`, `points` ((3, n) float64) and `triangles` ((3, t) int32) of the
            boundary; and `coordinates` ((3, V) float64) if the cells are the same, else None.
        """
        mesh = self._open_mesh().mesh
        surface = boundary_of(mesh)
        same = to != "" and to == fingerprint(mesh)
        return {
            "name": mesh.name,
            "vertices": mesh.vertex_count,
            "cells": mesh.cell_count,
            "volume": volume_of(mesh),
            "points": surface.points,
            "triangles": surface.triangles,
            "coordinates": mesh.coordinates if same else None,
        }

    def compare_with(
        self,
        told: Result,
        points: Block,
        triangles: Block,
        coordinates: Block | None = None,
        second: bool = True,
    ) -> Result:
        """Compare the open mesh with another, of which a session has told.

        Parameters
        ----------
        told : dict
            `name`, `vertices`, `cells` and `volume` of the other.
        points, triangles, coordinates : bytes
            Arrays that it handed over; no coordinates where the cells are others.
        second : bool
            Whether the other is the second of both: changes are what the second has more.

        Returns
        -------
        dict
            See `ComparedBook.described`.
        """
        mesh, name, volume = self._open_mesh().mesh, str(told["name"]), told["volume"]
        surface = TriangleSurface(
            np.frombuffer(points, dtype=np.float64).reshape(3, -1),
            np.frombuffer(triangles, dtype=np.int32).reshape(3, -1),
            name=name,
        )
        if coordinates is not None:
            vertices = np.frombuffer(coordinates, dtype=np.float64).reshape(3, -1)
            same = moved(mesh, vertices, name)
            return self._begin_comparing(Counterpart(name, surface, same, "", second, volume))
        ours, theirs = (mesh.vertex_count, mesh.cell_count), (int(told["vertices"]), int(told["cells"]))
        difference = "cells with other corners"
        if ours != theirs:
            difference = f"{ours[0]:,} and {theirs[0]:,} vertices, {ours[1]:,} and {theirs[1]:,} cells"
        return self._begin_comparing(Counterpart(name, surface, None, difference, second, volume))

    def compare_with_offered(self, name: str, second: bool = True) -> Result:
        """Compare the open mesh with a mesh, or a reference surface, that whoever holds the session offers.

        Raises
        ------
        MeshReadError
            It can't be read; what was compared before stays.
        HexaLabError
            Nothing is offered by that name.
        """
        mesh = self._open_mesh().mesh
        if name in self._surfaces:
            return self._begin_comparing(counterpart_of(mesh, self._surfaces[name](), second))
        if name not in self._offers:
            raise HexaLabError(f"nothing is offered by the name of {name!r}")
        try:
            other: Mesh | TriangleSurface = self._offers[name]()
        except NoCellsError as found:
            other = faces_alone(found)
        return self._begin_comparing(counterpart_of(mesh, other, second))

    def compare_with_surface(
        self, name: str, data: Block, companions: Mapping[str, Block] | None = None
    ) -> Result:
        """Compare the open mesh with a reference surface: a file of triangles, or a mesh's boundary.

        Raises
        ------
        MeshReadError
            It can't be read; what was compared before stays.
        """
        surface = read_reference_bytes(data, name, companions)
        return self._begin_comparing(counterpart_of(self._open_mesh().mesh, surface))

    def _begin_comparing(self, counterpart: Counterpart) -> Result:
        opened = self._open_mesh()
        opened.compare(ComparedBook(opened.mesh, counterpart))
        self._drawn().forget()
        described: Result = jsonable(self._compared().described())
        return described

    def stop_comparing(self) -> None:
        """Forget what the open mesh was compared with."""
        self._open_mesh().compare(None)
        self._drawn().forget()

    def measure_distance(self, back: bool = False) -> Result:
        """Measure the distance of some more vertices, so that other questions can come between.

        Parameters
        ----------
        back : bool
            Whether the way back is wanted too, from the counterpart to the open mesh.

        Returns
        -------
        dict
            `done`, `of`: vertices. Ask again until all are done.
        """
        return self._compared().step(back)

    def distance_facts(self, back: bool = False, diagonal: float | None = None) -> Result:
        """Tell the distances; see `ComparedBook.distances`.

        Parameters
        ----------
        back : bool
        diagonal : float, optional
            What percents are of; the open mesh's own by default.
        """
        facts: Result = jsonable(self._compared().distances(back, diagonal))
        return facts

    def distance_csv(self) -> str:
        """Write the distances of the boundary's vertices as CSV."""
        return self._compared().csv()

    def metric_changes(self, metric: str) -> Result:
        """Count the cells at which a metric got worse; see `hexalab.comparison.change_counts`.

        Raises
        ------
        HexaLabError
            There is no such metric, or the cells are others.
        """
        if metric not in METRICS:
            raise HexaLabError(f"there is no metric {metric!r}; there are {', '.join(METRICS)}")
        values = self._open_mesh().values(CHANGE + metric)
        counts: Result = jsonable(self._compared().changes(metric, values))
        return counts

    def _compared(self) -> ComparedBook:
        book = self._open_mesh().compared
        if book is None:
            raise HexaLabError("the mesh is compared with nothing")
        return book
