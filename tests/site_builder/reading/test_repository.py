"""Sources against their schema and against the files beside them."""

import json
import os

import pytest

from site_builder.reading.checking import schema
from site_builder.reading.repository import read_repository

SMALL, FAR = "small/source.yaml", "far/source.yaml"


def problems_of(demo):
    return [str(problem) for problem in read_repository(demo).problems]


def test_C1_the_demo_is_read_without_a_problem(demo):
    catalogue = read_repository(demo)
    assert catalogue.problems == []
    assert [source.slug for source in catalogue.sources] == ["small", "far"]
    small, far = catalogue.sources
    assert small.own
    assert not far.own
    assert [mesh.id for mesh in small.meshes] == ["small/pair", "small/parts-turned", "small/row"]
    assert far.meshes[0].remote == "https://meshes.example.org/data%20sets/far/one%20folder/first.mesh"
    assert far.meshes[0].name == "one folder / first"
    assert far.meshes[0].facts.cells == 844
    assert far.meshes[0].facts.irregular_edges == 8
    assert far.meshes[1].remote == "https://elsewhere.example.org/second.vtk"
    assert far.meshes[1].cells == 4200
    assert far.meshes[1].facts.sj_min is None
    assert far.reference["issued"] == {"date-parts": [[2021, 12]]}
    assert far.venue == "Journal of Meshes 12(3), 101–120"
    assert far.short == "Núñez et al. 2021"


@pytest.mark.parametrize(
    ("file", "old", "new", "expected"),
    [
        (
            FAR,
            "DOI: 10.5555/meshes.2021.7",
            "DOI: https://doi.org/10.5555/meshes.2021.7",
            'far/source.yaml:13: reference.DOI: found "https://doi.org/10.5555/meshes.2021.7", expected a bare DOI',
        ),
        (
            FAR,
            "licence: authors",
            "licence: mine",
            'far/source.yaml:17: licence: found "mine", expected one of authors, CC0-1.0',
        ),
        (FAR, "licence: authors\n", "", "far/source.yaml:1: missing: licence"),
        (
            FAR,
            "licence: authors",
            "license: authors",
            "unknown: license; known are reference, links, licence",
        ),
        (
            FAR,
            "pdf: https:",
            "pdf: javascript:",
            'far/source.yaml:15: links.pdf: found "javascript://meshes.example.org/paper.pdf"',
        ),
        (FAR, "far/\nmeshes", "far\nmeshes", "base_url: found"),
        (
            FAR,
            'issued: "2021-12"',
            "issued: soon",
            'far/source.yaml:8: reference.issued: found "soon", expected a year as 2021',
        ),
        (
            FAR,
            "family: Li,",
            "family: 7,",
            "far/source.yaml:7: reference.author[2].family: found 7, expected text; put it in quotes",
        ),
        (
            FAR,
            "  - url: one%20folder/first.mesh",
            "  - url: one%20folder/first.mesh\n    file: first.mesh",
            "far/source.yaml:21: meshes[0]: found",
        ),
        (FAR, "cells: 4200", "cells: 0", "far/source.yaml:24: meshes[1].cells: found 0, expected at least 1"),
        (
            FAR,
            "cells: 4200",
            "cells: many",
            'far/source.yaml:24: meshes[1].cells: found "many", expected a whole number',
        ),
        (FAR, "sha256: 0123", "sha256: 0xyz", "expected 64 hexadecimal digits in lower case"),
        (FAR, "first.mesh", "first.stl", "doesn't end as a mesh format that is read here"),
        (
            SMALL,
            "file: pair.mesh",
            "file: ../pair.mesh",
            "small/source.yaml:12: meshes[0].file: '../pair.mesh' must be a plain path inside the source's folder",
        ),
        (SMALL, "file: pair.mesh", "file: /etc/passwd.mesh", "must be a plain path"),
        (SMALL, "file: pair.mesh", "file: absent.mesh", "there is no file 'absent.mesh' beside source.yaml"),
        (SMALL, "file: pair.mesh", "file: parts/turned.mesh", "the slug 'parts-turned' is taken"),
        (
            SMALL,
            "description: Two cubes side",
            "description: Two\ndescription: x",
            "small/source.yaml:16: found the key",
        ),
        (SMALL, 'title: "Small', 'titel: "Small', "small/source.yaml:1: reference: missing: title"),
        (SMALL, 'title: "Small', 'titel: "Small', "small/source.yaml:3: reference.titel: unknown: titel"),
        (
            FAR,
            "10.5555/meshes.2021.7",
            '"10.5555/meshes.2021.7\\n"',
            'far/source.yaml:13: reference.DOI: found "10.5555/meshes.2021.7\\n"',
        ),
        (FAR, "pdf: https://meshes.example.org/", "pdf: https://:/", "far/source.yaml:15: links.pdf: found"),
        (FAR, "base_url: https://meshes.example.org", "base_url: https://[::1", "base_url: found"),
        (
            FAR,
            "https://elsewhere.example.org",
            "https://[::1",
            "meshes[1].url: 'https://[::1/second.vtk' is no web",
        ),
        (
            FAR,
            "https://elsewhere",
            "http://elsewhere",
            "meshes[1].url: http://elsewhere.example.org/second.vtk begins",
        ),
        (SMALL, "file: pair.mesh", f"file: {'long' * 60}.mesh", "a name of more than 200 bytes"),
    ],
)
def test_C1_an_error_names_file_line_and_field(demo, file, old, new, expected):
    text = (demo / file).read_text("utf-8")
    assert old in text
    (demo / file).write_text(text.replace(old, new, 1), "utf-8")
    found = problems_of(demo)
    assert found
    if expected.endswith("found the key"):
        assert any("not YAML" in problem or "twice" in problem for problem in found)
    else:
        assert any(expected in problem for problem in found), found


