"""Cells coloured, measured and filtered by the structure (SPEC T4, T5), against dictionaries."""

from __future__ import annotations

import re
from collections import deque
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from hexalab.session import Session
from hexalab.session.looking import BLOCK_COLOURS, CHOSEN_COLOURS
from hexalab.structure.quantities import QUANTITIES
from hexalab.surface.curves import BASE, CHORD_ROWS, CHORDS
from tests.core.session.checks import plain
from tests.core.session.looks import MESHES, Truth, session_of, truth_of

VIEWER = Path(__file__).parents[3] / "static" / "viewer" / "colours"
CROSSING, REST = 6, 7
"""Places of the viewer's palette: cells in several of the chosen, and in none."""


def coloured(session: Session, look: dict[str, Any], by: str) -> list[float]:
    """The colour of each cell under a look."""
    found = session.update({"structure": look, "colour": {"by": by}}, whole=True)["colour"]
    assert plain(found) and found["quantity"] == by and found["low"] is found["high"] is None
    assert found["label"] == {"block": "Block", "chosen": "Chosen"}[by]
    places: list[float] = found["map_position"].tolist()
    return places


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("complex", ["whole", "interior"])
def test_T4_blocks_that_share_a_face_have_different_colours(name: str, complex: str) -> None:
    truth = truth_of(name)
    places = coloured(session_of(name), {"complex": complex}, "block")
    block = {cell: n for n, cells in enumerate(truth.members("blocks", complex)) for cell in cells}
    assert {cell for cell, place in enumerate(places) if not np.isnan(place)} == set(block)
    assert {places[cell] for cell in block} <= set(range(BLOCK_COLOURS))
    for cells in truth.members("blocks", complex):
        assert len({places[cell] for cell in cells}) == 1
    for sides in truth.sides:
        around = [cell for cell, _ in sides if cell in block]
        for other in around[1:]:
            assert block[around[0]] == block[other] or places[around[0]] != places[other]


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("kind", ["sheets", "chords", "blocks"])
@pytest.mark.parametrize("complex", ["whole", "interior"])
def test_T4_the_chosen_have_colours_and_where_they_cross_another(name: str, kind: str, complex: str) -> None:
    truth, session = truth_of(name), session_of(name)
    members = truth.members(kind, complex)
    for chosen in ([], [1], [0, 3], [3, 0, 99_999, 2], [*range(min(len(members), 9))], [0, 0]):
        there = [number for number in dict.fromkeys(chosen) if number < len(members)]
        expected = []
        twice = crossed_twice(truth, kind)
        for cell in range(truth.mesh.cell_count):
            own = [place for place, number in enumerate(there) if cell in members[number]]
            crossing = len(own) > 1 or any((there[place], cell) in twice for place in own)
            expected.append(CROSSING if crossing else own[0] % 6 if own else REST)
        for form in ("cells", "surfaces"):
            look = {"kind": kind, "chosen": chosen, "complex": complex, "form": form}
            assert coloured(session, look, "chosen") == expected


def crossed_twice(truth: Truth, kind: str) -> set[tuple[int, int]]:
    """Sheets and chords with cells that they cross more than once."""
    found: set[tuple[int, int]] = set()
    if kind == "blocks":
        return found
    label: dict[Any, int] = {}
    slow = truth.slow
    classes = slow.sheets() if kind == "sheets" else slow.chords()
    places = ((0, 1), (1, 2), (0, 4)) if kind == "sheets" else ((3, 0, 4, 7), (0, 1, 5, 4), (0, 3, 2, 1))
    for row, cell in zip(truth.rows, slow.cells, strict=True):
        own = [label.setdefault(classes[frozenset(cell[p] for p in ends)], len(label)) for ends in places]
        found |= {(number, row) for number in own if own.count(number) > 1}
    return found


def test_T4_a_sheet_that_crosses_itself_is_there_to_be_coloured() -> None:
    assert crossed_twice(truth_of("structures/self-crossing"), "sheets")


def test_T4_without_things_to_choose_all_is_the_rest() -> None:
    session = session_of("layouts/hoops")
    for kind in ("none", "arcs"):
        assert set(coloured(session, {"kind": kind, "chosen": [0]}, "chosen")) == {REST}


