"""Types of arrays that all rooms share, and the size of a chunk."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Floats = NDArray[np.float64]
Ids = NDArray[np.int32]

CHUNK = 32768
"""Cells in a chunk: temporaries stay in cache and memory is bounded."""
