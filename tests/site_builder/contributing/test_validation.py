"""A contribution as CONTRIBUTING.md describes it: refused with the reason, mended, accepted, and on the site."""

import json
import os
import shutil
from pathlib import Path

import pytest

from site_builder import build, new_source, validate
from site_builder.contributing.scaffold import ScaffoldError

CUBE = Path(__file__).parents[1] / "demo" / "small" / "pair.mesh"
BIBTEX = """@article{doe2025,
  title = {Hexes for Everyone}, author = {Doe, Jane and Roe, Richard}, journal = {Journal of Meshes},
  year = {2025}, volume = {1}, number = {2}, pages = {3--14}, doi = {10.5555/hexes.2025}
}"""


@pytest.fixture
def contribution(demo, tmp_path):
    """What a newcomer has after following CONTRIBUTING.md, with one of the three meshes broken."""
    meshes = tmp_path / "my meshes"
    meshes.mkdir()
    for name in ("one.mesh", "two.mesh", "three.mesh"):
        shutil.copyfile(CUBE, meshes / name)
    (meshes / "two.mesh").write_text(CUBE.read_text().replace("0 1 1 0", "0 2 1 0"))
    (meshes / "three.mesh").write_text(CUBE.read_text().replace("8 9 12 11 0", "8 9 12 99 0"))
    (tmp_path / "doe.bib").write_text(BIBTEX)
    file = new_source(str(tmp_path / "doe.bib"), demo, meshes=meshes)
    for mesh in meshes.iterdir():
        shutil.copyfile(mesh, file.parent / mesh.name)
    return file


def test_C6_a_contribution_is_refused_mended_accepted_and_shown(contribution, demo, tmp_path):
    assert contribution.parent.name == "doe-2025-hexes-everyone"
    report = validate(demo)
    assert not report.ok
    places = {(problem.file, problem.field) for problem in report.problems}
    assert ("doe-2025-hexes-everyone/source.yaml", "contributors[0]") in places
    assert ("doe-2025-hexes-everyone/source.yaml", "meshes[0].description") in places
    assert ("doe-2025-hexes-everyone/source.yaml", "method") in places

    text = (
        contribution.read_text("utf-8")
        .replace('  - ""', "  - Jane Doe")
        .replace('method: ""', "method: octree")
    )
    for number in range(3):
        text = text.replace('description: ""', f"description: The result for model number {number + 1}.", 1)
    contribution.write_text(text, "utf-8")
    report = validate(demo)
    assert not report.ok
    (problem,) = [problem for problem in report.problems if problem.severity == "error"]
    assert problem.file == "doe-2025-hexes-everyone/source.yaml"
    assert text.splitlines()[problem.line - 1].strip() == "- file: three.mesh"
    assert problem.field == "meshes[1].file"
    assert "three.mesh" in problem.message
    assert "99" in problem.message
    assert "Refused: 1 error" in report.markdown
    assert "three.mesh" in report.markdown

    (contribution.parent / "three.mesh").write_text(CUBE.read_text().replace("2 1 1 0", "3 1 1 0"))
    report = validate(demo)
    assert report.ok, report.markdown
    assert "Accepted" in report.markdown
    assert "| doe-2025-hexes-everyone/three | 2 | 12 |" in report.markdown
    assert "| irregular edges | sheets | blocks | class |" in report.markdown
    assert "| 0 | 4 | 1 | regular |" in report.markdown

    out = tmp_path / "site"
    build(demo, out, strict=True, runtime=False)
    page = (out / "sources/doe-2025-hexes-everyone/three/index.html").read_text("utf-8")
    assert "The result for model number 2." in page
    assert "They were given to the catalogue to be looked at." in page
    assert "holds no copy" not in page
    assert '"@type":"Dataset"' in page
    assert "doe-2025-hexes-everyone" in (out / "index.html").read_text("utf-8")
    rows = json.loads((out / "search.json").read_text())
    contributed = [
        index for index, source in enumerate(rows["sources"]) if source[0] == "doe-2025-hexes-everyone"
    ]
    origins = {rows["facets"][0]["options"][int(m[9][0])] for m in rows["meshes"] if [m[0]] == contributed}
    assert origins == {"published"}, "a paper's meshes aren't our own, wherever they lie"
    assert "Hexes for Everyone" in [source[1] for source in rows["sources"]]
    listed = json.loads((out / "catalogue.json").read_text())["sources"]
    (source,) = [source for source in listed if source["doi"] == "10.5555/hexes.2025"]
    assert [mesh["slug"] for mesh in source["meshes"]] == ["one", "three", "two"]


def test_C6_one_source_can_be_checked_alone(demo):
    report = validate(demo / "small")
    assert report.ok
    assert [mesh.slug for mesh in report.meshes] == ["pair", "parts-turned", "row"]
    assert "cells have negative volume" in report.markdown or "cell has negative volume" in report.markdown


def test_C6_a_source_checked_alone_may_not_take_anothers_doi(demo):
    (demo / "new").mkdir()
    (demo / "new" / "source.yaml").write_text((demo / "far/source.yaml").read_text("utf-8"), "utf-8")
    (problem,) = [problem for problem in validate(demo / "new").problems if problem.severity == "error"]
    assert str(problem).startswith(
        "new/source.yaml:13: reference.DOI: the DOI 10.5555/meshes.2021.7 is taken"
    )


