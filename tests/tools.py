"""Real tools whose files and numbers are the truth: a test that uses one that is not here is left out, and counted.

>>> vtk = tool("vtk")            # the package, or a stand-in: importing it harms nobody  # doctest: +SKIP
>>> vtk.vtkPoints()              # where VTK is missing the test that gets here is skipped  # doctest: +SKIP
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from typing import Any

import pytest


def needs(package: str) -> None:
    """Leave the test out where the package is not installed; it is not imported."""
    if find_spec(package) is None:
        pytest.skip(f"needs {package}, which is not installed", allow_module_level=True)


def tool(module: str) -> Any:
    """The module, or where its package is not installed a stand-in that leaves out the test that calls it."""
    package = module.split(".")[0]
    return import_module(module) if find_spec(package) else Missing(package)


class Missing:
    """Stands for a package that is not installed, and for anything in it."""

    def __init__(self, package: str) -> None:
        self._package = package

    def __getattr__(self, name: str) -> Missing:
        if name.startswith("__"):
            raise AttributeError(name)
        return self

    def __call__(self, *values: Any, **named: Any) -> Any:
        needs(self._package)
