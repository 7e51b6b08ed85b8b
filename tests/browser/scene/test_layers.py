"""Silhouette, irregular edges, plane; a lost context; pictures for papers."""

from __future__ import annotations

import base64
import io
from typing import Any

import numpy as np
from PIL import Image

from .grids import grid_surface
from .test_drawing import FRONT, NO_LINES, at, scale, show


def structure(lines: Any, valence: list[int], boundary: list[int]) -> dict[str, Any]:
    """Return an irregular structure of wires, each with one barb and one flap downwards."""
    ends = np.array(lines, np.float32)
    down = np.array([0, -0.08, 0], np.float32)
    barbs = np.stack([ends[:, 0], ends[:, 0] + down], axis=1)
    paper = np.stack([ends[:, 0], ends[:, 1], ends[:, 1] + down, ends[:, 0] + down], axis=1)
    kinds = {"valence": np.array(valence, np.uint8), "boundary": np.array(boundary, np.uint8)}
    out = {"edges": ends.ravel(), "barbs": barbs.ravel(), "paper": paper.ravel(), **kinds}
    out["ends_on_boundary"] = np.zeros(len(valence), np.uint8)
    for part in ("barb", "paper"):
        out |= {f"{part}_{name}": value for name, value in kinds.items()}
    return out


def test_V3_the_silhouette_runs_from_none_over_flat_to_shaded(stage: Any) -> None:
    shown = np.ones((4, 2, 2), bool)
    shown[2:] = False
    hidden = grid_surface(~shown)
    show(stage, shown, camera={**FRONT, "projection": "orthographic", "direction": [0, -0.5, -0.9]})
    stage.call("setSilhouette", {"positions": hidden["positions"], "normals": hidden["normals"]})
    found = {}
    for strength in (0, 0.5, 1):
        stage.call("setStatus", {"silhouette": strength})
        stage.settle()
        found[strength] = stage.picture()
    ghost = np.any(found[0.5] != found[0], axis=2)
    assert 2000 < ghost.sum() < 60_000
    inside = found[0.5][ghost]
    values, counts = np.unique(inside, axis=0, return_counts=True)
    assert values[counts.argmax()].tolist() == [0xD7, 0xD7, 0xF0]
    assert counts.max() > 0.9 * ghost.sum(), "one even tone, however many faces lie behind each other"
    shaded = found[1][ghost].astype(int)
    assert shaded.min() > 150 and shaded.std() > 0.5
    model = np.all(found[0] == [255, 255, 0], axis=2) | np.all(found[0] == [255, 255, 255], axis=2)
    assert np.array_equal(found[1][~ghost & model], found[0][~ghost & model])


def test_V3_the_silhouette_never_covers_the_model(stage: Any) -> None:
    shown = np.ones((2, 2, 4), bool)
    shown[:, :, 2:] = False
    hidden = grid_surface(~shown)
    colours = {"by": "sides", "inside": "#ff8800"}
    show(stage, shown, camera={**FRONT, "projection": "orthographic"}, colour=colours)
    before = stage.picture()
    stage.call("setSilhouette", {"positions": hidden["positions"], "normals": hidden["normals"]})
    stage.call("setStatus", {"silhouette": 1})
    stage.settle()
    model = np.all(before == [255, 0x88, 0], axis=2)
    assert model.sum() > 3000
    assert np.array_equal(stage.picture()[model], before[model])


