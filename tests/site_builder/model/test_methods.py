"""Families of methods: the table, the schema that takes its ids, and what the repository says."""

import json
from pathlib import Path

import pytest

from site_builder.model.methods import METHODS
from site_builder.reading.checking import schema
from site_builder.reading.repository import read_repository

ROOT = Path(__file__).resolve().parents[3]


def test_C1_the_schema_takes_the_tables_ids():
    assert schema("source")["$defs"]["method"]["enum"] == list(METHODS)
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    assert [name for name in METHODS if f"`{name}`" not in text] == []


def test_C5_every_published_source_says_its_method():
    for source in read_repository(ROOT / "repository").sources:
        assert (source.method in METHODS) is not source.own, source.slug
        for mesh in source.meshes:
            assert mesh.method == "" or mesh.method in METHODS


def test_C1_a_row_says_otherwise_than_its_source(demo, edit):
    def change(data):
        data["meshes"][0]["method"] = "octree"
        data["meshes"][1]["method"] = ""

    edit(demo / "far" / "source.yaml", change)
    catalogue = read_repository(demo)
    far = next(source for source in catalogue.sources if source.slug == "far")
    assert catalogue.problems == []
    assert (far.method, [mesh.method for mesh in far.meshes]) == ("polycube", ["octree", ""])


@pytest.mark.parametrize("wrong", ["guessing", ""])
def test_C1_a_method_is_one_of_the_table(demo, edit, wrong):
    edit(demo / "far" / "source.yaml", lambda data: data.update(method=wrong))
    (problem,) = read_repository(demo).problems
    assert problem.message == f"found {json.dumps(wrong)}, expected one of {', '.join(METHODS)}"


def test_C1_a_paper_without_a_method_is_asked_for_it(demo, edit):
    edit(demo / "far" / "source.yaml", lambda data: data.pop("method"))
    (problem,) = read_repository(demo).problems
    assert (problem.severity, problem.field) == ("warning", "method")
