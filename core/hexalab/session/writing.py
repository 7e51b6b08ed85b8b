"""What a session writes for elsewhere: cells as a mesh, reports, lists of cells; a part of `Session`."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

from ..cell_lists import cell_list
from . import shown_cells
from .opened import Opened
from .picture import Picture

Result = dict[str, Any]


class Writing(ABC):
    """What a session is asked to write."""

    _size: int | None

    @abstractmethod
    def _open_mesh(self) -> Opened:
        """The open mesh; HexaLabError if there is none."""

    @abstractmethod
    def _drawn(self) -> Picture:
        """What was drawn of it last; HexaLabError if there is none."""

    @abstractmethod
    def _cell(self, cell: int) -> int:
        """The cell; HexaLabError if the mesh has none of that number."""

    def save_cells(
        self,
        format: str,
        metrics: Sequence[str] = (),
        attributes: Sequence[str] | None = None,
        structure: bool = False,
    ) -> Result:
        """Write the shown cells in a format, the id of a row of `hexalab.WRITERS`; see `shown_cells.shown_mesh`.

        Returns
        -------
        dict
            `data` ((n,) uint8, the file), `cells`, `vertices`, `notes` (what the format has no place for).
        """
        part = shown_cells.shown_mesh(self._open_mesh(), self._drawn().shown, metrics, attributes, structure)
        return {
            "cells": part.cell_count,
            "vertices": part.vertex_count,
            **shown_cells.shown_file(part, format),
        }

    def report(
        self,
        form: str,
        about: Result | None = None,
        pictures: Sequence[Result] = (),
        criteria: Any = None,
        strict: bool = False,
    ) -> Result:
        """Write the report of the mesh, as "html", "md", "json" or "xml"; see `reporting.report_of`."""
        from . import reporting  # when it is first needed: a browser's Python starts the sooner

        told = {"bytes": self._size, **(about or {})}
        return reporting.report_of(self._open_mesh(), form, told, pictures, criteria, strict)

    def report_poses(self, unit: str = "none") -> list[Result]:
        """Tell which pictures a report asks for; see `reporting.poses_of`."""
        from . import reporting

        return reporting.poses_of(self._open_mesh(), unit)

    def cell_list(self, cells: list[int], form: str, name: str = "cells") -> str:
        """Write cells as a text for other programs; see `hexalab.cell_list`."""
        return cell_list(self._open_mesh().mesh, [self._cell(cell) for cell in cells], form, name)
