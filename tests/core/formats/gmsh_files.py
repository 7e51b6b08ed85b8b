"""Meshes made by Gmsh, in a process of its own: its library and VTK's can't both be unloaded by one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.tools import needs


@dataclass
class Made:
    """What Gmsh knows of the mesh it wrote.

    Parameters
    ----------
    elements : dict of int to (n, k) array
        Node tags of each of its element types.
    points : dict of int to (3,) array
        Where each node is, by its tag.
    """

    elements: dict[int, Any]
    points: dict[int, Any]

    def count(self, kind: int) -> int:
        return len(self.elements.get(kind, ()))


@dataclass
class Opened:
    """What Gmsh finds in a file.

    Parameters
    ----------
    points : dict of int to (3,) array
        Where each node is, by its tag.
    cells : dict of int to tuple
        Of each volumetric element, by its tag: Gmsh's type, its node tags, smallest determinant of its Jacobian.
    physicals, partitions : dict of int to list of int
        The physical groups and partitions of each of them.
    entities : dict of int to int
        Its entity, of a partitioned one the parent.
    views : dict of str to (dict of int to list of float)
        Data by name, by tag.
    groups : dict of (int, int) to (str, list of int)
        Of each physical group, by its dimension and tag: its name, and the tags of its elements.
    lower : dict of int to list of int
        Node tags of each element of lower dimension, by its tag.
    """

    points: dict[int, Any]
    cells: dict[int, tuple[int, list[int], float]]
    physicals: dict[int, list[int]]
    partitions: dict[int, list[int]]
    entities: dict[int, int]
    views: dict[str, dict[int, list[float]]]
    groups: dict[tuple[int, int], tuple[str, list[int]]]
    lower: dict[int, list[int]]


@dataclass(frozen=True)
class File:
    """A file to write, under these options of Gmsh."""

    path: Path
    options: Sequence[tuple[str, float]] = ()


def make(
    *files: File,
    wedges: bool = True,
    order: int = 1,
    gaps: bool = False,
    partitions: int = 0,
    named: bool = False,
) -> Made:
    """A unit cube of hexahedra, and on request a prism of wedges beside it, written to each of the files.

    Volumes are in the physical groups 7 and 9. With `gaps`, node tags are 1007, 1014, ... Where it is `named`, the
    groups have names, both volumes are in a third, and there are groups of surfaces, of curves and of a point.
    """
    return _alone(_make, files, wedges, order, gaps, partitions, named)


def opened(path: Path, script: str = "", saved: Path | None = None) -> Opened:
    """What Gmsh finds in a file, after a script was run; the outcome may be saved."""
    return _alone(_opened, path, script, saved)


def _alone(function: Callable[..., Any], *arguments: Any) -> Any:
    """The function's result, from a process of its own."""
    needs("gmsh")
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(function, *arguments).result()


def _make(files: Sequence[File], wedges: bool, order: int, gaps: bool, partitions: int, named: bool) -> Made:
    import gmsh

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
        if named:
            gmsh.model.setPhysicalName(3, 7, "rock")
            gmsh.model.setPhysicalName(3, 9, "steel, hard")
            gmsh.model.addPhysicalGroup(3, cube + prism, 11, "all")
            gmsh.model.addPhysicalGroup(2, [1], 7, "floor")
            sides = [tag for _, tag in gmsh.model.getBoundary([(3, cube[0])], oriented=False)]
            gmsh.model.addPhysicalGroup(2, sides, 8, "skin")
            gmsh.model.addPhysicalGroup(1, [1, 3], 2, "rim")
            gmsh.model.addPhysicalGroup(0, [1], 1, "origin")
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        if gaps:
            tags, _, _ = gmsh.model.mesh.getNodes()
            gmsh.model.mesh.renumberNodes(tags.tolist(), (tags * 7 + 1000).tolist())
        if partitions:
            gmsh.model.mesh.partition(partitions)
        for file in files:
            for name, value in file.options:
                gmsh.option.setNumber(name, value)
            gmsh.write(str(file.path))
        return _told(gmsh)
    finally:
        gmsh.finalize()


def _told(gmsh: Any) -> Made:
    tags, points, _ = gmsh.model.mesh.getNodes()
    elements = {}
    for kind in gmsh.model.mesh.getElementTypes():
        numbers, nodes = gmsh.model.mesh.getElementsByType(kind)
        elements[int(kind)] = np.asarray(nodes).reshape(len(numbers), -1)
    return Made(elements, dict(zip(map(int, tags), np.reshape(points, (-1, 3)), strict=True)))


def _opened(path: Path, script: str, saved: Path | None) -> Opened:
    import gmsh

    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        exec(script, {"gmsh": gmsh})
        if saved:
            gmsh.write(str(saved))
        found = Opened(_told(gmsh).points, {}, {}, {}, {}, {}, {}, {})
        for dimension, group in gmsh.model.getPhysicalGroups():
            members = []
            for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, group):
                for tags in gmsh.model.mesh.getElements(dimension, entity)[1]:
                    members += tags.tolist()
            name = gmsh.model.getPhysicalName(dimension, group)
            found.groups[dimension, group] = (name, sorted(members))
        for dimension in range(3):
            for kind, tags, nodes in zip(*gmsh.model.mesh.getElements(dimension), strict=True):
                del kind
                rows = np.asarray(nodes).reshape(len(tags), -1).tolist()
                found.lower.update(zip(tags.tolist(), rows, strict=True))
        for dimension, entity in gmsh.model.getEntities(3):
            groups = [int(group) for group in gmsh.model.getPhysicalGroupsForEntity(dimension, entity)]
            parts = [int(part) for part in gmsh.model.getPartitions(dimension, entity)]
            parent = gmsh.model.getParent(dimension, entity)
            own = int(parent[1]) if parent[0] == 3 else int(entity)
            for kind, tags, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity), strict=True):
                rows = np.asarray(nodes).reshape(len(tags), -1).tolist()
                sizes = gmsh.model.mesh.getElementQualities(tags, "minDetJac")
                for tag, row, size in zip(tags.tolist(), rows, sizes.tolist(), strict=True):
                    found.cells[tag] = (int(kind), row, size)
                    found.physicals[tag], found.partitions[tag], found.entities[tag] = groups, parts, own
        for view in gmsh.view.getTags():
            _, tags, values, _, _ = gmsh.view.getModelData(view, 0)
            name = gmsh.view.option.getString(view, "Name")
            found.views[name] = {
                int(tag): list(map(float, row)) for tag, row in zip(tags, values, strict=True)
            }
        return found
    finally:
        gmsh.finalize()
