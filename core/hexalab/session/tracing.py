"""Questions about the structure of the open mesh (SPEC T): a part of `Session`."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

from ..packing import jsonable
from .opened import Opened
from .picture import Picture

Result = dict[str, Any]


class Tracing(ABC):
    """What a session is asked about structure. Whatever is asked is traced then, if it was not before."""

    @abstractmethod
    def _open_mesh(self) -> Opened:
        """The open mesh; HexaLabError if there is none."""

    @abstractmethod
    def _drawn(self) -> Picture:
        """What was drawn of it last; HexaLabError if there is none."""

    def trace(self) -> Result:
        """Trace a part of the structure, so that other questions can come between; ask again until all is done.

        Returns
        -------
        dict
            `done`, `of` (how many parts), `next` (the name of the one that follows; None after the last).
        """
        return self._open_mesh().traced.trace()

    def structure_facts(self, labels: bool = False) -> Result:
        """Tell the facts of the structure; see `hexalab.structure.facts_of`."""
        facts: Result = jsonable(self._open_mesh().traced.facts(labels))
        return facts

    def structure_table(self, table: str, variant: str = "whole") -> Result:
        """List arcs, nodes, sheets, chords or blocks.

        Parameters
        ----------
        table : str
            A name of `hexalab.structure.TABLES`.
        variant : "whole" or "interior"
            Which arcs, or which blocks: of all irregular edges, or of those inside alone.

        Returns
        -------
        dict
            `rows` (how many), `columns`: a list of `id`, `values` (int32, or uint8 for what holds or not), `words`
            (what the values stand for; None for numbers).
        """
        return self._open_mesh().traced.table(table, variant)

    def structure_csv(self, table: str, variant: str = "whole") -> str:
        """Write the same table as CSV."""
        return self._open_mesh().traced.csv(table, variant)

    def sheet_pairs(self) -> Result:
        """Tell which sheets cross and which run side by side.

        Returns
        -------
        dict
            `count` (of sheets), and for each pair that meets `one`, `other` (the smaller number first), `crossings`
            (cells), `beside` (faces between them), all int32.
        """
        return self._open_mesh().traced.pairs()

    def structure_box(self, kind: str, numbers: list[int], variant: str = "whole") -> Result | None:
        """Tell where arcs, sheets, chords or blocks are drawn: `centre` and `size` in drawing coordinates, or None."""
        return self._open_mesh().traced.box(kind, numbers, variant, self._drawn().drawn_mesh)
