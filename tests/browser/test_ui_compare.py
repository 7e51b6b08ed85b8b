"""Two meshes in one page under one status, or a mesh and a reference surface (SPEC S6, S7).

Truths: what the library tells of the same two meshes (which is held against VTK elsewhere), and pictures of a mesh
beside itself, which have to be alike.
"""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab import METRICS, quality
from hexalab.comparison import compare

from . import ui
from .conftest import planes
from .pairs import AFTER, BEFORE, OTHER
from .test_ui_page import AXE, violations

FACTS = compare(BEFORE, AFTER)
WAIT = 60

FIGURE = """async (which) => {
  const picture = await window.hexalab.figure("png", { width: 640, height: 320 }, which);
  const bytes = new Uint8Array(await picture.arrayBuffer());
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}"""

REFUSED = "url => window.hexalab.compare(url).catch(error => error.message)"

CUT_OFF = """() => [...document.querySelectorAll("body *")]
  .filter((one) => one.getBoundingClientRect().right > innerWidth + 1)
  .filter((one) => !one.closest(".visually-hidden, .skip, dialog, .panel"))
  .map((one) => one.outerHTML.slice(0, 80))"""


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    for name, mesh in (("before", BEFORE), ("after", AFTER), ("other", OTHER)):
        hexalab.write(mesh, shelf / f"{name}.mesh")
    with ui.one_viewer(chromium, site, script=AXE.read_text(), accept_downloads=True) as page:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/before.mesh")
        beside(page, site, "after.mesh")
        page.evaluate("() => (document.getElementById('section-compare').open = true)")
        yield page


@pytest.fixture
def two(opened: Page, site: str) -> Page:
    """Before at the left, after at the right, nothing else set."""
    opened.set_viewport_size({"width": 1280, "height": 800})
    opened.emulate_media(color_scheme="light", reduced_motion="reduce")
    if ui.summary(opened)["name"] != "before.mesh":
        opened.evaluate("url => window.hexalab.open(url)", f"{site}/bench/before.mesh")
    if (compared(opened) or {}).get("name") != "after.mesh":
        beside(opened, site, "after.mesh")
    ui.reset(opened)
    ui.until(lambda: compared(opened))
    return opened


def beside(page: Page, site: str, name: str) -> dict[str, Any]:
    found: dict[str, Any] = page.evaluate("url => window.hexalab.compare(url)", f"{site}/bench/{name}")
    return found


def compared(page: Page) -> Any:
    return page.evaluate("() => window.hexalab.comparison()")


def picture(page: Page, which: str = "both") -> np.ndarray:
    png = base64.b64decode(page.evaluate(FIGURE, which))
    return np.array(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)


def label(page: Page) -> str:
    return page.locator("#status-line").inner_text()


def test_S6_both_are_told_and_cells_are_the_same(two: Page) -> None:
    told = compared(two)
    assert (told["same_cells"], told["second"]["cells"], told["second"]["name"]) == (True, 60, "after.mesh")
    assert told["displacement"]["moved"] == FACTS["displacement"]["moved"] == 24
    assert told["displacement"]["max"] == pytest.approx(FACTS["displacement"]["max"], rel=1e-12)
    assert told["volume_ratio"] == pytest.approx(FACTS["volume_ratio"], rel=1e-12)
    assert two.locator(".pane-mesh").all_inner_texts() == ["before.mesh", "after.mesh"]


def test_S7_numbers_are_those_of_the_library(two: Page) -> None:
    apart = two.evaluate("() => window.hexalab.distances()")
    for way in ("a_to_b", "b_to_a"):
        for name, value in FACTS["distance"][way].items():
            assert apart[way][name] == pytest.approx(value, rel=1e-12, abs=1e-15), (way, name)
    assert apart["hausdorff_percent"] == pytest.approx(FACTS["distance"]["hausdorff_percent"], abs=1e-15)
    for metric in ("scaled_jacobian", "skew", "volume"):
        assert two.evaluate("id => window.hexalab.changes(id)", metric) == FACTS["changes"][metric]


