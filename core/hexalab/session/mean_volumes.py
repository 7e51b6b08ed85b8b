"""The mean volumes that size metrics compare with, found a share of the cells at a time."""

from __future__ import annotations

from ..mesh import Mesh
from ..quality.compute import compared_volumes

SHARE = 2**15
"""Cells per step: a few milliseconds, so that a slice can come between."""


class MeanVolumes:
    """Mean volume of the cells of each kind.

    Parameters
    ----------
    mesh : Mesh

    Examples
    --------
    >>> means = MeanVolumes(mesh)                                                # doctest: +SKIP
    >>> while not means.step():                                                  # doctest: +SKIP
    ...     answer_others()
    """

    def __init__(self, mesh: Mesh) -> None:
        self._mesh = mesh
        self._done = 0
        self._sums: dict[int, tuple[float, int]] = {}

    @property
    def known(self) -> dict[int, float] | None:
        """The means by kind; None until all cells have been measured."""
        if self._done < self._mesh.cell_count:
            return None
        return {kind: total / count for kind, (total, count) in self._sums.items()}

    def step(self) -> bool:
        """Measure the next share of the cells; return whether that was the last."""
        mesh, part = self._mesh, slice(self._done, self._done + SHARE)
        share = Mesh(mesh.coordinates, mesh.corners[:, part], mesh.kinds[part])
        sums = dict(self._sums)
        for kind, volumes in compared_volumes(share).items():
            total, count = sums.get(kind, (0.0, 0))
            sums[kind] = (total + float(volumes.sum()), count + len(volumes))
        self._sums, self._done = sums, self._done + share.cell_count
        return self.known is not None
