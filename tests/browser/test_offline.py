"""The site without a network, and a new version of it: real service workers, on a copy of the site below a path."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from benchmarks.page import SITE
from hexalab.formats import write_medit
from tests.browser.conftest import grid, planes
from tests.browser.visits import CONTROLLED, OPEN, cells, published_below, visitor

SCOPES = """async () => {
    const registrations = await navigator.serviceWorker.getRegistrations();
    return registrations.map(({ scope }) => scope);
}"""
KEPT_PAGES = """async (address) => {
    const found = [];
    for (const name of await caches.keys())
        for (const { url } of await (await caches.open(name)).keys())
            if (name.includes("precache") && url.startsWith(`${address}about/`)) found.push(url);
    return found;
}"""
SHELF = """async ({ script, limit, puts }) => {
    const { Shelf } = await import(script);
    const shelf = new Shelf(new URL("https://shelf.example/"));
    await shelf.setLimit(limit);
    const put = [];
    for (const [name, size] of puts) {
        put.push(await shelf.put(`https://mesh.example/${name}`, new Blob([new ArrayBuffer(size)]), { name }));
        await new Promise((resolve) => setTimeout(resolve, 5));
    }
    const rows = await shelf.list();
    for (const { address } of rows) await shelf.remove(address);
    return [put, rows.map(({ name, size }) => [name, size])];
}"""


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, str]]:
    """Folder and address of the site as a host shows it, with pages of its own beside it."""
    with published_below(tmp_path_factory.mktemp("host")) as found:
        yield found


def test_O1_the_second_visit_needs_no_network(chromium: Browser, published: tuple[Path, str]) -> None:
    _, address = published
    with visitor(chromium) as (context, page):
        page.goto(f"{address}viewer/?mesh=shapes/cube")
        page.evaluate("() => window.hexalab.ready")
        page.evaluate(CONTROLLED)
        assert cells(page) == 512
        page.goto(f"{address}sources/shapes/cube/")
        context.set_offline(True)

        page.goto(address)
        page.get_by_role("searchbox").fill("twisted")
        page.get_by_text("Twisted bar").first.wait_for()
        for path, heading in (
            ("sources/faults/", "HexaLab faults"),
            ("sources/shapes/cube/index.html", "Cube"),
            ("about/", "About"),
            ("sources/shapes/bar/", "This page is not kept here"),
        ):
            page.goto(address + path)
            assert heading in page.get_by_role("heading", level=1).inner_text()

        page.goto(f"{address}viewer/?mesh=shapes/cube")
        page.evaluate("() => window.hexalab.ready")
        assert cells(page) == 512
        assert page.evaluate(OPEN, list(write_medit.write(grid(3, 2, 2)))) == 12


def test_O1_what_lies_beside_the_site_is_left_alone(chromium: Browser, published: tuple[Path, str]) -> None:
    _, address = published
    with visitor(chromium) as (_, page):
        page.goto(f"{address}index.html?from=elsewhere")
        page.evaluate(CONTROLLED)
        page.goto(f"{address}about/index.html")
        page.wait_for_load_state()
        assert page.evaluate(SCOPES) == [address]
        page.goto(address.removesuffix("hexalab/"))
        assert page.title() == "Another site"
        assert page.evaluate("() => navigator.serviceWorker.controller") is None
        names = page.evaluate("() => caches.keys()")
        assert names
        assert all(name.endswith(address) for name in names)


def test_O1_a_new_version_is_offered_and_nothing_is_lost(
    chromium: Browser, published: tuple[Path, str]
) -> None:
    folder, address = published
    with visitor(chromium) as (_, page):
        page.goto(f"{address}viewer/")
        page.evaluate("() => window.hexalab.ready")
        page.evaluate(CONTROLLED)
        assert page.evaluate(OPEN, list(write_medit.write(grid(3, 2, 2)))) == 12
        page.evaluate("(status) => window.hexalab.setStatus(status)", planes(0.4))
        before = page.evaluate("() => window.hexalab.getStatus()")

        worker = folder / "service_worker.js"
        changed = re.sub(r'("about/index.html","revision":")\w+', r"\1next", worker.read_text("utf-8"))
        worker.write_text(changed, "utf-8")
        assert "next" not in "".join(page.evaluate(KEPT_PAGES, address))
        page.evaluate("async () => { await (await navigator.serviceWorker.getRegistration()).update(); }")
        offer = page.get_by_text("A new version of HexaLab is there")
        offer.wait_for()
        assert page.evaluate("() => window.hexalab.summary().cells") == 12  # not forced
        with page.expect_navigation():
            page.get_by_role("button", name="reload").click()
        page.evaluate("async () => { while (!window.hexalab) await new Promise((r) => setTimeout(r, 20)); }")
        page.evaluate("() => window.hexalab.ready")
        assert cells(page) == 12
        page.evaluate("() => window.hexalab.settled()")
        assert page.evaluate("() => window.hexalab.getStatus()") == before
        page.get_by_role("button", name="Undo").click()  # nor is what could be undone
        assert page.evaluate("() => window.hexalab.getStatus().filters.planes.items[0].offset") != 0.4
        waiting = "async () => Boolean((await navigator.serviceWorker.getRegistration()).waiting)"
        assert page.evaluate(waiting) is False

        for _ in range(20):  # what the old version kept goes behind the pages that follow
            page.goto(f"{address}about/")
            kept = page.evaluate(KEPT_PAGES, address)
            if len(kept) == 1:
                break
        assert kept == [f"{address}about/index.html?__WB_REVISION__=next"]


def test_O1_opened_meshes_are_kept_up_to_a_limit(chromium: Browser, published: tuple[Path, str]) -> None:
    _, address = published
    (script,) = (SITE / "scripts").glob("*/offline/shelf.js")
    where = f"{address}{script.relative_to(SITE).as_posix()}"
    with visitor(chromium) as (_, page):
        page.goto(f"{address}about/")
        puts = [["a", 400], ["b", 400], ["c", 400], ["d", 1001]]
        put, rows = page.evaluate(SHELF, {"script": where, "limit": 1000, "puts": puts})
        assert put == [True, True, True, False]
        assert rows == [["c", 400], ["b", 400]]
