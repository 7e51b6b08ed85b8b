"""What every room's tests share: how hypothesis draws, the one browser, and what is left out, told at the end."""

from __future__ import annotations

import gc
import os
import re
import signal
from collections import Counter
from collections.abc import Callable, Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page, Request

LEFT_OUT = pytest.StashKey[list[str]]()
"""Modules of tests that are not even imported, because hypothesis is missing."""

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    # Started in the background, the suite would ignore Ctrl-C, and so would all that it starts and interrupts.
    signal.signal(signal.SIGINT, signal.default_int_handler)

HYPOTHESIS = find_spec("hypothesis") is not None

if HYPOTHESIS:
    from hypothesis import settings

    # Nothing is timed: a slow machine is no fault. On CI the same examples on every run, or a pull request would be
    # answered by chance; `make nightly` draws new ones and prints how to have a failure again.
    settings.register_profile("here", deadline=None)
    settings.register_profile("ci", deadline=None, derandomize=True, database=None)
    settings.register_profile("nightly", deadline=None, derandomize=False, print_blob=True, max_examples=1000)
    settings.load_profile("ci" if os.environ.get("CI") else "here")


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave out what hypothesis draws where there is none, as in a browser's Python."""
    if HYPOTHESIS or collection_path.suffix != ".py":
        return None
    if not re.search(r"^(?:import|from) hypothesis", collection_path.read_text("utf-8"), re.MULTILINE):
        return None
    config.stash.setdefault(LEFT_OUT, []).append(collection_path.name)
    return True


def pytest_collection_finish() -> None:
    """Sessions collect garbage whenever a mesh is opened: they need not look through thousands of tests each time."""
    gc.freeze()


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    """Say how many tests were left out for want of what."""
    reasons = (str(report.longrepr[2]) for report in terminalreporter.stats.get("skipped", ()))
    wants = Counter(reason.removeprefix("Skipped: needs ") for reason in reasons if "needs " in reason[:15])
    for want, count in sorted(wants.items()):
        terminalreporter.line(
            f"LEFT OUT: {count} {'test needs' if count == 1 else 'tests need'} {want}", yellow=True
        )
    modules = config.stash.get(LEFT_OUT, [])
    if modules:
        terminalreporter.line(f"LEFT OUT: {len(modules)} modules of tests need hypothesis", yellow=True)


QUICK = "--js-flags=--liftoff-only"
"""WebAssembly is compiled once, the fast way: most pages of the tests live too short for the second to pay."""

BLOCKED: dict[str, Any] = {"service_workers": "block"}


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    """The one Chromium of all tests: Playwright runs but once in a thread.

    Its pages keep nothing for when there is no network, unless a test asks for it: no test meets what another has kept.
    """
    from hexalab.hosts.browser import browser

    with browser(QUICK) as running, pytest.MonkeyPatch.context() as patch:
        for name in ("new_context", "new_page"):
            patch.setattr(running, name, partial(_opened, getattr(running, name)))
        yield running


FEWER_LIGHTS = """() => {
    const { get } = URLSearchParams.prototype;
    URLSearchParams.prototype.get = function (name) {
        return get.call(this, name) ?? (name === "directions" ? "32" : null);
    };
}"""
"""The viewer gathers light from few directions, unless its address asks for others: light takes most of a processor."""

STRAYS: list[str] = []
"""Requests of the pages of this run that left this machine."""


def _opened(make: Callable[..., BrowserContext | Page], **options: Any) -> BrowserContext | Page:
    """A context or a page of the one browser, whose requests are watched."""
    made = make(**BLOCKED | options)
    made.add_init_script(f"({FEWER_LIGHTS})()")
    made.on("request", _note)
    return made


def _note(request: Request) -> None:
    address = urlsplit(request.url)
    if address.scheme in ("http", "https", "ws", "wss") and address.hostname not in (
        "localhost",
        "127.0.0.1",
    ):
        STRAYS.append(request.url)


@pytest.fixture(autouse=True)
def nothing_leaves() -> Iterator[None]:
    """No page asks anything of another machine (SPEC O3)."""
    yield
    strays, STRAYS[:] = list(STRAYS), []
    assert not strays, f"requests left this machine: {strays}"
