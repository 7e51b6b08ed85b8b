"""What scripts, links, files, keys and browsers do to a page: it says so in words, and goes on."""

from __future__ import annotations

import gzip
import json
import zipfile
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

import hexalab
from tests.browser import ui
from tests.browser.conftest import grid

MESH = grid(3, 3, 3)


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, shelf: Path) -> Iterator[Page]:
    """One viewer for all tests that leave it whole."""
    with ui.one_viewer(chromium, site) as page:
        ui.open_mesh(page, site, shelf, MESH, "a.b.c.mesh.gz")
        yield page


@pytest.fixture
def mesh(opened: Page) -> Page:
    ui.reset(opened)
    return opened


def words(page: Page, text: str, seconds: float = 20) -> None:
    """Wait for words among the messages."""
    ui.until(lambda: text in ui.messages(page), seconds)


# -- scripts and the clipboard


def test_A3_a_proxy_is_a_document_like_any_other(mesh: Page) -> None:
    assert mesh.evaluate("() => window.hexalab.setStatus(new Proxy({colour: {by: 'kind'}}, {}))") == []
    assert ui.status(mesh)["colour"]["by"] == "kind"


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("const a = {}; a.a = a; return a", "nested more than 64 deep"),
        ("return {a: () => 1}", "hold a function at a"),
        ("return {a: 1n}", "hold a bigint at a"),
        ("return {get a() { throw new Error('not now') }}", "not now"),
        ("let a = 1; for (let i = 0; i < 20000; i++) a = {a}; return a", "nested more than 64 deep"),
    ],
)
def test_A3_what_is_no_document_is_refused_and_the_core_goes_on(mesh: Page, script: str, said: str) -> None:
    ask = f"() => window.hexalab.setStatus((() => {{ {script} }})()).then(() => '', (error) => error.message)"
    assert said in mesh.evaluate(ask)
    assert ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}}) == []
    assert ui.shown(mesh) == 1


@pytest.mark.parametrize("depth", [1_500, 20_000])
def test_S3_deep_text_in_the_clipboard_is_refused(mesh: Page, depth: int) -> None:
    mesh.evaluate(
        """depth => {
            const data = new DataTransfer();
            data.setData("text/plain", '{"a":'.repeat(depth) + "1" + "}".repeat(depth));
            document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
        }""",
        depth,
    )
    words(mesh, "nested more than 64 deep")
    assert ui.set_status(mesh, {}) == []


@pytest.mark.parametrize(
    "size", [{"width": 10.5, "height": 10}, {"width": 0}, {"height": 9000}, {"width": "x"}]
)
def test_A3_sizes_of_pictures_are_whole_and_within_bounds(mesh: Page, size: dict[str, Any]) -> None:
    said = mesh.evaluate(
        "size => window.hexalab.screenshot(size).then(() => '', (error) => error.message)", size
    )
    assert "expected a whole number from 1 to 8192" in said


def test_S4_names_keep_all_but_the_ending(mesh: Page) -> None:
    mesh.locator("#bar").get_by_role("button", name="Share").click()
    with mesh.expect_download() as saved:
        mesh.get_by_role("button", name="Save as a file").click()
    assert saved.value.suggested_filename == "a.b.c.hexalab.json"
    mesh.keyboard.press("Escape")


def test_S3_copied_is_true(mesh: Page) -> None:
    """Neither way lets the page copy: then the text is selected, and the page says what to press."""
    mesh.evaluate(
        """() => {
            navigator.clipboard.writeText = () => Promise.reject(new Error("denied"));
            document.execCommand = () => false;
        }"""
    )
    mesh.locator("#bar").get_by_role("button", name="Share").click()
    field = mesh.locator(".copy-field").first
    field.get_by_role("button").click()
    ui.until(lambda: "Press Ctrl+C" in field.inner_text())
    assert "Copied" not in field.inner_text()
    assert mesh.evaluate("() => getSelection().toString() || document.activeElement.value").startswith("http")
    mesh.keyboard.press("Escape")


# -- links


