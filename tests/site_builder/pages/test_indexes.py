"""The indexes for machines: the viewer's, ours, the original's, the search's."""

import hashlib
import json

import pytest

from hexalab import catalogue
from hexalab.formats import read_bytes
from hexalab.packing import unpack
from site_builder.pages.facets import FACETS
from site_builder.pages.indexes import catalogue_json
from site_builder.reading.repository import read_repository


def load(site, name):
    return json.loads((site / name).read_text("utf-8"))


def test_C4_the_viewers_index(site):
    sources = load(site, "catalogue.json")["sources"]
    small, far = sources
    assert far["authors"] == ["Ana María Núñez", "J. van der Berg", "Wei Li"]
    assert (far["year"], far["doi"]) == (2021, "10.5555/meshes.2021.7")
    assert far["pdf"] == "https://meshes.example.org/paper.pdf"
    first, second = far["meshes"]
    assert first["remote"] is True
    assert first["url"] == "https://meshes.example.org/data%20sets/far/one%20folder/first.mesh"
    assert first["cells"] == 844
    assert second["bytes"] is None
    for mesh in small["meshes"]:
        assert mesh["remote"] is False
        data = (site / mesh["url"]).read_bytes()
        assert hashlib.sha256(data).hexdigest() == mesh["sha256"]
        assert len(data) == mesh["bytes"]
        assert read_bytes(data, mesh["url"]).cell_count == mesh["cells"]


def test_O2_meshes_here_have_a_preview(site):
    for mesh in load(site, "catalogue.json")["sources"][0]["meshes"]:
        preview = unpack((site / mesh["preview"]).read_bytes())
        assert preview


def test_C8_meshes_elsewhere_have_a_picture_where_there_is_one(demo):
    catalogue = read_repository(demo)
    pictures = {mesh.picture_address for mesh in catalogue.meshes} - {"pictures/far/second.webp"}
    small, far = json.loads(catalogue_json(catalogue, set(), pictures))["sources"]
    assert [mesh.get("picture") for mesh in far["meshes"]] == ["pictures/far/one-folder-first.webp", None]
    assert not any("picture" in mesh for mesh in small["meshes"])


def test_C3_our_index_has_a_version_and_all_facts(site):
    index = load(site, "index.json")
    assert index["version"] == catalogue.VERSION == 2
    assert index["url"] == "https://meshes.example.org/hex/"
    mesh = index["sources"][0]["meshes"][0]
    assert mesh["facts"]["quality"]["scaled_jacobian"]["min"] == pytest.approx(1)
    assert mesh["facts"]["cells_per_depth"] == [2]
    assert mesh["facts"]["interior_edge_valence"] == {}
    assert mesh["facts"]["structure"]["sheets"]["count"] == 4
    assert mesh["facts"]["structure"]["base_complex"]["dims"] == {"1x1x2": 1}
    assert "structure" not in index["sources"][1]["meshes"][0]["facts"]
    assert (site / mesh["page"] / "index.html").is_file()
    assert index["sources"][1]["reference"]["DOI"] == "10.5555/meshes.2021.7"
    assert "sj_min" not in index["sources"][1]["meshes"][1]["facts"]


def test_C3_our_index_has_what_belongs_to_a_mesh_and_citations(site):
    small, far = load(site, "index.json")["sources"]
    assert "Núñez, A. M." in far["citations"]["text"] and "@article{far," in far["citations"]["bibtex"]
    assert json.loads(far["citations"]["csl"])[0]["DOI"] == far["doi"] == "10.5555/meshes.2021.7"
    assert (far["year"], far["venue"]) == (2021, "Journal of Meshes 12(3), 101–120")
    for mesh in small["meshes"] + far["meshes"]:
        assert {"method", "model", "same_as", "picture"} <= mesh.keys()
    assert small["meshes"][0]["facts"]["groups"] is not None and "features" in small["meshes"][0]["facts"]
    assert not (site / "library.json").exists(), "one index"


def test_C9_the_python_package_reads_our_index(site, monkeypatch):
    index = (site / "index.json").read_bytes()
    monkeypatch.setattr(catalogue, "_bytes_at", lambda address: index)
    monkeypatch.setenv("HEXALAB_CATALOGUE", "https://meshes.example.org/hex")
    catalogue._listed.cache_clear()
    small, far = catalogue.sources()
    assert (far.doi, far.authors[0]) == ("10.5555/meshes.2021.7", "Ana María Núñez")
    assert small.meshes[0].facts["vertices"] == 12 and far.meshes[1].facts == {}
    assert small.meshes[0].address == "https://meshes.example.org/hex/meshes/small/pair.mesh"
    assert catalogue.cite("far/second") == far.citations["text"]
    catalogue._listed.cache_clear()


def test_C3_the_originals_form(site):
    index = load(site, "datasets/index.json")
    assert list(index) == ["sources"]
    small, far = index["sources"]
    assert set(far["paper"]) == {"title", "venue", "authors", "year", "PDF", "web", "DOI"}
    assert all(isinstance(value, str) for value in far["paper"].values())
    assert far["path"] == "2021 - Hexahedra & their friends"
    assert far["data"] == ["one folder/first.mesh", "second.vtk"]
    assert far["datasize"] == [844, 4200]
    assert far["label"].startswith("2021 - ")
    for name, cells in zip(small["data"], small["datasize"], strict=True):
        file = site / "datasets" / small["path"] / name
        assert read_bytes(file.read_bytes(), name).cell_count == cells


def test_C2_the_search_index_is_small_and_complete(site):
    index = load(site, "search.json")
    assert len(index["meshes"]) == 5
    assert [facet["id"] for facet in index["facets"]] == [facet.id for facet in FACETS]
    for row in index["meshes"]:
        assert len(row) == 14
        assert len(row[9]) == len(FACETS)
        for code, facet in zip(row[9], index["facets"], strict=True):
            assert int(code, 36) < len(facet["options"])
    names = {row[1]: row for row in index["meshes"]}

    def options(name):
        return {
            facet["id"]: facet["options"][int(code, 36)]
            for facet, code in zip(index["facets"], names[name][9], strict=True)
        }

    assert options("parts-turned")["validity"] == "invalid"
    assert options("second")["validity"] == "unknown"
    facets = ("irregular", "sheets", "crossing", "blocks")
    assert [options("row")[facet] for facet in facets] == ["none", "few", "none", "one"]
    assert [options("one-folder-first")[facet] for facet in facets] == ["untraced", *["unknown"] * 3]
    assert names["row"][11:13] == [7, 1], (
        "of five cubes in a row: a sheet through each, two along the row, one block"
    )
    assert names["second"][11:13] == [None, None]


def test_C2_references_can_be_downloaded_one_by_one_and_together(site):
    assert "@article{far," in (site / "sources/far/far.bib").read_text("utf-8")
    together = (site / "catalogue.bib").read_text("utf-8")
    assert together.count("@") == 2
    assert (site / "catalogue.ris").read_text("utf-8").count("ER  - ") == 2
    assert [item["id"] for item in load(site, "catalogue.csl.json")] == ["small", "far"]
