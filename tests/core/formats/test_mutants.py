"""SPEC R10: whatever the bytes, a reader gives a sound mesh or a MeshReadError, with bounded work and memory."""

from __future__ import annotations

import tracemalloc
import warnings

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.mutants import mutant, seeds
from tests.counting import lines_of_core

LINES, LINES_OF_A_BYTE = 5_000, 10
"""Lines of Python that a reader may run, and how many more for each byte of the file."""
MEGABYTES = 200
IN_TEST, NIGHTLY = range(1_000), range(1_000, 22_000)


def sound_or_refused(name: str, data: bytes) -> bool:
    """Whether the bytes are a mesh; fails on anything but a sound mesh or a MeshReadError."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        try:
            mesh = read_bytes(data, name)
        except MeshReadError as error:
            message = str(error)
            assert error.file == name and "\n" not in message and len(message) < 500, message
            assert error.line is None or error.line >= 1
            assert error.offset is None or error.offset >= 0
            return False
    assert mesh.coordinates.shape == (3, mesh.vertex_count) and np.isfinite(mesh.coordinates).all()
    assert mesh.corners.shape == (8, mesh.cell_count) and mesh.cell_count > 0
    assert mesh.corners.dtype == np.int32 and mesh.coordinates.dtype == np.float64
    assert mesh.corners.min() >= 0 and mesh.corners.max() < mesh.vertex_count
    assert mesh.kinds.shape == (mesh.cell_count,) and mesh.kinds.max() < 4
    for arrays, count in ((mesh.point_data, mesh.vertex_count), (mesh.cell_data, mesh.cell_count)):
        assert all(len(values) == count and values.dtype.kind in "iufb" for values in arrays.values())
    assert all(isinstance(note, str) and len(note) < 500 for note in mesh.notes)
    return True


def check_all(cases: object) -> tuple[int, int]:
    """Check pairs of a name and bytes; how many were meshes and how many refused."""
    read = refused = 0
    tracemalloc.start()
    try:
        for label, name, data in cases:  # type: ignore[attr-defined]
            tracemalloc.reset_peak()
            before = tracemalloc.get_traced_memory()[0]
            try:
                lines, good = lines_of_core(lambda name=name, data=data: sound_or_refused(name, data))
            except BaseException as error:
                raise AssertionError(f"{label} of {name}: {type(error).__name__}: {error}") from error
            read, refused = read + good, refused + (not good)
            peak = (tracemalloc.get_traced_memory()[1] - before) / 2**20
            allowed = LINES + LINES_OF_A_BYTE * len(data)
            assert lines < allowed and peak < MEGABYTES, (
                f"{label} of {name}: {lines} lines where {allowed} are allowed, {peak:.0f} MB"
            )
    finally:
        tracemalloc.stop()
    return read, refused


def test_R10_the_seeds_are_good() -> None:
    read, refused = check_all(("seed", *seed) for seed in seeds())
    assert refused == 0 and read > 15


def test_R10_a_thousand_mutants() -> None:
    read, refused = check_all((f"mutant {number}", *mutant(number)) for number in IN_TEST)
    assert read > 100 and refused > 300


@pytest.mark.nightly
def test_R10_many_mutants() -> None:
    read, refused = check_all((f"mutant {number}", *mutant(number)) for number in NIGHTLY)
    assert read + refused == len(NIGHTLY)


def test_R10_prefixes_of_each_seed() -> None:
    check_all(
        (f"prefix {length}", name, data[:length])
        for name, data in seeds()
        for length in range(0, len(data), max(1, len(data) // 40))
    )


@pytest.mark.nightly
def test_R10_every_prefix_of_each_seed() -> None:
    check_all(
        (f"prefix {length}", name, data[:length]) for name, data in seeds() for length in range(len(data))
    )
