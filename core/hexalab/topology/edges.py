"""Edges: their vertices, the cells around them, the edges of each cell.

An edge is known by its two vertices. Each of the twelve edges of each cell writes its larger id into a slot
that its smaller id and the difference of both choose; equal edges write the same, so whoever finds its own
larger id there has found the number of its edge: the slot. (As in `slots`, but what is written is the key and
not a number, so that nobody need look up the winner's key.) Those who find another go to the next layer of
slots.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arrays import CHUNK, Array, Ids
from ..cells import EDGES
from .slots import last_writers

FACE_EDGES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 4, 8, 9), (1, 5, 9, 10), (2, 6, 10, 11), (3, 7, 11, 8))
"""The edges of each of the six faces, as indices into `EDGES`."""

SLOT_BITS = 3
"""Eight slots for each vertex: one is the smaller end of some three edges, as in a grid, or of seven or eight."""

LARGEST = 2**31
"""Places below it are told in int32."""

LAYERS = 16
"""After so many layers the rest is sorted: a vertex that is the smaller end of very many edges."""

SAMPLE = 4096
"""Cells on which multipliers of the hash are tried."""

_MULTIPLIERS = (
    0x9E3779B1, 0x85EBCA77, 0xC2B2AE3D, 0x27D4EB2F, 0x165667B1, 0xB5297A4D,
    0x68E31DA4, 0x1B56C4E9, 0xD3A2646D, 0xFD7046C5, 0xA0761D65, 0xE7037ED1,
)  # fmt: skip


@dataclass(frozen=True)
class Edges:
    """All edges, in no particular order.

    Attributes
    ----------
    vertices : (2, E) int32
        Smaller and larger id.
    rows : (12, C) int32
        Edge at each place of each cell, -1 where it has vanished.
    """

    vertices: Ids
    rows: Ids


def find_edges(corners: Ids, vertex_count: int) -> Edges:
    """Number the edges of (8, C) corners, fewer than 2**28 vertices."""
    cell_count = corners.shape[1]
    rows = np.empty((12, cell_count), np.int32)
    table = np.full(vertex_count << SLOT_BITS, -1, np.int32)
    multiplier = _best_multiplier(corners)
    for start in range(0, cell_count, CHUNK):
        part = slice(start, start + CHUNK)
        for place, (a, b) in enumerate(EDGES):
            one, other = corners[a, part], corners[b, part]
            high = np.maximum(one, other)
            slot = rows[place, part]
            _hash(np.minimum(one, other), high, multiplier, slot)
            table[slot] = high
    taken = _taken(table)
    number = np.full(len(table), -1, np.int32)
    number[taken] = np.arange(len(taken), dtype=np.int32)
    missed: list[Array] = []
    places = np.int32 if rows.size < LARGEST else np.int64
    for start in range(0, cell_count, CHUNK):
        part = slice(start, start + CHUNK)
        for place, (a, b) in enumerate(EDGES):
            one, other, slot = corners[a, part], corners[b, part], rows[place, part]
            high = np.maximum(one, other)
            lost = np.flatnonzero(table[slot] != high)
            slot[:] = number[slot]
            if len(lost):
                where = (lost + (place * cell_count + start)).astype(places)
                missed.append(np.stack([where, np.minimum(one[lost], other[lost]), high[lost]]))
    ends = [np.stack([taken >> SLOT_BITS, table[taken]])]
    if missed:
        del number
        ends += _settle(rows.reshape(-1), table, np.concatenate(missed, axis=1), len(taken))
    return Edges(np.concatenate(ends, axis=1), rows)


def _taken(table: Ids) -> Ids:
    """Slots that an edge has; one that holds its own vertex was written last by an edge that has vanished."""
    found = [np.empty(0, np.int32)]
    for start in range(0, len(table), CHUNK):
        part = table[start : start + CHUNK]
        slots = np.arange(start, start + len(part), dtype=np.int32)
        found.append(slots[(part >= 0) & (part != slots >> SLOT_BITS)])
    return np.concatenate(found)


def _settle(rows: Ids, table: Ids, missed: Array, start: int) -> list[Ids]:
    """Number the edges that found their slot taken: (3, M) places in `rows`, smaller and larger ids."""
    ends: list[Ids] = []
    rest, low, high = missed
    rows[rest[low == high]] = -1
    real = np.flatnonzero(low != high)
    rest, low, high = rest[real], low[real], high[real]
    for layer in range(LAYERS):
        if not len(rest):
            return ends
        slot = np.empty_like(low)
        _hash(low, high, _MULTIPLIERS[layer % len(_MULTIPLIERS)], slot)
        order = np.arange(len(rest), dtype=np.int32)
        winner = last_writers(table, slot, order)
        winners = np.flatnonzero(winner == order)
        number = np.empty(len(rest), np.int32)
        number[winners] = np.arange(start, start + len(winners), dtype=np.int32)
        start += len(winners)
        ends.append(np.stack([low[winners], high[winners]]))
        same = high[winner] == high
        found = np.flatnonzero(same)
        rows[rest[found]] = number[winner[found]]
        left = np.flatnonzero(~same)
        rest, low, high = rest[left], low[left], high[left]
    keys, inverse = np.unique(low.astype(np.int64) << 32 | high, return_inverse=True)
    rows[rest] = inverse + start
    ends.append(np.stack([keys >> 32, keys & 0xFFFFFFFF]).astype(np.int32))
    return ends


def _hash(low: Ids, high: Ids, multiplier: int, out: Ids) -> None:
    """Slot of an edge: the difference of its ends, mixed, chooses among its smaller end's slots."""
    mixed = (high - low).view(np.uint32)
    mixed *= np.uint32(multiplier)
    mixed >>= np.uint32(32 - SLOT_BITS)
    np.left_shift(low, SLOT_BITS, out=out)
    out += mixed.view(np.int32)


