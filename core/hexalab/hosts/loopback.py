"""The viewer on this machine's own files: a server on the loopback, behind which the native core answers.

>>> with Loopback(file_offers([Path("bunny.mesh")])) as server:                  # doctest: +SKIP
...     print(server.address)
...     server.serve_forever()
"""

from __future__ import annotations

import json
import secrets
import select
import socket
import sys
import threading
from collections.abc import Mapping
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from queue import Empty
from typing import Any, ClassVar
from urllib.parse import urlsplit

from .. import __version__
from ..errors import HexaLabError
from .built import PAGE, built_viewer
from .frames import read_question
from .gate import LOOPBACK, refusal, same, token_of
from .listening import Event, Listener
from .offers import AnyOffer, listed
from .serving import TYPES

SEAT = "X-HexaLab-Seat"
"""The header with the page's own name for its session."""

GRACE = 30.0
"""Seconds that a session is kept when its page has gone, or only lost its connection."""

PADDING = bytes(8)


class Loopback(ThreadingHTTPServer):
    """Shows a viewer to whoever has the token, and answers it.

    Parameters
    ----------
    offers : mapping of str to Offer or SurfaceOffer
        What pages may open, and compare with; the first is opened.
    host : str
        An address of the loopback.
    port : int
        0 for any that is free.
    status : dict, optional
        Settings that the first mesh is opened under.
    watched : bool
        Whether pages are to know that changes will be told.
    opens : bool
        Whether pages open the first mesh by themselves.
    compare : str, optional
        The offer that pages compare the first with.
    grace : float
        Seconds that the session of a page is kept that has not come, or has gone.
    parting : float, optional
        The same of one that has gone, where it is less.
    viewer : Path, optional
        Folder of the viewer's files; the built one by default.

    Raises
    ------
    OSError
        The port is taken.
    HexaLabError
        The viewer is not built.
    """

    daemon_threads = True
    block_on_close = False  # a page that listens is told, and not waited for

    def __init__(
        self,
        offers: Mapping[str, AnyOffer],
        *,
        host: str = "127.0.0.1",
        port: int = 0,
        status: dict[str, Any] | None = None,
        watched: bool = False,
        opens: bool = True,
        compare: str | None = None,
        grace: float = GRACE,
        parting: float | None = None,
        viewer: Path | None = None,
    ) -> None:
        self.offers = offers
        self.files = {
            f"/{file.name}": file.read_bytes()
            for file in (viewer or built_viewer()).iterdir()
            if file.is_file()
        }
        self.status = status
        self.watched = watched
        self.opens = opens
        self.compare = compare
        self.token = secrets.token_urlsafe(32)
        self._ticket = secrets.token_urlsafe(32)
        self._grace = grace
        self._parting = grace if parting is None else parting
        self._seats: dict[str, Listener] = {}
        self._lock = threading.Lock()
        self.address_family = socket.AF_INET6 if ":" in host else socket.AF_INET
        super().__init__((host, port), Handler)
        self.port: int = self.server_address[1]
        self.shown_host = f"[{host}]" if ":" in host else host
        self.names = {f"{name}:{self.port}" for name in (*LOOPBACK, self.shown_host)}

    # -- for whoever runs it

    @property
    def address(self) -> str:
        """Where the page is, with the token, for the user's own eyes."""
        return f"http://{self.shown_host}:{self.port}/#token={self.token}"

    @property
    def once(self) -> str:
        """Where the page is, for one visit: others of this machine may see what a browser is started with."""
        return f"http://{self.shown_host}:{self.port}/#token={self._ticket}"

    def tell(self, event: Event) -> None:
        """Tell every page."""
        with self._lock:
            seats = list(self._seats.values())
        for seat in seats:
            seat.tell(event)

    def tell_of(self, name: str, there: bool) -> None:
        """Tell every page that a file is another, or gone."""
        self.tell({"changed" if there else "gone": name})

    def start(self) -> threading.Thread:
        """Serve in a thread of its own, until it is shut down."""
        thread = threading.Thread(target=self.serve_forever, args=(0.05,), name="server", daemon=True)
        thread.start()
        return thread

    def server_close(self) -> None:
        """Tell the pages, and free the port."""
        self.tell({"stopped": True})
        super().server_close()

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A page that leaves while it is answered is no error of ours."""
        if not isinstance(sys.exc_info()[1], OSError):
            super().handle_error(request, client_address)

    # -- for its requests

    def admit(self, given: str) -> bool:
        """Whether a page may come in: with the token, or with the ticket, which counts once."""
        with self._lock:
            if same(given, self._ticket):
                self._ticket = secrets.token_urlsafe(32)
                return True
        return same(given, self.token)

    def hello(self, seat: str) -> dict[str, Any]:
        """Seat a page, and say what it can open."""
        with self._lock:
            self._seats[seat] = Listener(self.offers)
        self._leave_in(self._grace, seat)
        return {
            "version": __version__,
            "token": self.token,
            "offers": listed(self.offers),
            "status": self.status,
            "watched": self.watched,
            "opens": self.opens,
            "compare": self.compare,
        }

    def seat(self, name: str) -> Listener | None:
        """A page's session, if it has one here."""
        with self._lock:
            return self._seats.get(name)

    def leave_later(self, name: str) -> None:
        """Let the session of a page that has gone go, if none listens for it in a while."""
        self._leave_in(self._parting, name)

    def _leave_in(self, seconds: float, name: str) -> None:
        timer = threading.Timer(seconds, self._forget, [name])
        timer.daemon = True
        timer.start()

    def _forget(self, name: str) -> None:
        with self._lock:
            seat = self._seats.get(name)
            if seat is not None and seat.empty:
                del self._seats[name]


