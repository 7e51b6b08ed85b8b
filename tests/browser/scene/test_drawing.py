"""What stands on the canvas: colours, lines, backgrounds, and that nothing is drawn at rest."""

from __future__ import annotations

from typing import Any

import numpy as np

from .grids import grid_surface

FRONT = {"target": [0, 0, 0], "direction": [0, 0, -1], "up": [0, 1, 0], "distance": 1.5, "fit": False}
NO_LINES = {"line_opacity": 0}


def show(stage: Any, shown: np.ndarray, **status: Any) -> None:
    stage.call("setMesh", {"cells": shown.size})
    plain = {"lighting": {"mode": "none"}, "camera": {**FRONT, "projection": "orthographic"}}
    stage.call("setStatus", {**plain, "separation": NO_LINES, "background": "#ffffff", **status})
    stage.call("setSurface", grid_surface(shown))
    stage.settle()


def at(picture: np.ndarray, place: tuple[float, float, float], projection: float) -> list[int]:
    """Return the colour of the pixel where a place of the scene appears, seen from the front."""
    height, width, _ = picture.shape
    x = width / 2 + place[0] * projection
    y = height / 2 - place[1] * projection
    return [int(c) for c in picture[int(y), int(x)]]


def scale(height: int) -> float:
    """Return the pixels to a diagonal at the target's distance."""
    return height / (2 * 1.5 * np.tan(np.radians(15)))


def test_V2_sides_have_exactly_their_colours(stage: Any) -> None:
    shown = np.ones((4, 3, 2), bool)
    shown[2:, :, 1] = False
    colours = {"by": "sides", "outside": "#12ab9c", "inside": "#e07b39"}
    show(stage, shown, colour=colours)
    picture = stage.picture()
    size = scale(300)
    cell = 1 / np.linalg.norm(shown.shape)
    assert at(picture, (-1.5 * cell, 0, 0), size) == [0x12, 0xAB, 0x9C]
    assert at(picture, (1.5 * cell, 0, 0), size) == [0xE0, 0x7B, 0x39]
    assert at(picture, (0.48, 0, 0), size) == [255, 255, 255]


def test_P6_recolouring_uploads_no_geometry_and_takes_one_frame(stage: Any) -> None:
    shown = np.ones((4, 2, 1), bool)
    show(stage, shown, colour={"by": "quality", "map": "jet"})
    stage.run("""() => {
        const gl = document.querySelector('canvas').getContext('webgl2');
        window.uploads = 0;
        for (const name of ['bufferData', 'bufferSubData']) {
            const old = gl[name].bind(gl);
            gl[name] = (...values) => { if (values[0] === gl.ARRAY_BUFFER) window.uploads++; old(...values); };
        }
    }""")
    frames = stage.run("scene.frames")
    values = np.linspace(0, 1, 8).astype(np.float32)
    values[3] = np.nan
    stage.call("setCellColours", values)
    stage.settle()
    assert stage.run("scene.frames") - frames == 1
    size = scale(300)
    cell = 1 / np.linalg.norm(shown.shape)
    picture = stage.picture()
    ids = np.arange(8).reshape(4, 2)
    assert at(picture, (-1.5 * cell, -0.5 * cell, 0), size) == [0, 0, 0x7F]
    assert at(picture, (1.5 * cell, 0.5 * cell, 0), size) == [0x8D, 0, 0]
    assert ids[1, 1] == 3
    assert at(picture, (-0.5 * cell, 0.5 * cell, 0), size) == [0x8C, 0x8C, 0x8C]
    stage.call("setStatus", {"colour": {"by": "quality", "map": "viridis"}})
    stage.settle()
    assert at(stage.picture(), (1.5 * cell, 0.5 * cell, 0), size) == [0xFD, 0xE7, 0x25]
    assert stage.run("scene.frames") - frames == 2
    assert stage.run("window.uploads") == 0


def test_V2_kinds_have_a_colour_each(stage: Any) -> None:
    show(stage, np.ones((4, 1, 1), bool), colour={"by": "kind", "map": "parula"})
    stage.call("setCellColours", np.arange(4, dtype=np.float32))
    stage.settle()
    picture = stage.picture()
    cell = 1 / np.sqrt(18)
    found = {tuple(at(picture, ((k - 1.5) * cell, 0, 0), scale(300))) for k in range(4)}
    assert len(found) == 4


def test_V6_nothing_is_drawn_at_rest_nor_for_a_status_that_changes_nothing(stage: Any) -> None:
    show(stage, np.ones((3, 3, 3), bool), lighting={"mode": "object_space_ao"})
    stage.run("scene.settled()")
    stage.settle()
    frames = stage.run("scene.frames")
    stage.run("next(20)")
    stage.run("scene.setStatus({ camera: scene.camera, silhouette: 1 })")
    stage.run("scene.setStatus({ camera: scene.camera, silhouette: 1 })")
    stage.run("next(10)")
    assert stage.run("scene.frames") - frames <= 1
    stage.run("scene.setStatus({ camera: { ...scene.camera, distance: 1.2 } })")
    stage.run("next(10)")
    assert stage.run("scene.frames") - frames <= 2


def test_V1_lines_are_a_pixel_or_more_and_dark_at_any_zoom(stage: Any) -> None:
    for distance in (0.2, 1.5, 4.0):
        camera = {**FRONT, "distance": distance, "projection": "perspective"}
        separation = {"line_opacity": 1, "line_width": 1}
        show(stage, np.ones((2, 2, 2), bool), separation=separation, camera=camera, silhouette=0)
        row = stage.picture()[150 - max(4, int(20 / distance)), :, 0].astype(int)
        middle = row[195:206]
        ink = (255 - middle).sum() / 255
        assert 0.9 < ink < 2.2, f"{ink} pixels of ink at distance {distance}"
        assert middle.min() < 140


