"""A page's session that also tells, without having been asked."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from queue import SimpleQueue
from typing import Any

from .offers import AnyOffer
from .seat import Seat

Event = dict[str, Any]
"""What a page is told without having asked, as JSON: ``{"changed": id}``, ``{"gone": id}``, ``{"stopped": true}``,
``{"identified": {"question": number, "sha256": text}}``."""


class Listener(Seat):
    """A page's session, and what it is told."""

    def __init__(self, offers: Mapping[str, AnyOffer]) -> None:
        super().__init__(offers)
        self._news: SimpleQueue[Event] | None = None
        self._missed: list[Event] = []
        self._telling = threading.Lock()

    def tell(self, event: Event) -> None:
        """Tell the page, as soon as it listens: a question may be answered before it does."""
        with self._telling:
            if self._news is None:
                self._missed.append(event)
            else:
                self._news.put(event)

    def listen(self) -> SimpleQueue[Event]:
        """What the page is told from now on, and what it has missed; whoever listened before does so no more."""
        with self._telling:
            self._news = SimpleQueue()
            for event in self._missed:
                self._news.put(event)
            self._missed = []
            return self._news

    def listens(self, news: SimpleQueue[Event]) -> bool:
        """Whether a queue is still the one that is filled."""
        return self._news is news

    def leave(self, news: SimpleQueue[Event]) -> None:
        """End listening."""
        with self._telling:
            if self.listens(news):
                self._news = None

    @property
    def empty(self) -> bool:
        """Whether no page listens."""
        return self._news is None
