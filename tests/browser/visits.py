"""Visits to the site as a host shows it, by browsers that may keep it."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Page

from benchmarks.page import SITE, WINDOW
from hexalab.hosts.serving import make_server

CONTROLLED = """async () => {
    await navigator.serviceWorker.ready;
    while (!navigator.serviceWorker.controller) await new Promise((resolve) => setTimeout(resolve, 20));
}"""
OPEN = """async (bytes) => {
    const opened = await window.hexalab.open(new File([new Uint8Array(bytes)], "grid.mesh"));
    return opened.cells;
}"""


@contextmanager
def served(top: Path) -> Iterator[str]:
    """A folder on a free port of this machine; yields its address."""
    with make_server(top) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server.address
        server.shutdown()


@contextmanager
def published_below(top: Path) -> Iterator[tuple[Path, str]]:
    """Folder and address of the built site below a path, with another page beside it."""
    folder = top / "hexalab"
    folder.mkdir()
    for entry in SITE.resolve().iterdir():
        if entry.name == "service_worker.js":
            (folder / entry.name).write_bytes(entry.read_bytes())
        else:
            (folder / entry.name).symlink_to(entry)
    (top / "index.html").write_text("<!doctype html><title>Another site</title>")
    with served(top) as address:
        yield folder, f"{address}hexalab/"


@contextmanager
def visitor(chromium: Browser, **options: Any) -> Iterator[tuple[BrowserContext, Page]]:
    """A browser of its own that may keep the site; no error may stay uncaught."""
    context = chromium.new_context(**{"viewport": WINDOW, "service_workers": "allow"} | options)
    page = context.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    try:
        yield context, page
    finally:
        context.close()
    assert not errors, errors


def cells(page: Page) -> int:
    """Cells of the mesh that is open, once one is."""
    found: int = page.evaluate(
        """async () => {
            const last = performance.now() + 60000;
            while (!window.hexalab?.summary()?.quality && !window.hexalab?.drawn().cells) {
                if (performance.now() > last) throw new Error(`no mesh: ${document.body.innerText}`);
                await new Promise((resolve) => setTimeout(resolve, 20));
            }
            return window.hexalab.summary().cells;
        }"""
    )
    return found
