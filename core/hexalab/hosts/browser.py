"""A headless Chromium that draws with WebGL 2: for thumbnails, `hexalab render` and the tests."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser, BrowserContext, Playwright, ViewportSize, sync_playwright

ARGUMENTS = (
    "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic",
    "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-gpu-compositing",
)  # fmt: skip
"""WebGL is drawn by a software GPU; the page around it is not: each of its frames would take twenty milliseconds."""
NAMES = ("chromium", "chromium-browser", "google-chrome")


class BrowserMissing(RuntimeError):
    """No Chromium was found."""


def executable(playwright: Playwright) -> str:
    """Path of a Chromium: `$HEXALAB_CHROMIUM`, Playwright's own download, or one on the PATH.

    Raises
    ------
    BrowserMissing
        If there is none.
    """
    found = (
        os.environ.get("HEXALAB_CHROMIUM"),
        playwright.chromium.executable_path,
        *map(shutil.which, NAMES),
    )
    for path in found:
        if path and Path(path).is_file():
            return path
    raise BrowserMissing(
        "no Chromium found: run `playwright install chromium` or install the package chromium"
    )


def launch(playwright: Playwright, more: tuple[str, ...] = ()) -> Browser:
    """Start Chromium without a window and with a software GPU, so that pictures are the same everywhere."""
    return playwright.chromium.launch(executable_path=executable(playwright), args=[*ARGUMENTS, *more])


@contextmanager
def browser(*more: str) -> Iterator[Browser]:
    """A Chromium for the time of a `with` block; with more arguments than `ARGUMENTS`, where they are given."""
    with sync_playwright() as playwright:
        running = launch(playwright, more)
        try:
            yield running
        finally:
            running.close()


@contextmanager
def kept_browser(profile: Path, window: ViewportSize) -> Iterator[BrowserContext]:
    """A Chromium that keeps everything in the folder `profile`, as that of a user who comes back does."""
    with sync_playwright() as playwright:
        context = playwright.chromium.launch_persistent_context(
            profile, executable_path=executable(playwright), args=list(ARGUMENTS), viewport=window
        )
        try:
            yield context
        finally:
            context.close()
