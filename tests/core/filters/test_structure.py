"""Filters by block, sheet and chord (SPEC T5), against the layers of a box and dictionaries of small meshes."""

from __future__ import annotations

from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab.filters import FilterStack
from hexalab.filters.structure import KINDS, hidden_by_structure, traced_of
from hexalab.mesh import Mesh
from hexalab.status import DEFAULTS, merge
from tests.core.filters.boxes import box
from tests.core.structure.members import things

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
MESHES = {
    name: hexalab.read(REPOSITORY / "structures" / f"{name}.mesh")
    for name in ("o-grid", "self-crossing", "mixed", "l-polycube", "collapsed")
}


def stack(mesh: Mesh) -> FilterStack:
    return FilterStack(mesh, lambda id: np.arange(mesh.cell_count, dtype=float))


def shown(mesh: Mesh, **structure: Any) -> set[int]:
    """The cells that the filter leaves, the rest of the settings being the defaults."""
    filters = merge(DEFAULTS["filters"], {"structure": structure})
    return set(np.flatnonzero(stack(mesh).apply(filters)).tolist())


def test_T5_sheets_of_a_box_are_its_layers_and_chords_its_rows() -> None:
    mesh = box(5, 4, 3)
    place = {cell: (cell % 5, cell // 5 % 4, cell // 20) for cell in range(60)}
    layers = {
        tuple(sorted(c for c in place if place[c][axis] == k))
        for axis in range(3)
        for k in range((5, 4, 3)[axis])
    }
    assert {tuple(sorted(shown(mesh, sheets=[sheet]))) for sheet in range(5 + 4 + 3)} == layers
    rows = {
        tuple(sorted(c for c in place if (place[c][a], place[c][b]) == (i, j)))
        for a, b in ((0, 1), (1, 2), (0, 2))
        for i, j in product(range((5, 4, 3)[a]), range((5, 4, 3)[b]))
    }
    assert {tuple(sorted(shown(mesh, chords=[chord]))) for chord in range(20 + 12 + 15)} == rows
    assert shown(mesh, blocks=[0]) == set(place)


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("complex", ["whole", "interior"])
@pytest.mark.parametrize("kind", KINDS)
def test_T5_cells_in_any_of_them_or_in_none(name: str, complex: str, kind: str) -> None:
    mesh = MESHES[name]
    members = things(mesh, complex == "interior")[kind]
    every = set(range(mesh.cell_count))
    for numbers in ([0], [len(members) - 1], [0, len(members) // 2], [*range(len(members))]):
        within = set().union(*(members[number] for number in numbers))
        settings = {kind: numbers, "complex": complex}
        assert shown(mesh, **settings) == within
        assert shown(mesh, keep="outside", **settings) == every - within


def test_T5_several_kinds_together_add_up() -> None:
    mesh = MESHES["o-grid"]
    known = things(mesh)
    within = known["blocks"][1] | known["sheets"][2] | known["sheets"][5] | known["chords"][0]
    assert 0 < len(within) < mesh.cell_count
    wanted = {"blocks": [1], "sheets": [2, 5], "chords": [0]}
    assert shown(mesh, **wanted) == within
    assert shown(mesh, keep="outside", **wanted) == set(range(mesh.cell_count)) - within


def test_T5_cells_that_are_not_traced_are_in_none() -> None:
    mesh = MESHES["mixed"]
    members = things(mesh)["blocks"]
    others = set(np.flatnonzero(mesh.kinds != 0).tolist())
    assert others and not others & set().union(*members)
    assert shown(mesh, blocks=[*range(len(members))]) == set(range(mesh.cell_count)) - others
    assert shown(mesh, blocks=[*range(len(members))], keep="outside") == others


@pytest.mark.parametrize(
    "structure",
    [
        {},
        {"keep": "outside"},
        {"complex": "interior"},
        {"blocks": [], "sheets": [], "chords": []},
        {"enabled": False, "blocks": [0], "sheets": [1]},
    ],
)
def test_T5_empty_lists_and_a_filter_that_is_off_hide_nothing(structure: dict[str, Any]) -> None:
    assert traced_of({**DEFAULTS["filters"]["structure"], **structure}) is None
    assert len(shown(box(3, 2, 2), **structure)) == 12


def test_T5_numbers_that_there_are_not_are_left_out() -> None:
    mesh = MESHES["l-polycube"]
    members = things(mesh)
    assert shown(mesh, sheets=[0, 10**9]) == members["sheets"][0]
    assert shown(mesh, blocks=[len(members["blocks"])]) == set()
    assert shown(mesh, blocks=[len(members["blocks"])], keep="outside") == set(range(mesh.cell_count))


def test_T5_structure_can_be_seen_through_by_itself_and_goes_with_the_others() -> None:
    mesh = MESHES["o-grid"]
    sheet = things(mesh)["sheets"][0]
    filters = merge(
        DEFAULTS["filters"],
        {
            "structure": {"sheets": [0]},
            "planes": {"items": [{"enabled": True, "normal": [0, 0, 1], "offset": 0.5}]},
            "picking": {"hidden": [min(sheet)]},
        },
    )
    filter_stack = stack(mesh)
    every = set(range(mesh.cell_count))
    by = {
        group: set(np.flatnonzero(filter_stack.hidden_by(group, filters)).tolist())
        for group in ("structure", "cut", "picking")
    }
    assert by["structure"] == every - sheet
    assert by["cut"] and by["picking"] == {min(sheet)}
    left = set(np.flatnonzero(filter_stack.apply(filters)).tolist())
    assert left == every - by["structure"] - by["cut"] - by["picking"] and left
    none = filter_stack.hidden_by("structure", DEFAULTS["filters"])
    assert none.shape == (mesh.cell_count,) and not none.any()


def test_T5_what_is_kept_is_never_stale() -> None:
    mesh = MESHES["o-grid"]
    kept = stack(mesh)
    steps: list[dict[str, Any]] = [
        {"sheets": [0]}, {"sheets": [1]}, {"sheets": [1], "keep": "outside"}, {"blocks": [1]},
        {"blocks": [1], "complex": "interior"}, {}, {"chords": [3]}, {"sheets": [0]},
    ]  # fmt: skip
    for step in steps:
        filters = merge(DEFAULTS["filters"], {"structure": step})
        assert set(np.flatnonzero(kept.apply(filters)).tolist()) == shown(mesh, **step)


def test_T5_the_structure_at_hand_is_asked_for_only_when_something_is_chosen() -> None:
    mesh = box(3, 3, 3)
    asked = []

    def structure() -> hexalab.Structure:
        asked.append(1)
        return hexalab.structure(mesh)

    filter_stack = FilterStack(mesh, lambda id: np.zeros(27), structure=structure)
    filter_stack.apply(DEFAULTS["filters"])
    assert not asked
    filters = merge(DEFAULTS["filters"], {"structure": {"sheets": [0]}})
    assert filter_stack.apply(filters).sum() == 9
    filter_stack.apply(filters)
    assert len(asked) == 1


def test_T5_what_is_hidden_is_the_callers() -> None:
    mesh = box(2, 2, 2)
    wanted = traced_of({"sheets": [0]})
    assert wanted
    structure = hexalab.structure(mesh)
    hidden = hidden_by_structure(structure, wanted)
    hidden[:] = True
    assert hidden_by_structure(structure, wanted).sum() == 4
