"""Helps the tests of `hexalab view`: the program as a user runs it, and a page of it."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Browser, Page

from tests.browser.ui import summary, until

ROOT = Path(__file__).parents[2]


@dataclass
class Program:
    """A running `hexalab view`; what it has printed, and the address in that."""

    process: subprocess.Popen[str]
    printed: str
    address: str

    @property
    def root(self) -> str:
        return self.address.split("#")[0]


@contextmanager
def viewing(*words: str | Path, environment: dict[str, str] | None = None) -> Iterator[Program]:
    """Run it until the end of the block; then it is interrupted, as by Ctrl-C, and must leave in good order."""
    process = subprocess.Popen(
        [sys.executable, "-m", "hexalab", "view", "--no-browser", *map(str, words)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT / "core"), **(environment or {})},
    )
    assert process.stdout and process.stderr
    printed = ""
    while "Ctrl-C" not in printed:
        line = process.stdout.readline()
        assert line, process.stderr.read()
        printed += line
    found = re.search(r"http\S+", printed)
    assert found
    try:
        yield Program(process, printed, found[0])
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
            assert process.wait(timeout=20) == 0
        assert process.stderr.read() == ""
        for stream in (process.stdout, process.stderr):
            stream.close()


@contextmanager
def visited(chromium: Browser, address: str, ends: bool = False) -> Iterator[Page]:
    """A page at an address, once a mesh is drawn; the console must stay clean, unless the program ends before it."""
    context = chromium.new_context(viewport={"width": 1280, "height": 800}, reduced_motion="reduce")
    page = context.new_page()
    errors: list[str] = []
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(address)
    until(lambda: (summary(page) or {}).get("findings") is not None)
    yield page
    context.close()
    assert ends or not errors, errors


def messages(page: Page) -> str:
    return page.locator(".message").all_inner_texts().__str__()
