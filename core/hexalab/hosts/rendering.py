"""Pictures of meshes without a window: the viewer, driven in headless Chromium, before the native core.

>>> with Renderer() as renderer:                                                 # doctest: +SKIP
...     rendering = renderer.render(BytesOffer("cube.mesh", data), {"filters": {"peel": {"depth": 1}}})
>>> Path("cube.png").write_bytes(rendering.data)                                 # doctest: +SKIP
"""

from __future__ import annotations

import base64
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any

from .easels import Easel, SurfaceEasel
from .headless import HEIGHT, WIDTH, Rejection, Shown, Viewer, Which
from .loopback import Loopback
from .offers import AnyOffer, Offer, SurfaceOffer
from .page_scripts import PORTRAY

MESH, OTHER_MESH, SURFACE = "0", "1", "2"
"""What the page knows by that is on an easel: the mesh, and what it is compared with, another mesh or a surface."""

PARTING = 2.0
"""Seconds that the session of a second mesh is kept when it has gone."""


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
    second : bytes or None
        The second mesh's own file, where the status asks for two (`figure.meshes`); else `data` shows both.
    """

    data: bytes
    rejections: list[Rejection] = field(default_factory=list)
    summary: dict[str, Any] = field(default_factory=dict)
    second: bytes | None = None


@dataclass(frozen=True)
class Portrait:
    """What a batch makes of one mesh.

    Parameters
    ----------
    measured : dict
        `name`, `problem` ("" if there is none), `picture`, `vertices`, `cells`, `boundary_faces`, `quality` (metric id
        to statistics), `comparison` if it is compared with something: `with`, `same_cells`, `difference`, `changes`,
        `distance`, `volume_ratio` (see `hexalab.comparison.compare`).
    line : dict of str to str
        Its line of the table, by column.
    files : dict of str to bytes
        Picture and histograms, by name.
    """

    measured: dict[str, Any]
    line: dict[str, str]
    files: dict[str, bytes]


class Renderer(Viewer):
    """Makes one picture after the other; the native core answers the page.

    Parameters
    ----------
    directions : int
        From which light is gathered; 0 for as many as the viewer takes.
    """

    def __init__(self, directions: int = 0) -> None:
        super().__init__()
        self._directions = directions
        self._easel, self._other, self._surface = Easel(), Easel(), SurfaceEasel()

    def address(self, started: ExitStack) -> str:
        """Serve the built viewer on this machine."""
        offers: dict[str, AnyOffer] = {MESH: self._easel, OTHER_MESH: self._other, SURFACE: self._surface}
        server = started.enter_context(Loopback(offers, opens=False, parting=PARTING))
        server.start()
        started.callback(server.shutdown)
        return server.address.replace("/#", f"/?directions={self._directions}#", 1)

    def render(
        self,
        mesh: Offer,
        status: dict[str, Any] | None = None,
        *,
        width: int = WIDTH,
        height: int = HEIGHT,
        transparent: bool = False,
        beside: AnyOffer | None = None,
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
        beside : Offer or SurfaceOffer, optional
            What it is compared with: of another mesh the picture is the `figure` with both, of this size; a surface is
            drawn over the mesh.

        Raises
        ------
        RenderError
            The mesh, or what it is compared with, can't be read, or the browser gave up.
        """
        size = {"width": width, "height": height}
        if beside is None or isinstance(beside, SurfaceOffer):
            with self.shown(mesh, status, beside) as shown:
                return self._rendering(mesh, "", size | {"transparent": transparent}, shown)
        bare = {"figure": {"transparent": True}} if transparent else None
        with self.shown(mesh, status, beside, bare) as shown:
            return self._rendering(mesh, "png", size, shown)

    def figure(
        self,
        mesh: Offer,
        status: dict[str, Any] | None = None,
        *,
        format: str = "png",
        width: int | None = None,
        height: int | None = None,
        beside: AnyOffer | None = None,
    ) -> Rendering:
        """Make the figure that a status asks for in its section `figure`: legend, scale bar, caption, panels.

        Parameters
        ----------
        mesh, status, beside
            As for `render`.
        format : str
            One of `FIGURES`.
        width, height : int, optional
            Pixels; by default what the status asks for.

        Raises
        ------
        RenderError
            As for `render`; or the figure leaves no room for its pictures.
        """
        size = {"width": width, "height": height} if width and height else None
        with self.shown(mesh, status, beside) as shown:
            return self._rendering(mesh, format, size, shown)

    def _rendering(self, mesh: Offer, format: str, size: dict[str, Any] | None, shown: Shown) -> Rendering:
        sides: tuple[Which, ...] = ("first", "second") if format and shown["apart"] else ("both",)
        files = [self.picture(mesh.name, format, size, side) for side in sides]
        return Rendering(files[0], shown["rejections"], shown["summary"], files[1] if files[1:] else None)

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
        beside: AnyOffer | None = None,
        beside_name: str = "",
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
        beside : Offer or SurfaceOffer, optional
            What it is compared with; see `render`.
        beside_name : str
            What that is called in the table; its own by default.

        Raises
        ------
        RenderError
            The browser gave up. A mesh that can't be read is told in the answer.
        """
        how: dict[str, Any] = {
            "name": name or mesh.name,
            "stem": stem,
            "layers": layers,
            "figures": figures,
        }
        if not figures:
            width, height = width or WIDTH, height or HEIGHT
        if width and height:
            how |= {"width": width, "height": height}
        with self._on_easels(mesh, beside) as offered:
            if beside is not None:
                how["beside"] = {"id": offered, "name": beside_name or beside.name}
            answer = self.answer(PORTRAY, {"offered": MESH, "how": how}, mesh.name)
        files = {file: base64.b64decode(data) for file, data in answer["made"]}
        return Portrait(answer["measured"], answer["line"], files)

    @contextmanager
    def shown(
        self,
        mesh: Offer,
        status: dict[str, Any] | None = None,
        beside: AnyOffer | None = None,
        over: dict[str, Any] | None = None,
    ) -> Iterator[Shown]:
        """Hold a mesh open in the viewer, and what it is compared with; errors as for `show_named`."""
        with self._on_easels(mesh, beside) as offered:
            yield self.show_named(mesh.name, MESH, status, beside=offered, over=over, settle=False)

    @contextmanager
    def _on_easels(self, mesh: Offer, beside: AnyOffer | None) -> Iterator[str]:
        """Put both on easels; what the page knows the second by. Nothing of a comparison stays for the next picture."""
        with ExitStack() as taken_down:
            taken_down.enter_context(self._easel.holding(mesh))
            if beside is None:
                yield ""
                return
            if isinstance(beside, SurfaceOffer):
                place = SURFACE
                taken_down.enter_context(self._surface.holding(beside))
            else:
                place = OTHER_MESH
                taken_down.enter_context(self._other.holding(beside))
            taken_down.callback(self.end_comparison)
            yield place


class Bench(threading.local):
    """A thread's own renderer: the browser is started once, and anew when it broke.

    Parameters
    ----------
    directions : int
        As for `Renderer`.
    """

    renderer: Renderer | None = None

    def __init__(self, directions: int = 0) -> None:
        self._directions = directions

    def ready(self) -> Renderer:
        """The renderer, started."""
        if self.renderer is None:
            self.renderer = Renderer(self._directions).__enter__()
        return self.renderer

    def clear(self) -> None:
        """Close the browser."""
        renderer, self.renderer = self.renderer, None
        if renderer is not None:
            renderer.__exit__(None, None, None)