def test_S1_a_link_with_settings_pasted_into_the_same_tab_applies(mesh: Page) -> None:
    ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}})
    address = mesh.evaluate("() => window.hexalab.getStatus() && location.href")
    link = mesh.evaluate(
        """async () => {
            const bytes = new TextEncoder().encode(JSON.stringify({ version: 2, colour: { by: "kind" } }));
            const deflated = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw"));
            const packed = new Uint8Array(await new Response(deflated).arrayBuffer());
            return "#status=" + btoa(String.fromCharCode(...packed)).replaceAll("+", "-").replaceAll("/", "_");
        }"""
    )
    mesh.evaluate("hash => { location.hash = hash }", link)
    ui.until(lambda: ui.status(mesh)["colour"]["by"] == "kind")
    mesh.evaluate("() => { location.hash = '#status=broken' }")
    words(mesh, "the link's status can't be read")
    mesh.evaluate("address => history.replaceState(null, '', address)", address.split("#")[0])


@pytest.mark.parametrize(
    ("address", "said"),
    [
        ("http://example.org/a.mesh", "only https addresses, and those of this site and this machine"),
        ("ftp://example.org/a.mesh", "begin with ftp: can't be read"),
        ("file:///a.mesh", "drop the file here"),
        ("https://[", "is no address of a mesh"),
    ],
)
def test_S1_an_address_that_cannot_be_opened_says_why(mesh: Page, address: str, said: str) -> None:
    told = mesh.evaluate("url => window.hexalab.open(url).then(() => '', (error) => error.message)", address)
    assert said in told
    words(mesh, said)


def test_S1_a_percent_sign_in_an_address(page: Page, site: str, shelf: Path) -> None:
    hexalab.write(MESH, shelf / "50%.mesh")
    page.goto(f"{site}/viewer/?mesh={site}/bench/50%2525.mesh")
    page.evaluate("() => window.hexalab.ready")
    ui.until(lambda: ui.summary(page).get("name") == "50%.mesh")


# -- files


def archive(files: dict[str, bytes], **options: Any) -> bytes:
    """A zip of the files."""
    out = BytesIO()
    with zipfile.ZipFile(out, "w", **options) as made:
        for name, data in files.items():
            made.writestr(name, data)
    return out.getvalue()


def drop(page: Page, *files: tuple[str, bytes]) -> None:
    """Drop files, (name, content) each, onto the window in one go."""
    page.evaluate(
        """files => {
            const transfer = new DataTransfer();
            for (const [name, bytes] of files) transfer.items.add(new File([new Uint8Array(bytes)], name));
            const event = new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true });
            document.body.dispatchEvent(event);
        }""",
        [[name, list(data)] for name, data in files],
    )


DECK = b"*HEADING\nmodel\n*INCLUDE, INPUT=parts/mesh.inp\n*STEP\n*END STEP\n"
PART = (Path(__file__).parents[1] / "core/formats/cases/abaqus-elset.inp").read_bytes()


def test_R5_a_deck_and_what_it_includes_are_dropped_together(mesh: Page) -> None:
    drop(mesh, ("job.inp", DECK))
    words(mesh, "it includes parts/mesh.inp")
    drop(mesh, ("mesh.inp", PART), ("job.inp", DECK))
    ui.until(lambda: ui.summary(mesh).get("name") == "job.inp")
    drop(mesh, ("mesh.inp", PART), ("job.inp.gz", gzip.compress(DECK)))
    ui.until(lambda: ui.summary(mesh).get("name") == "job.inp.gz")
    assert ui.summary(mesh)["kinds"]["hexahedron"] == 2


def test_R5_what_a_deck_includes_may_be_called_anything(mesh: Page) -> None:
    """CalculiX' preprocessor writes `all.msh`, which is no Gmsh file; a `.txt` is no settings here."""
    deck = b"*HEADING\n*INCLUDE, INPUT=all.msh\n*INCLUDE, INPUT=gr\xc3\xb6\xc3\x9fe.txt\n*STEP\n*END STEP\n"
    drop(mesh, ("all.msh", PART), ("cgx.inp", deck), ("größe.txt", b"** nothing\n"))
    ui.until(lambda: ui.summary(mesh).get("name") == "cgx.inp")
    assert ui.summary(mesh)["cells"] == 2
    assert "größe" not in ui.messages(mesh) and "all.msh" not in ui.messages(mesh)


