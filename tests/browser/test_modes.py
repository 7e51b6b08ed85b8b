"""Every mode, filter, colour and light on small meshes of all kinds; pictures that guard each mode under each light."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image, ImageDraw, ImageFilter
from playwright.sync_api import Browser, Page

import hexalab
from benchmarks.modes import WALK, differences, steps
from hexalab.cells import COLLAPSE, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE

from . import guards
from .conftest import grid
from .likeness import difference
from .ui import one_viewer

pytestmark = pytest.mark.browser

CUBE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
"""Corners of a unit cube."""


def mixed() -> hexalab.Mesh:
    """A row of cubes: one whole, one of six pyramids, one of two wedges; and a tetrahedron apart."""
    row = np.stack(np.meshgrid(np.arange(4), [0, 1], [0, 1], indexing="ij"), axis=-1).reshape(-1, 3)
    points = [*row.astype(float), (1.5, 0.5, 0.5), (5, 0, 0), (6, 0, 0), (5, 1, 0), (5, 0, 1)]

    def cube(x: int) -> list[int]:
        return [4 * (x + i) + 2 * j + k for i, j, k in CUBE]

    cells: list[tuple[int, list[int]]] = [(HEXAHEDRON, cube(0))]
    split = cube(1)
    for face in ((0, 1, 2, 3), (7, 6, 5, 4), (4, 5, 1, 0), (5, 6, 2, 1), (6, 7, 3, 2), (7, 4, 0, 3)):
        cells.append((PYRAMID, [*(split[place] for place in face), len(row)]))
    last = cube(2)
    cells += [
        (WEDGE, [last[place] for place in places]) for places in ((0, 2, 1, 4, 6, 5), (0, 3, 2, 4, 7, 6))
    ]
    cells.append((TETRAHEDRON, [len(row) + place for place in (1, 2, 3, 4)]))
    corners = np.array([[own[place] for place in COLLAPSE[kind]] for kind, own in cells], np.int32)
    kinds = np.array([kind for kind, _ in cells], np.uint8)
    return hexalab.Mesh(np.array(points, float).T, corners.T, kinds)


def broken() -> hexalab.Mesh:
    """A box with vertices thrown about, so that some cells are inverted, and with cells that repeat vertices."""
    mesh = grid(4, 3, 3, noise=0.9)
    cells = mesh.cells.copy()
    cells[0, 1] = cells[0, 0]
    cells[7, 4:] = cells[7, 4]
    cells[20, [2, 6]] = cells[20, [3, 7]]
    broken = hexalab.Mesh.from_cells(mesh.points, cells)
    assert (hexalab.quality(broken, "scaled_jacobian") <= 0).sum() > 3
    return broken


@pytest.fixture(scope="module")
def viewer(chromium: Browser, site: str) -> Iterator[Page]:
    with one_viewer(chromium, site) as page:
        yield page


@pytest.mark.parametrize(
    "make", [lambda: grid(5, 4, 3, noise=0.2), mixed, broken], ids=["hexahedra", "mixed", "broken"]
)
def test_V1_every_mode_draws_what_the_core_says(
    viewer: Page, site: str, shelf: Path, make: Callable[[], hexalab.Mesh]
) -> None:
    hexalab.write(make(), shelf / "modes.vtk")
    mesh = hexalab.read(shelf / "modes.vtk")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/modes.vtk")
    walk = list(steps(mesh))
    answers = viewer.evaluate(WALK, [step.partial for step in walk])
    assert differences(mesh, walk, answers) == []


FRONT: dict[str, Any] = {
    "camera": {"projection": "orthographic", "direction": [0, 0, -1], "up": [0, 1, 0], "distance": 1.5},
    "filters": {"planes": {"items": []}, "quality": {"items": []}, "picking": {"isolated": False}},
    "separation": {"mode": "lines", "line_opacity": 0},
    "lighting": {"mode": "none"},
    "silhouette": 0,
    "irregular": {"mode": 0},
}
WIDTH, HEIGHT = 240, 180
ENDS = {"red_blue": ((0, 0, 255), (255, 0, 0)), "parula": ((0x35, 0x2A, 0x87), (0xF9, 0xFB, 0x0E))}
KINDS = [(0xF2, 0xEF, 0xE8), (0xE5, 0xA0, 0x4C), (0x5A, 0xA9, 0xA0), (0xA0, 0x6A, 0xB4)]


def seen_from_the_front(mesh: hexalab.Mesh, place: tuple[float, float, float]) -> tuple[int, int]:
    """Pixel at which the view of `FRONT` shows a place."""
    half = 1.5 * np.tan(np.radians(15))
    x, y, _ = (np.array(place) - mesh.centre) / mesh.diagonal / half
    return round(WIDTH / 2 + x * HEIGHT / 2), round(HEIGHT / 2 - y * HEIGHT / 2)


def test_V2_cells_have_the_colour_of_their_quality_under_known_pixels(
    viewer: Page, site: str, shelf: Path
) -> None:
    points = grid(3, 2, 1).points.copy()
    points[-1] += (-0.6, -0.5, 0)  # the best cells are cubes, one is clearly the worst
    mesh = hexalab.Mesh.from_cells(points, grid(3, 2, 1).cells)
    hexalab.write(mesh, shelf / "colours.mesh")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/colours.mesh")
    worst = int(np.argmin(hexalab.quality(mesh, "scaled_jacobian")))
    for name, (best_colour, worst_colour) in ENDS.items():
        picture = guards.take(viewer, {**FRONT, "colour": {"by": "quality", "map": name, "range": None}})
        for cell, colour in ((0, best_colour), (worst, worst_colour)):
            at = seen_from_the_front(mesh, tuple(mesh.barycentres[:, cell]))
            assert np.abs(np.subtract(picture.getpixel(at), colour)).max() <= 3, (name, cell)


def test_V2_kinds_have_their_colours_under_known_pixels(viewer: Page, site: str, shelf: Path) -> None:
    mesh = mixed()
    hexalab.write(mesh, shelf / "kinds.vtk")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/kinds.vtk")
    picture = guards.take(viewer, {**FRONT, "colour": {"by": "kind"}})
    for kind, place in (
        (HEXAHEDRON, (0.5, 0.5, 1)),
        (PYRAMID, (1.5, 0.5, 1)),
        (WEDGE, (2.7, 0.4, 1)),
        (TETRAHEDRON, (5.2, 0.2, 0.5)),
    ):
        at = seen_from_the_front(mesh, place)
        assert np.abs(np.subtract(picture.getpixel(at), KINDS[kind])).max() <= 3, kind


def test_V3_values_beyond_the_range_and_those_that_are_none_have_their_colours(
    viewer: Page, site: str, shelf: Path
) -> None:
    mesh = grid(4, 1, 1)
    mesh.cell_data["heat"] = np.array([0, 1, 2, np.nan])
    hexalab.write(mesh, shelf / "beyond.vtu")
    viewer.evaluate("url => window.hexalab.open(url)", f"{site}/bench/beyond.vtu")
    colours = {"above": (0, 255, 0), "below": (255, 0, 255), "missing": (10, 20, 30)}
    colour = {
        "by": "attribute",
        "attribute": "cell:heat",
        "map": "red_blue",
        "range": [0.5, 1.5],
        "beyond": True,
    }
    colour |= {name: "#{:02x}{:02x}{:02x}".format(*value) for name, value in colours.items()}
    status = {**FRONT, "colour": colour}
    picture = guards.take(viewer, status)
    expected = [colours["below"], (255, 255, 255), colours["above"], colours["missing"]]
    for cell, value in enumerate(expected):
        at = seen_from_the_front(mesh, (cell + 0.5, 0.5, 1))
        assert np.abs(np.subtract(picture.getpixel(at), value)).max() <= 3, cell


@pytest.fixture(scope="module")
def guarded(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    """The viewer with the mesh of the pictures."""
    (shelf / guards.MESH.name).write_bytes(guards.MESH.read_bytes())
    with one_viewer(chromium, site, asked="?directions=1024") as page:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/{guards.MESH.name}")
        yield page


@pytest.mark.parametrize("name", guards.NAMES)
def test_V1_V5_each_mode_under_each_light_looks_as_it_did(guarded: Page, name: str) -> None:
    found = difference(guards.take(guarded, guards.status(name)), guards.model(name))
    assert found.passes, found


@pytest.mark.parametrize(
    "change",
    [
        {"silhouette": 0},
        {"colour": {"inside": "#ffa000"}},
        {"colour": {"outside": "#ffc8ff"}},
        {"separation": {"mode": "lines", "line_opacity": 0}},
        {"irregular": {"mode": 5, "boundary": True}},
        {"background": "#f0f0f0"},
        {"filters": {"peel": {"depth": 1}}},
    ],
    ids=lambda change: next(iter(change)),
)
def test_V1_a_guard_notices_what_is_drawn_wrongly(guarded: Page, change: dict[str, Any]) -> None:
    name = "lines-direct"
    back = {"silhouette": 1, "background": "#ffffff", "colour": {"inside": "#ffff00", "outside": "#ffffff"}}
    wrong = guards.take(guarded, {**guards.status(name), **change})
    found = difference(wrong, guards.model(name))
    guards.take(
        guarded, {**guards.status(name), **back, "filters": {**guards.VIEW["filters"], "peel": {"depth": 0}}}
    )
    assert not found.passes, found


def test_V1_no_two_guards_are_alike() -> None:
    for one, other in combinations(guards.NAMES, 2):
        assert not difference(guards.model(one), guards.model(other)).passes, (one, other)


def shifted(picture: Image.Image) -> Image.Image:
    """All edges 0.4 pixels away."""
    return picture.transform(
        picture.size, Image.Transform.AFFINE, (1, 0, 0.4, 0, 1, -0.4), Image.Resampling.BILINEAR
    )


def grainy(picture: Image.Image) -> Image.Image:
    """Three levels of noise in each pixel."""
    noise = np.random.default_rng(5).integers(-3, 4, (*picture.size[::-1], 3))
    return Image.fromarray(np.clip(np.asarray(picture) + noise, 0, 255).astype(np.uint8))


def sharpened(picture: Image.Image) -> Image.Image:
    """Edges harder, as with less antialiasing."""
    return picture.filter(ImageFilter.UnsharpMask(radius=1, percent=40, threshold=0))


@pytest.mark.parametrize("distort", [shifted, grainy, sharpened])
def test_V1_a_guard_bears_what_another_gpu_does(distort: Callable[[Image.Image], Image.Image]) -> None:
    for name in guards.NAMES:
        model = guards.model(name)
        found = difference(distort(model), model)
        assert found.passes, (name, found)


def blackened(picture: Image.Image) -> Image.Image:
    """One face of some twelve pixels black."""
    spoilt = picture.copy()
    ImageDraw.Draw(spoilt).polygon([(60, 60), (72, 62), (71, 73), (60, 71)], fill="black")
    return spoilt


def mottled(picture: Image.Image) -> Image.Image:
    """Acne: each twentieth pixel of what is not background dark."""
    pixels = np.asarray(picture).copy()
    spots = (pixels.min(axis=2) < 250) & (np.random.default_rng(6).random(pixels.shape[:2]) < 0.05)
    pixels[spots] = 0
    return Image.fromarray(pixels)


def darkened(picture: Image.Image) -> Image.Image:
    """All a twentieth darker."""
    return picture.point([round(level * 0.95) for level in range(256)] * 3)


def swapped(picture: Image.Image) -> Image.Image:
    """Red and blue in each other's place."""
    red, green, blue = picture.split()
    return Image.merge("RGB", (blue, green, red))


@pytest.mark.parametrize("distort", [blackened, mottled, darkened, swapped])
def test_V1_a_guard_notices_faults_of_light_and_colour(distort: Callable[[Image.Image], Image.Image]) -> None:
    for name in guards.NAMES:
        model = guards.model(name)
        found = difference(distort(model), model)
        assert not found.passes, (name, found)
