"""A signalling NaN among 32-bit coordinates made numpy warn (found by a mutant)."""

from __future__ import annotations

import struct
import warnings

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes

CORNERS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1"


def test_R10_a_signalling_nan_among_binary_coordinates() -> None:
    points = np.array(CORNERS.split(), dtype=">f4").tobytes()
    points = points[:8] + struct.pack(">I", 0x7F800001) + points[12:]
    data = b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" + points
    data += b"\nCELLS 1 9\n" + struct.pack(">9i", 8, *range(8)) + b"\nCELL_TYPES 1\n" + struct.pack(">i", 12)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(MeshReadError, match="byte 77: the z coordinate of vertex 1 is nan"):
            read_bytes(data, "x.vtk")
