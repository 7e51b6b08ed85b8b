"""Structure in dictionaries and sets, by the definitions: slow, plain, independent of the arrays.

Of hexahedra with eight vertices each, and faces of at most two cells.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable
from itertools import combinations, pairwise

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
OPPOSITE = ((5, 3), (2, 4), (0, 1))
FIRST = ((0, 1), (1, 2), (0, 4))
"""An edge of each direction."""

Set = frozenset[int]


def classes(things: Iterable[Hashable], links: Iterable[tuple[Hashable, Hashable]]) -> dict[Hashable, int]:
    """Number of each one's class."""
    beside = defaultdict(set)
    for one, other in links:
        beside[one].add(other)
        beside[other].add(one)
    label: dict[Hashable, int] = {}
    found = 0
    for thing in things:
        if thing in label:
            continue
        stack = [thing]
        label[thing] = found
        while stack:
            for other in beside[stack.pop()]:
                if other not in label:
                    label[other] = found
                    stack.append(other)
        found += 1
    return label


def members(label: dict[Hashable, int]) -> list[set[Hashable]]:
    """The members of each class."""
    out: dict[int, set[Hashable]] = defaultdict(set)
    for thing, number in label.items():
        out[number].add(thing)
    return list(out.values())


class Slow:
    """The structure of some cells."""

    def __init__(self, cells: list[list[int]]) -> None:
        self.cells = cells
        self.face_cells: dict[Set, list[int]] = defaultdict(list)
        self.rings: dict[Set, list[int]] = {}
        self.edge_cells: dict[Set, set[int]] = defaultdict(set)
        self.edge_faces: dict[Set, set[Set]] = defaultdict(set)
        for number, cell in enumerate(cells):
            for places in FACES:
                ring = [cell[place] for place in places]
                face = frozenset(ring)
                self.face_cells[face].append(number)
                self.rings[face] = ring
                for pair in pairwise([*ring, ring[0]]):
                    self.edge_faces[frozenset(pair)].add(face)
            for a, b in EDGES:
                self.edge_cells[frozenset((cell[a], cell[b]))].add(number)
        self.boundary = {face for face, around in self.face_cells.items() if len(around) == 1}
        self.boundary_edges = {edge for edge, faces in self.edge_faces.items() if faces & self.boundary}
        self.irregular = {
            edge
            for edge, around in self.edge_cells.items()
            if len(around) != (2 if edge in self.boundary_edges else 4)
        }

    def sheets(self) -> dict[Hashable, int]:
        """Class of each edge under "opposite in a face"."""
        links = []
        for a, b, c, d in self.rings.values():
            links += [(frozenset((a, b)), frozenset((c, d))), (frozenset((b, c)), frozenset((d, a)))]
        return classes(self.edge_cells, links)

    def one_sided(self) -> set[int]:
        """Sheets whose edges can't be directed alike: both directions of an edge are of one class."""
        links = []
        for a, b, c, d in self.rings.values():
            for p, q, r, s in ((a, b, d, c), (b, a, c, d), (b, c, a, d), (c, b, d, a)):
                links.append(((p, q), (r, s)))
        directed = classes([tuple(edge) for edge in self.edge_cells], links)
        sheet = self.sheets()
        return {
            sheet[edge]
            for edge in self.edge_cells
            if directed[tuple(edge)] == directed.get(tuple(edge)[::-1])
        }

    def crossings(self) -> list[tuple[int, int, int]]:
        """The sheets that cross each cell in each direction."""
        sheet = self.sheets()
        return [
            tuple(sheet[frozenset((cell[a], cell[b]))] for a, b in FIRST)  # type: ignore[misc]
            for cell in self.cells
        ]

    def self_touching(self) -> set[int]:
        """Sheets that have two edges at one vertex, those that cross a cell twice among them."""
        sheet = self.sheets()
        at: dict[tuple[int, int], int] = defaultdict(int)
        for edge in self.edge_cells:
            for vertex in edge:
                at[sheet[edge], vertex] += 1
        return {number for (number, _), edges in at.items() if edges > 1}

    def chords(self) -> dict[Hashable, int]:
        """Class of each face under "opposite in a cell"."""
        return classes(
            self.face_cells,
            [(self._face(cell, a), self._face(cell, b)) for cell in self.cells for a, b in OPPOSITE],
        )

    def _face(self, cell: list[int], local: int) -> Set:
        return frozenset(cell[place] for place in FACES[local])

    def walls(self, start: Set | None = None, inside_only: bool = False) -> set[Set]:
        """Faces that walls pass, by walking from face to face."""
        seeds = self.irregular - self.boundary_edges if inside_only else self.irregular
        stack = [face for edge in seeds for face in self.edge_faces[edge]]
        passed = set(stack)
        while stack:
            face = stack.pop()
            ring = self.rings[face]
            for pair in pairwise([*ring, ring[0]]):
                edge = frozenset(pair)
                if edge in self.irregular or edge in self.boundary_edges:
                    continue
                mine = set(self.face_cells[face])
                across = [other for other in self.edge_faces[edge] if not mine & set(self.face_cells[other])]
                assert len(across) == 1
                if across[0] not in passed:
                    passed.add(across[0])
                    stack.append(across[0])
        return passed

    def blocks(self, inside_only: bool = False) -> dict[Hashable, int]:
        """Class of each cell under "joined across a face that is not complex"."""
        walls = self.walls(inside_only=inside_only)
        links = [
            tuple(cells) for face, cells in self.face_cells.items() if len(cells) == 2 and face not in walls
        ]
        return classes(range(len(self.cells)), links)  # type: ignore[arg-type]

    def skeleton(self, inside_only: bool = False) -> tuple[int, int, int, int]:
        """Numbers of base vertices, base edges with ends, those without, base faces."""
        complex_faces = self.walls(inside_only=inside_only) | self.boundary
        edges = {edge for edge, faces in self.edge_faces.items() if faces <= complex_faces}
        at: dict[int, list[Set]] = defaultdict(list)
        for edge in edges:
            for vertex in edge:
                at[vertex].append(edge)
        through = {
            vertex
            for vertex, met in at.items()
            if len(met) == 2 and not self.edge_cells[met[0]] & self.edge_cells[met[1]]
        }
        chains = members(classes(edges, [(a, b) for v in through for a, b in [at[v]]]))
        closed = sum(all(vertex in through for edge in chain for vertex in edge) for chain in chains)  # type: ignore[attr-defined]
        links = [
            pair
            for edge, faces in self.edge_faces.items()
            if edge not in edges
            for pair in combinations(faces & complex_faces, 2)
        ]
        patches = classes(complex_faces, links)
        return len(at) - len(through), len(chains) - closed, closed, len(set(patches.values()))

    def graph(self, whole: bool) -> tuple[set[int], list[set[Hashable]]]:
        """Nodes, and the edges of each chain, of the graph of irregular edges."""
        edges = self.irregular if whole else self.irregular - self.boundary_edges
        outer = {vertex for edge in self.boundary_edges for vertex in edge}
        at: dict[int, list[Set]] = defaultdict(list)
        for edge in edges:
            for vertex in edge:
                at[vertex].append(edge)
        alike: Callable[[Set, Set], bool] = lambda a, b: (  # noqa: E731
            len(self.edge_cells[a]) == len(self.edge_cells[b])
            and (a in self.boundary_edges) == (b in self.boundary_edges)
        )
        through = {v for v, met in at.items() if len(met) == 2 and alike(*met) and (whole or v not in outer)}
        return set(at) - through, members(classes(edges, [(a, b) for v in through for a, b in [at[v]]]))
