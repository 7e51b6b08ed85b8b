"""Values kept of an open mesh are bounded, and those used longest ago leave first."""

from __future__ import annotations

import pytest

from hexalab.session.opened import Opened
from tests.core.filters.boxes import box


def test_P7_the_values_that_were_not_asked_for_for_longest_are_forgotten(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    mesh = box(3, 2, 1)
    opened = Opened(mesh)
    monkeypatch.setattr("hexalab.session.opened.MOST_BYTES_OF_VALUES", 3 * 8 * mesh.cell_count)
    skew, taper, volume = (opened.values(quantity) for quantity in ("skew", "taper", "volume"))
    assert opened.values("skew") is skew, "the oldest is used once more"
    shape = opened.values("shape")
    assert opened.values("volume") is volume
    assert opened.values("skew") is skew
    assert opened.values("shape") is shape
    assert opened.values("taper") is not taper


def test_P7_statistics_outlive_the_values_they_are_of(monkeypatch: pytest.MonkeyPatch) -> None:
    opened = Opened(box(3, 2, 1))
    monkeypatch.setattr("hexalab.session.opened.MOST_BYTES_OF_VALUES", 0)
    values, told = opened.values("volume"), opened.statistics_of("volume")
    opened.values("skew")
    assert opened.statistics_of("volume") is told
    assert opened.values("volume") is not values
    assert told["min"] == told["max"] == pytest.approx(1)
