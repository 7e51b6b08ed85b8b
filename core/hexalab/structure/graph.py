"""The graph of irregular edges: nodes, and between them arcs; loops are chains without a node (SPEC T1)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array, Ids
from ..topology.classes import classes
from .frame import Frame


@dataclass(frozen=True)
class Graph:
    """Chains of irregular edges between nodes.

    Attributes
    ----------
    nodes : (N,) int32
        Vertices at which chains end, ascending.
    node_types : (N,) int32
        Row of `types` for each.
    types : tuple of str
        "i 3 3 5 5": inside, and the valences of the irregular edges that meet there; "b 3": on the boundary.
    starts : (A + 1,) int32
        Where each chain begins in `vertices`: arcs first, then loops.
    vertices : (M,) int32
        Vertices of each chain in order, a loop's first one again at its end.
    valence : (A,) int32
        Cells around each edge of the chain.
    on_boundary : (A,) bool
    arcs : int
        How many of the chains are arcs.
    edges : (M',) int32
        Edges of each chain in order.
    """

    nodes: Ids
    node_types: Ids
    types: tuple[str, ...]
    starts: Ids
    vertices: Ids
    edges: Ids
    valence: Ids
    on_boundary: NDArray[np.bool_]
    arcs: int

    @property
    def count(self) -> int:
        """Number of chains."""
        return len(self.valence)

    @property
    def chains(self) -> list[Ids]:
        """Vertices of each chain."""
        return np.split(self.vertices, self.starts[1:-1]) if self.count else []

    @property
    def lengths(self) -> Ids:
        """(A,) int32: edges of each chain."""
        return np.diff(self.starts) - np.int32(1)


def interior_graph(frame: Frame) -> Graph:
    """The graph of the interior irregular edges; it ends at the boundary."""
    edges = np.flatnonzero(frame.irregular & ~frame.edge_on_boundary)
    return _graph(frame, edges, ends_at_boundary=True)


def whole_graph(frame: Frame) -> Graph:
    """The graph of all irregular edges, those of the boundary among them."""
    return _graph(frame, np.flatnonzero(frame.irregular), ends_at_boundary=False)


def _graph(frame: Frame, edges: Array, ends_at_boundary: bool) -> Graph:
    ends = frame.edge_vertices[:, edges]
    valence, outer = frame.valence[edges], frame.edge_on_boundary[edges]
    met, place = np.unique(ends, return_inverse=True)
    ends = place.reshape(ends.shape).astype(np.int32)
    at_boundary = frame.vertex_on_boundary[met]
    through = np.bincount(ends.reshape(-1), minlength=len(met)) == 2
    pair = _pairs(ends, through)
    through[through] = (valence[pair[0]] == valence[pair[1]]) & (outer[pair[0]] == outer[pair[1]])
    if ends_at_boundary:
        through &= ~at_boundary
    chains = chain(ends, through)
    first = chains.edges[chains.starts[:-1]]
    is_node = ~through
    types, of_node = _types(ends, valence, is_node, at_boundary)
    widths = np.diff(chains.starts)
    vertices = np.empty(len(edges) + len(widths), np.int32)
    starts = chains.starts + np.arange(len(widths) + 1, dtype=np.int32)
    heads = np.ones(len(vertices), dtype=bool)
    heads[starts[1:] - 1] = False
    vertices[heads] = met[chains.begins]
    vertices[~heads] = met[chains.last]
    return Graph(
        nodes=met[is_node].astype(np.int32),
        node_types=of_node,
        types=types,
        starts=starts.astype(np.int32),
        vertices=vertices,
        edges=edges[chains.edges].astype(np.int32),
        valence=valence[first],
        on_boundary=outer[first],
        arcs=chains.open,
    )


def _pairs(ends: Ids, through: NDArray[np.bool_]) -> Ids:
    """(2, T): the two edges at each of the vertices that are gone through, of (2, E) ends."""
    flat = ends.reshape(-1)
    hit = np.flatnonzero(through[flat])
    order = hit[np.argsort(flat[hit], kind="stable")]
    return (order % max(ends.shape[1], 1)).reshape(-1, 2).T.astype(np.int32)


@dataclass(frozen=True)
class Chains:
    """Edges in the order in which they follow one another.

    Attributes
    ----------
    edges : (E,) int32
        Edges, chain by chain: those with ends first, then closed ones, each kind by the smallest vertex at
        which they begin and the one that follows, however the edges are numbered.
    begins : (E,) int32
        The vertex at which each of these edges is entered.
    last : (C,) int32
        The vertex at which each chain ends.
    starts : (C + 1,) int32
        Where each chain begins in `edges`.
    open : int
        Number of chains with ends.
    """

    edges: Ids
    begins: Ids
    last: Ids
    starts: Ids
    open: int

    @property
    def count(self) -> int:
        """Number of chains."""
        return len(self.last)


def chain(ends: Ids, through: NDArray[np.bool_]) -> Chains:
    """Follow edges through vertices at which exactly two meet and one goes on.

    Each edge stands for two halves, one for each sense in which it is walked. A half knows its next; by
    doubling the stride all halves learn how far the end is, in a number of rounds that grows with the logarithm
    of the longest chain. A closed chain is cut where it begins.

    Parameters
    ----------
    ends : (2, E) int32
        Vertices of each edge.
    through : (V,) bool
        Whether a chain goes on at the vertex.

    Examples
    --------
    A chain 4-2-7-5 of three edges, and a ring 0-1-3::

        4 --e1-- 2 --e0-- 7 --e2-- 5        ring: e3 = 0 1, e4 = 1 3, e5 = 3 0

    >>> ends = np.array([[2, 2, 5, 0, 1, 0], [7, 4, 7, 1, 3, 3]], np.int32)
    >>> through = np.array([1, 1, 1, 1, 0, 0, 0, 1], bool)
    >>> chains = chain(ends, through)
    >>> chains.edges.tolist(), chains.begins.tolist(), chains.last.tolist(), chains.starts.tolist(), chains.open
    ([1, 0, 2, 3, 4, 5], [4, 2, 7, 0, 1, 3], [5, 0], [0, 3, 6], 1)
    """
    count = ends.shape[1]
    one, other = _pairs(ends, through)
    labels, found = classes(count, lambda: [(one, other)])
    # Half h < E walks edge h from ends[0] to ends[1], half E + h the other way.
    begin, finish = np.concatenate([ends[0], ends[1]]), np.concatenate([ends[1], ends[0]])
    label = np.concatenate([labels, labels])
    halves = np.arange(2 * count, dtype=np.int32)
    coming = np.flatnonzero(through[finish])
    coming = coming[np.argsort(finish[coming], kind="stable")].reshape(
        -1, 2
    )  # the two that come to each vertex
    following = halves.copy()
    following[coming[:, ::-1]] = (coming + count) % max(
        2 * count, 1
    )  # each goes on as the other one walked back
    closed = np.ones(found, dtype=bool)
    closed[label[following == halves]] = False
    may_start = np.flatnonzero(~through[begin] | closed[label])
    may_start = may_start[np.lexsort((finish[may_start], begin[may_start], label[may_start]))]
    start = may_start[np.unique(label[may_start], return_index=True)[1]]
    cut = np.zeros(2 * count, dtype=bool)
    cut[start[closed]] = cut[(start[closed] + count) % max(2 * count, 1)] = True
    last = cut[following]
    following[last] = halves[last]
    left, goal = _walk(following)
    mine = np.flatnonzero(
        goal == goal[start][label]
    )  # of its two senses a chain is walked in that of its start
    rank = np.empty(found, np.int32)
    rank[np.lexsort((finish[start], begin[start], closed))] = np.arange(found, dtype=np.int32)
    number = rank[label[mine]]
    mine = mine[np.lexsort((-left[mine], number))]
    starts = np.concatenate([[0], np.cumsum(np.bincount(number, minlength=found))]).astype(np.int32)
    return Chains(
        edges=(mine % max(count, 1)).astype(np.int32),
        begins=begin[mine],
        last=finish[mine[starts[1:] - 1]],
        starts=starts,
        open=int(np.count_nonzero(~closed)),
    )


def _walk(following: Ids) -> tuple[Ids, Ids]:
    """How many steps lead from each to the last that follows, and which that is; a last one is followed by itself."""
    steps: Ids = (following != np.arange(len(following), dtype=np.int32)).astype(np.int32)
    while True:
        further: Ids = following[following]
        if np.array_equal(further, following):
            return steps, following
        steps = steps + steps[following]
        following = further


def _types(
    ends: Ids, valence: Ids, is_node: NDArray[np.bool_], at_boundary: NDArray[np.bool_]
) -> tuple[tuple[str, ...], Ids]:
    """The node types that there are, the most frequent first, and the type of each node."""
    flat = ends.reshape(-1)
    around = np.concatenate([valence, valence])
    order = np.lexsort((around, flat))
    order = order[is_node[flat[order]]]
    nodes = np.flatnonzero(is_node)
    sizes = np.bincount(flat[order], minlength=len(is_node))[nodes]
    first = np.cumsum(sizes) - sizes
    table = np.zeros((len(nodes), 1 + int(sizes.max(initial=0))), np.int32)
    table[:, 0] = at_boundary[nodes]
    row = np.repeat(np.arange(len(nodes)), sizes)
    table[row, 1 + np.arange(len(order)) - np.repeat(first, sizes)] = around[order]
    rows, kind, counts = np.unique(table, axis=0, return_inverse=True, return_counts=True)
    by_count = np.argsort(-counts, kind="stable")
    rank = np.empty(len(rows), np.int32)
    rank[by_count] = np.arange(len(rows), dtype=np.int32)
    names = tuple(" ".join(["ib"[row[0]], *(str(v) for v in row[1:] if v)]) for row in rows[by_count])
    return names, rank[kind.reshape(-1)]
