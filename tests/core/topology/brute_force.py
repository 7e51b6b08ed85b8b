"""Topology by dictionaries: slow, plain, and independent of the arrays it is compared with."""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from itertools import pairwise

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))


class BruteForce:
    """Faces, edges, depth and components of a list of cells, eight ids each."""

    def __init__(self, cells: list[list[int]]) -> None:
        self.cells = cells
        self.face_cells: dict[frozenset[int], set[int]] = defaultdict(set)
        self.face_sides: dict[frozenset[int], list[tuple[int, int]]] = defaultdict(list)
        self.edge_cells: dict[frozenset[int], set[int]] = defaultdict(set)
        for number, cell in enumerate(cells):
            for local, places in enumerate(FACES):
                face = frozenset(cell[place] for place in places)
                if len(face) >= 3:
                    self.face_cells[face].add(number)
                    self.face_sides[face].append((number, local))
            for a, b in EDGES:
                if cell[a] != cell[b]:
                    self.edge_cells[frozenset((cell[a], cell[b]))].add(number)
        self.boundary = {face for face, around in self.face_cells.items() if len(around) == 1}
        self.boundary_vertices = set().union(*self.boundary) if self.boundary else set()

    @property
    def boundary_edges(self) -> set[frozenset[int]]:
        """Edges of the faces of the boundary."""
        found = set()
        for face in self.boundary:
            for number, local in self.face_sides[face]:
                ring = [self.cells[number][place] for place in FACES[local]]
                found |= {frozenset(pair) for pair in pairwise([*ring, ring[0]]) if len(set(pair)) == 2}
        return found

    def valence(self, on_boundary: bool) -> dict[int, int]:
        """Number of edges of each number of cells around."""
        edges = self.boundary_edges
        return dict(
            sorted(Counter(len(c) for e, c in self.edge_cells.items() if (e in edges) == on_boundary).items())
        )

    @property
    def neighbours(self) -> list[set[int]]:
        """Cells that share a face with each cell."""
        links: list[set[int]] = [set() for _ in self.cells]
        for around in self.face_cells.values():
            for cell in around:
                links[cell] |= around - {cell}
        return links

    @property
    def depth(self) -> list[int]:
        """Hops from a cell with a face on the boundary; -1 where there is no way to one."""
        depth = [-1] * len(self.cells)
        queue = deque(sorted({next(iter(self.face_cells[face])) for face in self.boundary}))
        for cell in queue:
            depth[cell] = 0
        links = self.neighbours
        while queue:
            cell = queue.popleft()
            for other in links[cell]:
                if depth[other] < 0:
                    depth[other] = depth[cell] + 1
                    queue.append(other)
        return depth

    @property
    def components(self) -> list[int]:
        """Label of each cell: components numbered in the order of their first cells."""
        label = [-1] * len(self.cells)
        links = self.neighbours
        found = 0
        for start in range(len(self.cells)):
            if label[start] >= 0:
                continue
            label[start] = found
            stack = [start]
            while stack:
                for other in links[stack.pop()]:
                    if label[other] < 0:
                        label[other] = found
                        stack.append(other)
            found += 1
        return label
