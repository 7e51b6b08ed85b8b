"""Random triangles, written by a few plain lines in every form and read again."""

from __future__ import annotations

import struct
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from hexalab.reference import TriangleSurface, read_reference_bytes
from tests.core.reference.surfaces import assert_same
from tests.core.reference.test_ply import CODES, FORMS, ply

SPACES = st.sampled_from([" ", "  ", "\t", " \t "])
NEWLINES = st.sampled_from(["\n", "\r\n", "\n\n", " \n", "\n  "])
SINGLE = st.floats(width=32, allow_nan=False, allow_infinity=False)
DOUBLE = st.floats(allow_nan=False, allow_infinity=False)
SPELLINGS = st.sampled_from([repr, "{:.17g}".format, "{:+.17e}".format, "{:.17E}".format])


@st.composite
def surfaces(draw: st.DrawFn, numbers: st.SearchStrategy[float]) -> tuple[Any, Any]:
    """(V, 3) points, all of them different, and (T, 3) triangles of three different vertices each."""
    points = draw(
        st.lists(
            st.tuples(numbers, numbers, numbers),
            min_size=3,
            max_size=12,
            unique_by=lambda p: tuple(x + 0.0 for x in p),
        )
    )
    rows = st.permutations(range(len(points))).map(lambda order: order[:3])
    triangles = draw(st.lists(rows, min_size=1, max_size=20))
    return np.array(points) + 0.0, np.array(triangles)


def check(data: bytes, points: Any, triangles: Any, whole: bool = True) -> TriangleSurface:
    found = read_reference_bytes(data, "x")
    assert_same(found, points[triangles])
    if whole:
        assert np.array_equal(found.points.T, points) and np.array_equal(found.triangles.T, triangles)
    return found


@given(surfaces(SINGLE), st.sampled_from([b"x", b"solid", b"solid x\nfacet normal"]), st.binary(max_size=40))
def test_binary_stl(surface: tuple[Any, Any], word: bytes, header: bytes) -> None:
    points, triangles = surface
    data = (word + header).ljust(80, b"x") + struct.pack("<I", len(triangles))
    for triangle in triangles:
        data += struct.pack("<12fH", *[0.0] * 3, *points[triangle].ravel(), 1)
    found = check(data, points, triangles, whole=False)
    assert found.points.shape[1] == len(np.unique(triangles))


@given(surfaces(DOUBLE), SPACES, NEWLINES, SPELLINGS, st.integers(1, 3))
def test_stl_in_text(surface: tuple[Any, Any], space: str, newline: str, spelled: Any, solids: int) -> None:
    points, triangles = surface
    text = ""
    for part in np.array_split(triangles, solids):
        text += newline.join(["solid x", ""])
        for triangle in part:
            rows = [space.join(["vertex", *map(spelled, corner)]) for corner in points[triangle].tolist()]
            text += newline.join(["facet normal 0 0 0", "outer loop", *rows, "endloop", "endfacet", ""])
        text += newline.join(["endsolid x", ""])
    found = check(text.encode(), points, triangles, whole=False)
    assert found.points.shape[1] == len(np.unique(triangles)) and found.notes == ()


@given(surfaces(DOUBLE), SPACES, NEWLINES, SPELLINGS, st.data())
def test_obj(surface: tuple[Any, Any], space: str, newline: str, spelled: Any, data: st.DataObject) -> None:
    points, triangles = surface
    form = data.draw(st.sampled_from(["{0}", "{0}/1", "{0}//{0}", "{0}/7/-1"]))
    back = data.draw(st.booleans())
    lines = [space.join(["v", *map(spelled, point)]) for point in points.tolist()]
    names = triangles - len(points) if back else triangles + 1
    lines += [space.join(["f", *(form.format(one) for one in row)]) for row in names.tolist()]
    found = read_reference_bytes(newline.join([*lines, ""]).encode(), "x.obj")
    assert np.array_equal(found.points.T, points) and np.array_equal(found.triangles.T, triangles)


@given(
    surfaces(DOUBLE), SPACES, NEWLINES, SPELLINGS, st.sampled_from(["OFF", "COFF", "NOFF", "STOFF", "CNOFF"])
)
def test_off(surface: tuple[Any, Any], space: str, newline: str, spelled: Any, kind: str) -> None:
    points, triangles = surface
    extra = ["0.5"] * (4 * ("C" in kind) + 3 * ("N" in kind) + 2 * ("ST" in kind))
    lines = [kind, f"{len(points)} {len(triangles)} 0"]
    lines += [space.join([*map(spelled, point), *extra]) for point in points.tolist()]
    lines += [space.join(map(str, [3, *row])) for row in triangles.tolist()]
    check(newline.join([*lines, ""]).encode(), points, triangles)


@given(surfaces(SINGLE), st.sampled_from(sorted(FORMS)), st.data())
def test_ply(surface: tuple[Any, Any], form: str, data: st.DataObject) -> None:
    points, triangles = surface
    types = st.sampled_from(sorted(CODES))
    whole = st.sampled_from([name for name, code in CODES.items() if code[0] in "iu"])
    others = data.draw(st.lists(st.one_of(types, st.tuples(whole, types)), max_size=3))
    others_of_vertices = data.draw(st.lists(types, max_size=2))
    place = data.draw(st.integers(0, len(others)))
    names = [
        f"list {one[0]} {one[1]} p{row}" if isinstance(one, tuple) else f"{one} p{row}"
        for row, one in enumerate(others)
    ]
    names.insert(place, f"list {data.draw(whole)} {data.draw(whole)} vertex_indices")
    rows = []
    for triangle in triangles.tolist():
        row: list[Any] = [
            [7] * data.draw(st.integers(0, 3)) if isinstance(one, tuple) else 7 for one in others
        ]
        row.insert(place, triangle)
        rows.append(row)
    corners = [
        "float x",
        "double y",
        "float32 z",
        *(f"{one} q{row}" for row, one in enumerate(others_of_vertices)),
    ]
    vertices = ("vertex", corners, [[*point, *[9] * len(others_of_vertices)] for point in points.tolist()])
    elements = [vertices, ("face", names, rows)]
    check(ply(form, *data.draw(st.permutations(elements))), points, triangles)
