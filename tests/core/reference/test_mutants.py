"""Whatever the bytes, a reader gives a sound surface or a MeshReadError, with bounded work and memory (SPEC R10)."""

from __future__ import annotations

import gzip
import random
import tracemalloc
import warnings
from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.reference import is_surface, read_reference_bytes
from tests.core.conftest import grid_points, legacy_vtk
from tests.core.formats import mutants
from tests.core.reference.surfaces import ball
from tests.core.reference.test_ply import FORMS, ply, simple
from tests.core.reference.test_stl import binary, in_text
from tests.counting import lines_of_core

LINES, LINES_OF_A_BYTE = 5_000, 10
"""Lines of Python that a reader may run, and how many more for each byte of the file."""
MEGABYTES = 200
IN_TEST, NIGHTLY = range(1_500), range(1_500, 30_000)


@cache
def seeds() -> tuple[tuple[str, bytes], ...]:
    """Names and bytes of small good files; without VTK fewer of them."""
    points, triangles = ball(0)
    places = [" ".join(map(str, point)) for point in points.tolist()]
    out = [
        ("a.stl", in_text(*points[triangles]).encode()),
        ("b.stl", binary(*points[triangles], header=b"solid")),
    ]
    faces = [[*map(int, triangle)] for triangle in triangles]
    mixed = [faces[0], [0, 2, 1, 3], faces[1], [0, 1, 2, 3, 4], faces[2]]
    for form in FORMS:
        out += [(f"{form}.ply", simple(form, points, faces)), (f"{form}2.ply", simple(form, points, mixed))]
        out.append((f"{form}3.ply", ply(
            form,
            ("face", ["uchar q", "list int float t", "list ushort uint vertex_index"],
             [[1, [0.5] * (row % 3), face] for row, face in enumerate(mixed)]),
            ("vertex", ["double x", "double y", "double z", "uchar red"], [[*point, 9] for point in points.tolist()]),
        )))  # fmt: skip
    rows = ["f " + " ".join(f"{one + 1}/1/{one - 6}" for one in face) for face in mixed]
    out.append(
        (
            "a.obj",
            "\n".join(
                ["# x", *(f"v {place}" for place in places), "vn 0 0 1", *rows, "f -1 -2 \\\n-3", ""]
            ).encode(),
        )
    )
    rows = [f"{len(face)} {' '.join(map(str, face))} 0.5 0.5 1" for face in mixed]
    out.append(
        (
            "a.off",
            "\n".join(
                [f"COFF\n6 {len(rows)} 0 # x", *(f"{place} 1 2 3 4" for place in places), *rows, ""]
            ).encode(),
        )
    )
    out.append(("b.off", " ".join(["OFF 6 2 0", *places, "3 0 1 2 4 0 1 2 3"]).encode()))
    out.append(("a.vtk", legacy_vtk(*grid_points((1, 1, 1)))))
    out.append(("a.obj.gz", gzip.compress(out[-4][1])))
    return tuple(out + (files_of_vtk() if find_spec("vtk") else []))


def files_of_vtk() -> list[tuple[str, bytes]]:
    """Seeds written by VTK."""
    from tests.core.reference.surfaces import written
    from tests.core.reference.test_vtk_polydata import VERSIONS, XML, legacy, vtk, with_everything

    data = with_everything()
    out = [(f"{version}{mode[-6:]}.vtk", legacy(data, version, mode)) for version, mode in VERSIONS]
    return out + [
        (f"{number}.vtp", written(vtk.vtkXMLPolyDataWriter(), data, **calls))
        for number, calls in enumerate(XML)
    ]


def mutant(number: int) -> tuple[str, bytes]:
    """The name and bytes of the mutant with that number; the same on every run."""
    source = random.Random(number)
    name, data = source.choice(seeds())
    zipped = name.endswith(".gz") and source.random() < 0.7
    data = gzip.decompress(data) if zipped else data
    for _ in range(source.choice((1, 1, 1, 2, 3))):
        data = source.choice(mutants.MUTATORS)(source, data)
    if source.random() < 0.05:
        name = source.choice(seeds())[0]
    return name, gzip.compress(data) if zipped else data


def sound_or_refused(name: str, data: bytes) -> bool:
    """Whether the bytes are a surface; fails on anything but a sound surface or a MeshReadError."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        assert is_surface(data, name) in (True, False)
        try:
            found = read_reference_bytes(data, name)
        except MeshReadError as error:
            message = str(error)
            assert error.file == name and "\n" not in message and len(message) < 500, message
            assert error.line is None or error.line >= 1
            assert error.offset is None or error.offset >= 0
            return False
        assert np.isfinite(found.points).all() and found.points.dtype == np.float64
        assert found.count > 0 and found.triangles.dtype == np.int32
        assert found.triangles.min() >= 0 and found.triangles.max() < found.points.shape[1]
        a, b, c = found.triangles
        assert ((a != b) & (b != c) & (c != a)).all()
        assert found.area >= 0 and found.closed in (True, False) and found.volume is not None
        assert all(isinstance(note, str) and len(note) < 500 for note in found.notes)
    return True


def check_all(cases: Iterable[tuple[str, str, bytes]]) -> tuple[int, int]:
    """How many were surfaces and how many refused."""
    read = refused = 0
    tracemalloc.start()
    try:
        for label, name, data in cases:
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


def test_the_seeds_are_good() -> None:
    read, refused = check_all(("seed", *seed) for seed in seeds())
    assert refused == 0 and read > 15


def test_mutants() -> None:
    read, refused = check_all((f"mutant {number}", *mutant(number)) for number in IN_TEST)
    assert read > 100 and refused > 300


def test_prefixes_of_each_seed() -> None:
    check_all(
        (f"prefix {length}", name, data[:length])
        for name, data in seeds()
        for length in range(0, len(data), max(1, len(data) // 40))
    )


@pytest.mark.nightly
def test_many_mutants() -> None:
    check_all((f"mutant {number}", *mutant(number)) for number in NIGHTLY)


@pytest.mark.nightly
def test_every_prefix_of_each_seed() -> None:
    check_all(
        (f"prefix {length}", name, data[:length]) for name, data in seeds() for length in range(len(data))
    )
