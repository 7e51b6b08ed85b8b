"""Writes Gmsh `.msh` 4.1 and 2.2, ASCII (Gmsh reference manual, "MSH file format").

Cells keep their order and their numbers. The attributes "physical", "entity" and "partition" become what they are in
the format (4.1 has no place for partitions without their topology); others become $NodeData and $ElementData.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..mesh import Mesh
from .writing import formatted, numbers_written, own_corners, runs

LARGEST_NUMBER = 2**31 - 1
TYPES = (5, 6, 7, 4)
"""Gmsh's element type for each kind."""

WIDTHS = (1, 3, 9)
"""How many components values may have."""

VOLUME = 3
"""Dimension of the entities that cells belong to."""


def write_2(mesh: Mesh) -> bytes:
    """The bytes of a `.msh` file of version 2.2."""
    nodes, elements = numbers(mesh)
    _, entities = entities_of(mesh)
    physicals, partitions = owners(mesh, "physical"), owners(mesh, "partition")
    parts = [b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", f"$Nodes\n{mesh.vertex_count}\n".encode()]
    parts += formatted("%d %r %r %r\n", [nodes, *mesh.coordinates])
    parts.append(f"$EndNodes\n$Elements\n{mesh.cell_count}\n".encode())
    tags = [physicals, entities, np.ones_like(partitions), partitions][: 4 if partitions.any() else 2]
    for which in runs(mesh.kinds):
        kind = int(mesh.kinds[which.start])
        corners = [nodes[corner] for corner in own_corners(mesh, kind, which)]
        columns = [elements[which], *(tag[which] for tag in tags), *corners]
        row = f"%d {TYPES[kind]} {len(tags)} " + " ".join(["%d"] * (len(columns) - 1)) + "\n"
        parts += formatted(row, columns)
    return b"".join([*parts, b"$EndElements\n", *values(mesh, nodes, elements, ("partition",))])


def write_4(mesh: Mesh) -> bytes:
    """The bytes of a `.msh` file of version 4.1: a block for each run of cells of one kind and entity."""
    nodes, elements = numbers(mesh)
    tags, of_cells = entities_of(mesh)
    low, high = (edge(mesh.coordinates, axis=1, initial=0).tolist() for edge in (np.min, np.max))
    box = " ".join(map(repr, [*low, *high]))
    parts = [b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", f"$Entities\n0 0 0 {len(tags)}\n".encode()]
    parts += [f"{tag} {box} {f'1 {physical}' if physical else '0'} 0\n".encode() for tag, physical in tags]
    count, most = mesh.vertex_count, int(nodes.max(initial=0))
    parts.append(f"$EndEntities\n$Nodes\n1 {count} {int(nodes.min(initial=1))} {most}\n".encode())
    parts.append(f"{VOLUME} {tags[0][0] if tags else 1} 0 {count}\n".encode())
    parts += formatted("%d\n", [nodes]) + formatted("%r %r %r\n", [*mesh.coordinates])
    blocks = list(runs(mesh.kinds, of_cells))
    least, most = int(elements.min(initial=1)), int(elements.max(initial=0))
    parts.append(f"$EndNodes\n$Elements\n{len(blocks)} {mesh.cell_count} {least} {most}\n".encode())
    for which in blocks:
        kind, size = int(mesh.kinds[which.start]), which.stop - which.start
        parts.append(f"{VOLUME} {of_cells[which.start]} {TYPES[kind]} {size}\n".encode())
        columns = [elements[which], *(nodes[corner] for corner in own_corners(mesh, kind, which))]
        parts += formatted(" ".join(["%d"] * len(columns)) + "\n", columns)
    return b"".join([*parts, b"$EndElements\n", *values(mesh, nodes, elements, ())])


def numbers(mesh: Mesh) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Numbers of nodes and of elements."""
    return (
        numbers_written(mesh.vertex_numbers, mesh.vertex_count, LARGEST_NUMBER),
        numbers_written(mesh.cell_numbers, mesh.cell_count, LARGEST_NUMBER),
    )


def is_owner(mesh: Mesh, name: str) -> bool:
    """Whether the attribute of cells can be what cells belong to: an int32, not negative."""
    found = mesh.cell_data.get(name)
    if found is None or found.ndim != 1 or found.dtype.kind not in "iu" or not len(found):
        return False
    return bool(found.min() >= 0 and found.max() <= LARGEST_NUMBER)


def owners(mesh: Mesh, name: str) -> NDArray[np.int64]:
    """(C,) what each cell belongs to, 0 where it is not known."""
    if not is_owner(mesh, name):
        return np.zeros(mesh.cell_count, np.int64)
    return mesh.cell_data[name].astype(np.int64)


def entities_of(mesh: Mesh) -> tuple[list[tuple[int, int]], NDArray[np.int64]]:
    """Tags of the volumes with their physical group (0 for none), and (C,) the tag of each cell's volume.

    A volume has its tag from the file where that is there and has one group alone; else they are counted.
    """
    pairs = np.stack([owners(mesh, "entity"), owners(mesh, "physical")])
    known, inverse = np.unique(pairs, axis=1, return_inverse=True)
    tags = known[0]
    if (tags < 1).any() or len(np.unique(tags)) < len(tags):
        tags = np.arange(1, len(tags) + 1)
    return list(zip(tags.tolist(), known[1].tolist(), strict=True)), tags[inverse.reshape(-1)]


def values(mesh: Mesh, nodes: Array, elements: Array, kept: tuple[str, ...]) -> Iterator[bytes]:
    """The sections of values, but for the attributes that say what cells belong to."""
    as_owners = {name for name in ("physical", "entity", *kept) if is_owner(mesh, name)}
    for section, tags, data in (
        ("NodeData", nodes, mesh.point_data),
        ("ElementData", elements, {k: v for k, v in mesh.cell_data.items() if k not in as_owners}),
    ):
        for name, array in data.items():
            table = array.reshape(len(array), -1).astype(np.float64)
            if table.shape[1] not in WIDTHS:
                continue
            title = name.replace('"', "'").replace("\n", " ").replace("\r", " ")
            head = f'${section}\n1\n"{title}"\n1\n0.0\n3\n0\n{table.shape[1]}\n{len(table)}\n'
            yield head.encode()
            yield from formatted("%d" + " %r" * table.shape[1] + "\n", [tags, *table.T])
            yield f"$End{section}\n".encode()


def keeps(_on: str, _name: str, array: Array) -> bool:
    """Whether an attribute has a place: one, three or nine components, whole numbers no larger than 2^53."""
    width = array.size // len(array) if len(array) else 1
    exact = (
        array.dtype.kind not in "iu" or not array.size or float(np.abs(array.astype(float)).max()) <= 2.0**53
    )
    return width in WIDTHS and exact
