"""`hexalab render` (SPEC A2, S3, S5): the same picture every time, with its status inside."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from hexalab import Mesh, cli, write
from hexalab.hosts.offers import FileOffer
from hexalab.hosts.rendering import Renderer
from hexalab.png_text import read_settings
from site_builder.pictures.album import png_size

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