def test_V3_the_model_is_seen_through_hidden_cells_before_it_alone(stage: Any) -> None:
    shown = np.ones((3, 3, 3), bool)
    shown[:, :, 1:] = False
    view = {**FRONT, "projection": "orthographic"}
    colours = {"by": "sides", "outside": "#204080", "inside": "#ffff00"}
    plain = {"camera": view, "colour": colours, "silhouette": 0, "lighting": {"mode": "none", "shade": 0}}
    show(stage, shown, **plain)
    pictures = []
    for cells, opacity in ((None, 0.5), (~shown, 0.5), (~shown, 1), (~shown, 0)):
        stage.call("setOver", "seeThrough", None if cells is None else grid_surface(cells))
        stage.call("setStatus", {"see_through": {"opacity": opacity}})
        stage.settle()
        pictures.append(stage.picture().astype(int))
    place = (0.05, 0.05, 0)
    none, half, whole, zero = (np.array(at(picture, place, scale(300))) for picture in pictures)
    assert none.tolist() == zero.tolist() == [255, 255, 0] and whole.tolist() == [0x20, 0x40, 0x80]
    assert np.abs(half - (none + whole) / 2).max() <= 1
    stage.call("setStatus", {"camera": {**view, "direction": [0, 0, 1]}, "see_through": {"opacity": 1}})
    stage.settle()
    behind = stage.picture().astype(int)
    assert at(behind, place, scale(300)) == [0x20, 0x40, 0x80], (
        "the model's own side covers what lies behind it"
    )
    stage.call("setOver", "seeThrough", None)
    stage.settle()
    middle = slice(110, 190), slice(160, 240)
    assert np.array_equal(stage.picture()[middle], behind[middle])


def test_V4_seven_steps_show_what_they_say(stage: Any) -> None:
    shown = np.ones((2, 2, 2), bool)
    show(stage, shown, camera={**FRONT, "projection": "orthographic"}, silhouette=0)
    bare = stage.picture()
    free = [[-0.5, 0.35, 0], [0.5, 0.35, 0]]
    behind = [[-0.2, 0.1, -0.4], [0.2, 0.1, -0.4]]
    rim = [[-0.5, -0.35, 0], [0.5, -0.35, 0]]
    stage.call("setOver", "irregular", structure([free, behind, rim], [3, 5, 6], [0, 0, 1]))
    seen = []
    for mode in range(7):
        stage.call("setStatus", {"irregular": {"mode": mode, "boundary": False}})
        stage.settle()
        seen.append(np.any(stage.picture() != bare, axis=2))
    height = [rows.any(axis=1).sum() for rows in (mask[:60] for mask in seen)]
    through = [mask[110:145].sum() for mask in seen]
    assert not seen[0].any()
    assert 1 <= height[1] <= 4 and height[2] == height[1]
    assert height[3] > 15 and height[4] == height[3] and height[5] > 15
    assert [bool(amount) for amount in through] == [False, False, True, False, True, False, True]
    assert all(not mask[200:].any() for mask in seen), "those of the boundary are off"
    stage.call("setStatus", {"irregular": {"mode": 1, "boundary": True}})
    stage.settle()
    assert np.any(stage.picture()[200:] != bare[200:])


