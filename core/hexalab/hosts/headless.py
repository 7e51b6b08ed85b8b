"""The viewer in a headless Chromium."""

from __future__ import annotations

import base64
from abc import ABC, abstractmethod
from contextlib import ExitStack, suppress
from typing import Any, Literal, Self, TypedDict

from playwright.sync_api import Error as PlaywrightError
from playwright.sync_api import Page

from ..errors import HexaLabError
from .browser import BrowserMissing, browser
from .page_scripts import END, PICTURE, SHOW

WIDTH, HEIGHT = 1280, 800

PATIENCE = 600_000
"""Milliseconds for one picture: light on a large mesh takes its time without a graphics card."""

FIGURES = ("png", "svg", "pdf")
"""Formats of figures."""

Which = Literal["both", "first", "second"]
"""Which of two meshes that are compared a figure shows."""


class RenderError(HexaLabError):
    """A picture can't be made."""


class Rejection(TypedDict):
    """A setting that could not be applied.

    Attributes
    ----------
    path : str
        The setting, as "separation.gap".
    found, expected : str
        In words.
    """

    path: str
    found: str
    expected: str


class Shown(TypedDict):
    """What the page tells once a mesh stands in it: `rejections` and `summary`, as `Rendering` has them.

    And `apart`: whether there is a second mesh, and its settings ask for a file of its own.
    """

    rejections: list[Rejection]
    summary: dict[str, Any]
    apart: bool


class Viewer(ABC):
    """The viewer in a headless browser, wherever its page comes from."""

    def __init__(self) -> None:
        self._open = ExitStack()
        self._page: Page | None = None

    def __enter__(self) -> Self:
        """Start the browser, and the viewer in it.

        Raises
        ------
        RenderError
            There is no viewer, or no browser, or the viewer does not start.
        """
        try:
            with ExitStack() as started:
                self._page = self._start(started)
                self._open = started.pop_all()
        except BrowserMissing as error:
            raise RenderError(str(error)) from None
        except PlaywrightError as error:
            raise RenderError(f"the viewer does not start: {_first_line(error)}") from None
        return self

    def __exit__(self, *_: object) -> None:
        self._open.close()

    @property
    def page(self) -> Page:
        """The viewer's page."""
        assert self._page is not None, "use it in a with block"
        return self._page

    @abstractmethod
    def address(self, started: ExitStack) -> str:
        """Serve the viewer as long as `started` is open; gives its page's address."""

    def show_named(
        self,
        name: str,
        offered: str = "",
        status: dict[str, Any] | None = None,
        *,
        beside: str = "",
        over: dict[str, Any] | None = None,
        settle: bool = True,
        open: bool = True,
    ) -> Shown:
        """Open a mesh in the viewer and wait until its light has converged.

        Parameters
        ----------
        name : str
            Of the mesh, for what goes wrong; of one of the site's catalogue "source/mesh".
        offered : str
            What the page knows a mesh by that is at hand.
        status : dict, optional
            Whole or partial, ours or the original's; it is laid over the defaults, whatever was shown before.
        beside : str
            What the page knows by that the mesh is compared with.
        over : dict, optional
            More settings, laid over these.
        settle : bool
            Whether to wait for the light on the page; a picture that is taken completes its own.
        open : bool
            Whether to open the mesh; one that stands there already keeps nothing of its settings.

        Raises
        ------
        RenderError
            The mesh, or what it is compared with, can't be read, or the browser gave up.
        """
        statuses = [one for one in (status, over) if one]
        asked = {
            "offered": offered,
            "beside": beside,
            "name": name,
            "statuses": statuses,
            "settle": settle,
            "open": open,
        }
        answer = self.answer(SHOW, asked, name)
        return Shown(rejections=answer["rejections"], summary=answer["summary"], apart=answer["apart"])

    def end_comparison(self) -> None:
        """Let go of what the open mesh is compared with; of a browser that gave up nothing is said."""
        with suppress(PlaywrightError):
            self.page.evaluate(END)

    def picture(self, name: str, format: str, size: dict[str, Any] | None, which: Which = "both") -> bytes:
        """Take the picture of what is shown, or its figure in a format of `FIGURES`; errors as for `show_named`."""
        answer = self.answer(PICTURE, {"format": format, "size": size, "which": which}, name)
        return base64.b64decode(answer["data"])

    def answer(self, script: str, argument: dict[str, Any], name: str) -> dict[str, Any]:
        """What a script of the page answers; errors as for `show_named`."""
        try:
            answer: dict[str, Any] = self.page.evaluate(script, argument)
        except PlaywrightError as error:
            raise RenderError(f"{name}: the browser gave up: {_first_line(error)}") from None
        if "failed" in answer:
            raise RenderError(str(answer["failed"]))
        return answer

    def _start(self, started: ExitStack) -> Page:
        address = self.address(started)
        chromium = started.enter_context(browser())
        context = chromium.new_context(
            viewport={"width": WIDTH, "height": HEIGHT}, service_workers="block", color_scheme="light"
        )
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        page.goto(address)
        page.wait_for_function("() => window.hexalab !== undefined")
        page.evaluate("() => window.hexalab.ready")
        return page


def _first_line(error: Exception) -> str:
    return str(error).strip().splitlines()[0]
