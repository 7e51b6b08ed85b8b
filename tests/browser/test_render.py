"""`hexalab render` (SPEC A2, S3, S5): the same picture every time, with its status inside."""

from __future__ import annotations

import io
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
import pytest
from PIL import Image

from benchmarks.page import SITE
from hexalab import Mesh, cli, write
from hexalab.hosts.offers import FileOffer, other_file
from hexalab.hosts.rendering import Renderer, Rendering
from hexalab.png_text import read_settings
from site_builder.pictures.album import png_size

from .conftest import grid

pytestmark = pytest.mark.browser


@pytest.fixture
def cube(tmp_path: Path) -> Path:
    """A file of one unit cube."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    path = tmp_path / "cube.mesh"
    write(Mesh.from_cells(corners, [range(8)]), path)  # type: ignore[arg-type]
    return path


def run(words: list[str]) -> int:
    """The command line in a thread of its own: Playwright runs once in each, and here the tests' browser does."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(cli.main, words).result()


def test_A2_render_makes_the_same_picture_again_from_its_own_status(
    cube: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status = {"separation": {"mode": "rounded"}, "background": "#336699", "silhouette": 7}
    (tmp_path / "status.json").write_text(json.dumps(status))
    first, second = tmp_path / "first.png", tmp_path / "second.png"
    words = ["render", str(cube), "--width", "320", "--height", "200"]
    assert run([*words, "-o", str(first), "--status", str(tmp_path / "status.json")]) == 0
    out, err = capsys.readouterr()
    assert out.startswith(f"{first}: 320 x 200 pixels")
    assert err.count("\n") == 1 and "silhouette: found 7" in err
    drawn = read_settings(first.read_bytes())
    assert drawn["separation"]["mode"] == "rounded"
    assert drawn["background"] == "#336699"
    assert drawn["mesh"]["cells"] == 1
    assert run([*words, "-o", str(second), "--status", str(first)]) == 0
    assert second.read_bytes() == first.read_bytes()


def test_B3_nothing_of_a_picture_stays_for_the_next(cube: Path) -> None:
    def pictures() -> list[bytes]:
        with Renderer() as renderer:
            size = {"width": 160, "height": 100}
            mesh = FileOffer(cube, "cube.mesh")
            first = renderer.render(mesh, {"lighting": {"mode": "none"}}, **size)
            loud = {"background": "#336699", "colour": {"by": "quality"}, "separation": {"mode": "rounded"}}
            renderer.render(mesh, loud, **size)
            return [
                first.data,
                renderer.render(mesh, {"lighting": {"mode": "none"}}, **size).data,
            ]

    with ThreadPoolExecutor(1) as thread:
        first, third = thread.submit(pictures).result()
    assert first == third


def test_R3_what_was_drawn_before_leaves_nothing_in_the_light() -> None:
    mesh = FileOffer(SITE / "meshes/shapes/bracket.mesh", "bracket.mesh")
    light = {"lighting": {"mode": "screen_space_ao"}}
    cut = {"filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0.3, 0.2], "offset": 0.5}]}}}
    turned = {"camera": {"direction": [0.3, -1, 0.2], "up": [0, 0, 1]}, "background": "#000000"}

    def pictures() -> list[bytes]:
        with Renderer() as renderer:
            size = {"width": 720, "height": 480}
            return [renderer.render(mesh, light | more, **size).data for more in (cut, turned, cut)]

    with ThreadPoolExecutor(1) as thread:
        first, _, third = thread.submit(pictures).result()
    assert first == third


def test_S5_render_makes_figures_of_each_format(
    cube: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    look = {
        "lighting": {"mode": "none"},
        "colour": {"by": "quality"},
        "figure": {"legend": "bar", "caption": True, "width": 85, "unit": "mm"},
    }
    (tmp_path / "look.json").write_text(json.dumps(look))
    words = ["render", str(cube), "--status", str(tmp_path / "look.json"), "-o"]
    assert run([*words, str(tmp_path / "cube.svg")]) == 0
    svg = (tmp_path / "cube.svg").read_text()
    assert ">Scaled<" in svg and ">Jacobian<" in svg and "cube.mesh" in svg and svg.count("<image ") == 1
    assert run([*words, str(tmp_path / "cube.pdf")]) == 0
    assert (tmp_path / "cube.pdf").read_bytes().startswith(b"%PDF-")
    assert run([*words, str(tmp_path / "cube.png"), "--figure"]) == 0
    assert png_size(tmp_path / "cube.png")[0] == round(85 / 25.4 * 300)
    assert read_settings((tmp_path / "cube.png").read_bytes())["figure"]["legend"] == "bar"
    sized = ["--figure", "--width", "500", "--height", "300"]
    assert run([*words, str(tmp_path / "sized.png"), *sized]) == 0
    assert png_size(tmp_path / "sized.png") == (500, 300)
    capsys.readouterr()
    for wrong, told in (("x.jpg", ".svg or .pdf"), ("x.svg --transparent", "figure.transparent")):
        assert run([*words, *wrong.split()]) == cli.MISUSE
        assert told in capsys.readouterr().err


Made = TypeVar("Made")


def rendered(work: Callable[[Renderer], Made]) -> Made:
    """What is made by one renderer, in a thread of its own."""

    def made() -> Made:
        with Renderer() as renderer:
            return work(renderer)

    with ThreadPoolExecutor(1) as thread:
        return thread.submit(made).result()


def pixels(rendering: Rendering) -> Any:
    """(height, width, 3) of a PNG."""
    return np.asarray(Image.open(io.BytesIO(rendering.data)).convert("RGB"))


BARE = {"lighting": {"mode": "none"}, "silhouette": 0}
RED = {"colour": {"by": "sides", "outside": "#ff0000"}, "separation": {"line_opacity": 0}, **BARE}


@pytest.fixture
def pair(tmp_path: Path) -> tuple[Path, Path, Path]:
    """Two meshes of the same cells and the same name; and a triangle before them."""
    for folder, noise in (("a", 0.0), ("b", 0.3)):
        (tmp_path / folder).mkdir()
        write(grid(3, 3, 3, noise=noise), tmp_path / folder / "box.mesh")
    (tmp_path / "film.off").write_text("OFF\n3 1 0\n-9 -9 4\n9 -9 4\n0 9 4\n3 0 1 2\n")
    return tmp_path / "a" / "box.mesh", tmp_path / "b" / "box.mesh", tmp_path / "film.off"


def test_S6_two_meshes_are_in_one_picture_and_nothing_of_it_stays(pair: tuple[Path, Path, Path]) -> None:
    mesh = FileOffer(pair[0], "box.mesh")
    other, film = other_file(pair[1]), other_file(pair[2])
    size = {"width": 300, "height": 200}
    changes = {"colour": {"by": "attribute", "attribute": "change:scaled_jacobian"}}
    worse = {"filters": {"quality": {"items": [{"quantity": "change:scaled_jacobian", "maximum": 0}]}}}

    def pictures(renderer: Renderer) -> dict[str, Rendering]:
        return {
            "alone": renderer.render(mesh, RED, **size),
            "both": renderer.render(mesh, RED, **size, beside=other),
            "bare": renderer.render(mesh, RED, **size, beside=other, transparent=True),
            "film": renderer.render(mesh, RED, **size, beside=film),
            "hidden": renderer.render(
                mesh, {**RED, "compare": {"reference": {"shown": False}}}, **size, beside=film
            ),
            "changes": renderer.render(mesh, {**BARE, **changes, **worse}, **size, beside=other),
            "again": renderer.render(mesh, RED, **size),
            "figure": renderer.figure(mesh, BARE, format="svg", beside=other),
        }

    made = rendered(pictures)
    assert made["again"].data == made["alone"].data
    assert [one.rejections for one in made.values()] == [[]] * len(made)
    assert all(one.second is None for one in made.values())
    red = {name: (pixels(one) == (255, 0, 0)).all(axis=2) for name, one in made.items() if name != "figure"}
    assert red["both"].shape == (200, 300)
    halves = [int(half.sum()) for half in (red["both"][:, :150], red["both"][:, 150:])]
    assert min(halves) > 2000 and not red["both"][:, 148:152].any()
    assert halves[0] == pytest.approx(halves[1], rel=0.02), "inner vertices alone moved: both are seen alike"
    told = {name: read_settings(one.data) for name, one in made.items() if name != "figure"}
    assert told["both"]["mesh"]["cells"] == told["both"]["compare"]["other"]["cells"] == 27
    assert told["both"]["mesh"]["sha256"] != told["both"]["compare"]["other"]["sha256"] != ""
    assert told["again"]["compare"]["other"]["name"] == ""
    assert Image.open(io.BytesIO(made["bare"].data)).convert("RGBA").getpixel((2, 2)) == (0, 0, 0, 0)
    assert (
        told["film"]["compare"]["reference"]["shown"]
        and told["film"]["compare"]["other"]["name"] == "film.off"
    )
    assert red["film"].sum() < red["alone"].sum(), "the film is over the mesh"
    assert np.array_equal(red["hidden"], red["alone"])
    assert told["changes"]["colour"]["attribute"] == "change:scaled_jacobian"
    assert told["changes"]["filters"]["quality"]["items"][0]["quantity"] == "change:scaled_jacobian"
    svg = made["figure"].data.decode()
    assert svg.count("<image ") == 2 and ">A: box.mesh<" in svg and ">B: box.mesh<" in svg


def test_A2_render_compares_as_the_settings_ask(
    pair: tuple[Path, Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    first, second, _ = pair
    (tmp_path / "apart.json").write_text(json.dumps({**BARE, "figure": {"meshes": "apart"}}))
    out = tmp_path / "box.png"
    words = ["render", str(first), "--with", str(second), "-o", str(out), "--width", "240", "--height", "160"]
    assert run([*words, "--status", str(tmp_path / "apart.json")]) == 0
    told, err = capsys.readouterr()
    sides = [tmp_path / "box-A.png", tmp_path / "box-B.png"]
    assert err == "" and [line.split(",")[0] for line in told.splitlines()] == [
        f"{side}: 240 x 160 pixels" for side in sides
    ]
    assert not out.exists() and [png_size(side) for side in sides] == [(240, 160)] * 2
    status = read_settings(sides[0].read_bytes())
    status["figure"]["meshes"], status["compare"]["layout"] = "together", "curtain"
    (tmp_path / "curtain.json").write_text(json.dumps(status))
    assert run([*words, "--status", str(tmp_path / "curtain.json")]) == 0
    assert capsys.readouterr().out.startswith(f"{out}: 240 x 160 pixels") and png_size(out) == (240, 160)
    line = np.asarray(Image.open(out).convert("RGB"))[:120, 118:123]
    assert (line == (0x85, 0x88, 0x8D)).all(axis=2).sum(axis=1).tolist() == [1] * 120, "where the two meet"