def test_V4_valences_differ_in_colour(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool), camera={**FRONT, "projection": "orthographic"}, silhouette=0)
    lines = [[[-0.3, 0.36 - 0.02 * k, 0.4], [0.3, 0.36 - 0.02 * k, 0.4]] for k in range(4)]
    stage.call("setOver", "irregular", structure(lines, [2, 3, 5, 7], [0, 0, 0, 0]))
    stage.call("setStatus", {"irregular": {"mode": 1}})
    stage.settle()
    column = stage.picture()[:, 200].astype(int)
    inked = {tuple(p // 60) for p in column[:60] if p.min() < 140}
    assert len(inked) >= 4


def test_F1_the_plane_stands_where_it_cuts(stage: Any) -> None:
    show(stage, np.ones((4, 1, 1), bool), camera={**FRONT, "projection": "orthographic"}, silhouette=0)
    before = stage.picture()
    stage.call("showPlane", {"normal": [1, 0, 0], "offset": 0.75, "extent": [-0.4, 0.4]})
    stage.settle()
    changed = np.any(stage.picture() != before, axis=2)
    columns = np.nonzero(changed.any(axis=0))[0]
    size = 300 / (2 * 1.5 * np.tan(np.radians(15)))
    assert abs(columns.mean() - (200 + 0.2 * size)) < 2
    stage.call("showPlane", None)
    stage.settle()
    assert np.array_equal(stage.picture(), before)


def test_V9_a_lost_context_comes_back_with_the_same_picture(stage: Any) -> None:
    show(stage, np.ones((3, 3, 3), bool), lighting={"mode": "object_space_ao"}, colour={"by": "sides"})
    stage.run("scene.settled()")
    before = stage.picture()
    stage.run("""async () => {
        const gl = document.querySelector('canvas').getContext('webgl2');
        window.told = [];
        scene.on('contextlost', () => told.push('lost'));
        scene.on('contextrestored', () => told.push('restored'));
        const loss = gl.getExtension('WEBGL_lose_context');
        loss.loseContext();
        await new Promise((done) => setTimeout(done, 200));
        loss.restoreContext();
        await new Promise((done) => setTimeout(done, 200));
        await scene.settled();
    }""")
    assert stage.run("told") == ["lost", "restored"]
    stage.settle()
    after = stage.picture()
    assert np.abs(after.astype(int) - before).max() <= 1
    stage.messages[:] = [m for m in stage.messages if "Context Lost" not in m and "CONTEXT_LOST" not in m]
    stage.messages[:] = [m for m in stage.messages if "Context Restored" not in m]


def screenshot(stage: Any, **options: Any) -> np.ndarray:
    """Return a screenshot's pixels, (h, w, 4)."""
    data = stage.page.evaluate(
        """async (options) => {
            const bytes = new Uint8Array(await (await scene.screenshot(options)).arrayBuffer());
            let text = '';
            for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
            return btoa(text);
        }""",
        options,
    )
    return np.array(Image.open(io.BytesIO(base64.b64decode(data))).convert("RGBA"))


def test_S5_a_picture_of_any_size_shows_what_the_canvas_shows(stage: Any) -> None:
    shown = np.ones((4, 3, 3), bool)
    shown[2:, 1:, 1:] = False
    view = {**FRONT, "direction": [-0.5, -0.5, -0.7], "projection": "perspective"}
    show(stage, shown, camera=view, lighting={"mode": "object_space_ao"}, separation={"line_opacity": 0.4})
    stage.run("scene.settled()")
    stage.settle()
    canvas = stage.picture().astype(int)[:210, :310]
    same = screenshot(stage, width=400, height=300)
    assert same.shape == (300, 400, 4) and np.all(same[..., 3] == 255)
    difference = np.abs(same[:210, :310, :3].astype(int) - canvas)
    assert difference.mean() < 2.5
    large = screenshot(stage, width=2600, height=1950)
    assert large.shape == (1950, 2600, 4)
    small = np.array(Image.fromarray(large[..., :3]).resize((400, 300), Image.Resampling.BOX)).astype(int)
    assert np.abs(small[:210, :310] - canvas).mean() < 2.5
    seam = np.abs(np.diff(large[..., :3].astype(int), axis=1)).mean(axis=(0, 2))
    assert seam[1023] < 5 * np.median(seam) + 1, "tiles meet without a seam"
    again = screenshot(stage, width=400, height=300)
    assert np.array_equal(again, same)


def test_S5_a_transparent_background_has_no_fringe(stage: Any) -> None:
    show(stage, np.ones((2, 2, 2), bool), separation=NO_LINES, silhouette=0, background="#ff0000")
    stage.call("setStatus", {"camera": {**FRONT, "direction": [-0.5, -0.3, -0.8]}})
    picture = screenshot(stage, width=300, height=300, transparent=True)
    alpha = picture[..., 3]
    assert alpha[0, 0] == 0 and alpha[150, 150] == 255
    rim = (alpha > 40) & (alpha < 255)
    assert rim.any()
    assert picture[rim][:, 1].min() > 240, "the red background must not bleed into the rim"


def test_S5_a_transparent_picture_over_any_colour_is_the_picture_on_that_colour(stage: Any) -> None:
    shown = np.ones((3, 3, 3), bool)
    shown[1:, :, 1:] = False
    view = {**FRONT, "direction": [-0.5, -0.3, -0.8]}
    lines = {"line_opacity": 0.4, "line_width": 3}
    show(stage, shown, camera=view, separation=lines, silhouette=1, background="#5a9a5a")
    stage.call("setSilhouette", {k: grid_surface(~shown)[k] for k in ("positions", "normals")})
    stage.call("setOver", "irregular", structure([[[-0.4, 0.2, 0.2], [0.4, -0.2, 0.2]]], [3], [0]))
    stage.call("setStatus", {"irregular": {"mode": 2}})
    clear = screenshot(stage, width=300, height=300, transparent=True).astype(float)
    solid = screenshot(stage, width=300, height=300).astype(float)
    cover = clear[..., 3:] / 255
    over = clear[..., :3] * cover + np.array([0x5A, 0x9A, 0x5A]) * (1 - cover)
    assert 0.1 < (cover == 1).mean() < 0.9 and ((cover > 0.05) & (cover < 0.95)).mean() > 0.02
    assert np.abs(over - solid[..., :3]).max() <= 3


def test_V4_a_wire_that_ends_on_the_boundary_does_not_dot_it(stage: Any) -> None:
    dots = []
    for ends in (0, 3):
        show(stage, np.ones((1, 1, 1), bool), camera={**FRONT, "direction": [0.2, 0.1, -1]})
        half = 0.5 / np.sqrt(3)
        wires = [[[x, y, half], [x, y, -half]] for x in (-0.2, 0, 0.2) for y in (-0.2, 0, 0.2)]
        record = structure(wires, [3] * 9, [0] * 9)
        stage.call("setOver", "irregular", {**record, "ends_on_boundary": np.full(9, ends, np.uint8)})
        stage.call("setStatus", {"irregular": {"mode": 1}})
        stage.settle()
        picture = stage.picture().astype(int)
        dots.append(int((np.ptp(picture[:210, :310], axis=2) > 12).sum()))
    assert dots[0] > 2 and dots[1] == 0


def test_S5_a_size_out_of_bounds_is_refused(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool))
    refusal = stage.run("scene.screenshot({ width: 9000, height: 10 }).catch((e) => e.message)")
    assert "8192" in refusal and "9000" in refusal


def arrows(*rows: tuple[Any, Any, int]) -> dict[str, Any]:
    """Return a record of arrows, each by its place, its vector and whether it points inward."""
    places, vectors, inward = zip(*rows, strict=True)
    return {
        "positions": np.array(places, np.float32).ravel(),
        "vectors": np.array(vectors, np.float32).ravel(),
        "inward": np.array(inward, np.uint8),
        "cells": np.zeros(len(rows), np.uint32),
        "longest": 1.0,
        "not_finite": 0,
        "zero": 0,
    }


RED = {"attribute": "point:flow", "length": 0.3, "colour": "#e00000"}
ORTHOGRAPHIC = {**FRONT, "projection": "orthographic"}


def is_red(picture: np.ndarray) -> np.ndarray:
    """Return which pixels have some of the arrows' ink, (h, w); none of the axes in the corner."""
    colour = picture[..., :3].astype(int)
    found = colour[..., 0] - colour[..., 1:].max(axis=2) > 40
    found[-80:, -80:] = False
    return np.asarray(found)


def test_R8_an_arrow_starts_at_its_face_or_arrives_there(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool), camera=ORTHOGRAPHIC, silhouette=0)
    front = 0.5 / np.sqrt(3)
    size = scale(300)
    for inward, begins in ((0, 0.0), (1, -0.15)):
        stage.call("setOver", "arrows", arrows(((0, 0.05, front), (0.5, 0, 0), inward)))
        stage.call("setStatus", {"arrows": RED})
        stage.settle()
        rows, columns = np.nonzero(is_red(stage.picture()))
        assert abs(columns.min() - (200 + begins * size)) < 2.5
        assert abs(columns.max() - (200 + (begins + 0.15) * size)) < 3.5
        assert abs(rows.mean() - (150 - 0.05 * size)) < 1
        heights = [int((columns == column).sum()) for column in range(columns.min(), columns.max() + 1)]
        assert np.argmax(heights) > 0.5 * len(heights), "the head is at the end"
        assert heights[-1] <= 2 and max(heights) >= 3 * heights[3]


