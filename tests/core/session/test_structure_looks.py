"""Looking at the structure (SPEC T4): what an update draws under all combinations of settings, against dictionaries."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from hexalab.session import Session, looking
from tests.core.session.checks import plain
from tests.core.session.looks import (
    MESHES,
    NOWHERE,
    PLAIN,
    Screen,
    Settings,
    all_looks,
    mesh_of,
    session_of,
    truth_of,
)

MATTERS = ("kind", "chosen", "form", "complex", "boundary", "curves", "explode")


def check(screen: Screen, name: str, look: Settings, shown: np.ndarray, silhouette: bool = True) -> None:
    """Hold what is on the screen against what should be."""
    truth = truth_of(name)
    solid = truth.solid(look, shown)
    if look["kind"] in ("sheets", "blocks") and look["form"] == "surfaces":
        assert screen.faces("surface") == truth.within(look, shown)
        assert screen.records["surface"]["two_sided"]
    else:
        assert screen.faces("surface") == truth.around(solid, look)
        assert not screen.records["surface"]["two_sided"]
    assert screen.faces("see_through") == truth.around(shown & ~solid, look)
    assert screen.lines() == truth.curve_count(look, shown)


@pytest.mark.parametrize("name", MESHES)
def test_T4_every_combination_draws_each_shown_cell_once_whole_or_faint(name: str) -> None:
    screen = Screen(session_of(name))
    truth = truth_of(name)
    every = np.ones(truth.mesh.cell_count, bool)
    known: dict[Any, tuple[list[int], list[int], int]] = {}
    for look in all_looks(truth.mesh):
        screen.update({"structure": look})
        key = tuple(str(look[part]) for part in matters(look))
        if (
            key not in known
        ):  # dictionaries are slow, and much of the settings doesn't matter to much of the rest
            check(screen, name, look, every)
            known[key] = screen.faces("surface"), screen.faces("see_through"), screen.lines()
        assert (screen.faces("surface"), screen.faces("see_through"), screen.lines()) == known[key]


def matters(look: Settings) -> tuple[str, ...]:
    """Settings that matter, by the words of the schema."""
    kind = look["kind"]
    return (
        "kind", "curves",
        *(("chosen",) if kind != "none" else ()),
        *(("form",) if kind in ("sheets", "chords", "blocks") else ()),
        *(("complex",) if kind == "blocks" or look["curves"] else ()),
        *(("boundary",) if kind == "arcs" else ()),
        *(("explode",) if kind == "blocks" else ()),
    )  # fmt: skip


@pytest.mark.parametrize("name", MESHES)
def test_T4_nothing_is_sent_twice_and_steps_add_up(name: str) -> None:
    looks = list(all_looks(truth_of(name).mesh))
    steps = np.random.default_rng(5).permutation(len(looks))[:40].tolist()
    screen = Screen(session_of(name))
    for step in steps:
        screen.update({"structure": looks[step], "colour": {"by": ("block", "chosen", "sides")[step % 3]}})
        assert screen.update({"structure": dict(looks[step])}) == set()
    afresh = Screen(session_of(name))
    afresh.update({"structure": looks[step], "colour": {"by": ("block", "chosen", "sides")[step % 3]}})
    for record in ("surface", "colour", "silhouette"):
        same(screen.records[record], afresh.records[record])
    for record in ("see_through", "curves"):
        if record in afresh.records:
            same(screen.records[record], afresh.records[record])
        else:
            assert all(
                not len(part) for part in screen.records[record].values() if isinstance(part, np.ndarray)
            )


def same(one: Any, other: Any) -> None:
    """Whether two records are alike to the last bit."""
    if one is None or other is None:
        assert one is other
        return
    assert one.keys() == other.keys()
    for part in one:
        assert np.array_equal(
            one[part],
            other[part],
            equal_nan=isinstance(one[part], np.ndarray) and one[part].dtype.kind == "f",
        ), part


@pytest.fixture
def screen() -> Screen:
    """A sphere's layout: seven blocks and more, nodes inside."""
    return Screen(session_of("layouts/nodes-of-six"))


