"""`hexalab.show` in a real JupyterLab, in real Chromium (SPEC A6)."""

from __future__ import annotations

import base64
import io
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from playwright.sync_api import Browser, Frame, Page
from playwright.sync_api import Error as PlaywrightError

import hexalab
from hexalab.png_text import read_settings

from .conftest import grid
from .lab import Lab, jupyterlab, marimo
from .ui import until

pytest.importorskip("anywidget")
pytest.importorskip("jupyterlab")
pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    with jupyterlab(tmp_path_factory.mktemp("lab")) as running:
        hexalab.write(grid(4, 3, 3), running.folder / "box.mesh")
        yield running


def frames(page: Page) -> list[Frame]:
    """The views that show a mesh, in the order of the page."""
    page.evaluate("() => 0")  # what has happened meanwhile is heard
    return [frame for frame in page.frames if frame != page.main_frame and shows(frame)]


def shows(frame: Frame) -> bool:
    try:
        return bool(frame.evaluate("() => Boolean(window.hexalab?.summary()?.shown)"))
    except PlaywrightError:  # it is just being made, or goes
        return False


def view(page: Page, count: int = 1) -> Frame:
    return until(lambda: len(found := frames(page)) == count and found, 60)[0]


def asked(frame: Frame, what: str) -> Any:
    return frame.evaluate(f"() => window.hexalab.{what}")


def run(page: Page, code: str) -> str:
    """Run code in the notebook's kernel, beside its cells; what it prints."""
    script = """async (code) => {
        const { kernel } = window.jupyterapp.shell.currentWidget.sessionContext.session;
        const future = kernel.requestExecute({ code, store_history: false });
        let text = "";
        future.onIOPub = ({ content }) => { text += content.text ?? (content.traceback ?? []).join("\\n"); };
        await future.done;
        return text;
    }"""
    return re.sub(r"\x1b\[[\d;]*m", "", page.evaluate(script, code)).strip()


SHOW = "import hexalab\nview = hexalab.show('box.mesh', {'lighting': {'mode': 'direct'}}, height=420)\nview"


def test_A6_a_view_shares_settings_and_cells_with_the_kernel_and_leaves_a_picture(
    chromium: Browser, lab: Lab
) -> None:
    with lab.opened(chromium, "one.ipynb", SHOW) as page:
        frame = view(page)
        assert asked(frame, "summary()")["cells"] == 36
        assert asked(frame, "getStatus()")["lighting"]["mode"] == "direct", "the settings that it was given"
        assert page.locator("iframe[title=HexaLab]").bounding_box()["height"] == 420  # type: ignore[index]

        run(page, "view.status = {'filters': {'peel': {'depth': 1}}}")
        until(lambda: asked(frame, "summary()")["shown"]["cells"] == 2)
        asked(frame, "setStatus({ background: '#336699' })")
        until(
            lambda: (
                run(page, "print(view.status['background'], view.status['filters']['peel']['depth'])")
                == "#336699 1"
            )
        )

        assert run(page, "print(view.picked)") == "[]"
        run(page, "view.picked = [7]")
        until(lambda: "7" in frame.locator(".inspector").inner_text())
        run(page, "view.picked = []")
        until(lambda: frame.locator(".inspector").is_hidden())
        run(page, "view.status = {'filters': {'peel': {'depth': 0}}}")
        until(lambda: asked(frame, "summary()")["shown"]["cells"] == 36)
        box = frame.locator("#canvas").bounding_box()
        assert box
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        picked = until(lambda: (text := run(page, "print(view.picked)")) != "[]" and text)
        assert re.fullmatch(r"\[\d+\]", picked)

        run(page, "view.height = 500")
        until(lambda: page.locator("iframe[title=HexaLab]").bounding_box()["height"] == 500)  # type: ignore[index]

        def still() -> bytes:
            (_, picture) = lab.saved(page, "one.ipynb")["cells"][0]["outputs"]
            found = re.search(r'src="data:image/png;base64,([^"]+)"', "".join(picture["data"]["text/html"]))
            return base64.b64decode(found[1]) if found else b""

        until(lambda: (png := still()) and read_settings(png)["background"] == "#336699", 60)
        assert page.locator(".hexalab-still").is_hidden(), "the live view stands before it"
        outputs = lab.saved(page, "one.ipynb")["cells"][0]["outputs"]
        assert "box.mesh (36 hexahedron)" in "".join(outputs[0]["data"]["text/plain"])
        saved = (lab.folder / "one.ipynb").read_text()
        assert len(saved) < 1_000_000 and "trustedTypes" not in saved, "the viewer is not saved with it"
    without_kernel(chromium, lab)


