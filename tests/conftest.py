"""What every room's tests share: where published meshes may lie, and which tests only a native Python can run."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser

ROOT = Path(__file__).resolve().parents[1]
MESHES = Path(os.environ.get("HEXALAB_MESHES", ROOT.parent / "shared" / "meshes"))
"""Published meshes with facts about them; they belong to their authors and are not part of this project."""

NATIVE = ("vtk", "vtkmodules", "gmsh", "meshio", "hypothesis", "jsonschema", "playwright", "PIL", "yaml")
"""Packages that a browser's Python lacks: a module of tests that imports one of them is left out there."""


def pytest_ignore_collect(collection_path: Path) -> bool | None:
    if sys.platform != "emscripten" or collection_path.suffix != ".py":
        return None
    imported = re.findall(r"^\s*(?:import|from)\s+(\w+)", collection_path.read_text(), re.MULTILINE)
    return True if any(name in NATIVE and find_spec(name) is None for name in imported) else None


@pytest.fixture(scope="session")
def meshes() -> Path:
    """Folder of published meshes; the test is skipped where it is absent."""
    if not MESHES.is_dir():
        pytest.skip(f"no published meshes in {MESHES}")
    return MESHES


@pytest.fixture(scope="session")
def expected(meshes: Path) -> dict[str, Any]:
    """Facts about each published mesh by its file name, from dictionaries and VTK's Verdict."""
    facts: dict[str, Any] = json.loads((meshes / "expected.json").read_text())
    return facts


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    """The one Chromium of all tests: Playwright runs but once in a thread."""
    from hexalab.hosts.browser import browser

    with browser() as running:
        yield running