def quantities(truth: Truth) -> dict[str, NDArray[np.float64]]:
    """All quantities of each cell, NaN where there is none."""
    slow, rows = truth.slow, truth.rows
    out = {id: np.full(truth.mesh.cell_count, np.nan) for id in QUANTITIES}
    sheets, blocks = truth.whole["sheets"], truth.whole["blocks"]
    for row in rows:
        own = [cells for cells in sheets if row in cells]
        out["structure:sheets"][row] = len(own)
        out["structure:smallest_sheet"][row] = min(map(len, own))
        (out["structure:block_cells"][row],) = (len(cells) for cells in blocks if row in cells)
    inner = slow.irregular - slow.boundary_edges
    queue = deque(sorted({cell for edge in inner for cell in slow.edge_cells[edge]}))
    distance = dict.fromkeys(queue, 0)
    beside: dict[int, set[int]] = {}
    for around in slow.face_cells.values():
        for cell in around:
            beside.setdefault(cell, set()).update(around)
    while queue:
        cell = queue.popleft()
        for other in beside[cell] - distance.keys():
            distance[other] = distance[cell] + 1
            queue.append(other)
    for cell, steps in distance.items():
        out["structure:distance"][rows[cell]] = steps
    return out


@pytest.mark.parametrize("name", MESHES)
def test_T5_quantities_are_values_colours_histograms_and_statistics(name: str) -> None:
    session, truth = session_of(name), truth_of(name)
    for id, expected in quantities(truth).items():
        assert np.array_equal(session.values(id), expected, equal_nan=True), id
        finite = expected[np.isfinite(expected)]
        low, high = (finite.min(), finite.max()) if len(finite) else (None, None)
        colour = session.update({"colour": {"by": "attribute", "attribute": id}})["colour"]
        assert plain(colour)
        assert (colour["quantity"], colour["low"], colour["high"], colour["high_first"]) == (
            id,
            low,
            high,
            False,
        )
        assert colour["label"] == QUANTITIES[id].name
        if len(finite):
            share = (expected - low) / ((high - low) or 1)
            assert np.allclose(colour["map_position"], share, atol=1e-6, equal_nan=True)
        else:
            assert np.isnan(colour["map_position"]).all()
        told = session.quality(id)
        assert plain(told)
        assert (told["min"], told["max"], told["count"]) == (low, high, len(finite))
        assert told["not_finite"] == len(expected) - len(finite)
        assert told["name"] == QUANTITIES[id].name and told["full_range"] is None
        bins = session.histogram(id, 8)
        assert bins["counts"].sum() == len(finite) and bins["not_finite"] == len(expected) - len(finite)
        assert bins["label"] == QUANTITIES[id].name
        worst = session.worst(id, 5)
        assert worst["values"] == sorted(finite.tolist(), reverse=True)[:5]
        assert [expected[cell] for cell in worst["cells"]] == worst["values"]
        for cell in (0, len(expected) - 1):
            value = session.value(cell, id)
            assert value["value"] == (expected[cell] if np.isfinite(expected[cell]) else None)
            assert value["components"] is None and value["pending"] is False


@pytest.mark.parametrize("name", ["layouts/nodes-of-six", "structures/mixed"])
def test_T5_quantities_are_filtered_by_and_counted_where_shown(name: str) -> None:
    session = session_of(name)
    for id, expected in quantities(truth_of(name)).items():
        finite = expected[np.isfinite(expected)]
        if not len(finite):
            continue
        middle = float(np.median(finite))
        band = {"quantity": id, "keep": "inside", "minimum": middle, "maximum": None}
        checked = session.check({"filters": {"quality": {"items": [band]}}})
        assert checked["rejections"] == []
        update = session.update(checked["partial"])
        assert update["shown_cells"] == np.count_nonzero(expected >= middle)
        assert session.histogram(id, 4, True)["counts"].sum() == np.count_nonzero(finite >= middle)


def test_T5_what_is_no_quantity_is_told() -> None:
    session = session_of("layouts/hoops")
    known = {"colour": {"by": "attribute", "attribute": "structure:distance"}}
    assert session.check(known)["rejections"] == Session().check(known)["rejections"] == []
    for document, path in (
        ({"colour": {"by": "attribute", "attribute": "structure:beauty"}}, "colour.attribute"),
        (
            {"filters": {"quality": {"items": [{"quantity": "structure:beauty"}]}}},
            "filters.quality.items[0].quantity",
        ),
    ):
        checked = session.check(document)
        assert [rejection["path"] for rejection in checked["rejections"]] == [path]
        assert "beauty" not in str(checked["partial"])


def test_T4_the_viewers_palettes_have_as_many_colours_as_the_core_counts() -> None:
    palettes = (VIEWER / "palettes.js").read_text("utf-8")
    chosen = (VIEWER / "structure.js").read_text("utf-8")

    def in_list(text: str, name: str) -> list[str]:
        found = re.search(rf"{name}[:=] ?\[(.*?)\]", text, re.DOTALL)
        return re.findall(r"#\w{6}", found[1]) if found else []

    assert len(in_list(palettes, "block")) == BLOCK_COLOURS
    assert len(in_list(chosen, "CHOSEN ")) == CHOSEN_COLOURS == CHORD_ROWS == CROSSING
    assert f"BASE_ROW = {BASE};" in chosen and f"CHORD_ROW = {CHORDS};" in chosen
