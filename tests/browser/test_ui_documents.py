"""Settings come and go: files, clipboard, link, editor, pictures; meshes by drop, twice, in error, half-way."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote

import pytest
from playwright.sync_api import Browser, Page

import hexalab

from . import ui
from .conftest import grid

MESH = grid(4, 4, 4, noise=0.1)


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    permissions = ["clipboard-read", "clipboard-write"]
    with ui.one_viewer(chromium, site, accept_downloads=True, permissions=permissions) as page:
        yield page


@pytest.fixture
def mesh(opened: Page, site: str, shelf: Path) -> Page:
    opened.keyboard.press("Escape")
    if ui.summary(opened).get("name") != "documents.mesh":
        ui.open_mesh(opened, site, shelf, MESH, "documents.mesh")
    ui.reset(opened)
    for button in opened.get_by_role("button", name="Dismiss this message").all():
        button.click()
    return opened


def clipboard(page: Page) -> str:
    text: str = page.evaluate("() => navigator.clipboard.readText()")
    return text


def test_S1_a_round_trip_changes_nothing(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}, "colour": {"by": "quality", "map": "jet"}})
    whole = ui.status(mesh)
    assert ui.set_status(mesh, whole) == []
    assert ui.status(mesh) == whole
    assert whole["mesh"]["cells"] == 64
    assert len(whole["mesh"]["sha256"]) == 64


def test_S1_a_wrong_value_is_named_and_the_rest_applies(mesh: Page) -> None:
    rejections = ui.set_status(
        mesh, {"filters": {"peel": {"depth": -1}}, "background": "#112233", "nonsense": 1}
    )
    assert sorted(rejection["path"] for rejection in rejections) == ["filters.peel.depth", "nonsense"]
    assert ui.status(mesh)["background"] == "#112233"
    assert "filters.peel.depth: found -1" in ui.messages(mesh)


def test_S2_copy_and_paste_leave_text_fields_alone(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 2}}})
    mesh.locator("#canvas").focus()
    mesh.keyboard.press("Control+c")
    ui.until(lambda: clipboard(mesh).startswith("{"))
    assert json.loads(clipboard(mesh))["filters"]["peel"]["depth"] == 2
    ui.set_status(mesh, {"filters": {"peel": {"depth": 0}}})
    mesh.keyboard.press("Control+v")
    ui.until(lambda: ui.status(mesh)["filters"]["peel"]["depth"] == 2)
    box = mesh.get_by_label("Slice, value")
    mesh.evaluate("() => navigator.clipboard.writeText('0.25')")
    box.focus()
    mesh.keyboard.press("Control+a")
    mesh.keyboard.press("Control+v")
    assert box.input_value() == "0.25"
    mesh.keyboard.press("Control+a")
    mesh.keyboard.press("Control+c")
    assert clipboard(mesh) == "0.25"
    box.press("Enter")
    assert ui.status(mesh)["filters"]["planes"]["items"][0]["offset"] == 0.25


def test_S2_what_is_pasted_and_no_document_is_said(mesh: Page) -> None:
    mesh.evaluate("() => navigator.clipboard.writeText('hello')")
    mesh.locator("#canvas").focus()
    mesh.keyboard.press("Control+v")
    ui.until(lambda: "the clipboard holds no settings" in ui.messages(mesh))


def test_S2_settings_are_saved_as_a_file_and_dropped_again(mesh: Page) -> None:
    ui.set_status(mesh, {"separation": {"mode": "fissure"}})
    mesh.get_by_role("button", name="Share").click()
    with mesh.expect_download() as waiting:
        mesh.get_by_role("button", name="Save as a file").click()
    mesh.keyboard.press("Escape")
    assert waiting.value.suggested_filename == "documents.hexalab.json"
    text = Path(waiting.value.path()).read_text()
    ui.reset(mesh)
    ui.drop(mesh, ("view.json", text))
    ui.until(lambda: ui.status(mesh)["separation"]["mode"] == "fissure")


def test_S2_the_editor_applies_and_names_what_is_wrong(mesh: Page) -> None:
    mesh.get_by_role("button", name="Share").click()
    mesh.get_by_role("button", name="Edit").click()
    field = mesh.get_by_label("Settings as JSON")
    assert json.loads(field.input_value()) == ui.status(mesh)
    field.fill('{"silhouette": 7}')
    mesh.get_by_role("button", name="Apply").click()
    ui.until(lambda: "silhouette: found 7" in mesh.locator("#status-editor").inner_text())
    field.fill('{"silhouette": 0.5}')
    mesh.get_by_role("button", name="Apply").click()
    ui.until(lambda: not mesh.locator("#status-editor").is_visible())
    assert ui.status(mesh)["silhouette"] == 0.5


def test_S2_a_link_restores_mesh_and_view(mesh: Page, site: str) -> None:
    address = f"{site}/bench/documents.mesh"
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}, "camera": {"direction": [1, 0, 0]}})
    before = ui.status(mesh)
    mesh.get_by_role("button", name="Share").click()
    ui.until(lambda: "#status=" in mesh.get_by_label("Link").input_value())
    fragment = mesh.get_by_label("Link").input_value().split("#")[1]
    mesh.keyboard.press("Escape")
    mesh.goto(f"{site}/viewer/?mesh={quote(address, safe='')}#{fragment}")
    ui.until(lambda: ui.shown(mesh) == 8, 60)
    after = ui.status(mesh)
    assert {**after, "mesh": 0} == {**before, "mesh": 0}


def test_S3_a_saved_picture_brings_the_view_back(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}, "lighting": {"mode": "none"}})
    mesh.evaluate(
        """async () => {
            const blob = await window.hexalab.screenshot({ width: 64, height: 48 });
            await window.hexalab.setStatus({ filters: { peel: { depth: 0 } } });
            const transfer = new DataTransfer();
            transfer.items.add(new File([blob], "view.png"));
            document.body.dispatchEvent(
                new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
        }"""
    )
    ui.until(lambda: ui.status(mesh)["filters"]["peel"]["depth"] == 1)


def test_V9_of_two_drops_at_once_the_last_one_stands(mesh: Page, shelf: Path) -> None:
    for name, sides in (("first.mesh", (9, 9, 9)), ("second.mesh", (2, 3, 2))):
        hexalab.write(grid(*sides), shelf / name)
    ui.drop(mesh, ("first.mesh", (shelf / "first.mesh").read_text()))
    ui.drop(mesh, ("second.mesh", (shelf / "second.mesh").read_text()))
    ui.until(lambda: ui.summary(mesh).get("name") == "second.mesh" and ui.summary(mesh)["shown"])
    mesh.wait_for_timeout(500)
    assert ui.summary(mesh)["cells"] == 12
    assert ui.drawn(mesh) == (12, 32)
    assert ui.messages(mesh) == ""


def test_R10_a_good_file_overtaken_by_a_bad_one_leaves_the_open_mesh(mesh: Page, shelf: Path) -> None:
    before = ui.until(lambda: ui.status(mesh)["mesh"]["sha256"] and ui.status(mesh)["mesh"])
    hexalab.write(grid(9, 9, 9), shelf / "first.mesh")
    asked = mesh.evaluate(
        """async ([good, bad]) => {
            const open = (name, text) => window.hexalab.open(new File([text], name));
            return (await Promise.allSettled([open("first.mesh", good), open("cut.mesh", bad)]))
                .map(({ status }) => status);
        }""",
        [(shelf / "first.mesh").read_text(), "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0"],
    )
    assert asked == ["rejected", "rejected"]
    ui.until(lambda: "cut.mesh" in ui.messages(mesh))
    assert ui.summary(mesh)["cells"] == 64
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    assert ui.drawn(mesh) == (8, 24)
    mesh.wait_for_timeout(300)
    assert ui.status(mesh)["mesh"] == before


def test_V9_a_mesh_and_its_settings_dropped_together(mesh: Page, shelf: Path) -> None:
    text = (shelf / "documents.mesh").read_text()
    ui.drop(mesh, ("again.mesh", text), ("again.json", json.dumps({"filters": {"peel": {"depth": 1}}})))
    ui.until(lambda: ui.summary(mesh).get("name") == "again.mesh" and ui.shown(mesh) == 8)


def test_V9_zero_cells_shown_and_a_mesh_of_one_cell(mesh: Page, site: str, shelf: Path) -> None:
    ui.set_status(mesh, {"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 1}]}}})
    assert ui.drawn(mesh) == (0, 0)
    assert "no cell shown of 64" in mesh.locator("#status-line").inner_text()
    ui.open_mesh(mesh, site, shelf, grid(1, 1, 1), "one.mesh")
    assert "The view of the mesh before was kept" in ui.messages(mesh)
    mesh.get_by_role("button", name="reset", exact=True).click()
    ui.until(lambda: ui.shown(mesh) == 1)
    assert ui.drawn(mesh) == (1, 6)
    assert ui.messages(mesh) == ""
    assert "1 of 1 cell shown" in mesh.locator("#status-line").inner_text()


def test_V9_the_worker_dies_and_the_mesh_is_back(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    mesh.evaluate("() => window.hexalab.restart()")
    ui.until(lambda: "open as before" in ui.messages(mesh), 60)
    assert ui.drawn(mesh)[0] == 8
