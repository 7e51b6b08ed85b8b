"""Pictures of meshes without a window: the built site's own viewer, driven in headless Chromium.

>>> with Renderer(Path("build/site")) as renderer:                               # doctest: +SKIP
...     rendering = renderer.render("cube.mesh", data, {"filters": {"peel": {"depth": 1}}})
>>> Path("cube.png").write_bytes(rendering.data)                                 # doctest: +SKIP
"""

from __future__ import annotations

import base64
import threading
from contextlib import ExitStack
from dataclasses import dataclass, field
from functools import partial
from http.server import ThreadingHTTPServer
from pathlib import Path
from typing import Any, Self, TypedDict
from urllib.parse import unquote

from playwright.sync_api import Error as PlaywrightError
from playwright.sync_api import Page

from hexalab import HexaLabError

from .browser import BrowserMissing, browser
from .serving import SiteHandler

WIDTH, HEIGHT = 1280, 800
OFFERED = "/-offered-mesh"
"""Address at which the page finds the mesh: the file itself is nowhere in the site."""

PATIENCE = 600_000
"""Milliseconds for one picture: light on a large mesh takes its time without a graphics card."""

SHOW = """async ({ address, name, status }) => {
  const hexalab = window.hexalab;
  try {
    await hexalab.reset(); // of the settings of the picture before nothing stays
    if (address) await hexalab.open(new File([await (await fetch(address)).blob()], name));
    else await hexalab.open(name);
    const rejections = status ? await hexalab.setStatus(status) : [];
    await hexalab.settled();
    return { rejections, summary: hexalab.summary() };
  } catch (error) {
    return { failed: error.message ?? String(error) };
  }
}"""

PICTURE = """async ({ format, size }) => {
  try {
    const { hexalab } = window;
    const picture = await (format ? hexalab.figure(format, size) : hexalab.screenshot(size));
    const bytes = new Uint8Array(await picture.arrayBuffer());
    let text = "";
    for (let at = 0; at < bytes.length; at += 32768)
      text += String.fromCharCode(...bytes.subarray(at, at + 32768));
    return { data: btoa(text) };
  } catch (error) {
    return { failed: error.message ?? String(error) };
  }
}"""

FIGURES = ("png", "svg", "pdf")
"""Formats of figures."""


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
    """What the page tells once a mesh stands in it: `rejections` and `summary`, as `Rendering` has them."""

    rejections: list[Rejection]
    summary: dict[str, Any]


@dataclass(frozen=True)
class Rendering:
    """A picture and what was told of it.

    Parameters
    ----------
    data : bytes
        The file; the status is in the text chunk of a PNG.
    rejections : list of Rejection
        What of the status could not be applied.
    summary : dict
        The mesh's, as `window.hexalab.summary()` gives it.
    """

    data: bytes
    rejections: list[Rejection] = field(default_factory=list)
    summary: dict[str, Any] = field(default_factory=dict)


class _Handler(SiteHandler):
    """The site, and one mesh beside it."""

    def __init__(self, *arguments: Any, shelf: dict[str, bytes], **named: Any) -> None:
        self._shelf = shelf
        super().__init__(*arguments, **named)

    def do_GET(self) -> None:
        """Hand out the mesh from memory, and files of the site."""
        if unquote(self.path) != OFFERED:
            return super().do_GET()
        data = self._shelf[OFFERED]
        self.send_response(200)
        self.send_header("Content-Type", "application/octet-stream")
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, format: str, *arguments: Any) -> None:
        """Stay quiet."""


