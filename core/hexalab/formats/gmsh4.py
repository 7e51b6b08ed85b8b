"""Nodes, elements and entities of `.msh` 4.1 and 4.0: blocks, one for each entity of the geometry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .assembly import Assembly
from .byte_order import as_coordinates, native
from .gmsh_numbers import Numbers
from .gmsh_parts import NODES_OF_TYPE, Elements, Nodes, own_corners
from .ids import whole_tags

SEVERAL = "A volume belongs to several physical groups: the attribute “physical” names the first."


class Entity(NamedTuple):
    """What the elements of an entity belong to: physical groups, the whole entity, partition; 0 for none."""

    physicals: tuple[int, ...]
    entity: int
    partition: int = 0


@dataclass(frozen=True)
class Layout:
    """In what the two versions differ.

    Parameters
    ----------
    numbers_of_entity : (2,) of int
        Where a block's first two numbers have the entity's dimension and its number.
    header : int
        How many sizes stand before the first block: blocks, entries, smallest and largest number.
    box_of_point : int
        How many numbers say where a point of the geometry is.
    tags_apart : bool
        Whether all numbers of a block's nodes stand before their coordinates.
    tag : str
        The binary type of an entry's number, without byte order; "" for the file's size_t.
    """

    numbers_of_entity: tuple[int, int]
    header: int
    box_of_point: int
    tags_apart: bool
    tag: str


LAYOUTS = {
    "4.1": Layout((0, 1), 4, 3, True, ""),
    "4.0": Layout((1, 0), 2, 6, False, "i4"),
}


class Gmsh4:
    """Reads the sections of a version 4 file.

    Parameters
    ----------
    numbers : Numbers
        The file.
    out : Assembly
        Gets notes and what is left out.
    layout : Layout
        That of its version.
    """

    def __init__(self, numbers: Numbers, out: Assembly, layout: Layout) -> None:
        self.numbers = numbers
        self.out = out
        self.layout = layout
        self.entity_of: dict[tuple[int, int], Entity] = {}

    def header(self, what: str) -> tuple[int, int]:
        """Number of blocks and of entries."""
        self.numbers.begin()
        blocks, entries = self.numbers.sizes(self.layout.header, what).tolist()[:2]
        return self.numbers.count(blocks, 8, "blocks"), self.numbers.count(entries, 1, what)

    def block(self, what: str) -> tuple[int, int, int, int]:
        """What a block begins with: dimension and number of its entity, a number, and its number of entries."""
        first = self.numbers.ints(3, what).tolist()
        (count,) = self.numbers.sizes(1, what).tolist()
        dimension, entity = (first[place] for place in self.layout.numbers_of_entity)
        return dimension, entity, first[2], self.numbers.count(count, 1, what)

    def nodes(self) -> Nodes:
        """Read what follows `$Nodes`: blocks of numbers and coordinates; parametric ones are dropped."""
        blocks, total = self.header("nodes")
        tags: list[NDArray[Any]] = [np.empty(0, dtype=np.int64)]
        points: list[NDArray[Any]] = [np.empty((3, 0))]
        for _ in range(blocks):
            dimension, _, parametric, count = self.block("nodes")
            width = 3 + (max(0, min(dimension, 3)) if parametric else 0)
            own, place = (self.nodes_apart if self.layout.tags_apart else self.node_rows)(count, width)
            tags.append(own)
            points.append(place.T)
        nodes = Nodes(np.concatenate(tags), as_coordinates(np.concatenate(points, axis=1).T))
        if len(nodes.tags) != total:
            # so Gmsh itself writes a mesh whose elements were moved to another entity
            self.out.note(f"$Nodes announces {total:,} nodes and has {len(nodes.tags):,}, which are read.")
        return nodes

    def nodes_apart(self, count: int, width: int) -> tuple[Array, Array]:
        """(count,) numbers, then (count, 3) coordinates out of rows of `width`."""
        tags = self.numbers.sizes(count, "$Nodes").astype(np.int64)
        return tags, self.numbers.doubles(count * width, "$Nodes").reshape(count, width)[:, :3]

    def node_rows(self, count: int, width: int) -> tuple[Array, Array]:
        """The same out of rows of a number and coordinates."""
        numbers = self.numbers
        if not numbers.binary:
            rows = numbers.doubles(count * (1 + width), "$Nodes").reshape(count, 1 + width)
            tags = whole_tags(rows[:, 0])
            if tags is None:
                raise numbers.error("a node of $Nodes has a number that is not whole")
            return tags, rows[:, 1:4]
        dtype = np.dtype([("tag", numbers.order + self.layout.tag), ("x", numbers.order + "f8", (width,))])
        packed = np.frombuffer(numbers.bytes(count * dtype.itemsize, "$Nodes"), dtype)
        return native(packed["tag"]).astype(np.int64), packed["x"][:, :3].astype(np.float64)

    def elements(self) -> list[Elements]:
        """Read what follows `$Elements`, a block per entity and type.

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
            rows = numbers.take(
                count * (1 + size), self.layout.tag or numbers.size_code, "$Elements"
            ).reshape(count, 1 + size)
            own_dimension, kind, order = own_corners(self.out, number, count)
            found += count
            corners = np.stack([rows[:, 1 + corner] for corner in order]).astype(np.int64)
            owner = self.entity_of.get((dimension, entity), Entity((), entity))
            first, *others = owner.physicals or (0,)
            entities, physicals, partitions = (
                np.full(count, value) for value in (owner.entity, first, owner.partition)
            )
            tags, ordinals = rows[:, 0].astype(np.int64), np.arange(found - count, found)
            parts.append(
                Elements(
                    own_dimension, kind, corners, tags, entities, physicals, partitions, ordinals, begin,
                    tuple(others),
                )
            )  # fmt: skip
        if found != total:
            raise numbers.error(f"$Elements has {found} elements, but announces {total}", begin)
        return parts

    def entities(self) -> None:
        """Read which physical groups each entity belongs to."""
        self.numbers.begin()
        self.each_entity("$Entities", False)

    def partitioned_entities(self) -> None:
        """Read which physical groups, entity and partition each part of an entity belongs to."""
        numbers, what = self.numbers, "$PartitionedEntities"
        numbers.begin()
        numbers.sizes(1, what)
        (ghosts,) = numbers.sizes(1, what).tolist()
        numbers.ints(2 * numbers.count(ghosts, 2, "ghost entities"), what)
        self.each_entity(what, True)

    def each_entity(self, what: str, partitioned: bool) -> None:
        """Read the entities of the four dimensions."""
        numbers = self.numbers
        counts = [numbers.count(count, 4, "entities") for count in numbers.sizes(4, what).tolist()]
        for dimension, count in enumerate(counts):
            for _ in range(count):
                (tag,) = numbers.ints(1, what).tolist()
                entity, partitions = tag, [0]
                if partitioned:
                    parent_dimension, parent = numbers.ints(2, what).tolist()
                    entity = parent if parent_dimension == dimension else tag
                    partitions = self.tags(what)
                numbers.doubles(6 if dimension else self.layout.box_of_point, what)
                groups = self.tags(what)
                if dimension:
                    self.tags(what)
                physicals = tuple(dict.fromkeys(abs(group) for group in groups))
                self.entity_of[dimension, tag] = Entity(physicals, entity, (partitions or [0])[0])
                if dimension == 3 and len(physicals) > 1:
                    self.out.note(SEVERAL)

    def tags(self, what: str) -> list[int]:
        """A counted list of ints."""
        (count,) = self.numbers.sizes(1, what).tolist()
        return [int(n) for n in self.numbers.ints(self.numbers.count(count, 1, "tags"), what)]