def without_kernel(chromium: Browser, lab: Lab) -> None:
    """What somebody sees who opens the saved notebook, before any cell is run."""
    made = chromium.new_context(viewport={"width": 1280, "height": 1200})
    page = made.new_page()
    page.goto(f"{lab.address}lab/tree/one.ipynb?token={lab._token}&reset")
    picture = page.locator(".hexalab-still img")
    until(lambda: picture.count() == 1 and picture.is_visible(), 60)
    assert picture.evaluate("(image) => image.naturalWidth") > 100
    made.close()


def test_A6_a_picture_comes_when_it_is_asked_for(chromium: Browser, lab: Lab) -> None:
    with lab.opened(chromium, "two.ipynb", SHOW) as page:
        view(page)
        run(page, "shot = view.screenshot(320, 200, wait=False)")
        until(lambda: run(page, "print(shot.done())") == "True", 60)
        (frame,) = frames(page)
        html = frame.evaluate("async () => (await window.hexalab.page()).text()")
        assert "<title>box.mesh</title>" in html, "the page's frame comes from the kernel"
        text = run(page, "import base64; print(base64.b64encode(shot.result()).decode())")
        png = base64.b64decode(text)
        assert Image.open(io.BytesIO(png)).size == (320, 200)
        assert read_settings(png)["mesh"]["name"] == "box.mesh"
        run(page, "shot = view.screenshot(9000, 9000, wait=False)")
        until(lambda: run(page, "print(shot.done())") == "True", 60)
        assert "8192" in run(page, "shot.result()")


def test_A6_several_views_are_apart_and_go_with_their_cells(chromium: Browser, lab: Lab) -> None:
    other = (
        "mesh = hexalab.read('box.mesh')\n"
        "other = hexalab.show((mesh.points * 2, mesh.cells[:10]), {'lighting': {'mode': 'direct'}})\nother"
    )
    with lab.opened(chromium, "three.ipynb", SHOW, other, "view") as page:
        view(page, 3)
        counts = sorted(asked(frame, "summary()")["cells"] for frame in frames(page))
        assert counts == [10, 36, 36]
        (ten,) = (frame for frame in frames(page) if asked(frame, "summary()")["cells"] == 10)
        ten.evaluate("() => window.hexalab.setStatus({ background: '#112233' })")
        until(lambda: run(page, "print(other.status['background'])") == "#112233")
        assert run(page, "print(view.status['background'])") != "#112233"
        assert run(page, "print(len(view._seats), len(other._seats))") == "2 1"
        page.evaluate(
            """async () => {
                const { commands, shell } = window.jupyterapp;
                shell.currentWidget.content.activeCellIndex = 1;
                await commands.execute("notebook:delete-cell");
            }"""
        )
        until(lambda: run(page, "print(len(view._seats), len(other._seats))") == "2 0")
        bundles = page.evaluate(
            "() => Object.getOwnPropertySymbols(globalThis).filter((one) => /hexalab/.test(String(one))).length"
        )
        assert bundles == 1, "the script is fetched once for all"


def test_A6_a_mesh_beyond_one_message_goes_to_the_kernel_and_comes_from_it(
    chromium: Browser, lab: Lab
) -> None:
    hexalab.write(grid(60, 60, 50), lab.folder / "large.vtk")
    assert (lab.folder / "large.vtk").stat().st_size > 12_000_000
    with lab.opened(chromium, "four.ipynb", SHOW) as page:
        frame = view(page)
        frame.set_input_files("#file", lab.folder / "large.vtk")
        until(lambda: asked(frame, "summary()")["cells"] == 180_000, 120)
        until(lambda: (asked(frame, "summary()")["shown"] or {}).get("cells") == 180_000, 60)