class Renderer:
    """The viewer, ready to make one picture after the other.

    Parameters
    ----------
    site : Path
        A built site.
    """

    def __init__(self, site: Path) -> None:
        self._site = site
        self._shelf: dict[str, bytes] = {}
        self._open = ExitStack()
        self._page: Page | None = None

    def __enter__(self) -> Self:
        """Serve the site on this machine and start the browser.

        Raises
        ------
        RenderError
            There is no site, or no browser, or the viewer does not start.
        """
        if not (self._site / "viewer" / "index.html").is_file():
            raise RenderError(f"there is no viewer in {self._site}: build the site first (hexalab build)")
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

    def render(
        self,
        name: str,
        data: bytes | None,
        status: dict[str, Any] | None = None,
        *,
        width: int = WIDTH,
        height: int = HEIGHT,
        transparent: bool = False,
    ) -> Rendering:
        """Make a picture of a mesh when its light has converged.

        Parameters
        ----------
        name : str
            The file's name, or "source/mesh" of the site's catalogue.
        data : bytes or None
            The file; None for a mesh of the catalogue.
        status : dict, optional
            Whole or partial, ours or the original's; it is laid over the defaults, whatever was rendered before.
        width, height : int
            Pixels, 8192 at most.
        transparent : bool
            Whether to leave the background out.

        Raises
        ------
        RenderError
            The mesh can't be read, or the browser gave up.
        """
        size = {"width": width, "height": height, "transparent": transparent}
        return self._picture(name, data, status, "", size)

    def figure(
        self,
        name: str,
        data: bytes | None,
        status: dict[str, Any] | None = None,
        *,
        format: str = "png",
        width: int | None = None,
        height: int | None = None,
    ) -> Rendering:
        """Make the figure that a status asks for in its section `figure`: legend, scale bar, caption, panels.

        Parameters
        ----------
        name, data, status
            As for `render`.
        format : str
            One of `FIGURES`.
        width, height : int, optional
            Pixels; by default what the status asks for.

        Raises
        ------
        RenderError
            The mesh can't be read, the figure leaves no room for its pictures, or the browser gave up.
        """
        size = {"width": width, "height": height} if width and height else None
        return self._picture(name, data, status, format, size)

    def _picture(
        self,
        name: str,
        data: bytes | None,
        status: dict[str, Any] | None,
        format: str,
        size: dict[str, Any] | None,
    ) -> Rendering:
        answer = self.show(name, data, status)
        taken = self._answer(PICTURE, {"format": format, "size": size}, name)
        return Rendering(base64.b64decode(taken["data"]), answer["rejections"], answer["summary"])

    def show(self, name: str, data: bytes | None, status: dict[str, Any] | None = None) -> Shown:
        """Open a mesh in the viewer and wait until its light has converged.

        Parameters
        ----------
        name, data, status
            As for `render`.

        Returns
        -------
        Shown
            What could not be applied, and the mesh's summary.

        Raises
        ------
        RenderError
            The mesh can't be read, or the browser gave up.
        """
        if data is not None:
            self._shelf[OFFERED] = data
        address = "" if data is None else OFFERED
        answer = self._answer(SHOW, {"address": address, "name": name, "status": status}, name)
        return Shown(rejections=answer["rejections"], summary=answer["summary"])

    @property
    def page(self) -> Page:
        """The viewer's page."""
        assert self._page is not None, "use it in a with block"
        return self._page

    def _answer(self, script: str, argument: dict[str, Any], name: str) -> dict[str, Any]:
        try:
            answer: dict[str, Any] = self.page.evaluate(script, argument)
        except PlaywrightError as error:
            raise RenderError(f"{name}: the browser gave up: {_first_line(error)}") from None
        if "failed" in answer:
            raise RenderError(str(answer["failed"]))
        return answer

    def _start(self, started: ExitStack) -> Page:
        handler = partial(_Handler, directory=str(self._site), shelf=self._shelf)
        server = started.enter_context(ThreadingHTTPServer(("127.0.0.1", 0), handler))
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, daemon=True).start()
        started.callback(server.shutdown)
        chromium = started.enter_context(browser())
        context = chromium.new_context(
            viewport={"width": WIDTH, "height": HEIGHT}, service_workers="block", color_scheme="light"
        )
        context.set_default_timeout(PATIENCE)
        page = context.new_page()
        page.goto(f"http://127.0.0.1:{server.server_address[1]}/viewer/")
        page.wait_for_function("() => window.hexalab !== undefined")
        page.evaluate("() => window.hexalab.ready")
        return page


def _first_line(error: Exception) -> str:
    return str(error).strip().splitlines()[0]
