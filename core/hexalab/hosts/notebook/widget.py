"""The widget: the viewer's page in a frame, whose questions the kernel's own core answers."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, Literal, overload

import anywidget
import traitlets

from ... import __version__
from ...errors import HexaLabError
from ...status import merge
from ..built import FRAME, NOTEBOOK, SCRIPT, SHEET, built_viewer
from ..frames import read_question
from ..offers import AnyOffer, Offer, listed
from ..seat import Seat
from .pieces import Pieces
from .still import still

OFFERED, COMPARED = "mesh", "other"
"""What the page knows the mesh by, and what it is compared with."""

HEIGHT = 520
LEAST_HEIGHT, MOST_HEIGHT = 200, 4000

PATIENCE = 20.0
"""Seconds that a picture is waited for."""

Settings = dict[str, Any]


class View(anywidget.AnyWidget):
    """A mesh in the viewer, in a notebook's cell. `hexalab.show` makes one.

    Attributes
    ----------
    status : dict
        All settings, as they are now; set it, whole or in part, to change them.
    picked : list of int
        The cell that the inspector tells of, from 0; set it to pick another, [] for none.
    height : int
        Of the view, in pixels.
    """

    _esm = "export default {}"  # the built one, once a view is made
    status = traitlets.Dict().tag(sync=True)
    picked = traitlets.List(traitlets.Int()).tag(sync=True)
    height = traitlets.Int(HEIGHT, min=LEAST_HEIGHT, max=MOST_HEIGHT).tag(sync=True)
    _version = traitlets.Unicode(__version__).tag(sync=True)

    def __init__(
        self,
        mesh: Offer,
        status: Settings | None = None,
        height: int = HEIGHT,
        compare: AnyOffer | None = None,
    ) -> None:
        folder = built_viewer()
        self._esm = (folder / NOTEBOOK).read_text("utf-8")
        self._bundle = [(folder / name).read_bytes() for name in (FRAME, SCRIPT)]
        self._mesh = mesh
        self._offers: dict[str, AnyOffer] = {OFFERED: mesh, **({COMPARED: compare} if compare else {})}
        self._first = dict(status or {})
        self._seats: dict[str, Seat] = {}
        self._pieces = Pieces()
        self._pictures: dict[int, Future[bytes]] = {}
        self._numbers = itertools.count(1)
        self._still = b""
        self._handle: Any = None
        super().__init__(status=self._first, height=height)
        self.on_msg(self._hear)

    @traitlets.validate("status")
    def _laid_over(self, proposal: Any) -> Settings:
        """A part that is set is laid over what is there: the page may not have said yet what all settings are."""
        return merge(self.status, proposal["value"])

    # -- for whoever has it

    @overload
    def screenshot(
        self,
        width: int | None = ...,
        height: int | None = ...,
        *,
        transparent: bool = ...,
        wait: Literal[True] = ...,
    ) -> bytes: ...

    @overload
    def screenshot(
        self,
        width: int | None = ...,
        height: int | None = ...,
        *,
        transparent: bool = ...,
        wait: Literal[False],
    ) -> Future[bytes]: ...

    def screenshot(
        self,
        width: int | None = None,
        height: int | None = None,
        *,
        transparent: bool = False,
        wait: bool = True,
    ) -> bytes | Future[bytes]:
        """Take a picture of what the view shows.

        Parameters
        ----------
        width, height : int, optional
            Pixels, 8192 at most; as large as the view by default.
        transparent : bool
            Whether to leave the background out.
        wait : bool
            Whether to wait for it. Some notebooks pass answers on between cells only: there ask for it in one cell,
            without waiting, and take its `result()` in the next.

        Returns
        -------
        bytes, or a Future of them
            A PNG that carries the settings.

        Raises
        ------
        HexaLabError
            No view is open, or the picture was waited for and did not come.
        """
        if not self._seats:
            raise HexaLabError("no view is open: show it in a cell first")
        number = next(self._numbers)
        coming = self._pictures[number] = Future[bytes]()
        size = {"width": width, "height": height} if width and height else {}
        self.send({"kind": "screenshot", "number": number, "options": {**size, "transparent": transparent}})
        if not wait:
            return coming
        try:
            return coming.result(PATIENCE)
        except TimeoutError:
            raise HexaLabError(
                f"no picture came within {PATIENCE:.0f} s, since this notebook may pass answers on only between cells: "
                "ask by screenshot(wait=False), and take the result() in the next cell"
            ) from None

    def __repr__(self) -> str:
        return f"HexaLab's view of {self._words}: run the cell to look at it"

    # -- for the notebook

    def _ipython_display_(self) -> None:
        """Show the widget, and below it the picture that stays when the notebook is saved."""
        from IPython.display import HTML, display

        bundle = self._repr_mimebundle_()
        data, metadata = bundle if isinstance(bundle, tuple) else (bundle, {})
        display(data, metadata=metadata, raw=True)
        self._handle = display(HTML(still(self._still, self._words, self.height)), display_id=True)

    @property
    def _words(self) -> str:
        kinds = ", ".join(f"{count:,} {kind}" for kind, count in self._mesh.mesh().kind_counts.items())
        return f"{self._mesh.name} ({kinds})"

    # -- for the page

    def _hear(self, _: Any, message: Any, buffers: list[Any]) -> None:
        """Answer a message of a page."""
        answers: dict[str, Callable[[dict[str, Any], list[Any]], None]] = {
            "bundle": self._give_bundle,
            "hello": self._seat,
            "sheet": self._give_sheet,
            "ask": self._ask,
            "picture": self._take_picture,
            "still": self._keep_still,
            "closed": self._close_view,
        }
        if isinstance(message, dict) and message.get("kind") in answers:
            answers[message["kind"]](message, buffers)

    def _give_bundle(self, message: dict[str, Any], _: list[Any]) -> None:
        self.send({"kind": "bundle", "view": message["view"]}, self._bundle)

    def _give_sheet(self, message: dict[str, Any], _: list[Any]) -> None:
        self.send({"kind": "sheet", "view": message["view"]}, [(built_viewer() / SHEET).read_bytes()])

    def _seat(self, message: dict[str, Any], _: list[Any]) -> None:
        view = str(message["view"])
        self._seats[view] = Seat(self._offers)
        hello = {
            "version": __version__,
            "offers": listed(self._offers),
            "status": self.status or None,
            "opens": True,
            "compare": COMPARED if COMPARED in self._offers else None,
        }
        self.send({"kind": "hello", "view": view, "hello": hello})

    def _ask(self, message: dict[str, Any], buffers: list[Any]) -> None:
        whole = self._pieces.add(message, buffers)
        if whole is None:
            return
        view, number = str(message["view"]), int(message["number"])
        seat = self._seats.get(view)
        if seat is None:
            return self._refuse(view, number, "the session has ended")
        try:
            question = read_question(whole)
        except HexaLabError as error:
            return self._refuse(view, number, str(error))
        identify = seat.identifier(question)
        packed, milliseconds = seat.answer(question)
        told = {"kind": "answer", "view": view, "number": number, "milliseconds": milliseconds}
        self.send(told, [packed.joined()])

        def identified(number: int, sha256: str) -> None:
            self.send({"kind": "identified", "view": view, "number": number, "sha256": sha256})

        identify(identified)

    def _refuse(self, view: str, number: int, reason: str) -> None:
        self.send({"kind": "refused", "view": view, "number": number, "reason": reason})

    def _take_picture(self, message: dict[str, Any], buffers: list[Any]) -> None:
        whole = self._pieces.add(message, buffers)
        if whole is None:
            return
        coming = self._pictures.pop(int(message["of"]), None)
        if coming is None:
            return  # another view of the same mesh was first
        if "error" in message:
            coming.set_exception(HexaLabError(str(message["error"])))
        else:
            coming.set_result(bytes(whole))

    def _keep_still(self, message: dict[str, Any], buffers: list[Any]) -> None:
        whole = self._pieces.add(message, buffers)
        if whole is None:
            return
        self._still = bytes(whole)
        if self._handle is not None:
            from IPython.display import HTML

            self._handle.update(HTML(still(self._still, self._words, self.height)))

    def _close_view(self, message: dict[str, Any], _: list[Any]) -> None:
        view = str(message["view"])
        self._pieces.forget(view)
        self._seats.pop(view, None)
