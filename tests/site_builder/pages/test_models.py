"""Pages of bodies that several sources mesh: the table, what is best in it, and the same for programs and papers."""

import csv
import dataclasses

import pytest

from site_builder.model.facts import Facts
from site_builder.pages.bodies import bodies
from site_builder.pages.model_csv import HEADS
from site_builder.pages.model_table import COLUMNS, latex, rows
from site_builder.reading.models import read_models
from site_builder.reading.repository import read_repository

from .test_pages import Page


@pytest.fixture(scope="module")
def page(site):
    return Page((site / "models/pair/index.html").read_text("utf-8"))


def table(site):
    return list(csv.DictReader((site / "models/pair/pair.csv").read_text("utf-8").splitlines()))


def test_C2_a_body_has_a_page_with_its_meshes_side_by_side(page):
    assert "A pair of cubes" in page.text
    assert (
        "3 meshes of 2 sources of the years 2021 to 2024. Somebody put two cubes side by side." in page.text
    )
    assert [a["data-mesh"] for tag, a in page.elements if tag == "tr" and "data-mesh" in a] == [
        "small/pair",
        "far/one-folder-first",
        "far/second",
    ]
    links = [a["href"] for tag, a in page.elements if tag == "a"]
    assert "../../sources/far/one-folder-first/index.html" in links
    assert "../../viewer/index.html?mesh=far/one-folder-first&with=small/pair" in links
    assert "../../viewer/index.html?mesh=small/pair&with=far/one-folder-first" in links
    assert "../../viewer/index.html?mesh=far/second" in links, "what fills something else has no rival"
    assert "the box around the body" in page.text


def test_C2_the_table_for_programs_has_all_metrics(site):
    first, other, box = table(site)
    assert list(first) == list(HEADS)
    assert (first["mesh"], first["method"], first["cells"], first["valid"]) == ("small/pair", "", "2", "2")
    assert float(first["scaled_jacobian.min"]) == pytest.approx(1)
    assert float(first["oddy.max"]) == pytest.approx(0)
    assert first["file"] == "https://meshes.example.org/hex/meshes/small/pair.mesh"
    assert (other["method"], other["scaled_jacobian.min"], other["blocks"]) == ("polycube", "", "")
    assert (box["domain"], box["cells"]) == ("box", "4200")


def test_C2_all_bodies_are_listed(site):
    page = Page((site / "models/index.html").read_text("utf-8"))
    assert "A pair of cubes" in page.text
    assert "3 meshes, 2 sources" in page.text


def facts(low, cells=10, counts=None):
    return Facts(
        cells=cells,
        vertices=20,
        sj_min=low,
        sj_mean=0.9,
        sj_max=1.0,
        interior_edge_valence={3: 8, 4: 2},
        histogram={"low": -1.0, "high": 1.0, "counts": counts or [0] * 60},
    )


@pytest.fixture
def body(demo, edit):
    """A body with two meshes that fill it, one of them in two formats, and one of the box around it."""
    again = {"url": "first.vtk", "same_as": "one-folder-first"}
    edit(demo / "far" / "source.yaml", lambda data: data["meshes"].append(again))
    catalogue = read_repository(demo)
    read_models(catalogue)
    assert [str(problem) for problem in catalogue.errors] == []
    return bodies(catalogue)["pair"]


def test_C2_a_mesh_in_another_format_is_left_out_and_counted(body):
    assert [mesh.id for mesh in body.meshes] == ["far/one-folder-first", "small/pair", "far/second"]
    assert body.left_out == 1


def column(found, head):
    place = [column.head for column in COLUMNS].index(head)
    return [(cells[place].text, cells[place].best) for _, cells in found]


def test_C2_the_best_of_a_column_is_marked_by_its_direction(body):
    first, second = body.filling
    first.facts, second.facts = facts(0.25), facts(-0.5)
    second.facts.interior_edge_valence = {3: 4, 4: 2}
    found = rows(body.filling)
    assert column(found, "min SJ") == [("0.250", True), ("−0.500", False)]
    assert column(found, "Irregular") == [("8", False), ("4", True)]
    assert column(found, "mean SJ") == [("0.900", False), ("0.900", False)], (
        "where all are alike none is best"
    )
    assert not any(best for _, best in column(found, "Cells")), "fewer cells are neither better nor worse"
    assert not any(cell.best for _, cells in rows(body.filling, compared=False) for cell in cells)


def test_C2_an_invalid_mesh_is_best_in_nothing(body):
    first, second = body.filling
    first.facts, second.facts = facts(0.25), facts(-0.5)
    second.facts.interior_edge_valence = {3: 4, 4: 2}
    second.facts.validity = {"valid": 9, "invalid": 1, "undecided": 0}
    assert [best for _, best in column(rows(body.filling), "Irregular")] == [False, False], (
        "a single mesh that counts has no rival"
    )
    third = dataclasses.replace(first, facts=facts(0.2))
    third.facts.interior_edge_valence = {3: 6, 4: 2}
    found = column(rows([first, second, third]), "Irregular")
    assert found == [("8", False), ("4", False), ("6", True)]


def test_C2_the_share_of_bad_cells_is_read_where_bins_end(body):
    (first, second), counts = body.filling, [0] * 60
    counts[38], counts[39] = 3, 7  # below 0.3, and from there on
    first.facts, second.facts = facts(0.28, counts=counts), facts(0.5)
    second.facts.histogram["counts"] = [0] * 7
    assert column(rows(body.filling), "SJ < 0.3") == [("30.0 %", False), ("–", False)]


def test_C2_a_table_for_latex_has_what_tex_needs(body):
    first, second = body.filling
    first.facts, second.facts = facts(0.25), facts(-0.5)
    first.name = "fig_7 & more"
    text = latex(body)
    assert r"fig\_7 \& more & \cite{far} & 10 & 20 & \textbf{0.250} & 0.900" in text
    assert "$-$0.500" in text
    assert r"SJ $<$ 0.3" in text
    assert text.count(r"\\") == 1 + len(body.filling)


def test_C2_a_metric_is_chosen_among_those_without_a_unit(page):
    options = [a["value"] for tag, a in page.elements if tag == "option"]
    assert "scaled_jacobian" in options
    assert not {"volume", "jacobian", "characteristic_length"} & set(options)


def test_C3_pages_of_bodies_are_in_the_sitemap(site):
    assert "<loc>https://meshes.example.org/hex/models/pair/</loc>" in (site / "sitemap.xml").read_text(
        "utf-8"
    )
