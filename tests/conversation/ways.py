"""The ways to a session: each takes questions and gives answers, arrays as numpy arrays.

Whoever adds a transport adds a way here, and the whole conversation runs through it.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
from playwright.sync_api import Browser, Page

from hexalab.packing import unpack
from hexalab.session.door import Door

Answer = Any
Ask = Callable[..., Answer]


class Refused(Exception):
    """The core said why it can't answer; `kind` is the exception's name."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


@contextmanager
def native(chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    """Straight through the door of this Python: what the other ways are held against."""
    del chromium, site, shelf
    door = Door()

    def ask(method: str, *args: Any) -> Answer:
        blocks = [one for one in args if isinstance(one, bytes)]
        given = [{"$bytes": blocks.index(one)} if isinstance(one, bytes) else one for one in args]
        return _result(unpack(door.answer(method, json.dumps(given), blocks).joined()))

    yield ask


@contextmanager
def worker(chromium: Browser, site: str, shelf: Path) -> Iterator[Ask]:
    """The static site's: the client, a worker, Pyodide."""
    page = chromium.new_page()
    errors: list[str] = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    (shelf / "conversation.html").write_text("<!doctype html><script src=conversation.js></script>")
    page.goto(f"{site}/bench/conversation.html")
    page.evaluate("place => begin('worker', place)", _places(page, site))

    def ask(method: str, *args: Any) -> Answer:
        given = [
            {"base64": base64.b64encode(one).decode()} if isinstance(one, bytes) else one for one in args
        ]
        return _result(_arrays(page.evaluate("([method, args]) => ask(method, args)", [method, given])))

    ask.page = page  # type: ignore[attr-defined]
    yield ask
    page.close()
    assert not errors


WAYS: dict[str, Callable[[Browser, str, Path], AbstractContextManager[Ask]]] = {
    "native": native,
    "worker": worker,
}


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