def test_T4_what_is_switched_off_is_sent_empty_once(screen: Screen) -> None:
    assert screen.update() == {"surface", "silhouette", "colour"}
    assert screen.update({"structure": {"kind": "sheets", "chosen": [1], "curves": True}}) == {
        "surface", "see_through", "curves",
    }  # fmt: skip
    assert screen.update({"structure": {"kind": "none"}}) == {"surface", "see_through"}
    assert screen.faces("see_through") == [] and screen.lines() > 0
    assert screen.update({"structure": {"curves": False}}) == {"curves"}
    assert screen.lines() == len(screen.records["curves"]["points"]) == 0
    assert screen.update({"structure": {"complex": "interior"}}) == set()
    assert screen.update({"structure": {"kind": "arcs"}}) == {"surface", "see_through", "curves"}
    assert screen.update({"structure": {"kind": "none"}}) == {"surface", "see_through", "curves"}
    assert screen.update() == set()


def test_T4_only_what_is_drawn_otherwise_is_sent(screen: Screen) -> None:
    screen.update({"colour": {"by": "block"}})
    look = lambda **part: screen.update({"structure": part})  # noqa: E731
    assert look(kind="sheets") == set(), "all sheets as cells are all cells"
    assert look(boundary=True) == set()
    assert look(complex="interior") == {"colour"}
    assert look(complex="whole") == {"colour"}
    assert look(kind="arcs") == {"surface", "see_through", "curves"}
    assert look(chosen=[2]) == {"curves"}
    assert look(chosen=[], boundary=False) == {"curves"}
    assert look(kind="chords", form="surfaces") == {"curves"}
    assert look(curves=True) == {"curves"} == look(curves=False)
    assert look(chosen=[5, 7]) == {"curves"}
    assert look(kind="sheets") == {"surface", "curves"}, "what is faint stays as it is"
    assert look(chosen=[1]) == {"surface"}
    assert look(form="cells") == {"surface", "see_through"}
    assert look(kind="blocks") == {"surface", "see_through"}
    assert look(explode=0.5) == {"surface", "see_through", "silhouette"}
    assert look(curves=True) == {"curves"}
    assert look(kind="sheets", explode=0) >= {"surface"}
    assert look(chosen=[3]) == {"surface", "see_through"}, "the base complex stays where it is"
    assert look(kind="blocks", explode=0.5) >= {"curves"}
    assert look(explode=0.75) == {"surface", "see_through", "silhouette", "curves"}
    screen.update({"colour": {"by": "chosen"}})
    assert look(explode=0.25) == {"surface", "see_through", "silhouette", "curves"}
    assert look(chosen=[2]) >= {"colour", "surface"}


def test_T4_numbers_that_there_are_not_are_left_out(screen: Screen) -> None:
    for kind in ("arcs", "sheets", "chords", "blocks"):
        for form in ("cells", "surfaces"):
            some = {"kind": kind, "form": form, "chosen": [1]}
            screen.update({"structure": some, "colour": {"by": "chosen"}})
            before = dict(screen.records)
            screen.update({"structure": {**some, "chosen": [1, NOWHERE, 2**40]}})
            for record in ("surface", "see_through", "curves", "colour"):
                if record in before:
                    same(before[record], screen.records[record])
            screen.update({"structure": {**some, "chosen": [NOWHERE]}})
            assert screen.faces("surface") == []
            faint = screen.records["curves"]["edge_faint"] if kind == "arcs" else np.empty(0)
            assert faint.all()