@pytest.mark.parametrize(
    "script", ["raise SystemExit(0)", "FILES = {'row.mesh.gz': lambda: 1 / 0}", "import nothing_of_this_name"]
)
def test_C6_a_script_that_fails_is_named(demo, script):
    (demo / "small" / "make.py").write_text(script)
    (problem,) = [problem for problem in validate(demo / "small").problems if problem.severity == "error"]
    assert problem.field == "meshes[2].made"
    assert "make.py fails: " in problem.message


def test_C6_what_the_file_does_not_hold_is_told_with_its_line(demo):
    text = (demo / "small/source.yaml").read_text("utf-8")
    (demo / "small/source.yaml").write_text(text.replace("cells: 2", f"cells: 3\n    sha256: {'0' * 64}"))
    errors = [problem for problem in validate(demo / "small").problems if problem.severity == "error"]
    assert [(problem.line, problem.field) for problem in errors] == [
        (14, "meshes[0].cells"),
        (15, "meshes[0].sha256"),
    ]


def test_C6_what_does_not_belong_in_a_source_is_named(demo):
    small = demo / "small"
    (small / "notes.docx").write_bytes(b"x")
    (small / "extra.mesh").write_text(CUBE.read_text())
    os.chmod(small / "pair.mesh", 0o755)
    os.symlink("/etc/passwd", small / "link.txt")
    os.mkfifo(small / "pipe.mesh")
    report = validate(demo)
    found = {problem.file: (problem.severity, problem.message) for problem in report.problems}
    assert found["small/notes.docx"] == ("error", "not a file that belongs here")
    assert found["small/extra.mesh"] == ("warning", "a mesh that source.yaml doesn't list")
    assert found["small/pair.mesh"][1].startswith("is executable")
    assert found["small/link.txt"][1].startswith("a symbolic link")
    assert found["small/pipe.mesh"] == ("error", "not a plain file")


def test_C6_the_same_file_twice_is_refused(demo):
    shutil.copyfile(demo / "small/pair.mesh", demo / "small/parts/turned.mesh")
    assert any("the same file as 'pair.mesh'" in problem.message for problem in validate(demo).problems)


def test_C6_a_remote_file_should_say_what_it_is(demo):
    file = demo / "far" / "source.yaml"
    text = file.read_text("utf-8").replace("    cells: 4200\n", "").replace("index_path", "# index_path")
    file.write_text(text, "utf-8")
    warnings = [problem for problem in validate(demo).problems if problem.severity == "warning"]
    assert any("its cells" in problem.message for problem in warnings)
    assert validate(demo).ok


def test_C6_markdown_cannot_be_injected(demo, edit):
    def change(data):
        data["meshes"][0]["file"] = "x](javascript:alert(1))|<b>`@all.mesh"

    edit(demo / "small" / "source.yaml", change)
    markdown = validate(demo).markdown
    assert "](javascript" not in markdown.replace("\\]", "")
    assert "<b>" not in markdown.replace("\\<b\\>", "")


def test_C6_an_empty_folder_is_no_repository(tmp_path):
    report = validate(tmp_path)
    assert not report.ok
    assert "no folder with a source.yaml" in report.markdown


def test_C6_a_source_can_be_started_by_questions(tmp_path):
    answers = {
        "Title": "Blocks: a study",
        "Authors": "Doe, Jane; The Block Group",
        "Year": "2025",
        "Journal": "Journal of Meshes",
        "DOI": "https://doi.org/10.5555/blocks",
        "Method": "sweeping",
        "Licence": "CC-BY-4.0",
    }
    file = new_source("blocks", tmp_path, ask=lambda question: answers[question.split()[0].strip(",")])
    text = file.read_text("utf-8")
    assert file.parent.name == "doe-2025-blocks-study"
    assert 'title: "Blocks: a study"' in text
    assert "{ literal: The Block Group }" in text
    assert 'DOI: "10.5555/blocks"' in text
    assert "licence: CC-BY-4.0" in text
    assert "method: sweeping  #" in text


def test_C6_a_source_is_not_started_twice(tmp_path):
    new_source("10.5555/again", tmp_path)
    with pytest.raises(ScaffoldError, match="is there already"):
        new_source("10.5555/again", tmp_path)


def test_C6_bibtex_of_an_older_manager_and_a_dois_address_start_a_source(tmp_path):
    (tmp_path / "old.bib").write_bytes(BIBTEX.replace("Doe", "Dö").encode("latin-1"))
    assert "family: Dö" in new_source(str(tmp_path / "old.bib"), tmp_path).read_text("utf-8")
    file = new_source("https://doi.org/10.5555/again", tmp_path)
    assert file.parent.name == "10-5555-again"
    assert 'DOI: "10.5555/again"' in file.read_text("utf-8")


def test_C6_a_folder_of_meshes_that_is_not_there_is_told(tmp_path):
    with pytest.raises(ScaffoldError, match="there is no folder"):
        new_source("blocks", tmp_path / "repository", meshes=tmp_path / "nowhere")
    assert not (tmp_path / "repository").exists()