def _best_multiplier(corners: Ids) -> int:
    """The multiplier that parts most edges of a sample of cells: in a grid there are few differences."""
    step = max(corners.shape[1] // SAMPLE, 1)
    sample = corners[:, ::step]
    low = np.concatenate([np.minimum(sample[a], sample[b]) for a, b in EDGES])
    high = np.concatenate([np.maximum(sample[a], sample[b]) for a, b in EDGES])
    pairs = np.unique(low.astype(np.int64) << 32 | high)
    low, high = (pairs >> 32).astype(np.int32), (pairs & 0xFFFFFFFF).astype(np.int32)
    slot = np.empty_like(low)
    best, most = _MULTIPLIERS[0], -1
    for multiplier in _MULTIPLIERS:
        _hash(low, high, multiplier, slot)
        parted = len(np.unique(slot))
        if parted > most:
            best, most = multiplier, parted
    return best


def cells_around(edges: Edges, repeating: Array) -> Ids:
    """Number of distinct cells around each edge.

    Parameters
    ----------
    edges : Edges
    repeating : (R,) int
        The cells that repeat a vertex: they alone may have an edge twice.
    """
    around: Ids = np.zeros(edges.vertices.shape[1], np.int32)
    for rows in edges.rows:
        np.add.at(around, rows[rows >= 0] if len(repeating) else rows, np.int32(1))
    if len(repeating):
        own = np.sort(edges.rows[:, repeating], axis=0)
        twice = own[1:][(own[1:] == own[:-1]) & (own[1:] >= 0)]
        np.subtract.at(around, twice, np.int32(1))
    return around


def repeating_cells(corners: Ids) -> NDArray[np.bool_]:
    """(C,) bool: which cells have a vertex at more than one corner."""
    out = np.empty(corners.shape[1], dtype=bool)
    for start in range(0, corners.shape[1], CHUNK):
        part = slice(start, start + CHUNK)
        ids = np.sort(corners[:, part], axis=0)
        np.any(ids[1:] == ids[:-1], axis=0, out=out[part])
    return out
