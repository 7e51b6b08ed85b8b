"""The worked examples in the docstrings of the room are run, so that they stay true."""

from __future__ import annotations

import doctest
from importlib import import_module

import pytest


@pytest.mark.parametrize("name", ["cutting", "lines", "strips", "surface", "welding"])
def test_worked_examples_are_true(name: str) -> None:
    done = doctest.testmod(import_module(f"hexalab.reference.{name}"))
    assert done.attempted > 0
    assert done.failed == 0
