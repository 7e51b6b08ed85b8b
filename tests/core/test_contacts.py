"""SPEC R12: parts that touch without being joined, their faces matching or not."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from hexalab.contacts import contacts
from hexalab.mesh import Mesh


def block(
    counts: tuple[int, int, int], low: tuple[float, ...], high: tuple[float, ...]
) -> tuple[np.ndarray, ...]:
    """Points (n, 3) and cells (m, 8) of a box of so many cubes along each axis."""
    axes = [np.linspace(a, b, n + 1) for a, b, n in zip(low, high, counts, strict=True)]
    points = np.array(list(itertools.product(*axes)))
    at = np.arange(len(points)).reshape([n + 1 for n in counts])
    corners = [(a, b, c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    places = itertools.product(*map(range, counts))
    cells = [[at[i + a, j + b, k + c] for a, b, c in corners] for i, j, k in places]
    return points, np.array(cells)


def joined(*blocks: tuple[np.ndarray, ...]) -> tuple[Mesh, np.ndarray]:
    """A mesh of blocks that share no vertex, and the block of each cell."""
    points, cells, labels, first = [], [], [], 0
    for number, (own, corners) in enumerate(blocks):
        points.append(own)
        cells.append(corners + first)
        labels.append(np.full(len(corners), number, dtype=np.int32))
        first += len(own)
    return Mesh.from_cells(np.concatenate(points), np.concatenate(cells)), np.concatenate(labels)


ONE = block((2, 3, 2), (0, 0, 0), (1, 1, 1))


@pytest.mark.parametrize("scale", [1e-6, 1, 1e9])
def test_R12_matching_faces_that_are_not_joined(scale: float) -> None:
    mesh, labels = joined(ONE, block((2, 3, 2), (1, 0, 0), (2, 1, 1)))
    assert contacts(Mesh.from_cells(mesh.points * scale, mesh.cells), labels) == {(0, 1): 6}


def test_R12_faces_of_another_size_are_counted_on_the_finer_side() -> None:
    fine = block((3, 12, 10), (1, 0, 0), (2, 1, 1))
    assert contacts(*joined(ONE, fine)) == {(0, 1): 120}
    assert contacts(*joined(fine, ONE)) == {(0, 1): 120}


def test_R12_a_part_that_overlaps_with_a_corner_only_counts_what_lies_on_it() -> None:
    shifted = block((1, 4, 4), (1, 0.5, 0.5), (2, 1.5, 1.5))
    assert contacts(*joined(ONE, shifted)) == {(0, 1): 4}, (
        "of sixteen faces those whose middle lies on the other part"
    )


def test_R12_parts_that_stand_apart_do_not_touch() -> None:
    assert contacts(*joined(ONE, block((2, 3, 2), (1.1, 0, 0), (2, 1, 1)))) == {}
    assert contacts(*joined(ONE, block((2, 3, 2), (3, 0, 0), (4, 1, 1)))) == {}


def test_R12_faces_that_look_the_same_way_do_not_touch() -> None:
    inside = block((1, 1, 1), (0.9, 0.2, 0.2), (1, 0.4, 0.4))
    assert contacts(*joined(ONE, inside)) == {}


def test_R12_cells_of_one_label_and_joined_cells_do_not_count() -> None:
    mesh, labels = joined(ONE, block((2, 3, 2), (1, 0, 0), (2, 1, 1)))
    assert contacts(mesh, np.zeros_like(labels)) == {}
    points, cells = block((4, 3, 2), (0, 0, 0), (2, 1, 1))
    whole = Mesh.from_cells(points, cells)
    halves = (whole.barycentres[0] > 1).astype(np.int32)
    assert contacts(whole, halves) == {}


def test_R12_tetrahedra_on_a_cube() -> None:
    points, cells = block((1, 1, 1), (0, 0, 0), (1, 1, 1))
    peak = np.array([[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1], [0.5, 0.5, 2]]) * 1.0
    corners = np.concatenate([cells, [[8, 9, 10, 10, 12, 12, 12, 12], [8, 10, 11, 11, 12, 12, 12, 12]]]).T
    mesh = Mesh(np.concatenate([points, peak]).T, corners, np.array([0, 3, 3], dtype=np.uint8))
    assert contacts(mesh, np.array([0, 1, 2], dtype=np.int32)) == {(0, 1): 1, (0, 2): 1}


def test_R12_two_meshes_of_one_cylinder_touch_though_their_faces_stand_off() -> None:
    def tube(inner: float, outer: float, around: int) -> tuple[np.ndarray, np.ndarray]:
        points, cells = block((1, around, 1), (inner, 0, 0), (outer, 2 * np.pi * (1 - 1e-9), 1))
        radius, angle, height = points.T
        return np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=1), cells

    found = contacts(*joined(tube(1, 2, 24), tube(2, 3, 60)))
    assert found == {(0, 1): 60}


def test_R12_random_labels_are_counted_as_by_a_loop() -> None:
    random = np.random.default_rng(4)
    blocks = []
    for x, y in itertools.product(range(3), range(2)):
        counts = tuple(random.integers(1, 4, 3).tolist())
        blocks.append(block(counts, (x, y, 0), (x + 1, y + 1, 1)))
    mesh, labels = joined(*blocks)
    found = contacts(mesh, labels)
    topology = mesh.topology
    rows = topology.faces.boundary
    cells, local = topology.face_cells[0, rows], topology.face_locals[0, rows]
    faces = mesh.points[topology.corners_of(cells, local).T]
    wanted: dict[tuple[int, int], list[int]] = {}
    for corners, label in zip(faces, labels[cells], strict=True):
        middle = corners.mean(axis=0)
        on = set()
        for other, other_label in zip(faces, labels[cells], strict=True):
            low, high = other.min(axis=0), other.max(axis=0)
            if other_label != label and (middle >= low - 1e-12).all() and (middle <= high + 1e-12).all():
                on.add(int(other_label))
        for neighbour in on:
            pair = (min(int(label), neighbour), max(int(label), neighbour))
            wanted.setdefault(pair, [0, 0])[int(label) > neighbour] += 1
    assert found == {pair: max(both) for pair, both in wanted.items()}
