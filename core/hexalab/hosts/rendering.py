"""Pictures of meshes without a window: the viewer, driven in headless Chromium, before the native core.

>>> with Renderer() as renderer:                                                 # doctest: +SKIP
...     rendering = renderer.render(BytesOffer("cube.mesh", data), {"filters": {"peel": {"depth": 1}}})
>>> Path("cube.png").write_bytes(rendering.data)                                 # doctest: +SKIP
"""

from __future__ import annotations

import base64
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any, Self, TypedDict

from playwright.sync_api import Error as PlaywrightError
from playwright.sync_api import Page

from hexalab import HexaLabError

from .browser import BrowserMissing, browser
from .loopback import Loopback
from .offers import Easel, Offer

WIDTH, HEIGHT = 1280, 800
EASEL = "0"
"""What the page knows the mesh by that is on the easel."""

PATIENCE = 600_000
"""Milliseconds for one picture: light on a large mesh takes its time without a graphics card."""

SHOW = """async ({ offered, name, status }) => {
  const hexalab = window.hexalab;
  try {
    await hexalab.reset(); // of the settings of the picture before nothing stays
    await (offered ? hexalab.openOffered(offered) : hexalab.open(name));
    await hexalab.identified();
    const rejections = status ? await hexalab.setStatus(status) : [];
    await hexalab.settled();
    return { rejections, summary: hexalab.summary() };
  } catch (error) {
    return { failed: error.message ?? String(error) };
  }
}"""

BASE64 = """(bytes) => {
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768)
    text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}"""

PICTURE = f"""async ({{ format, size }}) => {{
  try {{
    const {{ hexalab }} = window;
    const picture = await (format ? hexalab.figure(format, size) : hexalab.screenshot(size));
    return {{ data: ({BASE64})(new Uint8Array(await picture.arrayBuffer())) }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""

PORTRAY = f"""async ({{ offered, how }}) => {{
  try {{
    const {{ measured, row, made }} = await window.hexalab.portray(offered, how);
    const line = Object.fromEntries(Object.entries(row).map(([name, value]) => [name, String(value)]));
    return {{ measured, line, made: made.map(({{ name, bytes }}) => [name, ({BASE64})(bytes)]) }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""

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


@dataclass(frozen=True)
class Portrait:
    """What a batch makes of one mesh.

    Parameters
    ----------
    measured : dict
        `name`, `problem` ("" if there is none), `picture`, `vertices`, `cells`, `boundary_faces`, `quality` (metric id
        to statistics).
    line : dict of str to str
        Its line of the table, by column.
    files : dict of str to bytes
        Picture and histograms, by name.
    """

    measured: dict[str, Any]
    line: dict[str, str]
    files: dict[str, bytes]


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

    def show_named(self, name: str, offered: str = "", status: dict[str, Any] | None = None) -> Shown:
        """Open a mesh in the viewer and wait until its light has converged.

        Parameters
        ----------
        name : str
            Of the mesh, for what goes wrong; of one of the site's catalogue "source/mesh".
        offered : str
            What the page knows a mesh by that is at hand.
        status : dict, optional
            Whole or partial, ours or the original's; it is laid over the defaults, whatever was shown before.

        Raises
        ------
        RenderError
            The mesh can't be read, or the browser gave up.
        """
        answer = self.answer(SHOW, {"offered": offered, "name": name, "status": status}, name)
        return Shown(rejections=answer["rejections"], summary=answer["summary"])

    def picture(self, name: str, format: str, size: dict[str, Any] | None) -> bytes:
        """Take the picture of what is shown, or its figure in a format of `FIGURES`; errors as for `show_named`."""
        return base64.b64decode(self.answer(PICTURE, {"format": format, "size": size}, name)["data"])

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


class Renderer(Viewer):
    """Makes one picture after the other; the native core answers the page."""

    def __init__(self) -> None:
        super().__init__()
        self._easel = Easel()

    def address(self, started: ExitStack) -> str:
        """Serve the built viewer on this machine."""
        server = started.enter_context(Loopback({EASEL: self._easel}, opens=False))
        server.start()
        started.callback(server.shutdown)
        return server.address

    def render(
        self,
        mesh: Offer,
        status: dict[str, Any] | None = None,
        *,
        width: int = WIDTH,
        height: int = HEIGHT,
        transparent: bool = False,
    ) -> Rendering:
        """Make a picture of a mesh when its light has converged.

        Parameters
        ----------
        mesh : Offer
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
        with self.shown(mesh, status) as shown:
            return Rendering(self.picture(mesh.name, "", size), **shown)

    def figure(
        self,
        mesh: Offer,
        status: dict[str, Any] | None = None,
        *,
        format: str = "png",
        width: int | None = None,
        height: int | None = None,
    ) -> Rendering:
        """Make the figure that a status asks for in its section `figure`: legend, scale bar, caption, panels.

        Parameters
        ----------
        mesh, status
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
        with self.shown(mesh, status) as shown:
            return Rendering(self.picture(mesh.name, format, size), **shown)

    def portray(
        self,
        mesh: Offer,
        stem: str,
        layers: list[Any],
        *,
        name: str = "",
        width: int | None = None,
        height: int | None = None,
        figures: bool = False,
    ) -> Portrait:
        """Draw and measure a mesh as the page's batch does.

        Parameters
        ----------
        mesh : Offer
        stem : str
            What its files are called by.
        layers : list
            Settings documents, laid over the defaults and over each other.
        name : str
            What it is called in the table; the mesh's own by default.
        width, height : int, optional
            Of the picture in pixels; by default 1280 x 800, a figure's own.
        figures : bool
            Whether the picture is the figure that the settings ask for.

        Raises
        ------
        RenderError
            The browser gave up. A mesh that can't be read is told in the answer.
        """
        how = {"name": name or mesh.name, "stem": stem, "layers": layers, "figures": figures}
        if width and height:
            how |= {"width": width, "height": height}
        with self._on_easel(mesh):
            answer = self.answer(PORTRAY, {"offered": EASEL, "how": how}, mesh.name)
        files = {file: base64.b64decode(data) for file, data in answer["made"]}
        return Portrait(answer["measured"], answer["line"], files)

    @contextmanager
    def shown(self, mesh: Offer, status: dict[str, Any] | None = None) -> Iterator[Shown]:
        """Hold a mesh open in the viewer, its light converged; errors as for `show_named`."""
        with self._on_easel(mesh):
            yield self.show_named(mesh.name, EASEL, status)

    @contextmanager
    def _on_easel(self, mesh: Offer) -> Iterator[None]:
        self._easel.offer = mesh
        try:
            yield
        finally:
            self._easel.offer = None


def _first_line(error: Exception) -> str:
    return str(error).strip().splitlines()[0]