def test_R8_arrows_are_as_long_as_the_setting_says_and_never_thinner_than_a_pixel(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool), camera=ORTHOGRAPHIC, silhouette=0)
    stage.call(
        "setOver", "arrows", arrows(((-0.1, 0, 0.4), (1, 0, 0), 0), ((-0.1, -0.15, 0.4), (0.25, 0, 0), 0))
    )
    long = []
    for length in (0.05, 0.1, 0.3):
        stage.call("setStatus", {"arrows": {**RED, "length": length}})
        stage.settle()
        ink = is_red(stage.picture())
        long.append((np.ptp(np.nonzero(ink[:170])[1]), np.ptp(np.nonzero(ink[170:])[1])))
        assert ink[:170].any(axis=0).sum() == long[-1][0] + 1, "the shaft has no gaps"
    size = scale(300)
    assert np.allclose(long, [[n * size, n * size / 4] for n in (0.05, 0.1, 0.3)], atol=3)
    stage.call("setStatus", {"arrows": {"attribute": ""}})
    stage.settle()
    assert not is_red(stage.picture()).any()
    stage.call("setStatus", {"arrows": {"attribute": "point:flow"}})
    stage.call("setMesh", {"cells": 1})
    stage.settle()
    assert not is_red(stage.picture()).any(), "they belonged to the mesh before"


