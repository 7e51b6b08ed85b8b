"""Serving a built site on this machine: right types, no stale copies, nobody else's requests."""

from __future__ import annotations

import functools
import os
import sys
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

TYPES = {
    ".js": "text/javascript",
    ".mjs": "text/javascript",
    ".json": "application/json",
    ".wasm": "application/wasm",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".webp": "image/webp",
    ".css": "text/css",
    ".html": "text/html; charset=utf-8",
    ".webmanifest": "application/manifest+json",
    ".whl": "application/octet-stream",
    ".gz": "application/gzip",
    ".txt": "text/plain; charset=utf-8",
    ".csv": "text/csv; charset=utf-8",
    ".xml": "application/xml",
    ".bib": "text/plain; charset=utf-8",
    ".ris": "application/x-research-info-systems",
    ".map": "application/json",
    "": "application/octet-stream",
}
"""Types by ending; the machine's own table is not asked, since it may be wrong."""


class SiteHandler(SimpleHTTPRequestHandler):
    """Files of one folder, to be asked for anew each time and to be sent only if they have changed."""

    protocol_version = "HTTP/1.1"

    def end_headers(self) -> None:
        """Browsers keep what they got but ask whether it still holds."""
        self.send_header("Cache-Control", "no-cache")
        self.send_header("X-Content-Type-Options", "nosniff")
        super().end_headers()

    def guess_type(self, path: Any) -> str:
        """The type by the file's ending."""
        return TYPES.get(Path(path).suffix.lower(), TYPES[""])

    def list_directory(self, path: Any) -> None:
        """A folder without index.html isn't shown."""
        self.send_error(404, "No such page")

    def log_message(self, format: str, *arguments: Any) -> None:
        """Only what fails is worth a line."""
        if len(arguments) > 1 and str(arguments[1]).startswith(("4", "5")):
            super().log_message(format, *arguments)


class SiteServer(ThreadingHTTPServer):
    """Serves on the loopback interface only."""

    daemon_threads = True
    allow_reuse_address = os.name != "nt"  # on Windows that would share a taken port with its owner

    def __init__(self, directory: Path, port: int = 0) -> None:
        super().__init__(("127.0.0.1", port), functools.partial(SiteHandler, directory=str(directory)))

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A page that leaves while it is answered is no error of ours."""
        if not isinstance(sys.exc_info()[1], OSError):
            super().handle_error(request, client_address)

    @property
    def address(self) -> str:
        """Where the site is."""
        return f"http://localhost:{self.server_address[1]}/"


def make_server(directory: Path, port: int = 0) -> SiteServer:
    """A server of a built site that isn't running yet.

    Parameters
    ----------
    directory : Path
    port : int
        0 for any that is free.

    Raises
    ------
    OSError
        The port is taken.
    """
    return SiteServer(directory, port)


def serve(directory: Path, port: int = 0) -> None:
    """Serve a built site until interrupted; prints its address.

    Raises
    ------
    FileNotFoundError
        There is no site in the folder.
    OSError
        The port is taken.
    """
    if not (directory / "index.html").is_file():
        raise FileNotFoundError(f"there is no site in {directory}: build it first")
    with make_server(directory, port) as server:
        print(f"HexaLab is at {server.address}", flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()
