"""A start that fails, wherever it does, ends in words: it neither waits for ever nor leaves a blank page."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, Route

from tests.browser import ui
from tests.browser.conftest import grid
from tests.browser.test_forgiving import words

MESH = grid(3, 3, 3)
NO_HASH = "Object.defineProperty(self, 'crypto', {value: {getRandomValues: crypto.getRandomValues.bind(crypto)}});\n"


def start(chromium: Browser, address: str, prepare: Any = None, **context: Any) -> tuple[Page, list[str]]:
    """A page of its own at the address, and what its console reports."""
    page = chromium.new_context(**context).new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    if prepare:
        prepare(page)
    page.goto(address)
    return page, errors


def test_O4_an_interpreter_whose_file_is_missing_is_told(chromium: Browser, site: str) -> None:
    page, _ = start(
        chromium, f"{site}/viewer/", lambda page: page.route("**/*.asm.wasm", lambda route: route.abort())
    )
    words(page, "The measuring engine could not be started: ")
    assert "could not be fetched" in ui.messages(page)
    assert page.get_by_role("button", name="try again").count() == 1
    page.context.close()


def test_O4_a_file_that_the_server_has_not_is_told(chromium: Browser, site: str) -> None:
    gone = lambda route: route.fulfill(status=404, body="")  # noqa: E731
    page, _ = start(chromium, f"{site}/viewer/", lambda page: page.route("**/python_stdlib.zip", gone))
    words(page, "python_stdlib.zip is missing on the server (status 404)")
    page.context.close()


@pytest.mark.parametrize(
    "file", ["pyodide.asm.wasm", "pyodide.asm.js", "python_stdlib.zip", "numpy-*.whl", "hexalab-*.whl"]
)
def test_O5_a_damaged_file_is_named_and_fetched_anew(chromium: Browser, site: str, file: str) -> None:
    asked: list[str] = []

    def damage(route: Route) -> None:
        asked.append(route.request.url)
        if len(asked) > 2:  # by the start and by the check: then past all caches
            return route.continue_()
        response = route.fetch()
        body = bytearray(response.body())
        middle = len(body) // 2
        body[middle : middle + 4000] = bytes(4000)
        return route.fulfill(body=bytes(body), headers={"content-type": response.headers["content-type"]})

    page, _ = start(chromium, f"{site}/viewer/", lambda page: page.context.route(f"**/{file}", damage))
    words(page, "was damaged on its way or on this disk, and has been fetched anew")
    assert file.split("*")[0] in ui.messages(page)
    page.context.unroute_all()
    with page.expect_navigation():
        page.get_by_role("button", name="try again").click()
    page.evaluate("async () => { while (!window.hexalab) await new Promise((r) => setTimeout(r, 20)); }")
    assert page.evaluate("() => window.hexalab.ready.then(() => true)")
    page.context.close()


def test_O4_webassembly_blocked_by_a_policy_is_told(chromium: Browser, site: str) -> None:
    def without(route: Route) -> None:
        response = route.fetch()
        policy = "script-src 'self'"
        route.fulfill(response=response, headers={**response.headers, "content-security-policy": policy})

    page, _ = start(chromium, f"{site}/viewer/", lambda page: page.route("**/*.js", without))
    words(page, "WebAssembly is blocked here")
    page.context.close()


def test_O4_a_browser_without_workers_is_told(chromium: Browser, site: str) -> None:
    page, _ = start(chromium, f"{site}/viewer/", lambda page: page.add_init_script("delete window.Worker"))
    words(page, "no worker can be had here")
    page.context.close()


def test_O4_a_script_that_does_not_run_leaves_words_on_the_page(chromium: Browser, site: str) -> None:
    page, _ = start(
        chromium, f"{site}/viewer/", lambda page: page.route("**/main-*.js", lambda route: route.abort())
    )
    said = page.locator("#could-not-start")
    ui.until(said.is_visible)
    assert "The viewer could not start" in said.inner_text()
    page.context.close()


def test_A3_a_sandboxed_frame_works_or_says_why(chromium: Browser, site: str, shelf: Path) -> None:
    (shelf / "frame.html").write_text(
        f'<iframe sandbox="allow-scripts" src="{site}/viewer/" width=900 height=600></iframe>'
    )
    page, _ = start(chromium, f"{site}/bench/frame.html")
    frame = page.frames[1] if len(page.frames) > 1 else page.wait_for_event("frameattached")

    def told() -> bool:
        if frame.locator("#could-not-start").is_visible():
            return True
        return "ready" in str(frame.evaluate("() => window.hexalab ? 'there' : ''")) or bool(
            frame.locator(".messages").count() and frame.locator(".messages").inner_text().strip()
        )

    ui.until(told, 40)
    page.context.close()


def test_R7_sha256_is_known_where_the_browser_has_no_hash(chromium: Browser, site: str, shelf: Path) -> None:
    """As on plain http: the worker has no crypto.subtle, and Python hashes."""

    def without(route: Route) -> None:
        response = route.fetch()
        route.fulfill(response=response, body=NO_HASH + response.text())

    page, _ = start(chromium, f"{site}/viewer/", lambda page: page.route("**/worker*.js", without))
    page.evaluate("() => window.hexalab.ready")
    assert page.locator("#could-not-start").count() == 0
    ui.open_mesh(page, site, shelf, MESH, "hash.mesh")
    expected = hashlib.sha256((shelf / "hash.mesh").read_bytes()).hexdigest()
    ui.until(lambda: ui.status(page)["mesh"]["sha256"] == expected)
    page.context.close()


WATCHED = """
const cores = %d;
Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => cores });
const send = Worker.prototype.postMessage;
Worker.prototype.postMessage = function (message, ...more) {
    if (message.boot) window.booted = performance.now();
    return send.call(this, message, ...more);
};
window.linked = [];
const link = WebGL2RenderingContext.prototype.linkProgram;
WebGL2RenderingContext.prototype.linkProgram = function (program) {
    window.linked.push(performance.now());
    return link.call(this, program);
};
"""
PATIENT = """
const soon = window.setTimeout;
window.setTimeout = (task, wait = 0, ...more) => soon(task, wait * (wait < 1000 ? 1 : 60), ...more);
"""
"""On a busy machine, too, the order of things is seen: no wait runs out."""
DRAWN = """async () => {
    const until = async (done) => { while (!done()) await new Promise((soon) => setTimeout(soon, 5)); };
    await until(() => window.hexalab?.timings().preview);
    await window.hexalab.ready;
    const ready = performance.now();
    await window.hexalab.settled();
    const { booted, linked } = window;
    return { booted, picture: window.hexalab.timings().preview, early: linked.filter((at) => at < ready).length,
        linked: linked.length };
}"""


@pytest.mark.parametrize("cores", [2, 8])
def test_O4_on_few_cores_python_starts_after_the_first_picture(
    chromium: Browser, site: str, cores: int
) -> None:
    page, errors = start(
        chromium,
        f"{site}/viewer/?mesh=shapes/cube",
        lambda page: page.add_init_script(PATIENT + WATCHED % cores),
    )
    seen = page.evaluate(DRAWN)
    assert (seen["booted"] < seen["picture"]) == (cores > 2)
    assert not errors
    page.context.close()


def test_O4_one_program_is_compiled_before_python_where_the_processor_draws(
    chromium: Browser, site: str
) -> None:
    page, _ = start(
        chromium,
        f"{site}/viewer/?mesh=shapes/cube",
        lambda page: page.add_init_script(PATIENT + WATCHED % 8),
    )
    seen = page.evaluate(DRAWN)
    assert seen["early"] <= 2 < seen["linked"]
    page.context.close()


def test_O4_a_preview_that_does_not_come_holds_nothing_up(chromium: Browser, site: str) -> None:
    def held(page: Page) -> None:
        page.add_init_script(WATCHED % 2)
        page.route("**/*.preview", lambda route: None)

    page, _ = start(chromium, f"{site}/viewer/?mesh=shapes/cube", held)
    ui.until(lambda: page.evaluate("() => window.hexalab?.ready.then(() => true)"), 40)
    page.evaluate(
        "async () => { while (!window.hexalab.summary()) await new Promise((r) => setTimeout(r, 20)); }"
    )
    page.context.close()
