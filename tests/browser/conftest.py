"""The built site in real Chromium. A test fails if the console reports an error."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import hexalab
from benchmarks.page import SITE, WINDOW, serve


@pytest.fixture(scope="session")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder whose files the page finds under /bench/: write meshes there."""
    return tmp_path_factory.mktemp("shelf")


@pytest.fixture(scope="session")
def site(shelf: Path) -> Iterator[str]:
    """Address of the built site."""
    if not (SITE / "viewer" / "index.html").is_file():
        pytest.fail("the site is not built: run `make build`")
    with serve(shelf) as address:
        yield address


@pytest.fixture
def page(chromium: Browser) -> Iterator[Page]:
    """A new page in a context of its own, 1280 x 800."""
    context = chromium.new_context(viewport=WINDOW, accept_downloads=True)
    page = context.new_page()
    errors: list[str] = []
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.console_errors = errors  # type: ignore[attr-defined]
    yield page
    context.close()
    assert not errors, f"the console reported {errors}"


@pytest.fixture
def viewer(page: Page, site: str) -> Page:
    """The viewer with Python ready."""
    page.goto(f"{site}/viewer/")
    page.evaluate("() => window.hexalab.ready")
    return page


def grid(*sides: int, noise: float = 0.0) -> hexalab.Mesh:
    """A box of unit cubes, inner vertices moved by seeded noise."""
    lines = [np.arange(side + 1) for side in sides]
    points = np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3).astype(float)
    inner = ((points > 0) & (points < np.array(sides))).all(axis=1)
    points[inner] += np.random.default_rng(3).uniform(-noise, noise, points.shape)[inner]
    ids = np.arange(len(points)).reshape([side + 1 for side in sides])
    low, high = slice(None, -1), slice(1, None)
    ring = ((low, low), (high, low), (high, high), (low, high))
    cells = np.stack([ids[i, j, k].ravel() for k in (low, high) for i, j in ring], axis=1)
    return hexalab.Mesh.from_cells(points, cells)


def planes(offset: float, normal: tuple[float, float, float] = (1, 0, 0), **more: Any) -> dict[str, Any]:
    """A status with one plane."""
    item = {"enabled": True, "normal": list(normal), "offset": offset}
    return {"filters": {"planes": {"items": [item], **more}}}