def test_S6_one_status_rules_both(two: Page) -> None:
    ui.set_status(two, planes(0.5))
    expected = [
        np.count_nonzero(mesh.barycentres[0] >= mesh.barycentres[0].min() + 0.5 * np.ptp(mesh.barycentres[0]))
        for mesh in (BEFORE, AFTER)
    ]
    words = [f"{side}: {count} of 60 cells shown" for side, count in zip("AB", expected, strict=True)]
    ui.until(lambda: all(word in label(two) for word in words))
    two.evaluate("() => document.getElementById('second-canvas').focus()")
    two.keyboard.press("Control+z")
    ui.until(lambda: label(two).count("60 of 60 cells shown") == 2)


def test_S6_a_mesh_beside_itself_is_seen_alike(two: Page, site: str) -> None:
    beside(two, site, "before.mesh")
    ui.set_status(
        two, {**planes(0.4), "colour": {"by": "quality", "metric": "volume"}, "compare": {"labels": False}}
    )
    ui.until(lambda: "A: 36" in label(two) or "B: " in label(two))
    pixels = picture(two)
    half = pixels.shape[1] // 2
    one, other = (picture(two, which) for which in ("first", "second"))
    assert np.abs(one - other).max() <= 2
    assert (pixels[:, :half] < 250).any()
    assert (pixels[:, half:] < 250).any()


@pytest.mark.parametrize("pane", ["#canvas", "#second-canvas"])
def test_S6_the_camera_is_one(two: Page, pane: str) -> None:
    before = ui.status(two)["camera"]
    box = two.locator(pane).bounding_box()
    assert box
    two.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    two.mouse.down()
    two.mouse.move(box["x"] + box["width"] / 2 + 60, box["y"] + box["height"] / 2 + 20, steps=4)
    two.mouse.up()
    after = ui.status(two)["camera"]
    assert not np.allclose(before["direction"], after["direction"])
    one, other = (picture(two, which) for which in ("first", "second"))
    assert np.abs((one < 240).any(axis=2).astype(int) - (other < 240).any(axis=2)).mean() < 0.02, (
        "outlines agree"
    )


def test_S6_panel_tells_numbers_beside_each_other(two: Page) -> None:
    row = two.locator(".compare-table tr", has_text="Scaled Jacobian").first
    ui.until(row.is_visible)
    numbers = [quality(mesh, "scaled_jacobian").min() for mesh in (BEFORE, AFTER)]
    told = row.locator("td").all_inner_texts()
    assert [float(text.replace("−", "-")) for text in told[:2]] == pytest.approx(numbers, abs=6e-4)
    better = numbers[1] > numbers[0]
    assert ("better" if better else "worse") in row.locator("td").nth(2).get_attribute("class")  # type: ignore[operator]
    assert told[2].startswith("▲+" if better else "▼−")
    two.get_by_role("button", name="All metrics").click()
    ui.until(lambda: two.locator(".compare-table").first.locator("tbody tr").count() == len(METRICS), WAIT)
    with two.expect_download() as coming:
        two.locator(".compare-part", has=two.locator(".compare-table thead select")).get_by_role(
            "button", name="CSV"
        ).click()
    rows = [line.split(",") for line in Path(coming.value.path()).read_text().splitlines()]
    assert len(rows) == 1 + len(METRICS)
    for line in rows[1:]:
        difference = FACTS["difference"][line[0]]
        for place, name in ((4, "min"), (7, "mean"), (10, "max")):
            assert float(line[place]) == pytest.approx(difference[name], rel=1e-9, abs=1e-12), line[0]


