"""The light: against ray tracing, the same on every run, restarted only by geometry (SPEC V5, P4)."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import pytest

from hexalab.formats import read
from hexalab.mesh import Mesh
from hexalab.surface import DrawnMesh, extract_surface
from tests.whole_meshes import WHOLE_MESHES

from .grids import grid_surface, pack
from .rays import openness
from .test_drawing import FRONT, show

BASE64 = """(array) => {
    const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
    let text = '';
    for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
    return btoa(text);
}"""


def numbers(stage: Any, expression: str, dtype: Any = np.float32) -> np.ndarray:
    """Return a typed array of the page."""
    return np.frombuffer(base64.b64decode(stage.run(f"({BASE64})({expression})")), dtype)


def gather(stage: Any, surface: dict[str, Any]) -> np.ndarray:
    """Return the openness of every drawn vertex after all directions."""
    stage.call("setMesh", {"cells": 1})
    stage.call("setStatus", {"lighting": {"mode": "none"}, "silhouette": 0})
    stage.call("setSurface", surface)
    stage.run("() => { while (!scene.lighting.object.done) scene.lighting.object.advance(16); }")
    return numbers(stage, "scene.lighting.object.read()")


def whole(name: str) -> Mesh:
    """Return a mesh of a file by a part of its name."""
    (found,) = [mesh for mesh in WHOLE_MESHES if name in mesh.name]
    return read(found.file())


def surface_of(mesh: Mesh, mode: str) -> dict[str, Any]:
    """Return the surface of the half of a mesh that lies beyond the middle along x."""
    middle = mesh.points[mesh.cells].mean(axis=1)[:, 0]
    found = extract_surface(DrawnMesh(mesh), middle > (middle.min() + middle.max()) / 2, mode).arrays()
    return {k: np.ravel(v) if isinstance(v, np.ndarray) else v for k, v in found.items()}


def cavity() -> Mesh:
    """Return a box of 12 x 8 x 8 unit cells with a square shaft six cells deep."""
    there = np.ones((12, 8, 8), bool)
    there[6:, 3:5, 3:5] = False
    there[7:9, 2:6, 2:6] = False
    ids = np.arange(13 * 9 * 9).reshape(13, 9, 9)
    offsets = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cells = np.stack([ids[x : x + 12, y : y + 8, z : z + 8][there] for x, y, z in offsets], axis=1)
    points = np.stack(np.meshgrid(np.arange(13.0), np.arange(9.0), np.arange(9.0), indexing="ij"), -1)
    return Mesh.from_cells(points.reshape(-1, 3), cells)


LARGE = pytest.mark.nightly
"""Gaps between cells and rounded ones want depth maps of a million pixels: half a minute without a graphics card."""


@pytest.mark.parametrize(
    ("name", "mode"),
    [
        pytest.param(
            name, mode, marks=LARGE if mode != "lines" and name in ("rod-rod", "DEMO09", "hex-joint") else ()
        )
        for name in ("cavity", "structures/tunnels", "shapes/t-junction", "rod-rod", "DEMO09", "hex-joint")
        for mode in ("lines", "fissure", "rounded")
    ],
)
def test_V5_openness_is_that_of_traced_rays(stage: Any, name: str, mode: str) -> None:
    surface = surface_of(cavity() if name == "cavity" else whole(name), mode)
    directions = numbers(stage, "scene.lighting.object.directions", np.float64).reshape(-1, 3)
    assert directions.shape == (1024, 3)
    count = len(surface["positions"]) // 3
    some = np.random.default_rng(5).choice(count, min(count, 160), replace=False)
    found = gather(stage, surface)[some]
    # A quarter of the directions tells the truth to a hundredth; tracing all takes minutes.
    truth = openness(surface, some, directions[:256])
    error = np.abs(found - truth)
    assert error.mean() < 0.03, f"mean error {error.mean():.4f}"
    assert np.quantile(error, 0.95) < 0.1, f"95th percentile {np.quantile(error, 0.95):.4f}"
    assert truth.std() > 0.05


def test_V5_a_convex_body_is_open_everywhere_and_a_closed_room_nowhere(stage: Any) -> None:
    found = gather(stage, grid_surface(np.ones((5, 4, 3), bool)))
    assert found.min() > 0.995
    shell = np.ones((5, 5, 5), bool)
    shell[1:4, 1:4, 1:4] = False
    surface = grid_surface(shell)
    found = gather(stage, surface)
    inner = np.abs(surface["positions"].reshape(-1, 3)).max(axis=1) < 0.9 * 2.5 / np.sqrt(75)
    assert inner.sum() == 6 * 9 * 4
    assert found[inner].max() < 0.01
    assert found[~inner].min() > 0.99


def test_V5_inverted_faces_are_lit_from_the_side_that_is_open(stage: Any) -> None:
    surface = grid_surface(np.ones((4, 4, 4), bool))
    turned = surface["normals"].reshape(-1, 4).copy()
    turned[::16] *= -1
    turned[1::16] *= -1
    found = gather(stage, {**surface, "normals": turned.ravel()})
    assert found.min() > 0.97


def slab(shape: tuple[int, int, int]) -> Mesh:
    """Return a block of unit cubes."""
    ids = np.arange(np.prod(np.array(shape) + 1)).reshape(np.array(shape) + 1)
    offsets = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    x, y, z = shape
    corners = [ids[i : i + x, j : j + y, k : k + z].ravel() for i, j, k in offsets]
    return Mesh.from_cells(
        np.stack(np.unravel_index(ids.ravel(), ids.shape), axis=1), np.stack(corners, axis=1)
    )


@pytest.mark.parametrize("kind", ["holes", "bar rounded", "bar fissure", "plate lines"])
def test_V5_the_sums_are_the_same_on_every_run_and_for_every_batch(stage: Any, kind: str) -> None:
    # Long and thin bodies: along them a pixel of the depth map is far smaller than their diagonal suggests.
    shapes = {"bar": (16, 1, 1), "plate": (9, 9, 1)}
    stage.start(directions=144)  # at which lots of 1, 3, 16 and 7 do not end
    body, _, mode = kind.partition(" ")
    surface = (
        surface_of(slab(shapes[body]), mode)
        if mode
        else grid_surface(np.random.default_rng(2).random((6, 5, 4)) < 0.6)
    )
    first = gather(stage, surface)
    again = gather(stage, surface)
    assert np.array_equal(first, again)
    for lots in ([1], [1, 3, 16, 7], [8]):
        stage.call("setSurface", surface)
        stage.page.evaluate(
            """(lots) => {
                const { object } = scene.lighting;
                for (let k = 0; !object.done; k++) object.advance(lots[k % lots.length]);
            }""",
            lots,
        )
        assert np.array_equal(numbers(stage, "scene.lighting.object.read()"), first)


def test_V5_only_geometry_starts_the_light_anew(stage: Any) -> None:
    show(stage, np.ones((3, 3, 3), bool), lighting={"mode": "object_space_ao"})
    stage.run("scene.settled()")
    stage.call("setCellColours", np.linspace(0, 1, 27).astype(np.float32))
    for status in (
        {"colour": {"by": "quality", "map": "jet"}},
        {"camera": {**FRONT, "distance": 1.1}},
        {"silhouette": 0.5, "irregular": {"mode": 3}},
        {"lighting": {"mode": "direct"}},
        {"lighting": {"mode": "object_space_ao"}},
    ):
        stage.call("setStatus", status)
        stage.settle()
        assert stage.run("scene.lighting.object.count") == 1024
    begun = stage.page.evaluate(
        "(surface) => { scene.setSurface(unpack(surface)); return scene.lighting.object.count; }",
        pack(grid_surface(np.ones((3, 3, 2), bool))),
    )
    assert begun == 0


def test_V5_the_first_light_is_in_the_first_picture(stage: Any) -> None:
    shown = np.ones((4, 4, 4), bool)
    shown[2:, 2:, 2:] = False
    show(stage, shown, lighting={"mode": "object_space_ao"})
    stage.call("setSurface", grid_surface(shown))
    directions = stage.run("""async () => {
        const before = scene.frames;
        while (scene.frames === before) await next();
        return scene.lighting.object.count;
    }""")
    assert directions >= 6


def test_V5_screen_space_light_darkens_creases_and_casts_no_halo(stage: Any) -> None:
    shown = np.ones((8, 8, 8), bool)
    shown[4:, 4:, :] = False
    view = {**FRONT, "direction": [-0.6, -0.6, -0.53], "up": [0, 1, 0]}
    colours = {"by": "sides", "outside": "#ffffff", "inside": "#ffffff"}
    show(stage, shown, lighting={"mode": "direct"}, camera=view, colour=colours, silhouette=0)
    model = stage.picture()
    stage.call("setStatus", {"lighting": {"mode": "screen_space_ao"}})
    stage.settle()
    lit = stage.picture()[..., 0].astype(int)
    background = np.all(model == 255, axis=2)
    assert np.all(lit[background] == 255), "nothing is darkened beside the model"
    inside = lit[~background]
    assert np.quantile(inside, 0.02) < 0.8 * np.median(inside)
    # Along the outer rim of the model no band is darker than the faces within.
    rim = ~background & (np.roll(background, 2, 0) | np.roll(background, -2, 0) | np.roll(background, 2, 1))
    assert np.median(lit[rim]) > 0.85 * np.median(inside)
