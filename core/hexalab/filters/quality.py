"""Quality and attributes (SPEC F3; the paper, Quality Thresholding): hides cells by a value each has."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ..arrays import Floats

Keep = Literal["inside", "outside"]


def band(
    values: Floats,
    keep: Keep = "inside",
    minimum: float | None = None,
    maximum: float | None = None,
    worst: float = np.nan,
) -> NDArray[np.bool_]:
    """Cells whose value a band does not keep, (C,) bool.

    The paper's threshold, which hides cells not worse than it, is `keep` "inside" and, for a metric whose
    best is high, `maximum` alone. The ends of the band belong to what is kept on either side, so that both
    ends of a slider mean what they say: with a Scaled Jacobian of at most 1 nothing is hidden, of at most 0
    degenerate cells stay.

    Parameters
    ----------
    values : (C,) float64
        Native values.
    keep : "inside" or "outside"
        Keep the cells whose value lies in [minimum, maximum], or those not between the two.
    minimum, maximum : float or None
        Native values; None for an open end. A band without ends hides nothing.
    worst : float
        What a NaN counts as: -inf or inf, the worst end of a metric, so that hiding the good keeps it shown
        and hiding the bad hides it. NaN for values without a worst end: then it lies outside of every band.
    """
    if minimum is None and maximum is None:
        return np.zeros(len(values), dtype=bool)
    if keep == "inside":
        hidden = np.zeros(len(values), dtype=bool)
        if minimum is not None:
            hidden |= values < minimum
        if maximum is not None:
            hidden |= values > maximum
    else:
        hidden = np.ones(len(values), dtype=bool)
        if minimum is not None:
            hidden &= values > minimum
        if maximum is not None:
            hidden &= values < maximum
    lost = np.isnan(values)
    if lost.any():
        hidden[lost] = _hides_lost(keep, minimum, maximum, worst)
    return hidden


def _hides_lost(keep: Keep, minimum: float | None, maximum: float | None, worst: float) -> bool:
    """Whether the band hides a cell without a value."""
    within = not np.isnan(worst) and (minimum if worst < 0 else maximum) is None
    return within == (keep == "outside")
