"""The paper's normalisations phi and their inverses: native values to [0, 1] and back, 1 best, 0 worst.

Each is a pair of functions of (values, low, high), low and high being the finite extremes of the metric over the mesh
(paper, section "Metric normalization" and the table of metrics). What is not finite has no place on the scale: NaN.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ..arrays import Floats

Map = Callable[[Floats, float, float], Floats]


@dataclass(frozen=True)
class Normalisation:
    """phi, its inverse, and what the worst end of phi is.

    Parameters
    ----------
    forward, inverse : functions of (values, low, high)
        phi and its algebraic inverse, element by element.
    span : function of (low, high)
        The denominator of phi: where it vanishes the range is empty. None: phi does not depend on the mesh.
    """

    forward: Map
    inverse: Map
    span: Callable[[float, float], float] | None = None


def _same(values: Floats, low: float, high: float) -> Floats:
    return values


def _rise(values: Floats, low: float, high: float) -> Floats:
    return (values / 2 - low / 2) / (high / 2 - low / 2)  # halves: the range may pass what float64 holds


def _rise_back(values: Floats, low: float, high: float) -> Floats:
    return low * (1 - values) + high * values


def _fall_to_one(values: Floats, low: float, high: float) -> Floats:
    return (high - values) / (high - 1)


def _fall_to_one_back(values: Floats, low: float, high: float) -> Floats:
    return 1 + (1 - values) * (high - 1)


def _fall_to_zero(values: Floats, low: float, high: float) -> Floats:
    return (high - values) / high


def _fall_to_zero_back(values: Floats, low: float, high: float) -> Floats:
    return (1 - values) * high


def _share(values: Floats, low: float, high: float) -> Floats:
    return values / high


def _share_back(values: Floats, low: float, high: float) -> Floats:
    return values * high


IDENTITY = Normalisation(_same, _same)
"""phi(q) = q, clamped to [0, 1]: for the Scaled Jacobian that is max(q, 0)."""

BETWEEN_EXTREMES = Normalisation(_rise, _rise_back, lambda low, high: high / 2 - low / 2)
"""phi(q) = (q - qmin) / (qmax - qmin)."""

DOWN_TO_ONE = Normalisation(_fall_to_one, _fall_to_one_back, lambda low, high: high - 1)
"""phi(q) = (qmax - q) / (qmax - 1)."""

DOWN_TO_ZERO = Normalisation(_fall_to_zero, _fall_to_zero_back, lambda low, high: high)
"""phi(q) = (qmax - q) / qmax."""

SHARE_OF_HIGHEST = Normalisation(_share, _share_back, lambda low, high: high)
"""phi(q) = q / qmax."""

ROUNDING = 1e-12
"""A range narrower than this, relative to the values (or to 1 for numbers without a unit), is rounding: empty."""


def is_empty(normalisation: Normalisation, low: float, high: float, has_unit: bool) -> bool:
    """Whether the mesh's range leaves phi nothing to tell apart."""
    if normalisation.span is None:
        return False
    scale = max(abs(low), abs(high), 0.0 if has_unit else 1.0)
    return not (high / 2 - low / 2 > ROUNDING * (scale / 2) and normalisation.span(low, high) > 0)
