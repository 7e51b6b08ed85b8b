"""Groups of a deck: hidden, alone, coloured, measured; where they meet; nodes as points (SPEC R12)."""

from __future__ import annotations

import base64
import io
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Locator, Page

import hexalab
from hexalab.hosts.page_scripts import PICTURE

from . import grouped, ui
from .test_ui_page import AXE, violations

SVG = "{http://www.w3.org/2000/svg}"
MATERIALS = ("STEEL", "RUBBER", "GLASS")


@pytest.fixture(scope="module")
def written(shelf: Path) -> hexalab.Mesh:
    return grouped.deck(shelf / "deck.inp")


@pytest.fixture(scope="module")
def opened(chromium: Browser, site: str, written: hexalab.Mesh) -> Iterator[Page]:
    with ui.one_viewer(chromium, site, script=AXE.read_text()) as page:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/deck.inp")
        ui.until(lambda: ui.summary(page).get("findings") is not None)
        ui.unfold(page)
        yield page


@pytest.fixture
def mesh(opened: Page, site: str) -> Page:
    opened.set_viewport_size({"width": 1280, "height": 800})
    if ui.summary(opened).get("name") != "deck.inp":
        opened.evaluate("url => window.hexalab.open(url)", f"{site}/bench/deck.inp")
        ui.until(lambda: ui.summary(opened).get("findings") is not None)
    ui.reset(opened)
    return opened


@pytest.fixture(scope="module")
def rows(written: hexalab.Mesh) -> dict[str, np.ndarray]:
    """Cells of each group, by the name that the panel shows, those of materials as the sections say."""
    sets = grouped.sets(written)
    return {**sets, **{name: sets[f"{name}_CELLS"] for name in MATERIALS}}


def picture(page: Page) -> np.ndarray:
    """What the viewer's own picture has, (h, w, 3): it is a whole one, however busy the machine is."""
    page.evaluate("() => window.hexalab.setStatus({})")
    png = base64.b64decode(
        page.evaluate(PICTURE, {"format": "", "size": {"width": 960, "height": 720}})["data"]
    )
    return np.array(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)


def changed(before: np.ndarray, after: np.ndarray) -> int:
    """Pixels that differ."""
    return int((np.abs(after - before).max(axis=2) > 40).sum())


def box(page: Page, name: str) -> Locator:
    return page.get_by_role("checkbox", name=f"{name} shown", exact=True)


def colours(page: Page) -> dict[str, str]:
    """The squares beside the names in the list of groups."""
    found: dict[str, str] = page.evaluate(
        """() => Object.fromEntries([...document.querySelectorAll("#section-groups .group-list li")]
            .filter((row) => !row.querySelector(".category").hidden)
            .map((row) => [row.querySelector(".group-name").textContent,
                getComputedStyle(row.querySelector(".category")).backgroundColor]))"""
    )
    return found


def test_R12_the_list_has_every_group_with_its_cells(mesh: Page, rows: dict[str, np.ndarray]) -> None:
    heads = mesh.locator("#section-groups .group-list h3").all_inner_texts()
    assert heads == ["Materials", "Element sets", "Sets of nodes, as points"]
    told = mesh.locator("#section-groups .group-list li").evaluate_all(
        """all => all.map((one) => [one.querySelector(".group-name").textContent,
            Number(one.querySelector(".category-count").textContent)])"""
    )
    names = [*MATERIALS, *grouped.sets(grouped.solid())]
    assert told == [*([name, len(rows[name])] for name in names), ["FIXED", 25]]
    assert mesh.locator("#section-groups > summary .digest").text_content() == "8 of cells, 1 of nodes"
    assert mesh.get_by_title(grouped.LONG).first.is_visible()


def test_R12_groups_are_hidden_shown_alone_and_brought_back(mesh: Page, rows: dict[str, np.ndarray]) -> None:
    box(mesh, "STEEL").click()
    assert ui.drawn(mesh)[0] == 128 - 48
    assert mesh.locator(":focus").get_attribute("aria-label") == "STEEL shown", "the focus stays"
    mesh.keyboard.press("Space")
    assert ui.drawn(mesh)[0] == 128
    mesh.keyboard.press("Tab")
    assert mesh.locator(":focus").get_attribute("aria-label") == "Show STEEL only"
    mesh.keyboard.press("Enter")
    assert ui.drawn(mesh)[0] == 48
    assert [box(mesh, name).is_checked() for name in MATERIALS] == [True, False, False]
    box(mesh, "FLANGE").click()
    assert ui.drawn(mesh)[0] == len(np.union1d(rows["STEEL"], rows["FLANGE"])), "sets may overlap"
    mesh.get_by_role("button", name="Undo", exact=True).click()
    mesh.get_by_role("button", name="Undo", exact=True).click()
    assert ui.drawn(mesh)[0] == 128
    assert all(box(mesh, name).is_checked() for name in MATERIALS)
    box(mesh, "GLASS").click()
    box(mesh, grouped.LONG).click()
    hidden = np.union1d(rows["GLASS"], rows[grouped.LONG])
    assert ui.drawn(mesh)[0] == 128 - len(hidden)
    everything = mesh.locator("#section-groups").get_by_role("button", name="Show all", exact=True)
    everything.click()
    assert ui.drawn(mesh)[0] == 128
    assert everything.is_disabled()


