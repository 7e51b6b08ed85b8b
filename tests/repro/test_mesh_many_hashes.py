"""The pattern that recognises a format tried every way to split a row of hashes."""

from __future__ import annotations

import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes


def test_R10_hashes_before_a_mesh_do_not_take_for_ever() -> None:
    """The pattern that recognises the format tried every way to split a row of hashes."""
    with pytest.raises(MeshReadError):
        read_bytes(b"#" * 3000 + b" MeshVersion", "x.mesh")
