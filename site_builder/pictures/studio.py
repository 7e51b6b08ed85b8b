"""Taking pictures: one browser with the site's viewer in it, one picture after the other."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from pathlib import Path

from playwright.sync_api import Error as PlaywrightError
from playwright.sync_api import Locator

from hexalab.hosts.headless import RenderError, Viewer
from hexalab.hosts.serving import make_server
from hexalab.status import DEFAULTS, merge

from .album import Album
from .shot import HEIGHT, WIDTH, Shot

DIRECTIONS = 256
"""From which light is gathered, of the 1024 that the viewer takes: then a grey differs by more than four of 255 in one
pixel of a hundred at most."""

UNFOLD = """(part) => {
  for (let fold = part.closest("details"); fold; fold = fold.parentElement.closest("details")) {
    if (!fold.open) fold.dataset.unfolded = "";
    fold.open = true;
  }
}"""
"""Opens what is folded around a part of the page."""

FOLD = """() => {
  for (const fold of document.querySelectorAll("[data-unfolded]")) {
    fold.open = false;
    delete fold.dataset.unfolded;
  }
}"""
"""Folds it again, so that no picture depends on those before it."""

Progress = Callable[[str, float], None]
"""Called with what is being done, and how much of all pictures is done: 0 to 1."""


COMPARE = """async ({ mesh }) => {
  try {
    await window.hexalab.compare(mesh);
    await window.hexalab.settled();
    return {};
  } catch (error) {
    return { failed: error.message ?? String(error) };
  }
}"""


class Studio(Viewer):
    """The viewer of a built site, ready to take shots of its own meshes.

    Parameters
    ----------
    site : Path
        A built site.
    """

    def __init__(self, site: Path) -> None:
        super().__init__()
        self._site = site
        self._standing = ""

    def address(self, started: ExitStack) -> str:
        """Serve the site on this machine."""
        if not (self._site / "viewer" / "index.html").is_file():
            raise RenderError(f"there is no viewer in {self._site}: build the site first (hexalab build)")
        server = started.enter_context(make_server(self._site))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        started.callback(server.shutdown)
        return f"{server.address}viewer/?directions={DIRECTIONS}"

    def take(self, shot: Shot) -> bytes:
        """The PNG of a shot, its status inside.

        Raises
        ------
        RenderError
            The mesh can't be opened, the status is wrong, or the browser gave up.
        """
        name = shot.mesh.id
        status = merge({name: part for name, part in DEFAULTS.items() if name != "mesh"}, shot.status)
        standing, self._standing = self._standing == name, ""
        shown = self.show_named(name, status=status, settle=bool(shot.part), open=not standing)
        self._standing = name
        rejections = shown["rejections"]
        if rejections:
            raise RenderError(f"the status of a picture of {name} is wrong: {rejections}")
        if shot.beside:
            self.answer(COMPARE, {"mesh": shot.beside.id}, shot.beside.id)
        try:
            return self._picture(shot)
        finally:
            if shot.beside:
                self.page.evaluate("() => window.hexalab.endComparison()")

    def _picture(self, shot: Shot) -> bytes:
        name = shot.mesh.id
        if shot.part:
            return self._photograph(shot)
        if "figure" in shot.status:
            return self.picture(name, "png", None)
        return self.picture(name, "", {"width": shot.width, "height": shot.height, "transparent": False})

    def _photograph(self, shot: Shot) -> bytes:
        try:
            if shot.press:
                self._unfolded(shot.press).click()
            if shot.part != "body":
                return self._unfolded(shot.part).screenshot()
            return self._window(shot.width, shot.height)
        except PlaywrightError as error:
            raise RenderError(f"{shot.part} of the viewer can't be photographed: {error}") from None
        finally:
            self.page.evaluate(FOLD)

    def _unfolded(self, selector: str) -> Locator:
        """A part of the page, with all that it is folded into opened."""
        part = self.page.locator(selector)
        part.evaluate(UNFOLD)
        return part

    def _window(self, width: int, height: int) -> bytes:
        """The page in a window of that size; of a card's size, the window is left as it is."""
        usual = self.page.viewport_size
        if (width, height) == (WIDTH, HEIGHT) or usual is None:
            return self.page.screenshot()
        self.page.set_viewport_size({"width": width, "height": height})
        try:
            self.page.evaluate("() => window.hexalab.settled()")
            return self.page.screenshot()
        finally:
            self.page.set_viewport_size(usual)


GIVE_UP = 3
"""Pictures that may fail before the rest isn't tried any more."""


def take_missing(shots: Sequence[Shot], site: Path, album: Album, tell: Progress) -> tuple[int, str]:
    """Take the shots that the album lacks, those of large meshes last.

    Returns
    -------
    taken : int
        How many pictures are new.
    trouble : str
        One line that says why some are missing still; "" if none is.
    """
    missing = {shot.key: shot for shot in shots if shot.key and not album.picture(shot)}
    wanted = sorted(missing.values(), key=lambda shot: (shot.mesh.cells or 0, shot.mesh.id))
    failed: list[str] = []
    taken = 0
    if not wanted:
        return 0, ""
    try:
        tell("the viewer, for pictures", 0.0)
        with Studio(site) as studio:
            for number, shot in enumerate(wanted):
                tell(f"picture of {shot.mesh.id}", number / len(wanted))
                try:
                    album.keep(shot, studio.take(shot))
                    taken += 1
                except RenderError as error:
                    failed.append(str(error))
                    if len(failed) == GIVE_UP:
                        break
    except RenderError as error:
        failed.append(str(error))
    if not failed:
        return taken, ""
    return taken, f"{len(wanted) - taken} of {len(wanted)} pictures are missing: {failed[0]}"
