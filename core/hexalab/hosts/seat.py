"""One viewer's session, asked from whatever threads its questions come."""

from __future__ import annotations

import hashlib
import json
import threading
from collections.abc import Callable, Mapping
from time import perf_counter

from ..packing import Packed
from ..session import Session
from ..session.door import Door
from .frames import Question
from .offers import AnyOffer, SurfaceOffer

Identify = Callable[[int, str], None]
"""Called with a question's number and the SHA-256 of the file that it opened, "" where there is none."""

OPENING = ("open", "open_offered")


class Seat:
    """A session for one page.

    Parameters
    ----------
    offers : mapping of str to Offer or SurfaceOffer
        What the page may open, or compare with, without sending it.
    """

    def __init__(self, offers: Mapping[str, AnyOffer]) -> None:
        self._offers = offers
        surfaces = {name: one.surface for name, one in offers.items() if isinstance(one, SurfaceOffer)}
        meshes = {name: one.mesh for name, one in offers.items() if not isinstance(one, SurfaceOffer)}
        sizes = {name: one.size for name, one in offers.items()}
        self._door = Door(Session(meshes, sizes, surfaces))
        self._lock = threading.Lock()

    def answer(self, question: Question) -> tuple[Packed, float]:
        """Answer one question after the other; gives the milliseconds that it took, too."""
        with self._lock:
            began = perf_counter()
            packed = self._door.answer(question.method, question.text, question.blocks)
            return packed, 1000 * (perf_counter() - began)

    def identifier(self, question: Question) -> Callable[[Identify], None]:
        """Take hold of the file that a question is about to open, if it opens one.

        It is done before the question is answered: what is on an easel may be taken down or changed as soon as the
        page has its answer. What is returned hashes the file beside other work, and tells.
        """
        if question.method not in OPENING:
            return lambda tell: None
        hashed = self._hasher(question)

        def identify(tell: Identify) -> None:
            threading.Thread(target=lambda: tell(question.id, hashed()), daemon=True).start()

        return identify

    def _hasher(self, question: Question) -> Callable[[], str]:
        if question.method == "open_offered":
            try:
                offer = self._offers.get(str(json.loads(question.text)[0]))
            except (ValueError, LookupError, TypeError):
                return str  # the answer says what is wrong with the question
            return offer.hasher() if offer else str
        return lambda: hashlib.sha256(question.blocks[0]).hexdigest() if question.blocks else ""