def test_Q4_the_histogram_has_bars_and_the_line_of_the_second(two: Page) -> None:
    ui.until(lambda: two.locator(".histogram .steps").count() == 1)
    assert "Bars: A. Line: B." in two.locator(".histogram-frame").inner_text()
    with two.expect_download() as coming:
        two.evaluate(
            """() => {
              const button = document.querySelector('[aria-label="Save the histogram as CSV"]');
              button.closest("details").open = true;
              button.click();
            }"""
        )
    head, *rows = (line.split(",") for line in Path(coming.value.path()).read_text().splitlines())
    assert head[2:] == ["cells of A", "cells of B"]
    edges = [float(row[0]) for row in rows] + [float(rows[-1][1])]
    for place, mesh in ((2, BEFORE), (3, AFTER)):
        counts = np.histogram(quality(mesh, "scaled_jacobian"), edges)[0]
        assert [int(row[place]) for row in rows] == counts.tolist()


def test_S6_cells_that_got_worse_are_coloured_shown_and_listed(two: Page) -> None:
    change = quality(AFTER, "scaled_jacobian") - quality(BEFORE, "scaled_jacobian")
    worse = np.flatnonzero(change < -1e-9)
    words = two.locator(".compare-part p[role=status]")
    ui.until(lambda: f"worse at {len(worse)} cell" in words.inner_text())
    two.get_by_role("button", name="Colour by change").click()
    status = ui.status(two)["colour"]
    assert (status["by"], status["attribute"], status["map"]) == (
        "attribute",
        "change:scaled_jacobian",
        "diverging",
    )
    two.get_by_role("button", name="Only what got worse").click()
    ui.until(lambda: label(two).count(f"{len(worse)} of 60 cells shown") == 2)
    two.get_by_role("button", name="Only what got worse").click()
    two.get_by_role("button", name="Colour by change").click()
    assert ui.status(two)["colour"]["map"] == "parula"
    worst = int(change.argmin()) + 1  # Medit counts from 1
    two.locator(".compare-part .cell-list button").first.click()
    titles = [two.locator(name) for name in ("#inspector-title", "#second-inspector-title")]
    ui.until(lambda: all(title.inner_text() == f"Cell {worst}" for title in titles))


def test_S6_picked_cells_are_those_of_both_where_they_are_the_same(two: Page, site: str) -> None:
    ui.set_status(two, {"filters": {"picking": {"hidden": [0, 1]}}})
    ui.until(lambda: label(two).count("58 of 60 cells shown") == 2)
    beside(two, site, "other.mesh")
    ui.until(lambda: "B: 64 of 64 cells shown" in label(two))
    assert compared(two)["same_cells"] is False
    canvas = two.locator("#second-canvas")
    box = canvas.bounding_box()
    assert box
    two.keyboard.down("Control")
    two.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    two.keyboard.up("Control")
    ui.until(lambda: "B: 63 of 64 cells shown" in label(two))
    status = ui.status(two)
    assert len(status["compare"]["picking"]["hidden"]) == 1
    assert status["filters"]["picking"]["hidden"] == [0, 1]


def test_S6_a_curtain_is_dragged(two: Page) -> None:
    two.locator("#compare-layout").select_option("curtain")
    line = two.locator(".divider")
    box, view = line.bounding_box(), two.locator("#view").bounding_box()
    assert box
    assert view
    two.mouse.move(box["x"] + 6, box["y"] + box["height"] / 2)
    two.mouse.down()
    two.mouse.move(view["x"] + 0.3 * view["width"], box["y"] + 50, steps=5)
    two.mouse.up()
    assert ui.status(two)["compare"]["divider"] == pytest.approx(0.3, abs=0.01)
    widths = [two.locator(name).bounding_box()["width"] for name in ("#canvas", "#second-canvas")]  # type: ignore[index]
    assert widths == [view["width"]] * 2
    ui.set_status(two, {"camera": {"distance": 9.0}})
    two.get_by_role("button", name="Fit what is shown").click()  # though the second picture lies over it
    assert ui.status(two)["camera"]["distance"] < 5
    line.focus()
    two.keyboard.press("ArrowRight")
    assert ui.status(two)["compare"]["divider"] == pytest.approx(0.32, abs=0.01)
    ui.set_status(two, {"compare": {"divider": 0.5}, "colour": {"by": "quality"}})
    ui.set_status(two, {"compare": {"labels": False}})
    pixels = picture(two)
    one, other = (picture(two, which) for which in ("first", "second"))
    part = pixels.shape[1] // 2 - 4
    assert np.abs(pixels[:, :part] - one[:, :part]).max() <= 2
    assert np.abs(pixels[:, -part:] - other[:, -part:]).max() <= 2
    two.locator("#canvas").focus()
    two.keyboard.press("x")
    assert ui.status(two)["compare"]["layout"] == "beside"


