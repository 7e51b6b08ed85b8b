"""The built site in a real browser, for measuring and for opening meshes by the hundred."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from playwright.sync_api import Page, ViewportSize

from hexalab.hosts.browser import browser

SITE = Path("build/site")
WINDOW: ViewportSize = {"width": 1280, "height": 800}


class _Files(SimpleHTTPRequestHandler):
    """Serves the site, and under /bench/ another folder."""

    extensions_map = {  # noqa: RUF012
        **SimpleHTTPRequestHandler.extensions_map,
        ".mjs": "text/javascript",
        ".js": "text/javascript",
        ".wasm": "application/wasm",
    }

    def __init__(self, *args: Any, folder: Path, **kwargs: Any) -> None:
        self.folder = folder
        super().__init__(*args, directory=str(SITE), **kwargs)

    def translate_path(self, path: str) -> str:
        if not path.startswith("/bench/"):
            return super().translate_path(path)
        self.directory, site = str(self.folder), self.directory
        try:
            return super().translate_path(path.removeprefix("/bench"))
        finally:
            self.directory = site

    def log_message(self, format: str, *args: Any) -> None:
        """Stay quiet."""


@contextmanager
def serve(folder: Path) -> Iterator[str]:
    """The site on a free port of this machine, with `folder` under /bench/; yields the address."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Files, folder=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()


@contextmanager
def viewer(folder: Path) -> Iterator[tuple[Page, str, list[str]]]:
    """The viewer, ready, in a window of 1280 x 800; yields page, address and the console's errors so far."""
    with serve(folder) as address, browser() as chromium:
        page = chromium.new_page(viewport=WINDOW, service_workers="block")
        errors: list[str] = []
        page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(f"{address}/viewer/")
        page.evaluate("() => window.hexalab.ready")
        yield page, address, errors
