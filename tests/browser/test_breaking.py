"""When things break, it is said, and what can go on goes on (SPEC O5); what the core holds does not grow (P7)."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from benchmarks.memory import thirty
from hexalab.formats import write_medit
from tests.browser import ui
from tests.browser.conftest import grid, planes
from tests.browser.visits import CONTROLLED, OPEN, cells, published_below, visitor

NO_STORAGE = """() => {
    const refused = () => { throw new DOMException("The operation is insecure.", "SecurityError"); };
    delete Navigator.prototype.serviceWorker;
    delete window.caches;
    IDBFactory.prototype.open = refused;
    Object.defineProperty(window, "localStorage", { get: refused });
    Object.defineProperty(window, "sessionStorage", { get: refused });
}"""
KILLERS = """() => {
    window.workers = [];
    const Original = Worker;
    window.Worker = class extends Original {
        constructor(...given) { super(...given); window.workers.push(this); }
    };
}"""
KILL = """() => {
    const worker = window.workers.at(-1);
    worker.terminate();
    worker.dispatchEvent(new ErrorEvent("error", { message: "killed" }));
}"""
EVICT = """async (part) => {
    const gone = [];
    for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const request of await cache.keys())
            if (request.url.includes(part) && (await cache.delete(request))) gone.push(request.url);
    }
    return gone;
}"""
HERE = """async (part) => {
    for (const name of await caches.keys())
        for (const request of await (await caches.open(name)).keys())
            if (request.url.includes(part)) return true;
    return false;
}"""
SPOIL = """async (part) => {
    for (const name of await caches.keys()) {
        const cache = await caches.open(name);
        for (const request of await cache.keys())
            if (request.url.includes(part)) await cache.put(request, new Response(new Uint8Array(1000)));
    }
}"""


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Path, str]]:
    with published_below(tmp_path_factory.mktemp("host")) as found:
        yield found


def test_O5_a_window_that_keeps_nothing_says_so_and_goes_on(
    chromium: Browser, published: tuple[Path, str]
) -> None:
    _, address = published
    with visitor(chromium) as (context, page):
        context.add_init_script(f"({NO_STORAGE})()")
        page.goto(f"{address}viewer/?mesh=shapes/cube")
        page.evaluate("() => window.hexalab.ready")
        assert cells(page) == 512
        assert page.evaluate(OPEN, list(write_medit.write(grid(3, 2, 2)))) == 12
        page.get_by_role("button", name="Help").click()
        expect(page.get_by_role("dialog")).to_contain_text("It does not work without a network: this browser")
        page.goto(f"{address}sources/shapes/")
        keep = page.locator(".keep")
        expect(keep.get_by_role("button")).to_be_disabled()
        expect(keep.get_by_role("status")).to_contain_text("This browser keeps nothing here")
        page.goto(f"{address}offline/")
        expect(page.locator("#offline-state")).to_contain_text("Nothing is kept: this browser")


@pytest.mark.parametrize("moment", ["start", "open", "slice", "rest"])
def test_O5_the_core_may_die_at_any_moment(chromium: Browser, site: str, moment: str) -> None:
    with visitor(chromium, service_workers="block") as (context, page):
        context.add_init_script(f"({KILLERS})()")
        page.goto(f"{site}/viewer/")
        if moment == "start":
            page.evaluate("() => new Promise((resolve) => setTimeout(resolve, 300))")
            page.evaluate(KILL)
            assert "could not be started" in ui.messages(page)
            with page.expect_navigation():
                page.get_by_role("button", name="try again").click()
            page.evaluate(
                "async () => { while (!window.hexalab) await new Promise((r) => setTimeout(r, 9)); }"
            )
        page.evaluate("() => window.hexalab.ready")
        mesh = list(write_medit.write(grid(6, 5, 4)))
        if moment == "open":
            page.evaluate(f"(bytes) => {{ ({OPEN})(bytes).catch(() => {{}}); setTimeout({KILL}, 5); }}", mesh)
            ui.until(lambda: page.evaluate("() => window.workers.length") == 2)
            page.evaluate("() => new Promise((resolve) => setTimeout(resolve, 200))")
            ui.until(lambda: "The core stopped" in ui.messages(page))
        assert page.evaluate(OPEN, mesh) == 120
        if moment == "slice":
            page.evaluate(
                f"(status) => {{ window.hexalab.setStatus(status).catch(() => {{}}); ({KILL})(); }}",
                planes(0.5),
            )
        if moment == "rest":
            page.evaluate(KILL)
        if moment in ("slice", "rest"):
            ui.until(lambda: "the mesh is open as before" in ui.messages(page))
        page.evaluate("(status) => window.hexalab.setStatus(status)", planes(0.5))
        page.evaluate("() => window.hexalab.settled()")
        assert page.evaluate("() => window.hexalab.summary().shown.cells") == 60


def test_O5_what_the_browser_threw_out_is_kept_anew(chromium: Browser, published: tuple[Path, str]) -> None:
    _, address = published
    with visitor(chromium) as (context, page):
        page.goto(f"{address}viewer/")
        page.evaluate("() => window.hexalab.ready")
        page.evaluate(CONTROLLED)
        assert page.evaluate(EVICT, "python_stdlib.zip")
        context.set_offline(True)
        page.goto(f"{address}viewer/")
        ui.until(
            lambda: "python_stdlib.zip could not be fetched: the network may be gone" in ui.messages(page)
        )
        context.set_offline(False)
        page.reload()
        page.evaluate("() => window.hexalab.ready")
        ui.until(lambda: page.evaluate(HERE, "python_stdlib.zip"))


def test_O5_what_was_spoilt_on_the_disk_is_fetched_anew(
    chromium: Browser, published: tuple[Path, str]
) -> None:
    _, address = published
    with visitor(chromium) as (_, page):
        page.goto(f"{address}viewer/")
        page.evaluate("() => window.hexalab.ready")
        page.evaluate(CONTROLLED)
        page.evaluate(SPOIL, "pyodide.asm.wasm")
        page.goto(f"{address}viewer/")
        ui.until(lambda: "pyodide.asm.wasm was damaged" in ui.messages(page))
        with page.expect_navigation():
            page.get_by_role("button", name="try again").click()
        page.evaluate("async () => { while (!window.hexalab) await new Promise((r) => setTimeout(r, 9)); }")
        page.evaluate("() => window.hexalab.ready")


def test_P7_thirty_meshes_take_no_more_memory_than_two(viewer: Page, site: str, shelf: Path) -> None:
    (shelf / "thirty.mesh").write_bytes(write_medit.write(grid(12, 12, 12, noise=0.1)))
    ui.set_status(viewer, {"lighting": {"mode": "direct"}})
    sizes = thirty(viewer, f"{site}/bench/thirty.mesh")
    assert sizes[1] > 10e6
    assert sizes[-1] <= sizes[1]


def test_P7_a_second_mesh_that_goes_leaves_nothing(viewer: Page, site: str, shelf: Path) -> None:
    (shelf / "one.mesh").write_bytes(write_medit.write(grid(2, 2, 2)))
    address = f"{site}/bench/one.mesh"
    viewer.evaluate("url => window.hexalab.open(url)", address)
    session = viewer.context.new_cdp_session(viewer)

    def listeners(times: int) -> int:
        """How many the page has after so many more comparisons with another mesh."""
        for _ in range(times):
            viewer.evaluate("url => window.hexalab.compare(url)", address)
            viewer.evaluate("() => window.hexalab.endComparison()")
        ui.until(lambda: len(viewer.workers) == 1)
        session.send("HeapProfiler.collectGarbage")
        counted: int = session.send("Memory.getDOMCounters")["jsEventListeners"]
        return counted

    assert listeners(1) == listeners(3)