def test_S6_each_takes_the_place_of_the_other(two: Page) -> None:
    ui.set_status(two, {"filters": {"peel": {"depth": 1}}})
    two.get_by_role("button", name="Swap").click()
    ui.until(lambda: (compared(two) or {}).get("name") == "before.mesh")
    assert ui.summary(two)["name"] == "after.mesh"
    assert ui.status(two)["filters"]["peel"]["depth"] == 1
    there = two.evaluate("() => window.hexalab.changes('volume')")
    assert (there["worse"], there["better"]) == (
        FACTS["changes"]["volume"]["better"],
        FACTS["changes"]["volume"]["worse"],
    )


def test_S7_a_surface_that_is_dropped_on_the_right_is_measured_against(two: Page) -> None:
    square = "OFF\n4 1 0\n0 0 5\n5 0 5\n5 4 5\n0 4 5\n4 0 1 2 3\n"
    two.evaluate(
        """text => {
            const { right, top, bottom } = document.getElementById("view").getBoundingClientRect();
            const transfer = new DataTransfer();
            transfer.items.add(new File([text], "square.off"));
            const where = { clientX: right - 50, clientY: (top + bottom) / 2 };
            document.body.dispatchEvent(
              new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true, ...where }));
        }""",
        square,
    )
    ui.until(lambda: (compared(two) or {}).get("name") == "square.off")
    assert two.locator("#second-pane").count() == 0
    apart = two.evaluate("() => window.hexalab.distances()")
    expected = compare(BEFORE, hexalab.read_reference(io.BytesIO(square.encode())))["distance"]
    assert apart["a_to_b"]["max"] == pytest.approx(expected["a_to_b"]["max"], rel=1e-12)
    assert apart["b_to_a"]["mean"] == pytest.approx(expected["b_to_a"]["mean"], rel=1e-12)
    assert ui.status(two)["compare"]["reference"]["shown"] is True
    with_film = picture(two)
    ui.set_status(two, {"compare": {"reference": {"shown": False}}})
    assert np.abs(with_film - picture(two)).max() > 20
    two.get_by_role("button", name="Colour by distance").click()
    ui.until(lambda: ui.status(two)["colour"]["attribute"] == "compare:distance")
    two.get_by_role("button", name="End the comparison").click()
    ui.until(lambda: compared(two) is None)
    assert ui.status(two)["colour"]["by"] == "quality"
    assert not {"error", "warning"} & set(ui.messages(two).split(":"))


def test_O5_a_broken_second_leaves_what_is_there(two: Page, site: str, shelf: Path) -> None:
    (shelf / "broken.mesh").write_text("MeshVersionFormatted 2\nDimension 3\nVertices 2\n0 0 0 0\n")
    failed = two.evaluate(REFUSED, f"{site}/bench/broken.mesh")
    assert "broken.mesh" in failed
    assert "broken.mesh" in ui.messages(two)
    assert compared(two)["name"] == "after.mesh"
    ui.set_status(two, {"filters": {"picking": {"hidden": [0]}}})
    ui.until(lambda: label(two).count("59 of 60 cells shown") == 2)


