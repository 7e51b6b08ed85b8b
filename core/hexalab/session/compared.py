"""What the open mesh is compared with, and what was measured of both."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from ..arrays import Floats
from ..comparison import (
    DISTANCE,
    Counterpart,
    Measuring,
    cellwise_values,
    change_counts,
    displacement_facts,
    largest_of_corners,
    surface_facts,
    volume_of,
    volume_ratio,
)
from ..comparison.quantities import QUANTITIES
from ..errors import HexaLabError
from ..mesh import Mesh
from ..numbering import vertex_numbers
from ..reference import boundary_of
from ..surface import Frame, Silhouette, extract_reference


class ComparedBook:
    """An open mesh beside its counterpart.

    Parameters
    ----------
    mesh : Mesh
    counterpart : Counterpart
    """

    def __init__(self, mesh: Mesh, counterpart: Counterpart) -> None:
        self.mesh = mesh
        self.counterpart = counterpart

    @cached_property
    def measuring(self) -> Measuring:
        """The way from the mesh's boundary to the counterpart."""
        return Measuring(boundary_of(self.mesh), self.counterpart.index)

    @cached_property
    def back(self) -> Measuring:
        """The way back from the counterpart to the mesh's boundary."""
        return self.measuring.turned(self.counterpart.surface)

    def step(self, back: bool) -> dict[str, Any]:
        """Measure some more distances, there and then, if they are wanted, `back`: `done`, `of` how many vertices."""
        ways = [self.measuring, self.back] if back else [self.measuring]
        for way in ways:
            if way.done < way.count:
                way.step()
                break
        return {"done": sum(way.done for way in ways), "of": sum(way.count for way in ways)}

    def distances(self, back: bool, diagonal: float | None) -> dict[str, Any]:
        """Tell the distances: `there`, and `back`, None if it is not wanted; see `Measuring.facts`."""
        scale = self.mesh.diagonal if diagonal is None else diagonal
        return {
            "there": self.measuring.finish().facts(scale),
            "back": self.back.finish().facts(scale) if back else None,
        }

    def values(self, quantity: str) -> Floats:
        """(C,) float64: a quantity of `hexalab.comparison.QUANTITIES`.

        Raises
        ------
        HexaLabError
            It needs the same cells in both, and they are others.
        """
        if quantity == DISTANCE:
            return largest_of_corners(self.of_vertices, self.mesh.corners)
        if self.counterpart.mesh is None:
            raise HexaLabError(
                f"{QUANTITIES[quantity].name} can't be told: {self.counterpart.name} has not the same cells"
            )
        return cellwise_values(self.mesh, self.counterpart, quantity)

    @property
    def of_vertices(self) -> Floats:
        """(V,) float64: distance of each vertex of the boundary; NaN inside."""
        return self.measuring.finish().of_vertices(self.mesh.vertex_count)

    def described(self) -> dict[str, Any]:
        """Tell what it is compared with.

        Returns
        -------
        dict
            `name`, `same_cells`, `difference` (what tells the cells apart; "" for a reference surface), `surface` (see
            `surface_facts`, of a reference surface; None of a mesh), `displacement` (see `displacement_facts`; None
            where the cells are others), `diagonal` (of the mesh's extent), `volume_ratio` (second over first).
        """
        other = self.counterpart
        volumes = volume_of(self.mesh), other.volume
        way = other.displacement(self.mesh) if other.mesh is not None else None
        return {
            "name": other.name,
            "same_cells": way is not None,
            "difference": other.difference,
            "surface": surface_facts(other.surface) if other.is_surface else None,
            "displacement": None if way is None else displacement_facts(way, self.mesh.diagonal),
            "diagonal": self.mesh.diagonal,
            "volume_ratio": volume_ratio(*(volumes if other.second else volumes[::-1])),
        }

    def changes(self, metric: str, values: Floats) -> dict[str, Any]:
        """Count the cells at which a metric got worse; see `change_counts`."""
        return change_counts(self.mesh, metric, values)

    def drawn(self, frame: Frame) -> Silhouette:
        """The counterpart's surface, in drawing coordinates of the mesh."""
        surface = self.counterpart.surface
        return extract_reference(surface.points, surface.triangles, frame)

    def csv(self) -> str:
        """The distances as CSV: number and place of each vertex of the boundary, and how far it is away."""
        measuring = self.measuring.finish()
        rows = measuring.rows
        numbers = vertex_numbers(self.mesh, rows)
        columns: Sequence[Any] = (numbers.tolist(), *self.mesh.coordinates[:, rows].tolist())
        told = zip(*columns, measuring.distances.tolist(), strict=True)
        return "vertex,x,y,z,distance\n" + "".join(",".join(map(repr, row)) + "\n" for row in told)
