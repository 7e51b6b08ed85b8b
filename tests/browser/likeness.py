"""How alike two pictures are to the eye: enough to tell a wrong picture from one that another GPU has rasterised.

Both are blurred first, so that an edge a fraction of a pixel away, or smoothed otherwise, counts little. Then two
numbers are looked at: the mean difference of the whole, and that of the worst block, which finds a fault in a corner.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageFilter

BLUR = 2
"""Radius in pixels."""

BLOCK = 12
"""Side of a block in pixels."""

MOST, MOST_IN_BLOCK = 1.8, 9.0
"""Differences that pass, in levels of 0 to 255."""


@dataclass(frozen=True)
class Difference:
    """Levels of 0 to 255, mean over the three colours.

    Parameters
    ----------
    mean : float
        Over the whole picture.
    worst : float
        Mean over the block where it is largest.
    """

    mean: float
    worst: float

    @property
    def passes(self) -> bool:
        """Whether the eye would take the pictures for the same."""
        return self.mean <= MOST and self.worst <= MOST_IN_BLOCK


def difference(one: Image.Image, other: Image.Image) -> Difference:
    """Compare two pictures of one size."""
    assert one.size == other.size
    gap = np.abs(_blurred(one) - _blurred(other)).mean(axis=2)
    height, width = (side // BLOCK * BLOCK for side in gap.shape)
    blocks = gap[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).mean(axis=(1, 3))
    return Difference(float(gap.mean()), float(blocks.max()))


def _blurred(picture: Image.Image) -> NDArray[Any]:
    return np.asarray(picture.convert("RGB").filter(ImageFilter.GaussianBlur(BLUR))).astype(float)
