"""The viewer before the native core, with a box open: one for all tests of what leaves the page."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import hexalab
from hexalab.hosts.loopback import Loopback
from hexalab.hosts.offers import file_offers

from .. import grouped
from ..conftest import grid

SIZE = {"width": 900, "height": 700}


@pytest.fixture(scope="package")
def brick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A box of 4 x 3 x 2 unit cubes far from the origin, in a file."""
    mesh = grid(4, 3, 2)
    path = tmp_path_factory.mktemp("export") / "brick.vtk"
    moved = hexalab.Mesh(mesh.coordinates + np.array([[100.0], [20], [-3]]), mesh.corners, mesh.kinds)
    hexalab.write(moved, path)
    return path


@pytest.fixture(scope="package")
def flow(brick: Path) -> Path:
    """The same box with a vector in each cell, and a number at each vertex."""
    mesh = hexalab.read(brick)
    mesh.cell_data["flow"] = np.arange(72.0).reshape(24, 3)
    mesh.point_data["height"] = mesh.coordinates[2]
    path = brick.with_name("flow.vtk")
    hexalab.write(mesh, path)
    return path


@pytest.fixture(scope="package")
def deck(brick: Path) -> Path:
    """A box with sets, and numbers of its own."""
    path = brick.with_name("deck.inp")
    grouped.deck(path)
    return path


@pytest.fixture(scope="package")
def viewer(chromium: Browser, brick: Path, flow: Path, deck: Path) -> Iterator[Page]:
    """The viewer before the native core, with the first box open; the others are offered, too."""
    with Loopback(file_offers([brick, flow, deck]), opens=False) as server:
        server.start()
        context = chromium.new_context(viewport=SIZE, accept_downloads=True)
        page = context.new_page()
        errors: list[str] = []
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(server.address)
        page.evaluate("() => window.hexalab.ready")
        page.evaluate("() => window.hexalab.openOffered('0')")
        yield page
        context.close()
        server.shutdown()
        assert not errors, f"the console reported {errors}"


@pytest.fixture(autouse=True)
def fresh(viewer: Page) -> None:
    """Each test begins with the mesh's own settings."""
    viewer.keyboard.press("Escape")
    viewer.evaluate("() => window.hexalab.reset()")
