"""`np.fromstring(text, count=n)` returns unwritten memory where the text has fewer numbers."""

from __future__ import annotations

import numpy as np

from hexalab.formats import read_bytes


def test_R1_numpy_returns_unwritten_memory_for_a_count_too_large() -> None:
    """`np.fromstring(text, count=n)` does not tell when the text has fewer numbers: a piece that ends early."""
    rows = "\n".join(["1.00000000000000000000000000000000000000000000000000000e+00 0 0 0"] * 6000)
    mesh = f"MeshVersionFormatted 2\nDimension 3\nVertices\n6000\n{rows}\nTetrahedra\n1\n1 2 3 4 0\nEnd\n"
    found = read_bytes(mesh.encode(), "x.mesh").points
    np.testing.assert_array_equal(found, np.tile([1.0, 0, 0], (6000, 1)))
