"""The ways to a session: each takes questions and gives answers, arrays as numpy arrays.

Whoever adds a transport adds a way here, and the whole conversation runs through it.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Browser, Page

from hexalab.hosts.loopback import Loopback
from hexalab.hosts.offers import FileOffer
from hexalab.packing import unpack
from hexalab.session import Session
from hexalab.session.door import Door

Answer = Any


@dataclass(frozen=True)
class Ask:
    """How one way is asked; its page, if it has one; whether it has a mesh at hand."""

    put: Callable[..., Answer]
    page: Page | None = None
    offers: bool = True

    def __call__(self, method: str, *args: Any) -> Answer:
        return self.put(method, *args)


class Refused(Exception):
    """The core said why it can't answer; `kind` is the exception's name."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


@contextmanager
def native(chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    """Straight through the door of this Python: what the other ways are held against."""
    del chromium, site
    door = Door(Session({OFFERED: FileOffer(shelf / OFFERED, OFFERED).mesh}))

    def ask(method: str, *args: Any) -> Answer:
        blocks = [one for one in args if isinstance(one, bytes)]
        given = [{"$bytes": blocks.index(one)} if isinstance(one, bytes) else one for one in args]
        return _result(unpack(door.answer(method, json.dumps(given), blocks).joined()))

    yield Ask(ask)


@contextmanager
def worker(chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    """The static site's: the client, a worker, Pyodide; nothing is at hand there."""
    (shelf / "conversation.html").write_text(HTML)
    with _page(chromium, f"{site}/bench/conversation.html") as page:
        page.evaluate("place => begin('worker', place)", _places(page, site))
        yield Ask(_asking(page), page, offers=False)


@contextmanager
def server(chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    """That of `hexalab view`: the client, a server on the loopback, the native core."""
    del site
    with Loopback({OFFERED: FileOffer(shelf / OFFERED, OFFERED)}) as running:
        running.files["/conversation.html"] = HTML.encode()
        running.files["/conversation.js"] = (shelf / "conversation.js").read_bytes()
        running.start()
        root = f"http://127.0.0.1:{running.port}/"
        with _page(chromium, f"{root}conversation.html") as page:
            page.evaluate("place => begin('server', place)", {"root": root, "token": running.token})
            yield Ask(_asking(page), page)
        running.shutdown()


WAYS: dict[str, Callable[[Browser, str, Path], AbstractContextManager[Ask]]] = {
    "native": native,
    "worker": worker,
    "server": server,
}

OFFERED = "offered.vtk"
"""A file on the shelf that every way but the worker has at hand."""

HTML = "<!doctype html><script src=conversation.js></script>"


@contextmanager
def _page(chromium: Browser, address: str) -> Iterator[Page]:
    page = chromium.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(address)
    yield page
    page.close()
    assert not errors


def _asking(page: Page) -> Callable[..., Answer]:
    def ask(method: str, *args: Any) -> Answer:
        given = [
            {"base64": base64.b64encode(one).decode()} if isinstance(one, bytes) else one for one in args
        ]
        return _result(_arrays(page.evaluate("([method, args]) => ask(method, args)", [method, given])))

    return ask


class _Html(HTMLParser):
    places: dict[str, str | None]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "html":
            self.places = {name.removeprefix("data-"): value for name, value in attrs}


def _places(page: Page, site: str) -> dict[str, str]:
    """Where the built viewer's worker and interpreter are, as its page says."""
    html = _Html()
    html.feed(page.request.get(f"{site}/viewer/").text())
    return {name: f"{site}/viewer/{html.places[name]}" for name in ("worker", "runtime")}


def _result(answer: dict[str, Any]) -> Answer:
    if "error" in answer:
        raise Refused(**answer["error"])
    return answer["result"]


def _arrays(value: Any) -> Any:
    if isinstance(value, list):
        return [_arrays(one) for one in value]
    if not isinstance(value, dict):
        return value
    if value.keys() == {"array", "base64"}:
        return np.frombuffer(base64.b64decode(value["base64"]), value["array"])
    return {name: _arrays(one) for name, one in value.items()}
