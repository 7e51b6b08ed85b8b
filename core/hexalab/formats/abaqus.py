"""Abaqus and CalculiX `.inp` (SPEC R5): *NODE and *ELEMENT of volumetric elements, in parts and their instances."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..arrays import Array, Floats
from ..cells import WEDGE
from ..errors import MeshReadError
from ..mesh import Mesh
from .abaqus_deck import Block, Deck
from .abaqus_elements import ElementType, element_type
from .abaqus_fields import count_of_elements
from .abaqus_groups import LOWER_KINDS, Placed, Resolver
from .abaqus_rows import ElementRows, element_rows, node_error, node_rows
from .abaqus_scopes import ASSEMBLY, DECK, INSTANCE, PART, Scope, model
from .abaqus_sets import ELSET, NO_NUMBERS, NSET, plain
from .abaqus_systems import COORDINATES, HERE, Placement, instance_placement, node_system
from .assembly import WEDGE_OF_OTHERS, Assembly, CellBlock, check_finite
from .feature_blocks import FeatureBlock, joined_features, named_apart
from .file import File
from .ids import Numbering

CORNERS = (8, 6, 5, 4)
"""How many corners a cell of each kind has of its own."""

NOT_FOLLOWED = {
    name: f"*{name} makes {what} of others: these are not shown."
    for name, what in (
        ("NGEN", "nodes"), ("NFILL", "nodes"), ("NCOPY", "nodes"), ("NMAP", "nodes"),
        ("ELGEN", "elements"), ("ELCOPY", "elements"),
    )
}  # fmt: skip
"""Keywords that change the mesh and are not followed: what is noted of each."""


def read(file: File) -> Mesh:
    """Read the bytes of an `.inp` file; raises MeshReadError."""
    return Reader(file).read()


class Reader:
    """One pass from keyword to keyword.

    Parameters
    ----------
    file : File
        The deck; files that it includes are its companions.
    """

    def __init__(self, file: File) -> None:
        self.file = file
        self.deck = Deck(file)
        self.out = Assembly(file, "inp")
        self.loose = Scope(DECK)
        self.scopes = [self.loose]
        self.scope = self.loose
        self.assembly = self.loose
        self.system: Placement = HERE
        self.has_fluid_cavities = False
        self.cells = 0
        self.surplus: dict[ElementType, int] = {}
        self.handlers: dict[str, Callable[[Block], None]] = {
            "NODE": self.nodes,
            "ELEMENT": self.elements,
            "SYSTEM": self.local_system,
            "PART": self.begin_part,
            "ENDPART": self.end_part,
            "ASSEMBLY": self.begin_assembly,
            "ENDASSEMBLY": self.end_part,
            "INSTANCE": self.begin_instance,
            "ENDINSTANCE": self.end_instance,
        }

    def read(self) -> Mesh:
        """Read every keyword's lines, then join the scopes; what isn't followed is noted.

        Raises
        ------
        MeshReadError
            No keyword, no `*NODE`, or rows that don't fit; file and line are named.
        """
        for block in self.deck.blocks():
            keyword = block.keyword
            if keyword.name in NOT_FOLLOWED:
                self.out.note(NOT_FOLLOWED[keyword.name])
            self.has_fluid_cavities |= keyword.name == "FLUIDPROPERTY"
            handler = self.handlers.get(keyword.name)
            if handler is None:
                self.scope.defined.read(block)
            elif not block.goes_on or keyword.name in ("NODE", "ELEMENT"):
                handler(block)
        if not self.deck.keywords:
            raise self.file.error("the file has no keyword such as *NODE", line_at=0)
        if not any(scope.tags for scope in self.scopes):
            raise self.file.error("the file has no *NODE section" + self.missing(), line_at=0)
        if self.deck.missing:
            self.out.note(f"Not all of the deck is here{self.missing()}.")
        return self.join()

    def missing(self) -> str:
        """The part of a sentence that names files which are included and not there."""
        names = list(dict.fromkeys(self.deck.missing))
        if not names:
            return ""
        listed = ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
        return (
            f": it includes {listed}, which {'was' if len(names) == 1 else 'were'} not found in its folder; "
            "open the files together"
        )

    # -- scopes

    def enter(self, scope: Scope) -> None:
        """Go on in another scope; a system of coordinates ends with its own."""
        if scope not in self.scopes:
            self.scopes.append(scope)
        self.scope, self.system = scope, HERE

    def begin_part(self, block: Block) -> None:
        """*PART: numbers of its own."""
        self.enter(Scope(PART, plain(block.keyword.options.get("NAME", ""))))

    def end_part(self, _block: Block) -> None:
        """*END PART, *END ASSEMBLY: back in the deck."""
        self.assembly = self.loose
        self.enter(self.loose)

    def begin_assembly(self, block: Block) -> None:
        """*ASSEMBLY: has nodes of its own, apart from those of instances."""
        self.assembly = Scope(ASSEMBLY, plain(block.keyword.options.get("NAME", "")))
        self.enter(self.assembly)

    def begin_instance(self, block: Block) -> None:
        """*INSTANCE: a part at a place, which may define nodes and elements itself."""
        options = block.keyword.options
        name = plain(options.get("NAME", ""))
        placement = instance_placement(block.numbers())
        if placement is None:
            raise block.error(
                f"instance {name} has no place: expected a translation, and for a rotation "
                "two points of its axis and an angle"
            )
        self.enter(Scope(INSTANCE, name, plain(options.get("PART", "")), placement))

    def end_instance(self, _block: Block) -> None:
        """*END INSTANCE: back in the assembly."""
        self.enter(self.assembly)

    # -- lines

    def local_system(self, block: Block) -> None:
        """*SYSTEM: the nodes after it lie in a system of their own."""
        system = node_system(block.numbers())
        if system is None:
            self.out.note("A *SYSTEM whose points span no system of coordinates is not followed.")
        self.system = system or HERE

    def nodes(self, block: Block) -> None:
        """*NODE: rows of number, x, y, z; more numbers in a row (a normal) are skipped."""
        tags, points = node_rows(block)
        check_finite(points, lambda message, row: node_error(block, message, row))
        letter = block.keyword.option("SYSTEM")[:1] or "R"
        if letter not in COORDINATES:
            raise block.error(f"*NODE, SYSTEM={letter} is unknown, expected R, C or S")
        to_rectangular = COORDINATES[letter]
        self.put_into_set(block, NSET, tags)
        if len(tags):
            self.scope.tags.append(tags)
            self.scope.points.append(self.system(to_rectangular(points) if to_rectangular else points))

    def elements(self, block: Block) -> None:
        """*ELEMENT: rows of number and nodes."""
        name = block.keyword.option("TYPE")
        kind = element_type(name)
        if kind is None:
            left_out = self.scope.left_out
            called = f"elements of type {name[:20] or 'unknown'}"
            left_out[called] = left_out.get(called, 0) + count_of_elements(block)
            self.put_into_set(block, ELSET, NO_NUMBERS)
            return
        if kind.dimension < 3:
            self.lower(block, kind)
            return
        rows = element_rows(block, kind)
        self.put_into_set(block, ELSET, rows.numbers)
        if len(rows.numbers):
            self.scope.elements.append(rows)
        if rows.surplus:
            self.surplus[kind] = self.surplus.get(kind, 0) + rows.surplus

    def lower(self, block: Block, kind: ElementType) -> None:
        """*ELEMENT of edges or faces; what can't be read costs them, not the mesh."""
        try:
            rows = element_rows(block, kind)
        except MeshReadError as error:
            self.out.note(f"Elements of type {kind.name} were left out. {error}.")
            rows = ElementRows(block, kind, NO_NUMBERS, np.zeros((0, kind.least), dtype=np.int64))
        self.put_into_set(block, ELSET, rows.numbers)
        if len(rows.numbers):
            self.scope.lower.append(rows)

    def put_into_set(self, block: Block, kind: str, numbers: Array) -> None:
        """Put what a block defines into the set that its keyword names."""
        if name := plain(block.keyword.options.get(kind, "")):
            self.scope.defined.put(kind, name, numbers)

    # -- the whole

    def join(self) -> Mesh:
        """Join the scopes that are in the model, their vertices one after the other."""
        shown, notes = model(self.scopes)
        for note in notes:
            self.out.note(note)
        with_nodes = [scope for scope in shown if scope.tags]
        if not with_nodes:
            raise self.file.error("no part that is instanced has nodes", line_at=0)
        places = {id(scope): Placed(scope, Numbering(NO_NUMBERS), 0) for scope in shown}
        orphans = [(scope, rows) for scope in shown if not scope.tags for rows in scope.elements]
        first, moved, repeated = 0, 0, 0
        all_points: list[Floats] = []
        all_tags: list[Array] = []
        for scope in with_nodes:
            tags, points, again = scope.nodes()
            placed = places[id(scope)]
            placed.nodes, placed.first_node = Numbering(tags), first
            own = [(scope, rows) for rows in scope.elements]
            for owner, rows in own + (orphans if scope is with_nodes[0] else []):
                self.add(rows, placed, places[id(owner)])
            all_tags.append(tags)
            all_points.append(points)
            first += len(tags)
            moved += again
            repeated += scope.repeated_elements()
        for scope in shown:
            for called, count in scope.left_out.items():
                self.out.leave_out(called, count)
        self.note_repeated(moved, repeated)
        self.out.coordinates = np.concatenate(all_points, axis=1)
        self.out.vertex_numbers = np.concatenate(all_tags)
        lower = self.lower_blocks(list(places.values()), places[id(with_nodes[0])])
        self.out.features += lower  # named where there are no cells
        return self.grouped(self.out.mesh(), list(places.values()), lower)

    def lower_blocks(self, scopes: list[Placed], first: Placed) -> list[FeatureBlock]:
        """Edges and faces of all scopes, in one block for each dimension; `first` has the nodes of those without."""
        blocks = []
        for dimension, size in ((1, 2), (2, 4)):
            parts: list[Array] = [np.zeros((size, 0), dtype=np.int32)]
            start = 0
            for placed in scopes:
                nodes = placed if placed.scope.tags else first
                for rows in placed.scope.lower:
                    if rows.type.dimension != dimension:
                        continue
                    corners = nodes.nodes.places(np.ascontiguousarray(rows.nodes[:, : rows.type.corners].T))
                    corners[corners >= 0] += np.int32(nodes.first_node)
                    parts.append(np.concatenate([corners, corners[-1:]]) if len(corners) < size else corners)
                    count = len(rows.numbers)
                    placed.put(LOWER_KINDS[dimension], rows.numbers, np.arange(start, start + count))
                    start += count
            if start:
                blocks.append(FeatureBlock(dimension, np.concatenate(parts, axis=1)))
        return blocks

    def grouped(self, mesh: Mesh, scopes: list[Placed], lower: list[FeatureBlock]) -> Mesh:
        """The mesh with the sets and surfaces of the deck."""
        resolver = Resolver(scopes, mesh, self.out.note)
        groups = named_apart(list(resolver.groups()))
        features = joined_features(resolver.features(lower), mesh.vertex_count, self.out.note)
        for note in resolver.notes():
            self.out.note(note)
        return replace(mesh, groups=tuple(groups), features=features)

    def note_repeated(self, nodes: int, elements: int) -> None:
        """Note numbers that were given twice, and nodes in excess."""
        if nodes:
            self.out.note(f"{counted(nodes, 'node')} more than one place: the last definition counts.")
        if elements:
            self.out.note(f"{counted(elements, 'element')} the number of another one: all are shown.")
        for kind, count in self.surplus.items():
            self.out.note(
                f"{counted(count, 'element')} more nodes than the {kind.most} of type {kind.name}: "
                "the surplus is passed over."
            )

    def add(self, rows: ElementRows, nodes: Placed, owner: Placed) -> None:
        """Add elements to the mesh, whose nodes are those of one scope and whose numbers are another's."""
        kind = rows.type.kind
        if self.has_fluid_cavities and rows.type.name.startswith("F3D4"):
            self.out.leave_out(f"faces of fluid cavities, of type {rows.type.name}", len(rows.numbers))
            return
        own = CORNERS[kind]
        order = list(WEDGE_OF_OTHERS) if kind == WEDGE else list(range(own))
        corners = nodes.nodes.places(np.ascontiguousarray(rows.nodes[:, order].T))
        missing = corners < 0
        if missing.any():
            cell = int(np.argmax(missing.any(axis=0)))
            node = int(rows.nodes[cell, order[int(np.argmax(missing[:, cell]))]])
            message = f"element {int(rows.numbers[cell])} refers to node {node}, which is missing"
            raise rows.error(message + self.missing(), cell)
        if rows.type.least > own:
            most = rows.type.least
            self.out.note(f"Cells of higher order (elements of {most} nodes) are shown by their corners.")
        start = self.cells
        self.cells += len(rows.numbers)
        owner.put(ELSET, rows.numbers, np.arange(start, self.cells))
        corners = corners + np.int32(nodes.first_node)
        self.out.blocks.append(CellBlock(kind, corners, self.locate, numbers=rows.numbers))

    def locate(self, message: str, _cell: int, _corner: int) -> MeshReadError:
        """An error without a line; nodes that are missing have been found in `add`, with theirs."""
        return self.file.error(message, line_at=0)


def counted(count: int, what: str) -> str:
    """A number of things, with the verb: "1 node has", "2 nodes have"."""
    return f"{count:,} {what} has" if count == 1 else f"{count:,} {what}s have"
