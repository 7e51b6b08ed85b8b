"""The worked examples in the core's docstrings are run, so that they stay true."""

from __future__ import annotations

import doctest
from importlib import import_module

import pytest

WORKED = (
    "quality.validity",
    "surface.fan",
    "topology.classes",
    "topology.faces",
    "topology.matching",
    "topology.pairs",
    "topology.slots",
)
"""Modules that explain dense array code by an example."""


@pytest.mark.parametrize("name", WORKED)
def test_X1_worked_examples_are_true(name: str) -> None:
    done = doctest.testmod(import_module(f"hexalab.{name}"))
    assert done.attempted > 3
    assert done.failed == 0
