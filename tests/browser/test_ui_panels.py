"""Drawing, quality, structure, view, inspector: each control, by what it changes in status and picture."""

from __future__ import annotations

import csv
import io
import xml.etree.ElementTree
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser, Page

import hexalab

from . import ui
from .conftest import grid

MESH = grid(5, 5, 5, noise=0.2)
MESH.cell_data["stress"] = np.linspace(-2.0, 3.0, MESH.cell_count)
VALUES = hexalab.quality(MESH, "scaled_jacobian")


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, accept_downloads=True) as page:
        ui.open_mesh(page, site, shelf, MESH, "panels.vtu")
        ui.unfold(page)
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    ui.reset(opened)
    return opened


def test_V1_each_separation_mode_has_its_slider_and_a_surface(mesh: Page) -> None:
    faces = {}
    for mode, slider in (
        ("lines", "separation-line_opacity"),
        ("darkness_coded_edges", "separation-line_opacity"),
        ("fissure", "separation-gap"),
        ("rounded", "separation-radius"),
    ):
        mesh.locator("#separation").select_option(mode)
        ui.set_status(mesh, {})
        visible = [
            one
            for one in ("separation-line_opacity", "separation-gap", "separation-radius")
            if mesh.locator(f"#{one}").is_visible()
        ]
        assert visible == [slider]
        faces[mode] = mesh.evaluate("() => window.hexalab.drawn().faces")
    assert faces["lines"] == faces["darkness_coded_edges"] == 150
    assert faces["rounded"] > faces["fissure"] > faces["lines"]


def test_V2_colours_by_hexadecimal_and_by_attribute(mesh: Page) -> None:
    mesh.locator("#colour-by").select_option("attribute")
    ui.until(lambda: "stress" in mesh.locator("#metric option:checked").inner_text())
    numbers = mesh.locator(".digest-line dd")
    ui.until(lambda: numbers.all_inner_texts() == ["−2.000", "0.500", "3.000"])
    mesh.locator("#background").evaluate("input => input.parentElement.querySelector('.hex').focus()")
    text = mesh.get_by_label("Background colour, as hexadecimal")
    text.fill("#336699")
    text.press("Enter")
    assert ui.status(mesh)["background"] == "#336699"
    text.fill("blue")
    text.press("Enter")
    assert text.input_value() == "#336699"


def test_P6_another_map_asks_nothing_of_the_core(mesh: Page) -> None:
    mesh.locator("#colour-by").select_option("quality")
    ui.set_status(mesh, {})
    before = mesh.evaluate("() => window.hexalab.timings().slice")
    mesh.locator("#colour-map").select_option("viridis")
    mesh.wait_for_timeout(300)
    assert mesh.evaluate("() => window.hexalab.timings().slice") == before
    assert ui.status(mesh)["colour"]["map"] == "viridis"


def test_Q3_statistics_are_the_cores_for_every_metric(mesh: Page) -> None:
    for metric in ("scaled_jacobian", "edge_ratio", "volume"):
        mesh.locator("#metric").select_option(metric)
        values = hexalab.quality(MESH, metric)
        expected = [f"{x:.3f}" for x in (values.min(), values.mean(), values.max())]
        ui.until(lambda wanted=expected: mesh.locator(".digest-line dd").all_inner_texts() == wanted)
    mesh.locator("#metric").select_option("scaled_jacobian")
    ui.until(lambda: mesh.locator("#section-statistics-more").get_by_text("0.50 to 1.00").count() == 1)


def test_Q3_a_click_on_a_worst_cell_flies_to_it(mesh: Page) -> None:
    worst = int(np.argmin(VALUES))
    mesh.get_by_role("button", name=str(worst), exact=True).first.click()
    ui.until(lambda: mesh.locator(".inspector h2").inner_text() == f"Cell {worst}")
    centre = MESH.points[MESH.cells[worst]]
    wanted = ((centre.min(axis=0) + centre.max(axis=0)) / 2 - MESH.centre) / MESH.diagonal
    assert ui.status(mesh)["camera"]["target"] == pytest.approx(wanted.tolist(), abs=1e-9)


def test_Q4_dragging_over_the_histogram_keeps_a_band_and_its_lines_can_be_moved(mesh: Page) -> None:
    ui.until(lambda: mesh.locator(".histogram .bar").count() > 5)
    ui.drag(mesh, ".histogram", 0.5, 0.8)
    item = ui.status(mesh)["filters"]["quality"]["items"][0]
    assert (item["keep"], item["quantity"]) == ("inside", "scaled_jacobian")
    low, high = item["minimum"], item["maximum"]
    inside = np.count_nonzero((low <= VALUES) & (high >= VALUES))
    assert ui.drawn(mesh)[0] == inside
    line = mesh.get_by_role("slider", name="Lowest value shown")
    line.focus()
    line.press("ArrowLeft")
    assert ui.status(mesh)["filters"]["quality"]["items"][0]["minimum"] < item["minimum"]
    mesh.keyboard.press("Control+z")
    assert ui.status(mesh)["filters"]["quality"]["items"][0] == item
    mesh.locator(".histogram").dblclick(position={"x": 20, "y": 60})
    assert ui.status(mesh)["filters"]["quality"]["items"] == []


