"""The face under the pointer, its highlight, the click that sets the centre."""

from __future__ import annotations

from typing import Any

import numpy as np

from .grids import grid_surface
from .test_drawing import FRONT, scale, show


def test_F4_picks_are_exact_to_the_pixel_in_both_projections(stage: Any) -> None:
    shown = np.ones((5, 4, 3), bool)
    show(stage, shown, camera={**FRONT, "projection": "orthographic"})
    size = scale(300)
    cell = 1 / np.linalg.norm(shown.shape)
    for i in range(5):
        for j in range(4):
            left, top = 200 + (i - 2.5) * cell * size, 150 - (j - 1) * cell * size
            for x, y in (
                (left + 1.5, top + 1.5),
                (left + cell * size - 1.5, top + 1.5),
                (left + cell * size / 2, top + cell * size - 1.5),
            ):
                hit = stage.call("pick", x, y)
                assert hit["cell"] == np.ravel_multi_index((i, j, 2), shown.shape)
                assert hit["localFace"] == 1
                assert hit["face"] == hit["cell"] * 8 + 1
    assert stage.call("pick", 3, 3) is None
    assert stage.call("pick", 200 + 2.5 * cell * size + 2, 150) is None


def test_F4_picks_follow_the_device_pixel_ratio(stage: Any) -> None:
    stage.start(400, 300, 2)
    shown = np.ones((2, 2, 2), bool)
    show(stage, shown, camera={**FRONT, "projection": "orthographic"})
    assert stage.call("pick", 195, 155)["cell"] == np.ravel_multi_index((0, 0, 1), shown.shape)
    assert stage.call("pick", 205, 145)["cell"] == np.ravel_multi_index((1, 1, 1), shown.shape)


def test_F4_faces_that_share_vertices_are_picked_too(stage: Any) -> None:
    surface = grid_surface(np.ones((2, 1, 1), bool))
    quads = np.arange(4 * len(surface["faces"]), dtype=np.uint32)
    stage.call("setMesh", {"cells": 2})
    stage.call("setStatus", {"camera": {**FRONT, "projection": "orthographic"}, "lighting": {"mode": "none"}})
    stage.call("setSurface", {**surface, "mode": "rounded", "quads": quads})
    stage.settle()
    assert stage.call("pick", 195, 150)["cell"] == 0
    assert stage.call("pick", 205, 150)["cell"] == 1


def test_F4_the_highlight_covers_the_face_and_goes_again(stage: Any) -> None:
    show(stage, np.ones((2, 2, 2), bool), camera={**FRONT, "projection": "orthographic"})
    before = stage.picture()
    face = stage.call("pick", 205, 145)["face"]
    stage.call("highlight", face)
    stage.settle()
    changed = np.any(stage.picture() != before, axis=2)
    size = scale(300) / np.sqrt(12)
    rows, columns = np.nonzero(changed)
    assert abs(rows.min() - (150 - size)) <= 2 and abs(rows.max() - 150) <= 2
    assert abs(columns.min() - 200) <= 2 and abs(columns.max() - (200 + size)) <= 2
    assert changed.sum() > 0.95 * size**2
    frames = stage.run("scene.frames")
    stage.call("highlight", face)
    stage.settle()
    assert stage.run("scene.frames") == frames
    stage.call("highlight", None)
    stage.settle()
    assert np.array_equal(stage.picture(), before)


def test_V6_a_double_click_turns_the_point_into_the_centre(stage: Any) -> None:
    show(stage, np.ones((4, 2, 2), bool), camera={**FRONT, "projection": "perspective"})
    before = stage.run("scene.camera")
    stage.page.mouse.dblclick(240, 150)
    after = stage.run("scene.camera")
    assert abs(after["target"][2] - 1 / np.sqrt(24)) < 1e-3
    assert after["target"][0] > 0.05
    assert after["direction"] == before["direction"]
    eye = [np.subtract(c["target"], np.multiply(c["direction"], c["distance"])) for c in (before, after)]
    assert abs(eye[0][2] - eye[1][2]) < 1e-6


def test_V6_dragging_turns_and_reports_and_a_still_click_is_a_click(stage: Any) -> None:
    show(stage, np.ones((2, 2, 2), bool))
    stage.run("""() => { window.seen = { camera: 0, click: [], end: 0 };
        scene.on('camera', () => seen.camera++); scene.on('cameraend', () => seen.end++);
        scene.on('click', ({ x, y }) => seen.click.push([x, y])); }""")
    mouse = stage.page.mouse
    mouse.move(200, 150)
    mouse.down()
    mouse.move(240, 170, steps=4)
    mouse.up()
    assert stage.run("seen.camera") >= 3
    assert stage.run("seen.end") == 1
    assert stage.run("seen.click") == []
    assert stage.run("scene.camera.direction[0]") > 0.05, "the near side follows the pointer"
    mouse.click(100, 90)
    assert stage.run("seen.click") == [[100, 90]]
    before = stage.run("scene.camera")
    mouse.move(300, 200)
    mouse.wheel(0, -300)
    stage.settle()
    assert stage.run("scene.camera.distance") < before["distance"]
    stage.page.keyboard.press("ArrowLeft")
    assert stage.run("scene.camera.direction") != before["direction"]
