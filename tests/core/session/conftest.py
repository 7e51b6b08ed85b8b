"""Open meshes that tests of the session begin with."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from hexalab.session import Session


@pytest.fixture
def session(attributed: bytes) -> Session:
    """A session with the 3 x 2 x 1 grid that has attributes."""
    opened = Session()
    opened.open("grid.vtk", attributed)
    return opened


@pytest.fixture
def block(grid: Callable[..., bytes]) -> Session:
    """A session with a grid of 4 x 4 x 4 unit cubes."""
    opened = Session()
    opened.open("block.mesh", grid(4, 4, 4))
    return opened
