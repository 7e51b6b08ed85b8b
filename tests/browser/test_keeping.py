"""What the user asks to be kept: a source whose meshes lie on another host, the page of what is kept, full storage."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, expect

from hexalab.formats import write_medit
from site_builder.build import build
from tests.browser.conftest import grid
from tests.browser.visits import CONTROLLED, cells, served, visitor

SIDES = {"small.mesh": (3, 2, 2), "tall.mesh": (2, 2, 9), "wide.mesh": (8, 7, 2)}
SOURCE = """
reference:
  type: article-journal
  title: Meshes that lie elsewhere
  author: [{{ family: Elsewhere, given: Ann }}]
  issued: 2025
licence: authors
base_url: "{host}"
meshes:
  - url: small.mesh
  - url: tall.mesh
  - url: wide.mesh
  - url: missing.mesh
"""
CATALOGUE = """
title: Kept
description: A catalogue whose meshes lie elsewhere, on a host that lets every site read its files.
address: http://localhost:8000/
publisher: Tests
"""
FULL = """() => {
    Cache.prototype.put = async () => { throw new DOMException("no room", "QuotaExceededError"); };
}"""


class Elsewhere(SimpleHTTPRequestHandler):
    """Another host, which lets every site read its files."""

    def end_headers(self) -> None:
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()

    def log_message(self, format: str, *arguments: Any) -> None:
        """Stay quiet."""


@pytest.fixture(scope="module")
def host(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("elsewhere")
    for name, sides in SIDES.items():
        (folder / name).write_bytes(write_medit.write(grid(*sides)))

    def handler(*arguments: Any) -> Elsewhere:
        return Elsewhere(*arguments, directory=str(folder))

    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


@pytest.fixture(scope="module")
def address(host: str, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A site of its own, below a path, with a source whose meshes lie on the other host."""
    top = tmp_path_factory.mktemp("kept")
    source = top / "repository" / "elsewhere-2025"
    source.mkdir(parents=True)
    (source.parent / "catalogue.yaml").write_text(CATALOGUE)
    (source / "source.yaml").write_text(SOURCE.format(host=host))
    build(source.parent, top / "host" / "hexalab", pictures=False, cache=top / "cache")
    with served(top / "host") as root:
        yield f"{root}hexalab/"


def kept(page: Page, address: str) -> list[list[str]]:
    """Rows of the table of meshes on the page of what is kept."""
    page.goto(f"{address}offline/")
    expect(page.locator("#offline")).to_have_attribute("aria-busy", "false")
    return [row.locator("th, td").all_inner_texts()[:5] for row in page.locator("#offline-meshes tr").all()]


def test_O1_a_source_on_another_host_is_kept_opened_without_a_network_and_freed(
    chromium: Browser, address: str, host: str
) -> None:
    with visitor(chromium) as (context, page):
        page.goto(f"{address}sources/elsewhere-2025/")
        page.evaluate(CONTROLLED)
        keep = page.locator(".keep")
        expect(keep.get_by_role("status")).to_have_text("4 meshes, size not known")
        keep.get_by_role("button", name="Keep offline").click()
        expect(keep.get_by_role("status")).to_contain_text("missing.mesh could not be fetched")
        expect(keep.get_by_role("status")).to_contain_text("answered 404")
        page.reload()
        expect(keep.get_by_role("status")).to_contain_text("3 of 4 meshes are kept")

        context.set_offline(True)
        page.goto(f"{address}sources/elsewhere-2025/tall/")
        assert page.get_by_role("heading", level=1).inner_text() == "tall"
        page.goto(f"{address}viewer/?mesh=elsewhere-2025/tall")
        page.evaluate("() => window.hexalab.ready")
        assert cells(page) == 36
        page.get_by_text("Kept offline", exact=True).wait_for()
        context.set_offline(False)

        rows = kept(page, address)
        assert sorted(row[0] for row in rows) == ["small", "tall", "wide"]
        assert {row[1] for row in rows} == {host.removeprefix("http://").strip("/")}
        assert {row[4] for row in rows} == {"until you free it"}
        page.get_by_role("button", name="Free: wide").click()
        expect(page.locator("#offline-meshes tr")).to_have_count(2)
        page.goto(f"{address}sources/elsewhere-2025/small/")
        page.get_by_role("button", name="Free").click()
        expect(page.get_by_role("button", name="Keep offline")).to_be_visible()
        assert [row[0] for row in kept(page, address)] == ["tall"]

        page.get_by_role("button", name="Free everything").click()
        page.get_by_role("button", name="Really free everything").click()
        expect(page.locator("#offline-state")).to_contain_text("not kept yet")
        assert page.evaluate("() => caches.keys()") == []