def test_R12_groups_are_coloured_neighbours_differ_and_legends_tell_them(mesh: Page) -> None:
    button = mesh.get_by_role("button", name="Colour by Materials", exact=True)
    button.click()
    ui.until(lambda: len(colours(mesh)) == 3)
    assert button.get_attribute("aria-pressed") == "true"
    found = colours(mesh)
    assert len(set(found.values())) == 3, "STEEL meets RUBBER, and RUBBER meets GLASS"
    rgb = {name: [int(part) for part in one[4:-1].split(",")] for name, one in found.items()}
    ui.set_status(mesh, {"lighting": {"mode": "none"}, "separation": {"line_opacity": 0}})
    shot = picture(mesh)
    seen = {name: int((np.abs(shot - one).max(axis=2) < 3).sum()) for name, one in rgb.items()}
    assert min(seen.values()) > 1000, seen
    legend = mesh.get_by_role("list", name="Colours of the groups").locator("li")
    assert [one.split("\n") for one in legend.all_inner_texts()] == [
        ["STEEL", "48"], ["RUBBER", "48"], ["GLASS", "32"]
    ]  # fmt: skip
    ui.set_status(mesh, {"figure": {"unit": "px", "width": 600, "height": 400, "legend": "bar"}})
    svg = ElementTree.fromstring(mesh.evaluate("async () => (await window.hexalab.figure('svg')).text()"))
    words = [(one.text or "").strip() for one in svg.iter(f"{SVG}text")]
    assert words == ["Materials", *MATERIALS]
    fills = {one.get("fill") for one in svg.iter(f"{SVG}rect")}
    assert {"#{:02x}{:02x}{:02x}".format(*one) for one in rgb.values()} <= fills
    mesh.locator("#colour-grouping").select_option("elset")
    ui.until(lambda: len(colours(mesh)) == 5)
    told = mesh.locator("#section-groups .group-part p:visible").first.inner_text()
    assert told == "56 cells in several: coloured by the smallest" or "in several" in told
    mesh.get_by_role("button", name="Colour by Element sets", exact=True).click()
    assert ui.status(mesh)["colour"]["by"] == "sides"
    ui.until(lambda: colours(mesh) == {})


def test_R12_statistics_of_each_group_are_what_numpy_says(
    mesh: Page, written: hexalab.Mesh, rows: dict[str, np.ndarray]
) -> None:
    quality, volume = (hexalab.quality(written, name) for name in ("scaled_jacobian", "volume"))
    lines = mesh.locator(".group-table tbody tr")
    ui.until(lambda: "…" not in lines.first.inner_text())
    ui.set_status(mesh, {"unit": "mm"})
    ui.until(lambda: "Volume (mm³)" in mesh.locator(".group-table thead").inner_text())
    told = {line.split("\t")[0]: line.split("\t")[1:] for line in lines.all_inner_texts()}
    assert list(told) == [*MATERIALS, *grouped.sets(written)]
    for name, (cells, invalid, least, mean, total) in told.items():
        some = rows[name]
        wanted = (quality[some].min(), quality[some].mean(), volume[some].sum())
        assert int(cells) == len(some)
        found = [float(one.replace("−", "-")) for one in (least, mean, total)]
        assert found == pytest.approx(wanted, abs=6e-4), name
        assert (int(invalid) > 0) == bool((quality[some] <= 0).any()), name


def test_R12_interfaces_are_counted_and_drawn_as_a_film(mesh: Page) -> None:
    box(mesh, "RUBBER").click()
    without = picture(mesh)
    mesh.locator("#interfaces").select_option("material")
    listed = mesh.get_by_role("list", name="Interfaces between groups").locator("li")
    ui.until(lambda: listed.count() == 2)
    assert listed.all_text_contents() == ["STEEL | RUBBER16 faces", "RUBBER | GLASS16 faces"]
    assert changed(without, picture(mesh)) > 2000
    assert mesh.locator("#interfaces option").all_inner_texts() == ["none", "of Materials", "of Element sets"]
    mesh.locator("#interfaces").focus()
    mesh.keyboard.press("Home")
    ui.until(lambda: ui.status(mesh)["marks"]["interfaces"] == "")
    assert changed(without, picture(mesh)) == 0
    assert not listed.count()


