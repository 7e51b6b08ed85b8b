"""Rules of the readers for odd files: numbers that occur twice, comments and line ends, cells that do not close."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from hexalab.cells import TETRAHEDRON
from hexalab.errors import MeshReadError
from hexalab.formats import container
from hexalab.formats.file import File
from hexalab.formats.half_faces import rebuilt
from hexalab.formats.ids import Numbering
from hexalab.formats.text import Text


def test_R3_of_a_number_that_occurs_twice_the_first_entry_counts() -> None:
    random = np.random.default_rng(4)
    tags = random.integers(1, 300, 2000)
    first: dict[int, int] = {}
    for place, tag in enumerate(tags.tolist()):
        first.setdefault(tag, place)
    asked = np.arange(-1, 302)
    assert Numbering(tags).places(asked).tolist() == [first.get(tag, -1) for tag in asked.tolist()]


@pytest.mark.parametrize("end", [b"\n", b"\r\n", b"\r"])
def test_R3_a_comment_ends_with_its_line_whatever_ends_the_line(end: bytes) -> None:
    text = Text(File(b"1 # one 7" + end + b"2 #" + end + b"3", "x.mesh"), comment=b"#")
    assert text.numbers(3, np.float64, "numbers").tolist() == [1, 2, 3]


@pytest.mark.parametrize(("size", "fine"), [(10_000, True), (10_001, False)])
def test_R6_a_gzip_stream_may_reach_its_bound_and_not_pass_it(
    monkeypatch: pytest.MonkeyPatch, size: int, fine: bool
) -> None:
    monkeypatch.setattr(container, "ALWAYS_FINE", 10_000)
    monkeypatch.setattr(container, "RATIO", 1)
    source = File(gzip.compress(b"x" * size), "x.mesh")
    if fine:
        assert len(container.inflated(source)) == size
    else:
        with pytest.raises(MeshReadError, match="refused"):
            container.inflated(source)


@pytest.mark.parametrize(("apexes", "closed"), [((3, 3, 3), True), ((3, 4, 5), False), ((3, 3, 4), False)])
def test_R3_triangles_around_a_base_are_a_tetrahedron_only_if_they_meet_in_one_vertex(
    apexes: tuple[int, int, int], closed: bool
) -> None:
    a, b, c = apexes
    rings = [[0, 2, 1], [0, 1, a], [1, 2, b], [2, 0, c]]
    origins, starts, sizes = np.array(rings).reshape(-1), np.arange(0, 12, 3), np.full(4, 3)
    corners, good = rebuilt(TETRAHEDRON, np.array([[0, 2, 4, 6]]), origins, starts, sizes)
    assert good.tolist() == [closed]
    if closed:
        assert corners[:, 0].tolist() == [0, 1, 2, 3]
