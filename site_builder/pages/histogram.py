"""The Scaled Jacobian's histogram as the numbers of an SVG, for the template to draw."""

from __future__ import annotations

from dataclasses import dataclass

from hexalab.quality import METRICS

from ..model.facts import Binned

WIDTH, HEIGHT = 480, 140
_BASE = 116


@dataclass(frozen=True)
class Bar:
    """One bin: its outline, whether it holds values that are not positive, and what it says when pointed at."""

    outline: str
    bad: bool
    title: str


@dataclass(frozen=True)
class Histogram:
    """All that the template draws."""

    width: int
    height: int
    base: int
    bars: list[Bar]
    ticks: list[tuple[float, str]]
    bracket: tuple[float, float]
    peak: int


def draw(histogram: Binned) -> Histogram:
    """Place the bars of a histogram.

    Parameters
    ----------
    histogram : Binned
        From -1 or 0 to 1.

    Returns
    -------
    Histogram
        In the units of an SVG of `WIDTH` by `HEIGHT`.
    """
    low, high, counts = histogram["low"], histogram["high"], histogram["counts"]
    step = WIDTH / len(counts)
    value_step = (high - low) / len(counts)
    peak = max(counts) or 1
    bars = []
    for index, number in enumerate(counts):
        if number:
            height = max(1.0, (_BASE - 12) * number / peak)
            start = low + index * value_step
            title = f"{start:.3f} to {start + value_step:.3f}: {number:,} cell{'' if number == 1 else 's'}"
            bad = start + value_step <= 1e-9
            outline = f"M{index * step + 0.5:g} {_BASE}v{-height:.4g}h{step - 1:g}V{_BASE}"
            bars.append(Bar(outline, bad, title.replace("-", "−")))
    ticks = [
        (round((value - low) / (high - low) * WIDTH, 2), f"{value:g}".replace("-", "−"))
        for value in ([-1, -0.5, 0, 0.5, 1] if low < 0 else [0, 0.25, 0.5, 0.75, 1])
    ]
    acceptable = METRICS["scaled_jacobian"].acceptable_range or (low, high)
    place = [round((value - low) / (high - low) * WIDTH, 2) for value in acceptable]
    return Histogram(WIDTH, HEIGHT, _BASE, bars, ticks, (place[0], place[1]), peak)
