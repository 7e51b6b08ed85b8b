"""A metric's histogram as SVG, to stand within a page whose style sheet gives it colours."""

from __future__ import annotations

from typing import Any

from ..words import count, counted, number
from .escaping import escape

WIDTH, HEIGHT = 240, 92
LEFT, RIGHT, TOP, BOTTOM = 4, 4, 14, 24
LEAST = 1.5
"""Height of a bar with a few cells: it is seen."""


def histogram_svg(metric: dict[str, Any]) -> str:
    """Draw the histogram of a row of `metrics`; "" where it has none.

    Bars whose middle is outside of the acceptable range have the class `outside`; a bracket below the axis marks the
    range itself.
    """
    data = metric["histogram"]
    if data is None:
        return ""
    counts = data["counts"]
    low, high, most = data["low"], data["high"], max(counts)
    base = HEIGHT - BOTTOM
    width = (WIDTH - LEFT - RIGHT) / len(counts)
    inside = _acceptable(metric["acceptable_range"])
    bars = []
    for place, many in enumerate(counts):
        if many:
            middle = low + (high - low) * ((place + 0.5) / len(counts))
            tall = max(LEAST, (base - TOP) * many / most)
            name = "bar" if inside[0] <= middle <= inside[1] else "bar outside"
            bars.append(
                f'<rect class="{name}" x="{LEFT + place * width:.2f}" y="{base - tall:.2f}" '
                f'width="{max(width - 0.6, 0.4):.2f}" height="{tall:.2f}"/>'
            )
    return (
        f'<svg class="histogram" viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(_words(metric))}">'
        f'<text x="{LEFT}" y="9">{count(most)}</text>'
        + "".join(bars)
        + f'<path class="axis" d="M{LEFT} {base}.5H{WIDTH - RIGHT}"/>'
        + _bracket(metric["acceptable_range"], low, high, base + 4)
        + f'<text x="{LEFT}" y="{HEIGHT - 4}">{number(low)}</text>'
        f'<text class="end" x="{WIDTH - RIGHT}" y="{HEIGHT - 4}">{number(high)}</text></svg>'
    )


def _acceptable(ends: list[float | None] | None) -> tuple[float, float]:
    low, high = ends or (None, None)
    return (float("-inf") if low is None else low, float("inf") if high is None else high)


def _bracket(ends: list[float | None] | None, low: float, high: float, y: float) -> str:
    """The acceptable range below the axis: closed where it ends within."""
    if ends is None or high <= low:
        return ""
    first, last = _acceptable(ends)
    if last < low or first > high:
        return ""
    a, b = (
        LEFT + (WIDTH - LEFT - RIGHT) * share for share in (_share(first, low, high), _share(last, low, high))
    )
    left = f"M{a:.2f} {y - 2}v4" if first >= low else ""
    right = f"M{b:.2f} {y - 2}v4" if last <= high else ""
    return f'<path class="acceptable" d="M{a:.2f} {y}H{b:.2f}{left}{right}"/>'


def _share(value: float, low: float, high: float) -> float:
    return min(max((value / 2 - low / 2) / (high / 2 - low / 2), 0.0), 1.0)


def _words(metric: dict[str, Any]) -> str:
    """The same for those who don't see it."""
    return (
        f"Histogram of {metric['name']}: {counted(metric['count'], 'cell')} "
        f"from {number(metric['min'])} to {number(metric['max'])}, median {number(metric['median'])}."
    )