def test_T4_slices_and_filters_go_with_what_is_looked_at(screen: Screen) -> None:
    name = "layouts/nodes-of-six"
    mesh = truth_of(name).mesh
    half = {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": 0.5}]}}
    screen.update({"filters": half})
    shown = np.zeros(mesh.cell_count, bool)
    x = mesh.barycentres[0]
    shown[x >= (x.min() + x.max()) / 2] = True
    assert 0 < shown.sum() < mesh.cell_count
    for look in (
        {"kind": "sheets", "chosen": [2, 3]}, {"kind": "sheets", "form": "surfaces", "chosen": []},
        {"kind": "blocks", "form": "surfaces", "chosen": [1]}, {"kind": "blocks", "explode": 1, "form": "cells"},
        {"kind": "chords", "form": "surfaces", "chosen": [0, 1, 40]}, {"kind": "chords", "form": "cells"},
        {"kind": "arcs", "chosen": []},
    ):  # fmt: skip
        whole = {**PLAIN, **look}
        screen.update({"structure": whole})
        check(screen, name, whole, shown)
    only = {"structure": {"kind": "sheets", "form": "cells", "chosen": [2]}}
    screen.update({**only, "filters": {"structure": {"blocks": [0, 1, 2], "keep": "outside"}}})
    shown &= ~truth_of(name).mask("blocks", [0, 1, 2], "whole")
    check(screen, name, {**PLAIN, **only["structure"]}, shown)
    screen.update({"filters": {"picking": {"hidden": np.flatnonzero(shown)[:1].tolist()}}})
    shown[np.flatnonzero(shown)[0]] = False
    check(screen, name, {**PLAIN, **only["structure"]}, shown)


def test_T4_hidden_cells_are_seen_through_beside_what_is_faint(screen: Screen) -> None:
    name = "layouts/nodes-of-six"
    truth = truth_of(name)
    every = np.ones(truth.mesh.cell_count, bool)
    hidden = truth.mask("blocks", [0, 5], "whole")
    look = {**PLAIN, "kind": "sheets", "chosen": [3]}
    filters = {"structure": {"blocks": [0, 5], "keep": "outside"}, "picking": {"hidden": [150]}}
    every[150] = False
    for cells, seen in (("none", ~every & False), ("structure", hidden), ("all", hidden | ~every)):
        screen.update({"structure": look, "filters": filters, "see_through": {"cells": cells}})
        shown = every & ~hidden
        solid = truth.solid(look, shown)
        assert screen.faces("surface") == truth.around(solid, look)
        assert screen.faces("see_through") == truth.around((shown & ~solid) | seen, look)


def test_T4_lean_updates_bring_the_surface_and_the_next_one_the_rest(screen: Screen) -> None:
    screen.update()
    look = {"kind": "blocks", "chosen": [1, 4], "explode": 0.5, "curves": True}
    assert screen.update({"structure": look}, lean=True) == {"surface"}
    assert len(screen.records["surface"]["edges"]) == 0
    assert screen.update() == {"surface", "silhouette", "see_through", "curves"}
    afresh = Screen(session_of("layouts/nodes-of-six"))
    afresh.update({"structure": look})
    for record in afresh.records:
        same(screen.records[record], afresh.records[record])
    assert screen.update({"structure": {"kind": "sheets", "form": "surfaces"}}, lean=True) == {"surface"}
    dual = screen.records["surface"]
    assert screen.update() >= {"silhouette", "see_through", "curves"}
    assert len(screen.records["surface"]["faces"]) == len(dual["faces"])


def test_T4_every_record_comes_when_the_whole_is_asked_for(screen: Screen) -> None:
    look = {"kind": "blocks", "chosen": [1, 4], "explode": 0.5, "curves": True}
    screen.update({"structure": look})
    before = dict(screen.records)
    assert screen.update(whole=True) == {
        "surface", "silhouette", "see_through", "curves", "marks", "colour",
    }  # fmt: skip
    for record in before:
        same(before[record], screen.records[record])
    assert screen.update() == set()


def test_T4_records_hold_what_may_leave_through_the_door(screen: Screen) -> None:
    for kind in ("arcs", "sheets", "chords", "blocks"):
        for form in ("cells", "surfaces"):
            look = {"kind": kind, "form": form, "chosen": [1], "curves": True, "explode": 0.5}
            assert plain(screen.session.update({"structure": look, "colour": {"by": "chosen"}}, whole=True))


@pytest.mark.parametrize("mode", ["lines", "darkness_coded_edges", "fissure", "rounded"])
def test_T4_all_separation_modes_draw_blocks_apart_and_what_is_chosen(screen: Screen, mode: str) -> None:
    name = "layouts/nodes-of-six"
    truth = truth_of(name)
    look = {**PLAIN, "kind": "blocks", "chosen": [1, 2, 3, 8], "explode": 0.5}
    screen.update({"structure": look, "separation": {"mode": mode}})
    every = np.ones(truth.mesh.cell_count, bool)
    exposed = set(truth.around(truth.solid(look, every), look))
    found = set(screen.faces("surface"))
    assert exposed <= found and screen.records["surface"]["mode"] == mode
    if mode in ("lines", "darkness_coded_edges"):
        assert exposed == found
    assert screen.records["see_through"]["mode"] == "lines"
    screen.update({"structure": {"form": "surfaces"}})
    assert screen.records["surface"]["two_sided"]


def test_T4_only_what_is_drawn_as_cells_has_arrows(attributed: bytes) -> None:
    session = Session()
    session.open("grid.vtk", attributed)

    def arrows(look: Settings) -> Any:
        changed = {"structure": look, "arrows": {"attribute": "point:flow"}}
        return session.update(changed, whole=True)["arrows"]

    one = arrows({"kind": "sheets", "chosen": [0]})
    assert set(one["cells"].tolist()) == {0, 3}, "the layer at x = 0"
    assert len(arrows({"kind": "sheets", "form": "surfaces"})["cells"]) == 0
    assert set(arrows({"kind": "none"})["cells"].tolist()) == set(range(6))


def test_T4_arrows_of_vertices_go_with_blocks_that_are_drawn_apart() -> None:
    bare = mesh_of("structures/l-polycube")
    mesh = replace(bare, point_data={"flow": bare.points - bare.points.mean(axis=0)})
    session = Session({"flow": lambda: mesh})
    session.open_offered("flow")
    arrows = {"arrows": {"attribute": "point:flow"}}
    before = session.update(arrows)["arrows"]
    apart = session.update({"structure": {"kind": "blocks", "explode": 1}})["arrows"]
    frame = session._open_mesh().drawn_mesh.frame
    for found, share in ((before, 0), (apart, 1)):
        views = {cell: session.cell_view(cell)["centre"] for cell in set(found["cells"].tolist())}
        plain_views = {cell: mesh.barycentres[:, cell] for cell in views}
        moved = np.array(
            [
                share * (np.array(views[c]) - (plain_views[c] - frame.centre) / frame.diagonal)
                for c in found["cells"]
            ]
        )
        places = (found["positions"].reshape(-1, 3) - moved) * frame.diagonal + frame.centre
        expected = (places - bare.points.mean(axis=0)) / found["longest"]
        assert np.allclose(found["vectors"].reshape(-1, 3), expected, atol=1e-5)
    assert len(apart["cells"]) > len(before["cells"]), "between blocks there are faces now"


def test_T4_a_slice_sends_no_curves_but_chords(screen: Screen) -> None:
    screen.update({"structure": {"kind": "arcs", "curves": True}})
    plane = {"enabled": True, "normal": [1, 0, 0]}
    for offset, form in ((0.3, "cells"), (0.5, "surfaces")):
        came = screen.update({"filters": {"planes": {"items": [{**plane, "offset": offset}]}}})
        assert ("curves" in came) == (form == "surfaces")
        screen.update({"structure": {"kind": "chords", "form": "surfaces"}})


def test_P2_nothing_is_traced_before_structure_is_looked_at(screen: Screen) -> None:
    opened = lambda: set(vars(screen.session._open_mesh()))  # noqa: E731
    screen.update({"colour": {"by": "quality"}, "filters": {"peel": {"depth": 1}}})
    screen.update({"structure": {"chosen": [3], "explode": 0.5, "complex": "interior"}}, whole=True)
    screen.session.inspect(0)
    screen.session.cell_view(0)
    assert not {"traced", "onlooker"} & opened()
    screen.update({"structure": {"curves": True}})
    assert {"traced", "onlooker"} <= opened()


@pytest.mark.parametrize("kind", ["sheets", "chords"])
def test_T4_all_at_once_are_drawn_of_so_many_cells_and_no_more(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = session_of("layouts/nodes-of-six")
    cells = session.update()["shown_cells"]

    def drawn(chosen: list[int], most: int) -> int:
        monkeypatch.setattr(looking, "MOST_AT_ONCE", most)
        session.update({"structure": {"kind": "none"}})
        records = session.update({"structure": {"kind": kind, "form": "surfaces", "chosen": chosen}})
        return len(records["surface"]["faces"]) + len(
            records["curves"]["edge_rows"] if "curves" in records else ()
        )

    assert drawn([], cells) == (2 * 3 if kind == "sheets" else 3) * cells
    assert drawn([], cells - 1) == 0
    assert drawn([0], cells - 1) > 0, "what is chosen is drawn of any mesh"