def test_O5_a_broken_first_leaves_both(two: Page, site: str, shelf: Path) -> None:
    (shelf / "broken.mesh").write_text("MeshVersionFormatted 2\nDimension 3\nVertices 2\n0 0 0 0\n")
    two.evaluate("url => window.hexalab.open(url).catch(() => {})", f"{site}/bench/broken.mesh")
    ui.until(lambda: compared(two))
    assert ui.summary(two)["name"] == "before.mesh"
    assert two.evaluate("() => window.hexalab.changes('volume')") == FACTS["changes"]["volume"]
    ui.until(lambda: two.evaluate("() => window.hexalab.distances()"))


def test_O5_a_core_that_was_started_anew_knows_the_other_again(two: Page) -> None:
    ui.set_status(two, {"colour": {"by": "attribute", "attribute": "change:volume"}})
    two.evaluate("() => window.hexalab.restart()")
    ui.until(lambda: compared(two) is None)
    ui.until(lambda: compared(two), WAIT)
    assert two.evaluate("() => window.hexalab.changes('volume')") == FACTS["changes"]["volume"]
    assert ui.status(two)["colour"]["attribute"] == "change:volume"


def test_S2_the_link_of_a_comparison_opens_cold(chromium: Browser, site: str) -> None:
    meshes = "mesh=layouts/winding-walls&with=layouts/straight-walls"
    context = chromium.new_context(viewport={"width": 1280, "height": 800})
    page = context.new_page()
    errors: list[str] = []
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.goto(f"{site}/viewer/?{meshes}")
    ui.until(lambda: page.evaluate("() => window.hexalab?.comparison?.()"), WAIT)
    ui.set_status(
        page, {"compare": {"layout": "curtain", "divider": 0.25}, "filters": {"peel": {"depth": 1}}}
    )
    page.get_by_role("button", name="Share").click()
    link = ui.until(lambda: page.locator("#share input").first.input_value())
    assert meshes in unquote(link)
    page.goto("about:blank")
    page.goto(link)
    ui.until(lambda: page.evaluate("() => window.hexalab?.comparison?.()"), WAIT)
    status = ui.status(page)
    assert (status["compare"]["layout"], status["compare"]["divider"]) == ("curtain", 0.25)
    assert status["compare"]["other"]["name"] == "straight-walls.mesh"
    assert status["filters"]["peel"]["depth"] == 1
    page.get_by_role("button", name="Close the second mesh").click()
    ui.until(lambda: "with=" not in page.url)
    context.close()
    assert errors == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
def test_V8_axe_finds_nothing_and_nothing_is_cut_off(two: Page, scheme: Any, size: tuple[int, int]) -> None:
    two.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    two.set_viewport_size({"width": size[0], "height": size[1]})
    two.evaluate("() => window.hexalab.distances()")
    assert violations(two) == []
    assert two.evaluate(CUT_OFF) == []
    boxes = [two.locator(name).bounding_box() for name in ("#canvas", "#second-canvas")]
    assert all(boxes)
    (one, other) = boxes
    assert one
    assert other
    stacked = size[0] < 721
    assert (other["y"] >= one["y"] + one["height"] - 1) is stacked
    assert (other["x"] >= one["x"] + one["width"] - 1) is not stacked


def test_S6_two_meshes_need_a_first(two: Page, chromium: Browser, site: str) -> None:
    with ui.one_viewer(chromium, site) as page:
        words = page.evaluate(REFUSED, f"{site}/bench/after.mesh")
        assert "Open a mesh first" in words


def test_S6_renamed_cells_are_the_library_s(two: Page, site: str, shelf: Path) -> None:
    """The same mesh with other corners of one cell is not the same."""
    corners = AFTER.corners.copy()
    corners[:, 7] = corners[[1, 2, 3, 0, 5, 6, 7, 4], 7]
    hexalab.write(replace(AFTER, corners=corners), shelf / "turned.mesh")
    told = beside(two, site, "turned.mesh")
    assert (told["same_cells"], told["difference"]) == (False, "cells with other corners")
