"""What each mesh of a batch is compared with (SPEC B2, S6): found by its path, and noticed when it changes."""

from __future__ import annotations

import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

from hexalab import HexaLabError, MeshReadError
from hexalab.hosts.batching import Job, Look, jobs_in
from hexalab.hosts.batching.counterparts import Beside, Counterparts
from hexalab.hosts.batching.records import kept
from hexalab.hosts.batching.sources import Source
from hexalab.hosts.offers import SurfaceOffer

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

TRIANGLE = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
DECK = b"*HEADING\n*INCLUDE, INPUT=part.inc\n"
PART = b"""*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8
1, 1, 2, 3, 4, 5, 6, 7, 8
"""


@pytest.fixture
def others(tmp_path: Path, grid: Any) -> Path:
    """A folder with meshes, a surface, and files of one stem."""
    folder = tmp_path / "others"
    (folder / "deep").mkdir(parents=True)
    for name in ("box.mesh", "deep/box.mesh", "twice.mesh", "twice.mesh.gz"):
        (folder / name).write_bytes(grid(1, 1, 1))
    (folder / "deep" / "bar.obj").write_bytes(TRIANGLE)
    (folder / "box.json").write_text("{}")
    (folder / ".bar.mesh").write_bytes(grid(1, 1, 1))
    return folder


def names(beside: Beside) -> tuple[str, tuple[str, ...]]:
    return beside.name, beside.parts


def test_B2_a_counterpart_has_the_same_path_and_may_have_another_ending(others: Path) -> None:
    found = Counterparts(others)
    assert names(found.of("box.mesh")) == ("box.mesh", ())
    assert names(found.of("box.vtk")) == ("box.mesh", ())
    assert names(found.of("deep/box.vtk.gz")) == ("deep/box.mesh", ())
    assert names(found.of("deep/bar.mesh")) == ("deep/bar.obj", ())
    assert names(found.of("twice.mesh")) == ("twice.mesh", ()), "the same path comes first"


@pytest.mark.parametrize(
    ("mesh", "told"),
    [
        ("bar.mesh", "holds nothing of this name"),
        ("other/box.mesh", "holds nothing of this name"),
        ("twice.vtk", "holds twice.mesh and twice.mesh.gz, expected one"),
    ],
)
def test_B2_a_mesh_without_a_counterpart_is_told_of(others: Path, mesh: str, told: str) -> None:
    with pytest.raises(HexaLabError, match=told):
        Counterparts(others).of(mesh)


def test_B2_an_archive_has_the_same_counterparts(others: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "others.zip", "w") as pack:
        for name in Source(others).names():
            pack.write(others / name, name)
    found = Counterparts(tmp_path / "others.zip")
    assert names(found.of("deep/bar.mesh")) == ("deep/bar.obj", ())
    assert isinstance(found.of("deep/bar.mesh").offer(), SurfaceOffer)
    assert found.of("box.vtk").offer().mesh().cell_count == 1  # type: ignore[union-attr]


def test_B2_one_file_is_the_counterpart_of_all_and_brings_what_it_includes(
    others: Path, tmp_path: Path
) -> None:
    found = Counterparts(others / "deep" / "bar.obj")
    assert found.of("a.mesh") == found.of("deep/b.vtk")
    assert found.of("a.mesh").offer().surface().count == 1  # type: ignore[union-attr]
    (tmp_path / "job.inp").write_bytes(DECK)
    (tmp_path / "part.inc").write_bytes(PART)
    deck = Counterparts(tmp_path / "job.inp").of("a.mesh")
    assert names(deck) == ("job.inp", ("part.inc",))
    assert deck.offer().mesh().cell_count == 1  # type: ignore[union-attr]
    before = deck.key()
    (tmp_path / "part.inc").write_bytes(PART.replace(b"1, 1, 1\n", b"1, 1, 2\n"))
    assert deck.key() != before


def test_B2_a_file_that_was_read_is_kept_until_it_changes(others: Path, grid: Any) -> None:
    beside = Counterparts(others / "box.mesh").of("a.mesh")
    first = beside.offer()
    assert beside.offer() is first
    (others / "box.mesh").write_bytes(grid(2, 1, 1))
    assert beside.offer().mesh().cell_count == 2  # type: ignore[union-attr]


def test_B2_what_can_not_be_compared_with_is_told_before_anything_starts(tmp_path: Path) -> None:
    (tmp_path / "broken.mesh").write_text("nonsense")
    (tmp_path / "empty").mkdir()
    with pytest.raises(MeshReadError, match=r"broken\.mesh"):
        Counterparts(tmp_path / "broken.mesh")
    with pytest.raises(HexaLabError, match="there is no mesh and no surface in it"):
        Counterparts(tmp_path / "empty")
    with pytest.raises(HexaLabError, match="no such file"):
        Counterparts(tmp_path / "none")


def test_B3_a_job_is_the_same_after_it_was_written_down_and_another_with_another_counterpart(
    others: Path, tmp_path: Path, grid: Any
) -> None:
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    for name in ("box.vtk", "lonely.mesh"):
        (meshes / name).write_bytes(grid(2, 1, 1))
    box, lonely = jobs_in(meshes, Look({}), tmp_path / "out", others)
    assert box.beside == Beside(str(others), "box.mesh") and box.lack == ""
    assert lonely.beside is None and "nothing of this name" in lonely.lack
    assert [Job.of_dict(job.as_dict()) for job in (box, lonely)] == [box, lonely]
    source = Source(meshes)

    def key(job: Job) -> str:
        return job.key(job.offer(source), job.layers(source))

    alone, _ = jobs_in(meshes, Look({}), tmp_path / "out")
    before = key(box)
    assert key(alone) != before
    assert key(lonely) != key(jobs_in(meshes, Look({}), tmp_path / "out")[1])
    (others / "box.mesh").write_bytes(grid(2, 1, 1))
    assert key(box) != before


def test_B2_a_job_that_lacks_a_counterpart_fails_without_a_browser(
    others: Path, tmp_path: Path, grid: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    (meshes / "lonely.mesh").write_bytes(grid(1, 1, 1))
    (job,) = jobs_in(meshes, Look({}), tmp_path / "out", others)
    work = pytest.importorskip(
        "hexalab.hosts.batching.work", exc_type=ModuleNotFoundError
    )  # needs Playwright
    monkeypatch.setattr(work, "BENCH", None)
    outcome = work.run(job.as_dict())
    assert outcome["line"] == {"name": "lonely.mesh", "problem": job.lack} and outcome["files"] == []
    assert kept(job) is None