def test_O1_the_viewer_keeps_the_open_mesh_and_frees_it(chromium: Browser, address: str, host: str) -> None:
    with visitor(chromium) as (_, page):
        page.goto(f"{address}viewer/?mesh={host}small.mesh")
        page.evaluate("() => window.hexalab.ready")
        page.evaluate(CONTROLLED)
        assert cells(page) == 12
        page.get_by_role("button", name="Keep offline").click()
        page.get_by_text("Kept offline", exact=True).wait_for()
        assert [(row[0], row[4]) for row in kept(page, address)] == [("small", "until you free it")]
        page.locator("#offline-limit").fill("0")
        page.locator("#offline-limit").press("Enter")
        expect(page.locator("#offline-meshes tr")).to_have_count(1)  # what is kept does not count
        page.go_back()
        page.evaluate("() => window.hexalab.ready")
        page.locator(".keeping").get_by_role("button", name="Free").click()
        page.get_by_role("button", name="Keep offline").wait_for()
        assert kept(page, address) == []


def test_O1_keeping_can_be_cancelled(chromium: Browser, address: str) -> None:
    with visitor(chromium) as (_, page):
        page.goto(f"{address}sources/elsewhere-2025/")
        page.route("**/tall.mesh", lambda route: None)  # never answers
        keep = page.locator(".keep")
        keep.get_by_role("button", name="Keep offline").click()
        expect(keep.locator("progress")).to_be_visible()
        keep.get_by_role("button", name="Cancel").click()
        expect(keep.get_by_role("button", name="Keep offline")).to_be_visible()
        expect(keep.locator("progress")).to_be_hidden()


def test_O5_a_full_storage_is_said(chromium: Browser, address: str, host: str) -> None:
    with visitor(chromium) as (_, page):
        page.goto(f"{address}sources/elsewhere-2025/")
        page.evaluate(FULL)
        page.locator(".keep").get_by_role("button", name="Keep offline").click()
        expect(page.locator(".keep").get_by_role("status")).to_contain_text("storage is full")
        page.add_init_script(f"({FULL})()")
        page.goto(f"{address}viewer/?mesh={host}small.mesh")
        page.get_by_text("storage is full: small.mesh is not kept").wait_for()
        assert cells(page) == 12


def test_C8_the_manifest_names_what_is_there(address: str, chromium: Browser) -> None:
    with visitor(chromium) as (_, page):
        page.goto(address)
        session = page.context.new_cdp_session(page)
        found = session.send("Page.getAppManifest")
        assert found["errors"] == []
        document = json.loads(found["data"])
        for icon in document["icons"]:
            answer = page.request.get(address + icon["src"])
            assert answer.ok
            assert answer.headers["content-type"] == icon["type"]
        lacks = {
            lack["errorId"] for lack in session.send("Page.getInstallabilityErrors")["installabilityErrors"]
        }
        assert lacks <= {"in-incognito"}  # the browser's own state


HAND_OVER = """async (bytes) => {
    const folder = await navigator.storage.getDirectory();
    const handle = await folder.getFileHandle("handed.mesh", { create: true });
    const stream = await handle.createWritable();
    await stream.write(new Uint8Array(bytes));
    await stream.close();
    await window.launched({ files: [handle] });
}"""
QUEUE = """() => Object.defineProperty(window, "launchQueue", {
    value: { setConsumer: (take) => { window.launched = take; } } })"""


def test_O1_a_file_of_the_desktop_opens_in_the_viewer_from_any_page(chromium: Browser, address: str) -> None:
    with visitor(chromium) as (context, page):
        context.add_init_script(f"({QUEUE})()")
        for path in ("viewer/", "about/"):
            page.goto(address + path)
            page.wait_for_function("() => window.launched")
            if path == "about/":
                with page.expect_navigation(url="**/viewer/**"):
                    page.evaluate(HAND_OVER, list(write_medit.write(grid(2, 2, 2))))
            else:
                page.evaluate(HAND_OVER, list(write_medit.write(grid(2, 2, 3))))
            assert cells(page) == (8 if path == "about/" else 12)


SHARE = """async ({ address, bytes }) => {
    const form = document.createElement("form");
    form.method = "post";
    form.enctype = "multipart/form-data";
    form.action = `${address}share`;
    const input = document.createElement("input");
    input.type = "file";
    input.name = "files";
    const transfer = new DataTransfer();
    transfer.items.add(new File([new Uint8Array(bytes)], "shared.mesh"));
    input.files = transfer.files;
    form.append(input);
    document.body.append(form);
    form.submit();
}"""


def test_O1_a_file_that_is_shared_opens_in_the_viewer(chromium: Browser, address: str) -> None:
    with visitor(chromium, bypass_csp=True) as (_, page):
        page.goto(f"{address}about/")
        page.evaluate(CONTROLLED)
        with page.expect_navigation(url="**/viewer/**"):
            page.evaluate(SHARE, {"address": address, "bytes": list(write_medit.write(grid(2, 2, 2)))})
        assert cells(page) == 8
        assert "held" not in page.url
