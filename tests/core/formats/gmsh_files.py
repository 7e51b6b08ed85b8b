"""Meshes made by Gmsh."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import gmsh


@contextmanager
def extruded(wedges: bool = True, order: int = 1) -> Iterator[None]:
    """A unit cube of hexahedra, and on request a prism of wedges beside it, as Gmsh's current model.

    Volumes are in the physical groups 7 and 9.
    """
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.SaveAll", 1)
        geometry = gmsh.model.geo
        for number, (x, y) in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)]):
            geometry.addPoint(x, y, 0, 0.4, number + 1)
        for number in range(4):
            geometry.addLine(number + 1, (number + 1) % 4 + 1, number + 1)
        geometry.addCurveLoop([1, 2, 3, 4], 1)
        geometry.addPlaneSurface([1], 1)
        geometry.mesh.setTransfiniteSurface(1)
        geometry.mesh.setRecombine(2, 1)
        cube = [
            tag
            for dimension, tag in geometry.extrude([(2, 1)], 0, 0, 1, [3], recombine=True)
            if dimension == 3
        ]
        prism = []
        if wedges:
            corners = [geometry.addPoint(x, y, 0, 0.4) for x, y in ((3, 0), (4, 0), (3, 1))]
            lines = [geometry.addLine(corners[a], corners[(a + 1) % 3]) for a in range(3)]
            surface = geometry.addPlaneSurface([geometry.addCurveLoop(lines)])
            made = geometry.extrude([(2, surface)], 0, 0, 1, [2], recombine=True)
            prism = [tag for dimension, tag in made if dimension == 3]
        geometry.synchronize()
        gmsh.model.addPhysicalGroup(3, cube, 7)
        if prism:
            gmsh.model.addPhysicalGroup(3, prism, 9)
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        yield
    finally:
        gmsh.finalize()