class Handler(BaseHTTPRequestHandler):
    """Files of the viewer to whoever asks rightly; all else to whoever has the token."""

    server: Loopback
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True
    server_version = "HexaLab"
    sys_version = ""

    HEADERS: ClassVar[dict[str, str]] = {
        "Cache-Control": "no-store",
        "Content-Security-Policy": "frame-ancestors 'none'",
        "Cross-Origin-Opener-Policy": "same-origin",
        "Cross-Origin-Resource-Policy": "same-origin",
        "Referrer-Policy": "no-referrer",
        "X-Content-Type-Options": "nosniff",
        "X-Frame-Options": "DENY",
    }

    def do_GET(self) -> None:
        """The viewer's own files; no mesh is ever told so."""
        address = urlsplit(self.path).path
        address = f"/{PAGE}" if address == "/" else address
        refused = refusal(self.headers, self.server.names, navigating=address == f"/{PAGE}")
        if refused:
            return self._refuse(*refused)
        data = self.server.files.get(address)
        if data is None:
            return self._refuse(HTTPStatus.NOT_FOUND, "there is no such page")
        self._answer(HTTPStatus.OK, TYPES.get(Path(address).suffix, TYPES[""]), data)

    def do_POST(self) -> None:
        """A page's questions."""
        refused = refusal(self.headers, self.server.names)
        if refused:
            return self._refuse(*refused)
        if self.path == "/hello":
            return self._hello()
        if not same(token_of(self.headers), self.server.token):
            return self._refuse(HTTPStatus.FORBIDDEN, "the token is missing, or another than this server's")
        name = self.headers.get(SEAT, "")
        seat = self.server.seat(name)
        if seat is None:
            return self._refuse(HTTPStatus.GONE, "this page's session has ended")
        if self.path == "/ask":
            return self._ask(seat)
        if self.path == "/events":
            return self._events(name, seat)
        self._refuse(HTTPStatus.NOT_FOUND, "there is nothing to be asked so")

    def log_message(self, format: str, *arguments: Any) -> None:
        """Nothing of what is asked is written anywhere."""

    # -- within

    def _hello(self) -> None:
        seat = self.headers.get(SEAT, "")
        if not seat or not self.server.admit(token_of(self.headers)):
            return self._refuse(HTTPStatus.FORBIDDEN, "the token is missing, or another than this server's")
        self._answer(HTTPStatus.OK, TYPES[".json"], json.dumps(self.server.hello(seat)).encode())

    def _ask(self, seat: Listener) -> None:
        body = self._body()
        if body is None:
            return
        try:
            question = read_question(body)
        except HexaLabError as error:
            return self._refuse(HTTPStatus.BAD_REQUEST, str(error))
        identify = seat.identifier(question)
        packed, milliseconds = seat.answer(question)
        self._begin(HTTPStatus.OK, TYPES[""], packed.size, {"X-HexaLab-Milliseconds": f"{milliseconds:.3f}"})
        self.wfile.write(packed.head)
        at = 0
        for offset, array in packed.arrays:
            self.wfile.write(PADDING[: offset - at])
            self.wfile.write(array.reshape(-1).view("u1").data)
            at = offset + array.nbytes
        self.wfile.write(PADDING[: packed.size - len(packed.head) - at])
        identify(lambda number, sha256: seat.tell({"identified": {"question": number, "sha256": sha256}}))

    def _body(self) -> bytearray | None:
        """The request's body; None if there is none, which was refused."""
        length = self.headers.get("Content-Length", "")
        if not (length.isascii() and length.isdigit()):
            self._refuse(HTTPStatus.LENGTH_REQUIRED, "the length of the question is missing")
            return None
        body = bytearray(int(length))
        view, at = memoryview(body), 0
        while at < len(body):
            got = self.rfile.readinto(view[at:])
            if not got:
                self.close_connection = True
                return None
            at += got
        return body

    def _events(self, name: str, seat: Listener) -> None:
        """Tell what happens, a line each, until the page leaves."""
        news = seat.listen()
        self.close_connection = True
        try:
            self._begin(HTTPStatus.OK, "application/jsonl", None, {"Connection": "close"})
            while seat.listens(news):
                try:
                    event = news.get(timeout=0.5)
                except Empty:
                    if self._page_left():
                        break
                    continue
                self.wfile.write(json.dumps(event).encode() + b"\n")
                if "stopped" in event:
                    break
        except OSError:
            return  # the page has left
        finally:
            seat.leave(news)
            self.server.leave_later(name)

    def _page_left(self) -> bool:
        readable, _, _ = select.select([self.connection], [], [], 0)
        return bool(readable) and self.connection.recv(1, socket.MSG_PEEK) == b""

    def _answer(self, status: HTTPStatus, kind: str, data: bytes) -> None:
        self._begin(status, kind, len(data))
        self.wfile.write(data)

    def _refuse(self, status: HTTPStatus, reason: str) -> None:
        """Say no; what the request still holds is not read."""
        self.close_connection = True
        data = f"{reason}\n".encode()
        self._begin(status, "text/plain; charset=utf-8", len(data), {"Connection": "close"})
        self.wfile.write(data)

    def _begin(
        self, status: HTTPStatus, kind: str, size: int | None, more: Mapping[str, str] | None = None
    ) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        if size is not None:
            self.send_header("Content-Length", str(size))
        for name, value in {**self.HEADERS, **(more or {})}.items():
            self.send_header(name, value)
        self.end_headers()
