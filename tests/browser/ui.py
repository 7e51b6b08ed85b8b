"""Helps the tests of the user interface: a mesh open in the viewer, waiting without `eval`, numbers shown."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, Page

import hexalab


@contextmanager
def one_viewer(
    chromium: Browser, site: str, script: str = "", *, asked: str = "", **context: Any
) -> Iterator[Page]:
    """The viewer with Python ready, asked by its address, for several tests; at the end the console must be clean."""
    opened = chromium.new_context(viewport={"width": 1280, "height": 800}, reduced_motion="reduce", **context)
    page = opened.new_page()
    errors: list[str] = []
    page.on("console", lambda message: errors.append(message.text) if message.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.add_init_script(script)
    page.goto(f"{site}/viewer/{asked}")
    page.evaluate("() => window.hexalab.ready")
    set_status(page, {"lighting": {"mode": "direct"}})  # gathered light takes most of a processor's time
    yield page
    opened.close()
    assert not errors, f"the console reported {errors}"


def reset(page: Page) -> None:
    """Take back what a test did to the settings."""
    page.keyboard.press("Escape")
    page.mouse.move(2, 2)
    page.evaluate("() => window.hexalab.reset()")
    set_status(page, {"lighting": {"mode": "direct"}})


def until(question: Callable[[], Any], seconds: float = 20) -> Any:
    """Ask until the answer is true; the page's policy forbids Playwright's own waiting functions."""
    end = time.monotonic() + seconds
    while not (answer := question()):
        if time.monotonic() > end:
            raise AssertionError(f"still {answer!r} after {seconds} s")
        time.sleep(0.05)
    return answer


def open_mesh(page: Page, site: str, shelf: Path, mesh: hexalab.Mesh, name: str) -> dict[str, Any]:
    """Write a mesh to the shelf, open it in the page, wait for its diagnosis; returns the summary."""
    hexalab.write(mesh, shelf / name)
    page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/{name}")
    until(lambda: summary(page).get("findings") is not None)
    return summary(page)


def summary(page: Page) -> dict[str, Any]:
    """The page's summary of the mesh."""
    found: dict[str, Any] = page.evaluate("() => window.hexalab.summary()") or {}
    return found


def status(page: Page) -> dict[str, Any]:
    """The page's status document."""
    found: dict[str, Any] = page.evaluate("() => window.hexalab.getStatus()")
    return found


def set_status(page: Page, partial: dict[str, Any]) -> list[dict[str, str]]:
    """Apply a partial status; returns its rejections."""
    found: list[dict[str, str]] = page.evaluate("partial => window.hexalab.setStatus(partial)", partial)
    return found


def drawn(page: Page) -> tuple[int, int]:
    """Cells shown and faces drawn, once nothing is under way."""
    page.evaluate("() => window.hexalab.setStatus({})")
    faces = page.evaluate("() => window.hexalab.drawn().faces")
    assert faces == summary(page)["shown"]["faces"]
    return shown(page), faces


def shown(page: Page) -> int:
    """Cells shown, as the status line says."""
    return int(page.evaluate("() => window.hexalab.summary()?.shown?.cells ?? -1"))


def drag(page: Page, selector: str, start: float, end: float, steps: int = 8) -> None:
    """Drag over a control from one share of its width to another."""
    page.locator(selector).scroll_into_view_if_needed()
    box = page.locator(selector).bounding_box()
    assert box
    y = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] * start, y)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] * end, y, steps=steps)
    page.mouse.up()


def middle(page: Page) -> tuple[float, float]:
    """The middle of the canvas."""
    box = page.locator("#canvas").bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def unfold(page: Page) -> None:
    """Open all sections and folds of the panel."""
    page.evaluate(
        """() => {
            for (const fold of document.querySelectorAll("#panel details")) fold.open = true;
            for (const fold of document.querySelectorAll('.row-fold[aria-expanded="false"]')) fold.click();
        }"""
    )


def drop(page: Page, *files: tuple[str, str]) -> None:
    """Drop text files, (name, content) each, onto the window in one go."""
    page.evaluate(
        """files => {
            const transfer = new DataTransfer();
            for (const [name, content] of files) transfer.items.add(new File([content], name));
            const event = new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true });
            document.body.dispatchEvent(event);
        }""",
        [list(file) for file in files],
    )


def messages(page: Page) -> str:
    """The messages on the screen."""
    return page.locator(".messages").inner_text()
