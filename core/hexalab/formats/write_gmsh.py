"""Writes Gmsh `.msh` 4.1 and 2.2, ASCII (Gmsh reference manual, "MSH file format").

Cells keep their order and their numbers; features follow them. Groups become physical groups. The attributes
"physical", "entity" and "partition" become what they are in the format (4.1 has no place for partitions without their
topology); others become $NodeData and $ElementData.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from ..mesh import Mesh
from .gmsh_entities import LARGEST_NUMBER, Owners, is_owner, owners, physical_groups, whole_owner
from .vtk_grid import parted
from .writing import formatted, numbers_written, own_corners, runs

TYPES = (5, 6, 7, 4)
"""Gmsh's element type for each kind."""

TYPES_OF_FEATURES = {1: 15, 2: 1, 3: 2, 4: 3}
"""Gmsh's element type of features with so many corners."""

WIDTHS = (1, 3, 9)
"""How many components values may have."""

VOLUME = 3
"""Dimension of the entities that cells belong to."""


@dataclass
class Block:
    """Elements of one type and one dimension: (n,) rows among those of it, their numbers, (k, n) node numbers."""

    owners: Owners
    type: int
    rows: Array
    numbers: Array
    nodes: list[Array]


def write_2(mesh: Mesh) -> bytes:
    """The bytes of a `.msh` file of version 2.2."""
    nodes, elements = numbers(mesh)
    partitions = whole_owner(mesh, "partition")
    belong = owners(mesh)
    blocks = list(blocks_of(mesh, belong, nodes, elements))
    count = sum(len(block.rows) for block in blocks)
    parts = [b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", *names(belong)]
    parts.append(f"$Nodes\n{mesh.vertex_count}\n".encode())
    parts += formatted("%d %r %r %r\n", [nodes, *mesh.coordinates])
    parts.append(f"$EndNodes\n$Elements\n{count}\n".encode())
    for block in blocks:
        own = block.owners
        tags = [own.first[block.rows], own.entities[block.rows]]
        if own.dimension == VOLUME and partitions.any():
            tags += [np.ones(len(block.rows), np.int64), partitions[block.rows]]
        columns = [block.numbers, *tags, *block.nodes]
        row = f"%d {block.type} {len(tags)} " + " ".join(["%d"] * (len(columns) - 1)) + "\n"
        parts += formatted(row, columns)
    return b"".join([*parts, b"$EndElements\n", *values(mesh, nodes, elements, ("partition",))])


def write_4(mesh: Mesh) -> bytes:
    """The bytes of a `.msh` file of version 4.1: a block for each run of elements of one type and entity."""
    nodes, elements = numbers(mesh)
    belong = owners(mesh)
    blocks = [
        Block(block.owners, block.type, block.rows[part], block.numbers[part], [n[part] for n in block.nodes])
        for block in blocks_of(mesh, belong, nodes, elements)
        for part in runs(block.owners.entities[block.rows])
    ]
    parts = [b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", *names(belong), *entities(mesh, belong)]
    count, most = mesh.vertex_count, int(nodes.max(initial=0))
    parts.append(f"$Nodes\n1 {count} {int(nodes.min(initial=1))} {most}\n".encode())
    parts.append(f"{VOLUME} {next(iter(belong[0].physicals), 1)} 0 {count}\n".encode())
    parts += formatted("%d\n", [nodes]) + formatted("%r %r %r\n", [*mesh.coordinates])
    total = sum(len(block.rows) for block in blocks)
    ends = [int(block.numbers.max()) for block in blocks]
    least = min((int(block.numbers.min()) for block in blocks), default=1)
    parts.append(f"$EndNodes\n$Elements\n{len(blocks)} {total} {least} {max(ends, default=0)}\n".encode())
    for block in blocks:
        own, size = block.owners, len(block.rows)
        parts.append(f"{own.dimension} {own.entities[block.rows[0]]} {block.type} {size}\n".encode())
        columns = [block.numbers, *block.nodes]
        parts += formatted(" ".join(["%d"] * len(columns)) + "\n", columns)
    return b"".join([*parts, b"$EndElements\n", *values(mesh, nodes, elements, ())])


def blocks_of(mesh: Mesh, belong: list[Owners], nodes: Array, elements: Array) -> Iterator[Block]:
    """Cells in runs of one kind, then features, numbered on from the cells."""
    for which in runs(mesh.kinds):
        kind = int(mesh.kinds[which.start])
        corners = [nodes[corner] for corner in own_corners(mesh, kind, which)]
        yield Block(belong[0], TYPES[kind], np.arange(which.start, which.stop), elements[which], corners)
    following = int(elements.max(initial=0)) + 1
    for features, own in zip(mesh.features, belong[1:], strict=True):
        for part, size in parted(features):
            part = part[np.argsort(own.entities[part], kind="stable")]
            tags = np.arange(following, following + len(part))
            following += len(part)
            yield Block(own, TYPES_OF_FEATURES[size], part, tags, [*nodes[features.corners[:size, part]]])


def names(belong: list[Owners]) -> list[bytes]:
    """The section of the names of physical groups; nothing if none has one."""
    rows = [
        f'{own.dimension} {tag} "{name}"\n'.encode()
        for own in sorted(belong, key=lambda own: own.dimension)
        for tag, name in own.names.items()
    ]
    return [f"$PhysicalNames\n{len(rows)}\n".encode(), *rows, b"$EndPhysicalNames\n"] if rows else []


def entities(mesh: Mesh, belong: list[Owners]) -> list[bytes]:
    """The section of the entities of all four dimensions; their box is the mesh's, their boundary not known."""
    low, high = (edge(mesh.coordinates, axis=1, initial=0).tolist() for edge in (np.min, np.max))
    of_dimension = {own.dimension: own for own in belong}
    counts = [len(of_dimension[d].physicals) if d in of_dimension else 0 for d in range(4)]
    parts = [("$Entities\n" + " ".join(map(str, counts)) + "\n").encode()]
    for dimension in range(4):
        if dimension not in of_dimension:
            continue
        box = " ".join(map(repr, [*low, *high] if dimension else low))
        for tag, physicals in of_dimension[dimension].physicals.items():
            belongs = " ".join(map(str, [len(physicals), *physicals]))
            parts.append(f"{tag} {box} {belongs}{' 0' if dimension else ''}\n".encode())
    return [*parts, b"$EndEntities\n"]


def numbers(mesh: Mesh) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Numbers of nodes and of elements."""
    return (
        numbers_written(mesh.vertex_numbers, mesh.vertex_count, LARGEST_NUMBER),
        numbers_written(mesh.cell_numbers, mesh.cell_count, LARGEST_NUMBER),
    )


def values(mesh: Mesh, nodes: Array, elements: Array, kept: tuple[str, ...]) -> Iterator[bytes]:
    """The sections of values, but for the attributes that say what cells belong to."""
    as_owners = {name for name in ("entity", *kept) if is_owner(mesh, name)}
    if any(group.origin == "physical" for group in physical_groups(mesh)):
        as_owners.add("physical")
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
