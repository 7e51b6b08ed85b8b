"""Pages of published meshes and their sources: whose what is, what belongs together, and what weighs nothing."""

import re
import shutil

import pytest

from site_builder import build
from site_builder.model.catalogue import MeshEntry
from site_builder.pages.compact import compact
from site_builder.pages.mesh_page import mesh_values
from site_builder.pages.source_page import STRIP, strip
from site_builder.pages.words import breakable
from site_builder.reading.repository import read_repository

from ..conftest import DEMO
from .test_pages import Page


@pytest.fixture(scope="module")
def grown(tmp_path_factory):
    """The demo with a mesh in a second format, and pictures of six meshes."""
    root = tmp_path_factory.mktemp("grown")
    shutil.copytree(DEMO, root / "repository", ignore=shutil.ignore_patterns("__pycache__"))
    source = root / "repository" / "far" / "source.yaml"
    text = source.read_text("utf-8")
    rows = "  - url: one%20folder/first.vtk\n    slug: one-folder-first-vtk\n    same_as: one-folder-first\n"
    rows += "".join(f"  - url: more_{number}.vtk\n" for number in range(5))
    source.write_text(text.replace("method: polycube", f"{rows}method: polycube"), "utf-8")
    (source.parent / "pictures").mkdir()
    for slug in ("one-folder-first", *(f"more-{number}" for number in range(5))):
        (source.parent / "pictures" / f"{slug}.webp").write_bytes(b"RIFF\x04\0\0\0WEBP")
    build(root / "repository", root / "site", strict=True, runtime=False)
    return root / "site"


def page_of(site, address):
    return Page((site / "sources" / address / "index.html").read_text("utf-8"))


def links_of(page):
    return [attributes.get("href") for tag, attributes in page.elements if tag == "a"]


OWN_WORK = "Picture and measurements are HexaLab’s own, of the authors’ mesh."


def test_C8_a_mesh_names_its_body_its_method_and_whose_its_numbers_are(site):
    page = page_of(site, "far/one-folder-first")
    assert "../../../models/pair/index.html" in links_of(page)
    assert "A pair of cubes, 3 meshes side by side" in page.text
    assert "polycube" in page.text
    assert OWN_WORK in page.text
    assert OWN_WORK not in page_of(site, "far/second").text, "nobody has measured it"
    assert OWN_WORK not in page_of(site, "small/pair").text, "it is our own anyway"
    assert "the box around the body" in page_of(site, "far/second").text


def test_C8_a_mesh_in_two_formats_is_one_mesh(grown):
    first, copy = page_of(grown, "far/one-folder-first"), page_of(grown, "far/one-folder-first-vtk")
    assert "../../../sources/far/one-folder-first-vtk/index.html" in links_of(first)
    assert "../../../sources/far/one-folder-first/index.html" in links_of(copy)
    source = page_of(grown, "far")
    assert "7 meshes" in source.text
    assert "1 file holds a mesh of this list in another format" in " ".join(source.text.split())
    cards = [a for tag, a in source.elements if tag == "li" and a.get("class") == "card"]
    assert len(cards) == 7
    assert any((href or "").endswith("one%20folder/first.vtk") for href in links_of(source))


def test_C8_a_source_opens_with_a_strip_of_portraits(grown, site):
    page = page_of(grown, "far")
    assert sum(a.get("class") == "strip" for _, a in page.elements) == 1
    assert "Pictures and measurements are HexaLab’s own, of the authors’ meshes." in page.text
    assert not any(a.get("class") == "strip" for _, a in page_of(site, "small").elements)


def test_C8_a_strip_has_one_mesh_of_each_model(demo):
    source = read_repository(demo).sources[0]
    meshes = [
        MeshEntry(source, f"m{number}", f"m{number}", "url", "a.vtk", "a.vtk", model=model)
        for number, model in enumerate(["bunny", "bunny", "", "", "hand", "bunny", *[""] * 20])
    ]
    assert [mesh.slug for mesh in strip(meshes)][:4] == ["m0", "m2", "m3", "m4"]
    assert len(strip(meshes)) == STRIP


def test_C8_what_a_file_groups_and_marks_is_counted(demo):
    mesh = read_repository(demo).meshes[0]
    mesh.facts.groups = [
        {"id": "material:1", "name": "1", "kind": "cells", "origin": "material", "number": 1, "count": 8},
        {"id": "set:a", "name": "a", "kind": "vertices", "origin": "set", "number": None, "count": 3},
    ]
    edge = {"id": "curve:5", "name": "5", "origin": "curve", "number": 5, "count": 4}
    mesh.facts.features = {"edges": {"count": 6, "lost": 2, "groups": [edge]}}
    tallies = mesh_values(mesh)["groups"]
    assert [(tally.caption, tally.rows) for tally in tallies] == [
        ("Groups of cells", [("material 1", [8])]),
        ("Groups of vertices", [("a (set)", [3])]),
        ("Marked as features", [("edges", [6, 2])]),
        ("Groups of marked edges", [("curve 5", [4])]),
    ]


def test_C8_a_column_of_nothing_is_left_out(demo):
    mesh = read_repository(demo).meshes[0]
    row = {"min": 0.0, "max": 1.0, "mean": 0.5, "median": 0.5, "variance": 0.1, "outside_acceptable": 0}
    mesh.facts.quality = {"shape": {**row, "not_finite": 0}, "skew": {**row, "not_finite": 0}}
    assert mesh_values(mesh)["some_not_finite"] is False
    mesh.facts.quality["skew"]["not_finite"] = 3
    assert mesh_values(mesh)["some_not_finite"] is True


def test_C8_pages_carry_no_indentation(site):
    text = (site / "sources/small/pair/index.html").read_text("utf-8")
    between = re.sub(r"<pre.*?</pre>", "…", text, flags=re.DOTALL)
    assert "…" in between
    assert not re.search(r"\n\s", between)
    assert compact("<p>\n  one\n\n  two</p>\n") == "<p>\none\ntwo</p>\n"
    kept = "<pre>a\n  b</pre>\n<textarea>\n c</textarea>"
    assert compact(kept) == kept


@pytest.mark.parametrize(
    ("name", "broken"),
    [
        ("a / Part_1.hh.sat_polycut", "a / Part_<wbr>1.<wbr>hh.<wbr>sat_<wbr>polycut"),
        ("a_b<c", "a_<wbr>b&lt;c"),
        ("x__y.", "x__<wbr>y."),
    ],
)
def test_C8_names_break_after_their_marks(name, broken):
    assert breakable(name) == broken