def test_R5_a_deck_in_an_archive_is_one_mesh(mesh: Page) -> None:
    drop(mesh, ("model.zip", archive({"job/job.inp": DECK, "job/parts/mesh.inp": PART})))
    ui.until(lambda: ui.summary(mesh).get("name", "").endswith("job.inp") and ui.summary(mesh)["cells"] == 2)


def test_O3_a_folder_that_is_dropped_is_its_files(mesh: Page) -> None:
    """Real entries of a folder come from a real drag alone; these are its interface, with a hundred files at a time."""
    mesh.evaluate(
        """files => {
            const file = (name, bytes) => ({ isFile: true, isDirectory: false, name,
                file: (done) => done(new File([new Uint8Array(bytes)], name)) });
            const folder = (name, children) => ({ isFile: false, isDirectory: true, name, createReader: () => {
                let left = [...children];
                return { readEntries: (done) => { const some = left.slice(0, 1); left = left.slice(1); done(some); } };
            } });
            const [deck, part] = files;
            const root = folder("model", [file(".hidden.inp", deck), file("job.inp", deck),
                folder("parts", [file("mesh.inp", part)])]);
            const event = new Event("drop", { bubbles: true, cancelable: true });
            event.dataTransfer = { types: ["Files"], files: [], items: [{ webkitGetAsEntry: () => root }] };
            document.body.dispatchEvent(event);
        }""",
        [list(DECK), list(PART)],
    )
    ui.until(lambda: ui.summary(mesh).get("name") == "model/job.inp")
    assert ui.summary(mesh)["cells"] == 2


def test_B1_settings_dropped_with_an_archive_apply_over_its_own(mesh: Page, shelf: Path) -> None:
    hexalab.write(MESH, shelf / "x.vtk")
    own = json.dumps({"colour": {"by": "kind", "map": "jet"}}).encode()
    data = archive({"x.vtk": (shelf / "x.vtk").read_bytes(), "x.json": own})
    drop(mesh, ("x.zip", data), ("mine.json", json.dumps({"colour": {"by": "quality"}}).encode()))
    ui.until(lambda: ui.summary(mesh).get("name") == "x.vtk")
    ui.until(lambda: ui.status(mesh)["colour"]["by"] == "quality")
    assert ui.status(mesh)["colour"]["map"] == "jet"


def test_B1_archives_that_cannot_be_read_are_told_in_words(mesh: Page, shelf: Path) -> None:
    whole = archive({"x.mesh": b"MeshVersionFormatted 2\n" * 100}, compression=zipfile.ZIP_DEFLATED)
    encrypted = bytearray(whole)
    for at in (6, whole.index(b"PK\x01\x02") + 8):
        encrypted[at] |= 1
    drop(mesh, ("secret.zip", bytes(encrypted)))
    words(mesh, "x.mesh is encrypted: unpack the archive with its password")
    drop(mesh, ("cut.zip", whole[:-30]))
    words(mesh, "cut.zip: this is no ZIP archive, or it is cut short")
    broken = bytearray(whole)
    start = 30 + len("x.mesh")
    broken[start : start + 8] = b"\xff" * 8
    drop(mesh, ("broken.zip", bytes(broken)))
    words(mesh, "what is compressed there is broken")
    packed = archive({"x.mesh": b"x" * 1000}, compression=zipfile.ZIP_LZMA)
    drop(mesh, ("lzma.zip", packed))
    words(mesh, "found compression method 14 (LZMA)")


def test_O3_a_file_that_changes_on_disk_leaves_its_mesh_usable(mesh: Page, tmp_path: Path) -> None:
    path = tmp_path / "changing.mesh"
    hexalab.write(MESH, path)
    mesh.locator("#file").set_input_files(path)
    ui.until(lambda: ui.status(mesh)["mesh"]["name"] == "changing.mesh" and ui.status(mesh)["mesh"]["sha256"])
    path.write_bytes(b"something else")
    mesh.evaluate("() => window.hexalab.restart()")
    words(mesh, "the mesh is open as before", 60)
    assert ui.set_status(mesh, {"filters": {"peel": {"depth": 1}}}) == []
    assert ui.shown(mesh) == 1
