"""The viewer in a frame of another page (SPEC A3): poster, picture alone, questions, who is told what."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Frame, Page

import hexalab

from .conftest import grid
from .ui import until

pytestmark = pytest.mark.browser

MESH = grid(4, 4, 4, noise=0.1)

HOST = """<!doctype html><meta charset="utf-8"><title>host</title>
<iframe src="{src}" width="900" height="600"></iframe>
<script>
  window.heard = [];
  addEventListener("message", ({{ data }}) => heard.push(data));
  window.ask = (hexalab, args = [], more = {{}}) => new Promise((resolve) => {{
    const id = (window.last = (window.last ?? 0) + 1);
    addEventListener("message", function hear({{ data }}) {{
      if (data.id !== id) return;
      removeEventListener("message", hear);
      resolve(data);
    }});
    document.querySelector("iframe").contentWindow.postMessage({{ hexalab, id, args, ...more }}, "*");
  }});
</script>
"""


def frame_of(page: Page) -> Frame:
    """The frame with the viewer."""
    return until(lambda: next((one for one in page.frames if "/viewer/" in one.url), None))


def embedded(page: Page, site: str, shelf: Path, src: str, *, by: str = "127.0.0.1") -> Frame:
    """Show a frame in a page of this or another origin; gives the frame once it can be asked."""
    (shelf / "host.html").write_text(HOST.format(src=f"{site}{src}".replace("&", "&amp;")))
    page.goto(f"{site}/bench/host.html".replace("127.0.0.1", by))
    until(lambda: page.evaluate("() => heard.some(({ hexalab }) => hexalab === 'ready')"), 60)
    return frame_of(page)


@pytest.fixture
def other(chromium: Browser) -> Iterator[Page]:
    """A page whose console is not looked at: refusals are told there."""
    context = chromium.new_context(viewport={"width": 1000, "height": 700})
    yield context.new_page()
    context.close()


def ask(page: Page, method: str, *args: Any, **more: Any) -> dict[str, Any]:
    """Ask the frame from the page around."""
    answer: dict[str, Any] = page.evaluate(
        "([method, args, more]) => ask(method, args, more)", [method, list(args), more]
    )
    return answer


def test_A3_a_page_of_another_origin_talks_to_the_frame(other: Page, site: str, shelf: Path) -> None:
    hexalab.write(MESH, shelf / "frame.mesh")
    embedded(other, site, shelf, "/viewer/?embed", by="localhost")
    ready = other.evaluate("() => heard[0]")
    assert (ready["version"], ready["program"]) == (1, hexalab.__version__)
    assert {"open", "setStatus", "quality", "surface", "page"} <= set(ready["methods"])
    opened = ask(other, "open", f"{site}/bench/frame.mesh", version=1)
    assert (opened["hexalab"], opened["version"], opened["result"]["cells"]) == ("open", 1, 64)
    assert ask(other, "quality", "volume")["result"]["count"] == 64, "an address is no secret"
    assert "404" in ask(other, "open", f"{site}/bench/none.mesh")["error"]
    assert "there is no method ‘explode’, but open, summary" in ask(other, "explode")["error"]
    assert "version: found 2, expected 1" in ask(other, "summary", version=2)["error"]
    assert "expected a list" in other.evaluate("() => ask('summary', 7)")["error"]
    order = other.evaluate(
        """async () => {
          const order = [];
          addEventListener("message", ({ data }) => order.push(data.hexalab));
          await Promise.all([ask("settled"), ask("explode"), ask("summary")]);
          return order;
        }"""
    )
    assert order == ["settled", "explode", "summary"], "answers come in the order of questions"


def test_A3_a_file_of_the_reader_is_told_only_to_the_origin_that_the_address_names(
    other: Page, site: str, shelf: Path, tmp_path: Path
) -> None:
    secret = hexalab.Mesh(
        MESH.coordinates, MESH.corners, MESH.kinds, cell_data={"secretload": np.arange(64.0)}
    )
    hexalab.write(secret, tmp_path / "secret.vtk")
    hexalab.write(MESH, tmp_path / "mine.mesh")
    port = site.rsplit(":", 1)[1]
    reading = (
        ("summary", []), ("getStatus", []), ("screenshot", []), ("figure", ["svg"]), ("quality", ["volume"]),
        ("cells", ["vtu"]), ("surface", ["stl"]), ("page", []), ("turntable", [{"frames": 2}]), ("drawn", []),
        ("timings", []), ("groups", []), ("groupStatistics", []), ("interfaces", ["material"]),
    )  # fmt: skip
    frame = embedded(other, site, shelf, "/viewer/?embed", by="localhost")
    frame.locator("#file").set_input_files(tmp_path / "secret.vtk")
    until(lambda: frame.evaluate("() => window.hexalab.summary()?.cells") == 64)
    for method, args in reading:
        told = ask(other, method, *args)
        assert "result" not in told and "is a file of whoever looks at it" in told["error"], method
    assert ask(other, "setStatus", {"silhouette": 0.5})["result"] == []
    wrong = {"colour": {"attribute": "cell:x"}, "filters": {"picking": {"hidden": [10**6]}}}
    refused = ask(other, "setStatus", wrong)["result"]
    assert {one["path"] for one in refused} == {"colour.attribute", "filters.picking.hidden"}
    assert "64" not in str(refused)
    assert "secret" not in other.evaluate("() => JSON.stringify(heard)")
    sent = other.evaluate(
        "(text) => ask('open', [new File([text], 'mine.mesh')])", (tmp_path / "mine.mesh").read_text()
    )
    assert sent["result"]["name"] == "mine.mesh", "what the page around has sent is its own"
    assert ask(other, "quality", "volume")["result"]["count"] == 64

    frame = embedded(other, site, shelf, f"/viewer/?embed&origin=http://localhost:{port}", by="localhost")
    frame.locator("#file").set_input_files(tmp_path / "secret.vtk")
    until(lambda: frame.evaluate("() => window.hexalab.summary()?.cells") == 64)
    assert ask(other, "summary")["result"]["name"] == "secret.vtk"


def test_A3_a_frame_that_names_an_origin_neither_hears_nor_answers_another(
    other: Page, site: str, shelf: Path
) -> None:
    for named in ("https://blog.example", "nonsense"):
        (shelf / "host.html").write_text(HOST.format(src=f"{site}/viewer/?embed&amp;origin={named}"))
        other.goto(f"{site}/bench/host.html".replace("127.0.0.1", "localhost"))
        frame = frame_of(other)
        until(lambda frame=frame: frame.evaluate("() => window.hexalab?.ready.then(() => true)"))
        other.evaluate("() => void ask('setStatus', [{ background: '#123456' }])")
        other.wait_for_timeout(500)
        assert other.evaluate("() => heard") == []
        assert frame.evaluate("() => window.hexalab.getStatus().background") == "#ffffff"


def test_A3_the_picture_alone_is_shown_and_leads_to_the_whole(page: Page, site: str) -> None:
    page.goto(f"{site}/viewer/?embed&mesh=shapes/cube&origin=https://blog.example")
    page.evaluate("() => window.hexalab.ready")
    until(lambda: page.evaluate("() => window.hexalab.summary()?.cells"))
    for part in ("#bar", "#panel", "#status-line"):
        assert not page.locator(part).is_visible()
    box = page.locator("#canvas").bounding_box()
    assert box and (box["width"], box["height"]) == (1280, 800)
    page.evaluate("() => window.hexalab.setStatus({ silhouette: 0.25 })")
    link = page.get_by_role("link", name="Open in HexaLab")
    link.hover()
    until(lambda: "#status=" in (link.get_attribute("href") or ""))
    address = link.get_attribute("href") or ""
    assert "embed" not in address and "origin" not in address and "mesh=shapes%2Fcube" in address
    assert "Cube" in page.locator(".embedded").inner_text()


def test_A3_a_poster_stands_until_the_mesh_is_asked_for(page: Page, site: str) -> None:
    fetched: list[str] = []
    page.on("request", lambda request: fetched.append(request.url.removeprefix(site)))
    page.route("**/pictures/**", lambda route: route.fulfill(path="build/site/icons/icon-180.png"))
    page.goto(f"{site}/embed/?mesh=shapes/cube&title=A%20<b>cube#status=abc")
    load = page.get_by_role("link", name="Load the mesh A <b>cube")
    assert (
        load.get_attribute("href")
        == f"{site}/viewer/?mesh=shapes%2Fcube&title=A+%3Cb%3Ecube&embed=#status=abc"
    )
    until(lambda: page.locator(".embed-poster").evaluate("(image) => image.naturalWidth") > 0)
    assert not [one for one in fetched if "/viewer/" in one or "runtime" in one or "catalogue.json" in one]
    page.goto(f"{site}/embed/?mesh=shapes/cube")
    page.get_by_role("link", name="Load the mesh cube").click()
    until(
        lambda: "/viewer/" in page.url and page.evaluate("() => window.hexalab?.summary()?.cells") == 512, 60
    )


def test_A3_a_poster_of_what_has_none_is_words(page: Page, site: str) -> None:
    page.goto(f"{site}/embed/?mesh=https://example.org/a/part.vtk")
    assert page.get_by_role("link", name="Load the mesh part.vtk").is_visible()
    assert page.locator("img").count() == 0


def test_A3_the_wheel_scrolls_the_page_around_until_the_frame_was_clicked(
    other: Page, site: str, shelf: Path
) -> None:
    frame = embedded(other, site, shelf, "/viewer/?embed&mesh=shapes/cube")
    until(lambda: frame.evaluate("() => window.hexalab.summary()?.cells"), 60)
    other.evaluate(
        "() => document.body.append(Object.assign(document.createElement('div'), { style: 'height: 3000px' }))"
    )

    def distance() -> float:
        return float(frame.evaluate("() => window.hexalab.getStatus().camera.distance"))

    before = distance()
    other.mouse.move(400, 300)
    other.mouse.wheel(0, 200)
    until(lambda: other.evaluate("() => scrollY") > 100)
    assert distance() == before
    other.evaluate("() => scrollTo(0, 0)")
    other.mouse.click(60, 60)
    other.mouse.move(400, 300)
    other.mouse.wheel(0, 200)
    until(lambda: distance() != before)
    assert other.evaluate("() => scrollY") == 0


def test_A3_the_guides_examples_run(page: Page, site: str) -> None:
    page.route("**/pictures/**", lambda route: route.fulfill(path="build/site/icons/icon-180.png"))
    page.goto(f"{site}/guide/embedding/")
    frame = page.frame_locator("#driven")
    ask_quality = page.get_by_role("button", name="Ask for its Scaled Jacobian")
    assert ask_quality.is_disabled()
    frame.get_by_role("link", name="Load the mesh").click()
    answer = page.locator("#driven-answer")
    until(lambda: "ready: version 1" in answer.inner_text(), 60)
    inside = frame_of(page)
    until(lambda: inside.evaluate("() => window.hexalab.summary()?.cells"), 60)
    page.get_by_role("button", name="Cut it in half").click()
    until(lambda: inside.evaluate("() => window.hexalab.getStatus().filters.planes.items[0].offset") == 0.5)
    until(lambda: answer.inner_text() == "setStatus: []")
    page.get_by_role("button", name="Colour it").click()
    until(lambda: inside.evaluate("() => window.hexalab.getStatus().colour.by") == "quality")
    ask_quality.click()
    until(lambda: '"count":512' in answer.inner_text())
    page.get_by_role("button", name="Put it back").click()
    until(lambda: inside.evaluate("() => window.hexalab.getStatus().colour.by") != "quality")


def test_A3_what_is_shared_can_be_embedded(page: Page, site: str, shelf: Path) -> None:
    page.route("**/pictures/**", lambda route: route.fulfill(path="build/site/icons/icon-180.png"))
    page.goto(f"{site}/viewer/?mesh=shapes/cube")
    page.evaluate("() => window.hexalab.ready")
    until(lambda: page.evaluate("() => window.hexalab.summary()?.cells"))
    page.locator("#bar").get_by_role("button", name="Share").click()
    dialog = page.locator("#share")
    code = until(lambda: dialog.get_by_label("Embed").input_value())
    badge = dialog.get_by_label("Badge").input_value()
    assert badge.startswith(
        f"[![open in HexaLab]({site}/badge.svg)]({site}/viewer/?mesh=shapes%2Fcube#status="
    )
    (shelf / "shared.html").write_text(f"<!doctype html><title>shared</title>{code}")
    page.goto(f"{site}/bench/shared.html")
    frame = page.frame_locator("iframe")
    frame.get_by_role("link", name="Load the mesh Cube").wait_for()
    assert page.locator("iframe").get_attribute("title") == "Cube, HexaLab"


def test_A3_a_file_of_ones_own_has_a_link_and_nothing_to_embed(page: Page, site: str, tmp_path: Path) -> None:
    hexalab.write(MESH, tmp_path / "mine.mesh")
    page.goto(f"{site}/viewer/")
    page.evaluate("() => window.hexalab.ready")
    page.locator("#file").set_input_files(tmp_path / "mine.mesh")
    until(lambda: page.evaluate("() => window.hexalab.summary()?.cells") == 64)
    page.locator("#bar").get_by_role("button", name="Share").click()
    dialog = page.locator("#share")
    until(lambda: "#status=" in dialog.get_by_label("Link").input_value())
    assert dialog.get_by_label("Embed").is_hidden() and dialog.get_by_label("Badge").is_hidden()