def test_A6_what_can_not_be_shown_is_said(chromium: Browser, lab: Lab) -> None:
    with lab.opened(chromium, "five.ipynb", SHOW) as page:
        view(page)
        assert "expected a Mesh, a path" in run(page, "hexalab.show(3)")
        assert "missing.mesh" in run(page, "hexalab.show('missing.mesh')")
        assert "expected (C, 8)" in run(
            page, "import numpy as np; hexalab.show((np.zeros((8, 3)), np.zeros((1, 4), int)))"
        )
        frame = view(page)
        page.evaluate("() => window.jupyterapp.shell.currentWidget.sessionContext.session.kernel.shutdown()")
        frame.evaluate(
            "() => { void window.hexalab.setStatus({ filters: { peel: { depth: 1 } } }).catch(() => {}); }"
        )
        until(lambda: "then run the cell again" in frame.locator(".message").all_inner_texts().__str__(), 60)


@pytest.mark.parametrize("theme", ["JupyterLab Dark", "JupyterLab Light"])
def test_A6_it_is_dark_where_the_notebook_is(chromium: Browser, lab: Lab, theme: str) -> None:
    with lab.opened(chromium, "six.ipynb", SHOW) as page:
        page.evaluate(
            "theme => window.jupyterapp.commands.execute('apputils:change-theme', { theme })", theme
        )
        frame = view(page)
        dark = "() => matchMedia('(prefers-color-scheme: dark)').matches"
        until(lambda: frame.evaluate(dark) is (theme == "JupyterLab Dark"))


def test_A6_a_view_that_was_shown_before_can_be_shown_again(chromium: Browser, lab: Lab) -> None:
    with lab.opened(chromium, "seven.ipynb", SHOW) as page:
        view(page)
        page.evaluate("() => window.jupyterapp.commands.execute('notebook:run-all-cells')")
        until(lambda: len(frames(page)) == 1 and asked(frames(page)[0], "summary()")["cells"] == 36, 60)


def test_A6_two_meshes_beside_each_other_and_a_mesh_beside_a_surface(chromium: Browser, lab: Lab) -> None:
    hexalab.write(grid(4, 3, 3, noise=0.2), lab.folder / "after.vtk")
    (lab.folder / "square.off").write_text("OFF\n4 1 0\n0 0 3\n4 0 3\n4 3 3\n0 3 3\n4 0 1 2 3\n")
    both = "import hexalab\nview = hexalab.show('box.mesh', compare='after.vtk')\nview"
    beside = "import hexalab\nview = hexalab.show(hexalab.read('box.mesh'), compare='square.off')\nview"
    with lab.opened(chromium, "eight.ipynb", both) as page:
        frame = view(page)
        told = until(lambda: asked(frame, "comparison()"), 60)
        assert (told["name"], told["same_cells"]) == ("after.vtk", True)
        assert asked(frame, "changes('scaled_jacobian')")["worse"] == 36
        run(page, "view.status = {'filters': {'peel': {'depth': 1}}}")
        until(lambda: asked(frame, "summary()")["shown"]["cells"] == 2)
    with lab.opened(chromium, "nine.ipynb", beside) as page:
        frame = view(page)
        told = until(lambda: asked(frame, "comparison()"), 60)
        assert (told["name"], told["surface"]["triangles"]) == ("square.off", 2)
        assert asked(frame, "distances()")["a_to_b"]["max"] == pytest.approx(3)
        assert "missing.stl" in run(page, "hexalab.show('box.mesh', compare='missing.stl')")
        assert "expected a Mesh, a path" in run(page, "hexalab.show('box.mesh', compare=3)")


APP = """import marimo
app = marimo.App()

@app.cell
def _():
    import hexalab
    view = hexalab.show("box.mesh", {"lighting": {"mode": "direct"}})
    view
    return (view,)
"""


def test_A6_it_is_shown_in_marimo(chromium: Browser, tmp_path: Path) -> None:
    pytest.importorskip("marimo")
    hexalab.write(grid(4, 3, 3), tmp_path / "box.mesh")
    hexalab.write(grid(60, 60, 50), tmp_path / "large.vtk")
    (tmp_path / "app.py").write_text(APP)
    with marimo(tmp_path / "app.py") as address:
        page = chromium.new_page(viewport={"width": 1280, "height": 900})
        page.goto(address)
        frame = view(page)
        assert asked(frame, "summary()")["cells"] == 36
        assert asked(frame, "setStatus({ filters: { peel: { depth: 1 } } })") == []
        assert asked(frame, "summary()")["shown"]["cells"] == 2
        frame.set_input_files("#file", tmp_path / "large.vtk")
        until(lambda: asked(frame, "summary()")["cells"] == 180_000, 120)
        page.close()
