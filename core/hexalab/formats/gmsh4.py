"""Nodes, elements and entities of `.msh` 4.1: blocks, one for each entity of the geometry."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .assembly import Assembly
from .byte_order import as_coordinates
from .gmsh_numbers import Numbers
from .gmsh_parts import NODES_OF_TYPE, Elements, Nodes, own_corners


class Gmsh4:
    """Reads the sections of a version 4.1 file."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers = numbers
        self.physical_of_volume: dict[int, int] = {}

    def header(self, what: str) -> tuple[int, int]:
        """Number of blocks and of entries."""
        self.numbers.begin()
        blocks, entries = self.numbers.sizes(4, what).tolist()[:2]
        return self.numbers.count(blocks, 8, "blocks"), self.numbers.count(entries, 1, what)

    def block(self, what: str) -> list[int]:
        """The four numbers that a block begins with; the last is its number of entries."""
        first = self.numbers.ints(3, what).tolist()
        (count,) = self.numbers.sizes(1, what).tolist()
        return [*first, self.numbers.count(count, 1, what)]

    def nodes(self) -> Nodes:
        """Read what follows `$Nodes`: blocks of numbers, then of coordinates; parametric ones are dropped.

        Raises
        ------
        MeshReadError
            The blocks hold another number of nodes than announced.
        """
        numbers = self.numbers
        blocks, total = self.header("nodes")
        tags: list[NDArray[Any]] = [np.empty(0, dtype=np.int64)]
        points: list[NDArray[Any]] = [np.empty((3, 0))]
        for _ in range(blocks):
            dimension, _, parametric, count = self.block("nodes")
            tags.append(numbers.sizes(count, "$Nodes").astype(np.int64))
            width = 3 + (max(0, min(dimension, 3)) if parametric else 0)
            points.append(numbers.doubles(count * width, "$Nodes").reshape(count, width)[:, :3].T)
        nodes = Nodes(np.concatenate(tags), as_coordinates(np.concatenate(points, axis=1).T))
        if len(nodes.tags) != total:
            raise numbers.error(f"$Nodes has {len(nodes.tags)} nodes, but announces {total}")
        return nodes

    def elements(self, out: Assembly) -> list[Elements]:
        """Read what follows `$Elements`, a block per entity and type; what isn't volumetric is counted in `out`.

        Raises
        ------
        MeshReadError
            A type has no fixed number of nodes, or the blocks hold another number of elements than announced.
        """
        numbers = self.numbers
        begin = numbers.text.position
        blocks, total = self.header("elements")
        found, parts = 0, []
        for _ in range(blocks):
            start = numbers.text.position
            dimension, entity, number, count = self.block("elements")
            size = int(NODES_OF_TYPE[number]) if 0 <= number < len(NODES_OF_TYPE) else 0
            if not size:
                raise numbers.error(
                    f"elements of type {number} were found, which has no fixed number of nodes", start
                )
            rows = numbers.sizes(count * (1 + size), "$Elements").reshape(count, 1 + size)
            own = own_corners(out, number, count)
            found += count
            if own is None:
                continue
            kind, order = own
            corners = np.stack([rows[:, 1 + corner] for corner in order])
            physical = self.physical_of_volume.get(entity, 0) if dimension == 3 else 0
            parts.append(
                Elements(
                    kind,
                    corners.astype(np.int64),
                    rows[:, 0].astype(np.int64),
                    np.full(count, entity, dtype=np.int32),
                    np.full(count, physical, dtype=np.int32),
                    np.arange(found - count, found),
                    begin,
                )
            )
        if found != total:
            raise numbers.error(f"$Elements has {found} elements, but announces {total}", begin)
        return parts

    def entities(self) -> None:
        """Read which physical group each volume belongs to."""
        numbers = self.numbers
        numbers.begin()
        counts = [numbers.count(count, 4, "entities") for count in numbers.sizes(4, "$Entities").tolist()]
        for dimension, count in enumerate(counts):
            for _ in range(count):
                (tag,) = numbers.ints(1, "$Entities").tolist()
                numbers.doubles(6 if dimension else 3, "$Entities")
                groups = self.tags()
                if dimension:
                    self.tags()
                if dimension == 3 and groups:
                    self.physical_of_volume[tag] = abs(groups[0])

    def tags(self) -> list[int]:
        """A counted list of ints."""
        (count,) = self.numbers.sizes(1, "$Entities").tolist()
        return [int(n) for n in self.numbers.ints(self.numbers.count(count, 1, "tags"), "$Entities")]