def test_Q4_the_acceptable_range_does_not_run_through_the_largest_count(mesh: Page) -> None:
    least = f"{hexalab.quality(MESH, 'warpage').min():.3g}"
    for bars in ("horizontal", "vertical"):
        ui.set_status(mesh, {"colour": {"metric": "warpage"}, "histogram": {"orientation": bars}})
        ui.until(lambda: mesh.locator(".digest-line dd").first.inner_text() == least)
        box = mesh.locator(".histogram .bracket").bounding_box()
        largest = mesh.locator(".histogram text").last.bounding_box()
        assert box and largest
        assert largest["y"] + largest["height"] <= box["y"] or largest["x"] + largest["width"] <= box["x"]


def test_Q8_the_variant_of_a_metric_stands_below_its_name(mesh: Page) -> None:
    ui.set_status(mesh, {"colour": {"metric": "scaled_jacobian"}})
    ui.until(lambda: mesh.locator(".variant").inner_text() == "with the centre")
    name, variant = mesh.locator("#metric").bounding_box(), mesh.locator(".variant").bounding_box()
    assert name and variant
    assert variant["x"] == name["x"]
    ui.set_status(mesh, {"colour": {"metric": "stretch"}})
    ui.until(lambda: not mesh.locator(".variant").is_visible())


def test_Q4_the_histogram_is_saved_as_csv_svg_and_png(mesh: Page) -> None:
    ui.set_status(mesh, {"histogram": {"bins": 20}})
    ui.until(lambda: mesh.locator(".histogram .bar").count() in range(1, 21))
    files = {}
    for kind in ("CSV", "SVG", "PNG"):
        with mesh.expect_download() as waiting:
            mesh.get_by_role("button", name=f"Save the histogram as {kind}").click()
        files[kind] = Path(waiting.value.path()).read_bytes()
        assert waiting.value.suggested_filename == f"panels-scaled_jacobian.{kind.lower()}"
    rows = list(csv.DictReader(io.StringIO(files["CSV"].decode())))
    assert len(rows) == 20
    low, high = "scaled_jacobian low", "scaled_jacobian high"
    edges = [float(row[low]) for row in rows] + [float(rows[-1][high])]
    counts, _ = np.histogram(VALUES, edges)
    assert [int(row["cells"]) for row in rows] == counts.tolist()
    root = xml.etree.ElementTree.fromstring(files["SVG"])
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    assert len(root.findall(".//*[@class='bar']")) == np.count_nonzero(counts)
    assert files["PNG"].startswith(b"\x89PNG")
    assert b"iTXthexalab" in files["PNG"]


def test_V4_irregular_steps_have_names_and_the_legend_counts(mesh: Page) -> None:
    slider = mesh.locator("#irregular")
    slider.focus()
    slider.press("End")
    assert slider.get_attribute("aria-valuetext") == "Paper, through"
    assert ui.status(mesh)["irregular"]["mode"] == 6
    # a box of cubes: no irregular edge inside, twelve rims of five edges on the boundary
    assert mesh.locator("#irregular-why").text_content() == "this mesh has no irregular edges"
    assert mesh.locator(".legend tbody tr td").all_inner_texts() == ["0", "60"]
    mesh.locator("#irregular-boundary").check()
    assert mesh.locator("#irregular-why").text_content() == ""


def test_V6_axis_views_projection_and_reset(mesh: Page) -> None:
    mesh.get_by_role("button", name="View from top").click()
    assert ui.status(mesh)["camera"]["direction"] == [0, -1, 0]
    mesh.locator("#projection").select_option("orthographic")
    assert "no angle" in (mesh.locator("#field-of-view-why").text_content() or "")
    mesh.locator("#canvas").focus()
    mesh.keyboard.press("ArrowRight")
    ui.until(lambda: ui.status(mesh)["camera"]["up"] != [0, 0, -1])
    mesh.get_by_role("button", name="Reset the camera").click()
    camera = ui.status(mesh)["camera"]
    assert (camera["direction"], camera["fit"]) == (ui.summary(mesh)["view"]["direction"], True)
    assert ui.status(mesh)["camera"]["projection"] == "perspective"


def test_V7_a_click_inspects_the_cell_with_every_metric(mesh: Page) -> None:
    x, y = ui.middle(mesh)
    mesh.mouse.click(x, y)
    ui.until(lambda: mesh.locator(".inspector").is_visible())
    cell = int(mesh.locator(".inspector h2").inner_text().removeprefix("Cell "))
    # Sizes wait for the mesh's mean volume.
    ui.until(lambda: "…" not in mesh.locator(".inspector").inner_text())
    text = mesh.locator(".inspector").inner_text()
    for metric in hexalab.METRICS.values():
        value = hexalab.quality(MESH, metric.id)[cell]
        if 0.001 < abs(value) < 1e6:
            assert f"{value:.3f}".replace("-", "−") in text, metric.id
    assert "valid" in text
    assert f"{MESH.cell_data['stress'][cell]:.3f}".replace("-", "−") in text
    mesh.mouse.click(x * 0 + 400, 100)
    ui.until(lambda: not mesh.locator(".inspector").is_visible())


def test_a_double_click_on_a_label_resets_the_control(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 2}}, "separation": {"line_opacity": 0.9}})
    mesh.get_by_text("Peel", exact=True).dblclick()
    mesh.get_by_text("Darkness", exact=True).dblclick()
    assert ui.status(mesh)["filters"]["peel"]["depth"] == 0
    assert ui.status(mesh)["separation"]["line_opacity"] == 0.45
