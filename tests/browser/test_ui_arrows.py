"""Vectors of a file as arrows: chosen in the panel, told in words, seen in the picture."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

from . import ui
from .conftest import grid, planes

MESH = grid(4, 3, 2)
MESH.point_data["flow"] = MESH.points * [1.0, 0.5, -0.25]
MESH.point_data["heat"] = MESH.points[:, 0]


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site) as page:
        yield page


@pytest.fixture
def mesh(opened: Page, site: str, shelf: Path) -> Page:
    ui.open_mesh(opened, site, shelf, MESH, "vectors.vtk")
    ui.unfold(opened)
    ui.reset(opened)
    return opened


def picture(page: Page) -> np.ndarray:
    """The canvas, (h, w, 3), without the axes in its corner."""
    page.evaluate("() => window.hexalab.setStatus({})")
    page.mouse.move(2, 2)
    shot = np.array(Image.open(io.BytesIO(page.locator("#canvas").screenshot())).convert("RGB")).astype(int)
    shot[-110:, -110:] = 0
    return shot


def inked(before: np.ndarray, after: np.ndarray) -> Any:
    return (np.abs(after - before).max(axis=2) > 60).sum()


def test_R8_a_vector_of_the_file_is_picked_and_drawn_as_arrows(mesh: Page) -> None:
    bare = picture(mesh)
    options = mesh.locator("#arrows option").evaluate_all("all => all.map((one) => [one.value, one.text])")
    assert options == [["", "none"], ["point:flow", "flow"]]
    assert not mesh.locator("#arrows-length").is_visible()
    mesh.locator("#arrows").select_option("point:flow")
    assert ui.status(mesh)["arrows"]["attribute"] == "point:flow"
    with_arrows = picture(mesh)
    assert inked(bare, with_arrows) > 1000
    longest = float(np.linalg.norm(MESH.point_data["flow"], axis=1).max())
    told = mesh.locator(".arrows-told")
    ui.until(lambda: told.inner_text() == f"52 arrows; longest vector: {longest:.3f}")
    slider = mesh.locator("#arrows-length")
    slider.focus()
    slider.press("End")
    assert ui.status(mesh)["arrows"]["length"] == pytest.approx(0.2)
    assert inked(bare, picture(mesh)) > 2 * inked(bare, with_arrows)
    mesh.locator("#arrows").select_option("")
    assert np.array_equal(picture(mesh), bare)
    assert not told.is_visible() and not slider.is_visible()


def test_R8_arrows_follow_a_slice_and_their_ink_and_a_picture_has_them(mesh: Page) -> None:
    ui.set_status(mesh, {"arrows": {"attribute": "point:flow", "colour": "#e00000", "length": 0.2}})
    ui.set_status(mesh, planes(0.6))
    ui.until(lambda: mesh.locator(".arrows-told").inner_text().startswith("32 arrows"))  # of 2 x 3 x 2 cells
    red = lambda shot: int(((shot[..., 0] - shot[..., 1:].max(axis=2)) > 80).sum())  # noqa: E731
    assert red(picture(mesh)) > 300
    ui.set_status(mesh, planes(1))
    assert red(picture(mesh)) == 0
    ui.until(lambda: mesh.locator(".arrows-told").inner_text() == "no arrows")


def test_R8_a_mesh_without_vectors_offers_no_arrows_and_refuses_them(
    mesh: Page, site: str, shelf: Path
) -> None:
    ui.set_status(mesh, {"arrows": {"attribute": "point:flow"}})
    (rejection,) = ui.set_status(mesh, {"arrows": {"attribute": "point:heat", "length": 0.1}})
    assert rejection["path"] == "arrows.attribute"
    assert rejection["expected"] == "one of the attributes of three components: point:flow"
    assert ui.status(mesh)["arrows"] == {"attribute": "point:flow", "length": 0.1, "colour": "#1d1f23"}
    ui.open_mesh(mesh, site, shelf, grid(2, 2, 2), "plain.vtk")
    assert ui.status(mesh)["arrows"]["attribute"] == ""
    assert not mesh.locator("#arrows").is_visible()