def test_R12_a_set_of_nodes_is_drawn_as_points(mesh: Page) -> None:
    ui.set_status(mesh, {"camera": {"fit": True, "direction": [1, 0, 0], "up": [0, 0, 1]}})
    without = picture(mesh)
    points = mesh.get_by_role("checkbox", name="FIXED drawn as points", exact=True)
    points.focus()
    points.press("Space")
    with_points = picture(mesh)
    disc = np.pi / 4 * 8**2
    assert 0.5 * 25 * disc < changed(without, with_points) < 1.3 * 25 * disc
    points.click()
    assert changed(without, picture(mesh)) == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
def test_V8_axe_finds_nothing_among_groups(mesh: Page, scheme: Any, size: tuple[int, int]) -> None:
    mesh.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    mesh.set_viewport_size({"width": size[0], "height": size[1]})
    ui.set_status(
        mesh, {"colour": {"by": "group"}, "marks": {"interfaces": "material", "nodes": ["nset:FIXED"]}}
    )
    ui.until(lambda: mesh.get_by_role("list", name="Interfaces between groups").locator("li").count())
    assert violations(mesh) == []
    assert mesh.evaluate("() => document.documentElement.scrollWidth") == size[0]


def test_V8_what_is_used_most_stands_without_scrolling_with_groups_too(
    mesh: Page, chromium: Browser, site: str
) -> None:
    with ui.one_viewer(chromium, site) as page:
        page.evaluate("url => window.hexalab.open(url)", f"{site}/bench/deck.inp")
        ui.until(lambda: page.locator("#section-groups").is_visible())
        ui.until(lambda: ui.summary(page).get("findings") is not None)
        for control in ("#slice", "#separation", "#metric"):
            found = page.locator(control).bounding_box()
            assert found and found["y"] + found["height"] <= 800, control


def test_R12_another_mesh_shows_all_its_groups_and_no_marks_of_the_last(
    mesh: Page, site: str, shelf: Path
) -> None:
    box(mesh, "STEEL").click()
    ui.set_status(
        mesh,
        {
            "colour": {"by": "group", "grouping": "elset"},
            "marks": {"nodes": ["nset:FIXED"], "interfaces": "material"},
        },
    )
    ui.until(lambda: mesh.get_by_role("list", name="Interfaces between groups").locator("li").count())
    written = grouped.featured(shelf / "featured.vtu")
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/featured.vtu")
    ui.until(lambda: ui.summary(mesh).get("findings") is not None)
    names = mesh.locator("#section-groups .group-list .group-name").all_text_contents()
    assert names == [grouped.MARKUP, "EMPTY"], "a name is text"
    assert mesh.evaluate("() => window.broken") is None
    assert box(mesh, "EMPTY").is_disabled()
    assert ui.drawn(mesh)[0] == written.cell_count
    marks = ui.status(mesh)["marks"]
    assert (marks["nodes"], marks["interfaces"], marks["hidden"]) == ([], "", [])
    assert mesh.get_by_role("list", name="Interfaces between groups").locator("li").count() == 0
    hexalab.write(hexalab.Mesh.from_cells(written.points, written.cells), shelf / "bare.mesh")
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/bare.mesh")
    ui.until(lambda: not mesh.locator("#section-groups").is_visible())


def test_P2_a_thousand_groups_keep_their_rows_and_one_is_found_by_its_name(
    mesh: Page, site: str, shelf: Path
) -> None:
    random = np.random.default_rng(1)
    solid = grouped.solid()
    many = tuple(
        hexalab.Group(f"SET_{k:04}", "elset", random.choice(solid.cell_count, 5, replace=False))
        for k in range(1000)
    )
    hexalab.write(
        hexalab.Mesh(solid.coordinates, solid.corners, solid.kinds, groups=many), shelf / "many.inp"
    )
    mesh.evaluate("url => window.hexalab.open(url)", f"{site}/bench/many.inp")
    ui.until(lambda: mesh.locator("#section-groups .group-list li").count() == 1000)
    mesh.evaluate("() => { window.firstRow = document.querySelector('#section-groups .group-list li'); }")
    box(mesh, "SET_0000").click()
    assert ui.drawn(mesh)[0] == 123
    assert mesh.evaluate("() => window.firstRow === document.querySelector('#section-groups .group-list li')")
    find = mesh.get_by_role("searchbox", name="Find a group by its name")
    find.fill("set_074")
    assert mesh.locator("#section-groups .group-list li:visible").count() == 10
    mesh.get_by_role("button", name="Show SET_0742 only", exact=True).click()
    assert ui.drawn(mesh)[0] == 5
    find.fill("nothing")
    assert mesh.get_by_text("No group has “nothing” in its name.").is_visible()
