"""Later releases of numpy give no number at all where a word follows that is none (found under numpy 2.4)."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.formats import read_bytes
from hexalab.formats.tokens import parse


@pytest.mark.parametrize(
    ("text", "dtype", "numbers"),
    [
        (b"1 2 x 3", np.float64, [1, 2]),
        (b"1 2 x 3", np.int64, [1, 2]),
        (b"x", np.int64, []),
        (b"-1. .5 +2e3 nan inf 7\nEnd", np.float64, [-1, 0.5, 2000, np.nan, np.inf, 7]),
    ],
)
def test_R10_numbers_before_a_word_are_kept(text: bytes, dtype: type, numbers: list[float]) -> None:
    values, stopped = parse(text, dtype)
    np.testing.assert_array_equal(values, np.array(numbers, dtype))
    assert stopped


def test_R1_fortran_exponents_before_a_word() -> None:
    """`1d2` is a number to us and none to numpy: the text before it is asked for, not the text before `Hexahedra`."""
    rows = "\n".join(f"{x}d0 {y}d0 {z}.d+00 0" for x, y, z in np.ndindex(2, 2, 2))
    text = f"MeshVersionFormatted 2\nDimension 3\nVertices\n8\n{rows}\nHexahedra\n1\n1 2 3 4 5 6 7 8 0\nEnd\n"
    np.testing.assert_array_equal(read_bytes(text.encode(), "x.mesh").points, list(np.ndindex(2, 2, 2)))
