"""A mesh that lies elsewhere: a host that sends it when it is told to, and a site whose catalogue has its portrait."""

from __future__ import annotations

import base64
import io
import json
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import Browser

from hexalab.formats import write_medit
from site_builder.measuring.measurer import measure
from site_builder.pictures.portrait import portrait
from tests.browser.conftest import grid
from tests.browser.visits import OPEN, published_below, visitor

WAIT = 60.0
"""Seconds after which the host gives up waiting: only a test that has failed comes to it."""

TAKE = """async ([status, size]) => {
    await window.hexalab.setStatus(status);
    await window.hexalab.settled();
    const picture = new Uint8Array(await (await window.hexalab.screenshot(size)).arrayBuffer());
    return btoa(Array.from(picture, (byte) => String.fromCharCode(byte)).join(""));
}"""


@dataclass
class Host:
    """Sends a third of the file, and the rest when `go` is set; "missing.mesh" it has not."""

    data: bytes
    address: str = ""
    go: threading.Event = field(default_factory=threading.Event)

    def handler(self) -> type[BaseHTTPRequestHandler]:
        host = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                there = not self.path.endswith("missing.mesh")
                self.send_response(200 if there else 404)
                self.send_header("Access-Control-Allow-Origin", "*")
                self.send_header("Content-Length", str(len(host.data) if there else 0))
                self.end_headers()
                if there:
                    first = len(host.data) // 3
                    self.wfile.write(host.data[:first])
                    self.wfile.flush()
                    host.go.wait(WAIT)
                    self.wfile.write(host.data[first:])

            def log_message(self, format: str, *args: Any) -> None:
                """Stay quiet."""

        return Handler


@contextmanager
def host_of(data: bytes) -> Iterator[Host]:
    """A host on another port of this machine: for a page it is another origin."""
    host = Host(data)
    with ThreadingHTTPServer(("127.0.0.1", 0), host.handler()) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        host.address = f"http://127.0.0.1:{server.server_port}"
        yield host
        host.go.set()
        server.shutdown()


@dataclass(frozen=True)
class Faraway:
    """The site, the host, and the view that the portrait was taken under."""

    site: str
    host: Host
    view: dict[str, Any]

    def viewer(self, mesh: str) -> str:
        """Address that opens a mesh of the source "far"."""
        return f"{self.site}viewer/?mesh=far/{mesh}"


@contextmanager
def faraway_below(top: Path, chromium: Browser) -> Iterator[Faraway]:
    """The built site with one more source: "bar", which comes slowly, and "gone", which its host has not."""
    data = bytes(write_medit.write(grid(7, 4, 3, noise=0.2)))
    facts = measure(data, "bar.mesh")
    view = portrait(facts)
    with published_below(top) as (folder, site), host_of(data) as host:
        with visitor(chromium, service_workers="block") as (_, page):
            page.goto(f"{site}viewer/")
            page.evaluate("() => window.hexalab.ready")
            page.evaluate(OPEN, list(data))
            png = base64.b64decode(page.evaluate(TAKE, [view, {"width": 480, "height": 320}]))
        with Image.open(io.BytesIO(png)) as picture:
            picture.convert("RGB").save(folder / "bar.webp", quality=80)
        row = {"cells": facts.cells, "remote": True, "bytes": len(data), "sha256": facts.sha256}
        row |= {"picture": "bar.webp", "view": view}
        source: dict[str, Any] = {"slug": "far", "title": "Far away", "authors": ["A. One"], "year": 2020}
        source["meshes"] = [
            {"slug": "bar", "name": "Bar", "url": f"{host.address}/bar.mesh", **row},
            {"slug": "gone", "name": "Gone", "url": f"{host.address}/missing.mesh", **row, "sha256": None},
        ]
        index = folder / "catalogue.json"
        catalogue = json.loads(index.read_text("utf-8"))
        index.unlink()
        index.write_text(json.dumps({"sources": [*catalogue["sources"], source]}), "utf-8")
        yield Faraway(site, host, view)
