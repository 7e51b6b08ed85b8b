"""Sets of an Abaqus deck become groups, its surfaces features: resolved in the scope that each stands in.

A set of a part is there once for each of its instances. It is called by its name where that is the only one in the
model, else as in Abaqus: "INSTANCE.SET".
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ..arrays import Array
from ..cells import CORNERS_OF_KIND, WEDGE
from ..groups import Group, On
from ..mesh import Mesh
from .abaqus_elements import FACES
from .abaqus_scopes import INSTANCE, PART, Scope
from .abaqus_sets import ELSET, NO_NUMBERS, NSET, SetLines, SurfaceLines
from .assembly import WEDGE_OF_OTHERS
from .feature_blocks import FeatureBlock
from .ids import Numbering

FACE_COUNT = np.array([len(FACES[kind]) for kind in range(len(FACES))])
"""How many there are, by kind."""

NO_ROWS = NO_NUMBERS
LOWER_KINDS = {1: "ELSET 1", 2: "ELSET 2"}
"""The members of element sets that are edges or faces, in place of cells."""


class Entry(NamedTuple):
    """A set where it is defined: scope, name, what its keywords put into it, and a key of it."""

    placed: Placed
    name: str
    lines: list[SetLines]
    key: tuple[int, str]


@dataclass(eq=False)
class Placed:
    """A scope of the model, and where its nodes and elements lie in the mesh.

    Parameters
    ----------
    scope : Scope
    nodes : Numbering
        Of its nodes.
    first_node : int
        Row of the first one.
    elements : dict of str to lists of (n,) integers
        Numbers of its elements, block by block, and their rows: of cells under ELSET, of edges and faces among the
        features of their dimension under `LOWER_KINDS`.
    """

    scope: Scope
    nodes: Numbering
    first_node: int
    elements: dict[str, list[tuple[Array, Array]]] = field(default_factory=dict)

    def put(self, kind: str, numbers: Array, rows: Array) -> None:
        """Tell where elements have gone."""
        self.elements.setdefault(kind, []).append((numbers, rows))

    def rows_of(self, kind: str) -> Array:
        """Rows of all elements of a kind."""
        return np.concatenate([NO_ROWS, *(rows for _, rows in self.elements.get(kind, ()))])

    @cached_property
    def _numbered(self) -> dict[str, tuple[Numbering, Array]]:
        return {
            kind: (Numbering(np.concatenate([numbers for numbers, _ in blocks])), self.rows_of(kind))
            for kind, blocks in self.elements.items()
        }

    def elements_of(self, kind: str, numbers: Array) -> tuple[Array, int]:
        """Rows of the elements of those numbers, and how many are none that is kept."""
        own: Array = NO_ROWS
        there = np.zeros(numbers.shape, dtype=bool)
        for other, (numbering, rows) in self._numbered.items():
            places = numbering.places(numbers)
            there |= places >= 0
            if other == kind:
                own = rows[places[places >= 0]]
        return own, int(np.count_nonzero(~there))

    def nodes_of(self, numbers: Array) -> tuple[Array, int]:
        """Rows of the nodes of those numbers, and how many are not there."""
        places = self.nodes.places(numbers)
        found = places[places >= 0]
        return found.astype(np.int64) + self.first_node, len(places) - len(found)

    def lines_of(self, kind: str, name: str) -> Iterator[SetLines]:
        """What its keywords put into a set."""
        upper, asked = name.upper(), kind.partition(" ")[0]
        return (
            lines for lines in self.scope.defined.sets if lines.kind == asked and lines.name.upper() == upper
        )


class Resolver:
    """Finds members of sets in all scopes of the model.

    Parameters
    ----------
    scopes : list of Placed
    mesh : Mesh
        What was made of them.
    note : callable
        Takes a sentence.
    """

    def __init__(self, scopes: list[Placed], mesh: Mesh, note: Callable[[str], None]) -> None:
        self.scopes = scopes
        self.mesh = mesh
        self.note = note
        self.instances = {
            placed.scope.name.upper(): placed for placed in scopes if placed.scope.kind == INSTANCE
        }
        self.lost: Counter[str] = Counter()
        self.unknown: list[str] = []
        self.known: dict[tuple[int, str, str], Array | None] = {}

    def members(self, placed: Placed, kind: str, name: str) -> Array | None:
        """Rows of a set's members as a scope sees it, rising; None if there is no such set.

        They are those of all sets that can be reached by names, each gone through once.
        """
        key = (id(placed), kind, name.upper())
        if key not in self.known:
            self.known[key] = self.gathered(placed, kind, name)
        return self.known[key]

    def gathered(self, placed: Placed, kind: str, name: str) -> Array | None:
        """The members, without looking up what is known."""
        start = self.found(placed, kind, name)
        if start is None:
            return None
        rows: list[Array] = [NO_ROWS]
        waiting, seen = [start], {start.key}
        while waiting:
            entry = waiting.pop()
            for line in entry.lines:
                where = (
                    self.instances.get(line.instance.upper(), entry.placed) if line.instance else entry.placed
                )
                rows += [self.rows(where, kind, numbers, entry.name) for numbers in line.numbers]
                for other in line.names:
                    if line.of:
                        cells = self.entry(where, line.of, other)
                        rows.append(self.nodes_of_cells(cells) if cells is not None else NO_ROWS)
                        self.unknown += [other] if cells is None else []
                        continue
                    following = self.found(where, kind, other)
                    if following is None:
                        rows.append(self.numbered(where, kind, other))
                    elif following.key not in seen:
                        seen.add(following.key)
                        waiting.append(following)
        members: Array = np.unique(np.concatenate(rows))
        return members

    def found(self, placed: Placed, kind: str, name: str) -> Entry | None:
        """The set of a name, or of "INSTANCE.NAME"; None if there is none."""
        lines = list(placed.lines_of(kind, name))
        if lines:
            return Entry(placed, name, lines, (id(placed), name.upper()))
        instance, dot, rest = name.partition(".")
        inside = self.instances.get(instance.upper())
        return self.found(inside, kind, rest) if dot and rest and inside and inside is not placed else None

    def numbered(self, placed: Placed, kind: str, word: str) -> Array:
        """Rows of a number that stands among names: "INSTANCE.NUMBER"; none of a name that is not there."""
        instance, _, number = word.partition(".")
        inside = self.instances.get(instance.upper())
        if inside and number.isdigit() and len(number) < 19:
            return self.rows(inside, kind, np.array([int(number)]), word)
        self.unknown.append(word)
        return NO_ROWS

    def entry(self, placed: Placed, kind: str, word: str) -> Array | None:
        """Rows that a name or a number stands for; None if there is no such set."""
        if word.isdigit() and len(word) < 19:
            return self.rows(placed, kind, np.array([int(word)]), word)
        rows = self.members(placed, kind, word)
        if rows is None and "." in word and word.rpartition(".")[2].isdigit():
            return self.numbered(placed, kind, word)
        return rows

    def rows(self, placed: Placed, kind: str, numbers: Array, name: str) -> Array:
        """Rows of elements or nodes; those that are not there are counted under the set's name."""
        rows, lost = placed.nodes_of(numbers) if kind == NSET else placed.elements_of(kind, numbers)
        if lost and kind in (ELSET, NSET):
            self.lost[name] += lost
        return rows

    def nodes_of_cells(self, cells: Array) -> Array:
        """Vertices of cells, rising."""
        nodes: Array = np.unique(self.mesh.corners[:, cells])
        return nodes.astype(np.int64)

    # -- what becomes of it

    def groups(self) -> Iterator[Group]:
        """The groups of the model: instances, materials, element sets, node sets."""
        yield from self.pieces()
        yield from self.materials()
        yield from self.sets(ELSET, "cell")
        yield from self.sets(NSET, "vertex")
        yield from self.node_surfaces()

    def pieces(self) -> Iterator[Group]:
        """The instances, or the parts where none is instanced."""
        for placed in self.scopes:
            rows = placed.rows_of(ELSET)
            if placed.scope.kind in (INSTANCE, PART) and len(rows):
                yield Group(placed.scope.name, placed.scope.kind, rows)

    def materials(self) -> Iterator[Group]:
        """The cells of each material, by the sections of their sets."""
        found: dict[str, tuple[str, list[Array]]] = {}
        for placed in self.scopes:
            for material, name in placed.scope.defined.materials:
                rows = self.members(placed, ELSET, name)
                if rows is not None:
                    found.setdefault(material.upper(), (material, []))[1].append(rows)
        for material, parts in found.values():
            members = np.concatenate(parts)
            if len(members):
                yield Group(material, "material", members)

    def sets(self, kind: str, on: On) -> Iterator[Group]:
        """The sets of a kind that no program made for its own use, and that have a member."""
        origin = kind.partition(" ")[0]
        listed = [
            (placed, name)
            for placed in self.scopes
            for name in listed_names(placed.scope.defined.sets, origin)
        ]
        times = Counter(name.upper() for _, name in listed)
        for placed, name in listed:
            members = self.members(placed, kind, name)
            if members is not None and len(members):
                yield Group(called(placed.scope, name, times), origin.lower(), members, on)

    def node_surfaces(self) -> Iterator[Group]:
        """Surfaces that are made of nodes."""
        for placed, surface, name in self.surfaces(of_nodes=True):
            rows = [self.entry(placed, NSET, word) for word, _ in surface.rows]
            members = [some for some in rows if some is not None]
            if members:
                yield Group(name, "surface", np.concatenate(members), "vertex")

    def surfaces(self, of_nodes: bool) -> Iterator[tuple[Placed, SurfaceLines, str]]:
        """The surfaces that no program made for its own use, and what each is called."""
        listed = [
            (placed, surface)
            for placed in self.scopes
            for surface in placed.scope.defined.surfaces
            if not surface.internal and surface.of_nodes == of_nodes
        ]
        times = Counter(surface.name.upper() for _, surface in listed)
        for placed, surface in listed:
            yield placed, surface, called(placed.scope, surface.name, times)

    def features(self, lower: list[FeatureBlock]) -> list[FeatureBlock]:
        """Elements of lower dimension with their sets, and the faces of all surfaces with a group for each."""
        for block in lower:
            kind = LOWER_KINDS[block.dimension]
            block.groups += self.sets(kind, "cell")
        return [*lower, *self.faces_of_surfaces()]

    def faces_of_surfaces(self) -> list[FeatureBlock]:
        """The faces of all surfaces, each once, with a group for each surface."""
        found: list[tuple[str, Array]] = []
        passed_over = 0
        for placed, surface, name in self.surfaces(of_nodes=False):
            sides = []
            for word, face in surface.rows:
                cells = self.entry(placed, ELSET, word)
                if cells is None:
                    self.unknown.append(word)
                    continue
                some, lost = self.sides(cells, face)
                passed_over += lost
                sides.append(some)
            if sides:
                found.append((name, np.unique(np.concatenate(sides))))
        if passed_over:
            self.note(
                f"{passed_over:,} rows of surfaces name faces that their cells have not got: passed over."
            )
        if not found:
            return []
        every = np.unique(np.concatenate([sides for _, sides in found]))
        groups = [Group(name, "surface", np.searchsorted(every, sides)) for name, sides in found]
        return [FeatureBlock(2, self.corners_of(every), groups=groups)]

    def sides(self, cells: Array, face: str) -> tuple[Array, int]:
        """Faces of cells as 8 * cell + number of the face, from 0, and how many cells have no such face.

        Without a face they are those of the boundary (Abaqus Analysis User's Guide, "Element-based surfaces").
        """
        if not face:
            return self.free_sides(cells), 0
        if not (len(face) == 2 and face[0] in "SP" and face[1] in "123456"):
            return NO_ROWS, len(cells)
        number = int(face[1]) - 1
        has = number < FACE_COUNT[self.mesh.kinds[cells]]
        return 8 * cells[has].astype(np.int64) + number, int(np.count_nonzero(~has))

    def free_sides(self, cells: Array) -> Array:
        """Those faces of cells that are on the boundary of the mesh.

        Each is known by its vertices among the faces S1 to S6 of its cell.
        """
        topology = self.mesh.topology
        rows = topology.faces.boundary
        own, local = topology.face_cells[0, rows], topology.face_locals[0, rows]
        chosen = np.isin(own, cells)
        own, wanted = own[chosen], np.sort(topology.corners_of(own[chosen], local[chosen]), axis=0)
        found = []
        for number in range(6):
            has = np.flatnonzero(number < FACE_COUNT[self.mesh.kinds[own]])
            sides = 8 * own[has].astype(np.int64) + number
            same = np.sort(self.corners_of(sides), axis=0) == wanted[:, has]
            found.append(sides[same.all(axis=0)])
        free: Array = np.unique(np.concatenate(found))
        return free

    def corners_of(self, sides: Array) -> Array:
        """(4, n) vertices of faces."""
        cells, numbers = sides // 8, sides % 8
        out = np.empty((4, len(sides)), dtype=np.int32)
        for kind, faces in FACES.items():
            own = CORNERS_OF_KIND[kind]
            order = WEDGE_OF_OTHERS if kind == WEDGE else tuple(range(len(own)))
            for number, face in enumerate(faces):
                which = np.flatnonzero((self.mesh.kinds[cells] == kind) & (numbers == number))
                if len(which):
                    places = [own[order[node]] for node in (*face, face[-1])[:4]]
                    out[:, which] = self.mesh.corners[places][:, cells[which]]
        return out

    def notes(self) -> Iterator[str]:
        """What was not found."""
        if self.lost:
            names = short_list(self.lost)
            yield (
                f"{sum(self.lost.values()):,} entries of sets name elements or nodes that are not shown "
                f"({names}): left out of them."
            )
        if self.unknown:
            yield f"Sets and surfaces refer to sets that are not there: {short_list(self.unknown)}."


def listed_names(sets: list[SetLines], kind: str) -> list[str]:
    """Names of the sets of a kind, each once, but for those that a program made for its own use."""
    names: dict[str, str] = {}
    for lines in sets:
        if lines.kind == kind and not lines.internal:
            names.setdefault(lines.name.upper(), lines.name)
    return list(names.values())


def called(scope: Scope, name: str, times: Counter[str]) -> str:
    """What a set is called: by its name where only one scope has it, else with its instance's or part's."""
    return name if times[name.upper()] < 2 or not scope.name else f"{scope.name}.{name}"


def short_list(names: Iterable[str]) -> str:
    """The names, each once, the first five of them."""
    once = list(dict.fromkeys(names))
    return ", ".join(once[:5]) + (f" and {len(once) - 5} more" if len(once) > 5 else "")