def test_C1_a_long_text_is_refused_at_once(demo):
    text = (demo / SMALL).read_text("utf-8")
    assert "contributors: [Somebody Else]" in text
    endless = f'contributors: ["{"x" * 500_000}\\n\\n"]'
    (demo / SMALL).write_text(text.replace("contributors: [Somebody Else]", endless), "utf-8")
    assert any("contributors[0]: found 500002 characters" in problem for problem in problems_of(demo))


@pytest.mark.parametrize("name", ["source", "catalogue"])
def test_C1_each_pattern_is_tried_at_one_place_alone(name):
    """A pattern without `^` is tried at every place of a long text, and walks to its end from each."""
    found = patterns(schema(name))
    assert found
    assert [pattern for pattern in found if not pattern.startswith("^")] == []


def patterns(part):
    """All patterns within a schema."""
    if isinstance(part, list):
        return [pattern for inner in part for pattern in patterns(inner)]
    if not isinstance(part, dict):
        return []
    own = [part["pattern"]] if isinstance(part.get("pattern"), str) else []
    return own + [pattern for inner in part.values() for pattern in patterns(inner)]


def test_C1_two_sources_may_not_share_a_doi(demo):
    (demo / "again").mkdir()
    (demo / "again" / "source.yaml").write_text((demo / FAR).read_text("utf-8"), "utf-8")
    (problem,) = problems_of(demo)
    assert problem == "far/source.yaml:13: reference.DOI: the DOI 10.5555/meshes.2021.7 is taken by again"


def test_C1_symbolic_links_are_refused(demo, tmp_path):
    secret = tmp_path / "secret.mesh"
    secret.write_text("MeshVersionFormatted 2")
    (demo / "small" / "pair.mesh").unlink()
    os.symlink(secret, demo / "small" / "pair.mesh")
    assert any("symbolic link" in problem for problem in problems_of(demo))


def test_C1_nothing_is_read_from_outside_a_sources_folder(demo, tmp_path):
    (tmp_path / "outside.yaml").write_text((demo / FAR).read_text("utf-8"), "utf-8")
    (demo / FAR).unlink()
    os.symlink(tmp_path / "outside.yaml", demo / FAR)
    os.symlink(demo / "small", demo / "smaller")
    (demo / "folder" / "source.yaml").mkdir(parents=True)
    assert set(problems_of(demo)) == {
        "far: source.yaml is no plain file in this folder",
        "folder: source.yaml is no plain file in this folder",
        "smaller: a symbolic link, not a folder",
    }
    (demo / SMALL).write_text((demo / SMALL).read_text("utf-8").replace("file: pair", "file: ../pair"))
    assert read_repository(demo).sources[0].meshes[0].local is None


def test_C1_folder_names_are_slugs(demo):
    (demo / "far").rename(demo / "Far Away")
    assert any("must be lower-case letters" in problem for problem in problems_of(demo))


def test_C1_a_folder_without_source_is_named(demo):
    (demo / "empty").mkdir()
    assert "empty: no source.yaml in this folder" in problems_of(demo)


def test_C1_facts_belong_to_a_mesh(demo):
    file = demo / "far" / "facts.json"
    facts = json.loads(file.read_text("utf-8"))
    facts["meshes"]["gone.mesh"] = {"cells": 1}
    file.write_text(json.dumps(facts), "utf-8")
    assert any("'gone.mesh' is no url of a mesh" in problem for problem in problems_of(demo))


@pytest.mark.parametrize(
    "facts",
    ['{"colour": "red"}', '{"cells": "lots"}', '{"cells": true}', '{"cells": -1}', '{"sj_min": NaN}',
     '{"sha256": "<b>"}', '{"interior_edge_valence": {"4": "x"}}', '{"interior_edge_valence": {"four": 1}}',
     '{"notes": "x"}', '{"secret": 1}', '{"view": {}}', '{"structure": {}}', '{"quality": {"beauty": []}}',
     '"x"', "[" * 100_000],
)  # fmt: skip
def test_C1_facts_that_cannot_be_are_refused(demo, facts):
    file = demo / "far" / "facts.json"
    file.write_text(f'{{"meshes": {{"one%20folder/first.mesh": {facts}}}}}', "utf-8")
    assert any("not a table of facts" in problem for problem in problems_of(demo))


def test_C1_a_repository_that_is_not_there_is_a_problem(tmp_path):
    assert [p.message for p in read_repository(tmp_path / "nowhere").problems] == ["no such folder"]