def test_R8_the_model_hides_arrows_behind_it_and_they_hide_its_lines(stage: Any) -> None:
    show(stage, np.ones((2, 2, 2), bool), camera=ORTHOGRAPHIC, silhouette=0, separation={"line_opacity": 1})
    half = 0.5 / np.sqrt(3)
    stage.call("setStatus", {"arrows": RED})
    stage.call("setOver", "arrows", arrows(((-0.15, 0, -half), (1, 0, 0), 0)))
    stage.settle()
    assert not is_red(stage.picture()).any()
    stage.call("setOver", "arrows", arrows(((-0.15, 0, half), (1, 0, 0), 0)))
    stage.settle()
    ink = is_red(stage.picture())
    assert ink[150, 200] or ink[149, 200], "over the edges that cross there"
    stage.call("setOver", "arrows", arrows(((0, half, 0), (0, 1, 0), 0)))
    stage.settle()
    assert is_red(stage.picture())[20:60].any(), "what stands out of the mesh is before the far plane"


def test_S5_pictures_have_arrows_and_transparent_ones_no_fringe(stage: Any) -> None:
    show(stage, np.ones((1, 1, 1), bool), camera=ORTHOGRAPHIC, silhouette=0, background="#00ff00")
    half = 0.5 / np.sqrt(3)
    stage.call("setOver", "arrows", arrows(((half, 0, 0), (1, 0, 0), 0), ((0, 0, half), (0, 1, 0), 0)))
    stage.call("setStatus", {"arrows": RED})
    clear = screenshot(stage, width=300, height=300, transparent=True)
    solid = screenshot(stage, width=300, height=300)
    assert is_red(solid)[150, 150 + int(0.35 * scale(300)) :].any()
    cover = clear[..., 3:] / 255
    over = clear[..., :3] * cover + np.array([0, 255, 0]) * (1 - cover)
    assert np.abs(over - solid[..., :3]).max() <= 3
    assert (cover[is_red(solid)] > 0.2).all()