def test_V1_no_line_shines_through_or_breaks_on_a_slanted_face(stage: Any) -> None:
    camera = {**FRONT, "direction": [-0.75, -0.12, -0.65], "projection": "perspective"}
    show(stage, np.ones((6, 6, 6), bool), camera=camera, separation={"line_opacity": 1, "line_width": 1})
    with_lines = stage.picture()
    stage.call("setStatus", {"separation": NO_LINES})
    stage.settle()
    without = stage.picture()
    inked = (with_lines.astype(int) - without).sum(axis=2) < -60
    # Three slanted sides of 6 x 6 cells: lines cover a share of their pixels and no side is left blank or blackened.
    model = without.sum(axis=2) == 765
    assert 0.02 < inked.mean() < 0.3
    assert model.any()


def test_V1_where_lines_meet_they_are_as_dark_as_elsewhere(stage: Any) -> None:
    for colours in ({"by": "sides", "outside": "#ffffff"}, {"by": "sides", "outside": "#101040"}):
        show(
            stage, np.ones((3, 3, 1), bool), colour=colours, separation={"line_opacity": 0.4, "line_width": 6}
        )
        picture = stage.picture().astype(int)
        cell = 1 / np.sqrt(19)
        face = np.array(at(picture, (0, 0, 0), scale(300)))
        crossing = np.array(at(picture, (cell / 2, cell / 2, 0), scale(300)))
        beside = np.array(at(picture, (cell / 2, 0, 0), scale(300)))
        assert np.abs(crossing - beside).max() <= 1
        assert np.abs(face - beside).max() > 50


def test_V1_thousands_of_lines_lie_on_the_picture_as_few_do(stage: Any) -> None:
    show(stage, np.ones((3, 3, 1), bool), separation={"line_opacity": 0.4, "line_width": 6})
    few = stage.picture().astype(int)
    surface = grid_surface(np.ones((3, 3, 1), bool))
    lines = len(surface["edges"]) // 6
    for each in ("edges", "edge_cells", "edge_faces"):
        surface[each] = np.tile(surface[each], 2000 // lines)
    stage.call("setSurface", surface)
    stage.settle()
    assert stage.run("scene.drawn()")["edges"] > 1900
    assert np.abs(stage.picture().astype(int) - few).max() <= 1


def test_V1_lines_are_light_where_the_colours_on_both_sides_are_dark(stage: Any) -> None:
    lines = {"line_opacity": 1, "line_width": 5}
    show(stage, np.ones((4, 1, 1), bool), colour={"by": "quality", "map": "parula"}, separation=lines)
    stage.call("setCellColours", np.array([0, 0, 1, 1], np.float32))
    stage.settle()
    picture = stage.picture().astype(int)
    cell = 1 / np.sqrt(18)
    both_dark, one_light, both_light = (at(picture, (x * cell, 0, 0), scale(300)) for x in (-1, 0, 1))
    assert min(both_dark) > 120 and max(one_light) < 10 and max(both_light) < 10


def test_V1_darkness_tells_the_number_of_cells_around_an_edge(stage: Any) -> None:
    shown = np.ones((3, 1, 1), bool)
    surface = grid_surface(shown, "darkness_coded_edges")
    y = 0.2
    z = 0.5 / np.sqrt(11)  # the front of the row
    ends = np.array([[[x, -y, z], [x, y, z]] for x in (-0.3, 0.0, 0.3)], np.float32)
    surface["edges"] = ends.ravel()
    surface["edge_cells"] = np.array([1, 2, 5], np.uint8)
    surface["edge_faces"] = np.zeros(6, np.uint32)
    stage.call("setMesh", {"cells": 3})
    stage.call("setStatus", {"camera": {**FRONT, "projection": "orthographic"}, "lighting": {"mode": "none"}})
    stage.call("setStatus", {"separation": {"line_opacity": 1, "line_width": 2}})
    stage.call("setSurface", surface)
    stage.settle()
    row = stage.picture()[150, :, 0].astype(int)
    ink = [255 - row[int(200 + x * scale(300)) - 4 :][:9].min() for x in (-0.3, 0.0, 0.3)]
    assert 30 < ink[0] < ink[1] - 30 < ink[2] - 60


def test_V2_the_background_is_the_statuss_own(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool), background="#203040")
    assert stage.picture()[5, 5].tolist() == [0x20, 0x30, 0x40]
    stage.run("document.body.style.background = 'black'")
    stage.settle()
    assert stage.picture()[5, 5].tolist() == [0x20, 0x30, 0x40]


def test_V9_nothing_shown_and_a_single_cell_are_drawn_without_complaint(stage: Any) -> None:
    empty = np.zeros((2, 2, 2), bool)
    stage.call("setMesh", {"cells": 8})
    stage.call("setStatus", {"lighting": {"mode": "object_space_ao"}})
    surface = grid_surface(np.ones((1, 1, 1), bool))
    none = {key: value[:0] if isinstance(value, np.ndarray) else value for key, value in surface.items()}
    stage.call("setSurface", none)
    stage.run("scene.settled()")
    assert stage.run("scene.drawn()") == {"faces": 0, "triangles": 0, "edges": 0, "cells": 0}
    stage.call("setSurface", surface)
    stage.run("scene.settled()")
    assert stage.run("scene.drawn()") == {"faces": 6, "triangles": 12, "edges": 12, "cells": 1}
    assert empty.size == 8
