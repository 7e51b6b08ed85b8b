"""Building: the same bytes each time, nothing done twice, nothing left over, nothing wrong let through."""

import hashlib
import sys
from pathlib import Path

import pytest

from site_builder import BuildError, build
from site_builder.build import ADDRESS_VARIABLE
from site_builder.pages import interface


def tree(root: Path) -> dict[str, str]:
    return {
        file.relative_to(root).as_posix(): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in sorted(root.rglob("*"))
        if file.is_file()
    }


def test_C7_two_builds_from_scratch_are_byte_identical(demo, tmp_path):
    builds = []
    for name in ("one", "two"):
        out = tmp_path / name / "site"
        build(demo, out, runtime=False)
        builds.append(tree(out))
    assert builds[0] == builds[1]
    assert len(builds[0]) > 20


def test_C7_a_second_build_measures_and_writes_nothing(rebuild):
    first, second = rebuild(), rebuild()
    assert (first.measured, second.measured) == (3, 0)
    assert first.changed > 20
    assert second.changed == 0


def test_C7_what_no_longer_belongs_to_the_site_goes(demo, rebuild, edit):
    rebuild()
    site = demo.parent / "site"
    assert (site / "sources/small/pair/index.html").exists()
    edit(demo / "small" / "source.yaml", lambda data: data["meshes"].pop(0))
    rebuild()
    assert not (site / "sources/small/pair").exists()
    assert not (site / "meshes/small/pair.mesh").exists()


def test_C7_only_the_changed_mesh_is_measured_again(demo, rebuild):
    rebuild()
    file = demo / "small" / "pair.mesh"
    file.write_text(file.read_text().replace("2 1 1 0", "2.5 1 1 0"))
    assert rebuild().measured == 1


def test_C7_progress_tells_what_is_done_and_how_far_it_is(demo, tmp_path):
    told = []
    build(demo, tmp_path / "site", progress=lambda text, part: told.append((text, part)), runtime=False)
    assert told[0][1] == 0
    assert told[-1] == ("done", 1.0)
    assert [part for _, part in told] == sorted(part for _, part in told)
    assert any("small/pair" in text for text, _ in told)


def test_C6_a_broken_mesh_stops_the_build_with_its_place(demo, rebuild):
    (demo / "small" / "pair.mesh").write_text("MeshVersionFormatted 2\nDimension 3\nVertices 12\n0 0 0 0\n")
    with pytest.raises(BuildError) as caught:
        rebuild()
    (problem,) = caught.value.problems
    assert (problem.file, problem.line, problem.field) == ("small/source.yaml", 12, "meshes[0].file")
    assert "pair.mesh" in problem.message


def test_C6_declared_facts_must_be_true(demo, rebuild, edit):
    def change(data):
        data["meshes"][0]["cells"] = 3
        data["meshes"][1]["sha256"] = "0" * 64

    edit(demo / "small" / "source.yaml", change)
    with pytest.raises(BuildError) as caught:
        rebuild()
    fields = {problem.field: problem.message for problem in caught.value.problems}
    assert fields["meshes[0].cells"] == "3 here, 2 in the file"
    assert fields["meshes[1].sha256"].startswith("0000")


def test_C6_a_script_that_fails_is_named(demo, rebuild):
    (demo / "small" / "make.py").write_text("raise RuntimeError('no clay')")
    with pytest.raises(BuildError, match="no clay"):
        rebuild()
    (demo / "small" / "make.py").write_text("FILES = {}")
    with pytest.raises(BuildError, match=r"has no 'row.mesh.gz'"):
        rebuild()


def test_C3_the_address_of_the_site_can_be_given(demo, rebuild, monkeypatch):
    monkeypatch.setenv(ADDRESS_VARIABLE, "https://elsewhere.example.net/sub/")
    rebuild()
    assert "https://elsewhere.example.net/sub/sources/far/" in (demo.parent / "site/sitemap.xml").read_text()


def test_C7_the_summary_has_times_and_sizes(rebuild):
    report = rebuild()
    assert report.pages == 19 + interface.installed()
    assert report.meshes == 5
    assert (
        f"{19 + interface.installed()} pages, 2 sources, 5 meshes (3 measured, 0 pictures taken)"
        in report.summary
    )
    assert "meshes/" in report.summary


def test_C7_a_strict_build_stops_at_a_warning(demo, tmp_path, edit):
    def change(data):
        del data["reference"]["DOI"]

    edit(demo / "far" / "source.yaml", change)
    report = build(demo, tmp_path / "site", runtime=False)
    assert [str(warning) for warning in report.warnings] == [
        "far/source.yaml:1: reference: neither a DOI nor an arXiv id: readers can't get at the paper"
    ]
    with pytest.raises(BuildError, match="neither a DOI"):
        build(demo, tmp_path / "site", strict=True, runtime=False)


def test_C7_a_viewer_that_cannot_be_put_together_is_told_in_a_line(demo, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "site_builder.runtime", None)
    with pytest.raises(BuildError, match=r"the viewer can't be put together: .*`make build`"):
        build(demo, tmp_path / "site", pictures=False)
