"""Saving from the dialog and by `hexalab export` (SPEC A7, A8), and what can't be saved."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import Page

import hexalab
from hexalab.cli import export

from ..ui import until
from .asking import HALF, measured, polygons, put, run

pytestmark = pytest.mark.browser


def test_A8_what_can_not_be_saved_is_told(viewer: Page) -> None:
    for method, args, words in (
        ("surface", ["step"], "found the format ‘step’, expected one of glb, ply, obj, stl"),
        ("cells", ["glb"], "found the format ‘glb’, expected one of mesh, vtk, vtu"),
        ("page", [{"metrics": ["none"]}], "found the metric ‘none’"),
        ("page", [{"slices": [2]}], "found the slice 2, expected numbers from 0 to 1"),
        ("turntable", [{"frames": 1}], "frames: found 1, expected a whole number from 2 to 720"),
        ("turntable", [{"format": "gif"}], "found the format ‘gif’, expected zip, webm or mp4"),
        ("turntable", [{"format": "webm", "width": 321, "height": 240}], "expected even numbers"),
    ):
        ask = "([method, args]) => window.hexalab[method](...args).then(() => '', (error) => error.message)"
        assert words in viewer.evaluate(ask, [method, args])
    put(viewer, {"filters": {"peel": {"depth": 9}}})
    for method, args in (("surface", ["ply"]), ("cells", ["vtu"]), ("page", []), ("turntable", [])):
        assert "no cell is shown" in viewer.evaluate(ask, [method, args])


@pytest.mark.parametrize(
    ("what", "form", "name", "begins"),
    [
        ("cells", "vtu", "brick.vtu", b"<?xml"),
        ("surface", "glb", "brick.glb", b"glTF"),
        ("page", "", "brick.html", b"<!doctype html>"),
        ("turntable", "zip", "brick.zip", b"PK"),
        ("report", "html", "brick-report.html", b"<!doctype html>"),
    ],
)
def test_A8_the_dialog_saves(
    viewer: Page, tmp_path: Path, what: str, form: str, name: str, begins: bytes
) -> None:
    viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
    dialog = viewer.locator("#save")
    dialog.get_by_label("What").select_option(what)
    assert dialog.get_by_label("Format").is_visible() == bool(form)
    if form:
        assert dialog.get_by_label("Format").input_value() == form
    if what == "turntable":
        for label, value in (("Pictures", "2"), ("Width", "100"), ("Height", "80")):
            dialog.get_by_label(label).fill(value)
            dialog.get_by_label(label).press("Enter")
    with viewer.expect_download() as download:
        dialog.get_by_role("button", name="Save", exact=True).click()
    assert download.value.suggested_filename == name
    path = tmp_path / name
    download.value.save_as(path)
    assert path.read_bytes().startswith(begins)
    until(lambda: f"Saved: {name}" in dialog.locator(".save-result").inner_text())
    if what == "cells":
        found = hexalab.read(path)
        assert found.cell_count == 24 and set(found.cell_data) == {"scaled_jacobian"}


def test_A8_the_dialog_says_what_is_left_out(viewer: Page) -> None:
    viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
    dialog = viewer.locator("#save")
    dialog.get_by_label("What").select_option("cells")
    dialog.get_by_label("Format").select_option("mesh")
    with viewer.expect_download():
        dialog.get_by_role("button", name="Save", exact=True).click()
    until(lambda: "no place for the attributes scaled_jacobian" in dialog.locator(".save-notes").inner_text())


def test_A8_what_is_ticked_is_what_goes_along(viewer: Page, tmp_path: Path) -> None:
    viewer.evaluate("() => window.hexalab.openOffered('1')")
    try:
        viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
        dialog = viewer.locator("#save")

        def ticked() -> list[str]:
            return [
                box.get_attribute("value") or ""
                for box in dialog.locator("input[type=checkbox][value]:checked").all()
            ]

        dialog.get_by_label("What").select_option("page")
        assert ticked() == ["scaled_jacobian"]
        dialog.get_by_label("flow, y").check()
        dialog.get_by_label("What").select_option("cells")
        assert ticked() == ["scaled_jacobian", "cell:flow", "point:height"], (
            "a component is no whole attribute"
        )
        dialog.get_by_role("checkbox", name="height").uncheck()
        dialog.get_by_label("Format").select_option("vtu")
        with viewer.expect_download() as download:
            dialog.get_by_role("button", name="Save", exact=True).click()
        download.value.save_as(tmp_path / "flow.vtu")
        found = hexalab.read(tmp_path / "flow.vtu")
        assert set(found.cell_data) == {"scaled_jacobian", "flow"} and not found.point_data
        assert found.cell_data["flow"].shape == (24, 3)
        dialog.get_by_label("What").select_option("page")
        with viewer.expect_download() as download:
            dialog.get_by_role("button", name="Save", exact=True).click()
        download.value.save_as(tmp_path / "flow.html")
        assert (tmp_path / "flow.html").stat().st_size > 200_000
    finally:
        viewer.keyboard.press("Escape")
        viewer.evaluate("() => window.hexalab.openOffered('0')")


def test_A8_light_is_kept_where_it_comes_from_all_around(viewer: Page) -> None:
    for mode, kept in (("object_space_ao", True), ("direct", False)):
        put(viewer, {"lighting": {"mode": mode}})
        viewer.locator("#bar").get_by_role("button", name="Save", exact=True).click()
        viewer.locator("#save").get_by_label("What").select_option("surface")
        assert viewer.get_by_label("Light in the colours").is_checked() == kept
        viewer.keyboard.press("Escape")


def test_A8_page_and_command_line_know_the_same_limits() -> None:
    names = ("FRAMES", "MOST_FRAMES", "SECONDS", "MOST_SECONDS")
    script = (
        'import * as limits from "./static/viewer/state/leaving.js";'
        f"console.log(JSON.stringify({list(names)}.map((name) => limits[name])))"
    )
    words = ["node", "--input-type=module", "--eval", script]
    done = subprocess.run(words, capture_output=True, text=True, check=True, cwd=Path(__file__).parents[3])
    assert json.loads(done.stdout) == [getattr(export, name) for name in names]


def test_A8_export_writes_what_the_ending_says(
    brick: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "half.json").write_text(json.dumps({**HALF, "silhouette": 7}))
    status = ["--status", str(tmp_path / "half.json")]
    page = tmp_path / "page.html"
    words = ["export", str(brick), "-o", str(page), *status, "--metrics", "volume", "--slices", "2"]
    assert run([*words, "--reference", "B. Rick (2026)"]) == 0
    out, err = capsys.readouterr()
    assert out == f"{page}: 24 cells, {page.stat().st_size:,} bytes\n"
    assert err.count("\n") == 1 and "silhouette: found 7" in err
    assert "B. Rick (2026)" in page.read_text("utf-8")
    surface = tmp_path / "half.stl"
    assert run(["export", str(brick), "-o", str(surface), *status]) == 0
    assert measured(polygons(surface))[1] == pytest.approx(12, rel=1e-4)
    assert "single precision" in capsys.readouterr().err
