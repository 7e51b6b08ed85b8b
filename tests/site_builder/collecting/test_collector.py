"""Collecting remote meshes: what is due, what is written, what is told (SPEC C8)."""

from __future__ import annotations

import base64
import hashlib
import json
import shutil
from collections.abc import Callable, Generator, Sequence
from io import BytesIO
from pathlib import Path

import pytest
from PIL import Image

from hexalab.quality import METRICS
from site_builder.collecting import Collector, Report
from site_builder.collecting.jobs import CollectJob, Outcome, failed
from site_builder.collecting.work import HEIGHT, WIDTH, measured, shown
from site_builder.measuring.fetching import Fetched, Fetcher
from site_builder.measuring.mirror import Mirror
from site_builder.pictures.portrait import portrait
from site_builder.reading.repository import read_repository

ROOT = Path(__file__).parents[3]
MESHES = ("structures/valence-3.mesh", "structures/valence-5.mesh", "shapes/cube.mesh", "shapes/mixed.mesh")
SOURCE = """reference:
  type: article-journal
  title: Far away
  author:
    - { family: Far, given: Fara }
  issued: 2020
  DOI: 10.1000/far
licence: authors
base_url: https://far.example/data/
meshes:
"""


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A source of four remote meshes; `mirror` beside it has their files."""
    folder = tmp_path / "repository" / "far"
    folder.mkdir(parents=True)
    text = SOURCE
    for path in MESHES:
        target = tmp_path / "mirror" / "data" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        found = next((ROOT / "repository").glob(f"*/{Path(path).name}"))
        shutil.copyfile(found, target)
        text += f"  - url: {path}\n"
    (folder / "source.yaml").write_text(text)
    return tmp_path / "repository"


def webp(text: str) -> bytes:
    """A picture that depends on a text."""
    colour = tuple(hashlib.sha256(text.encode()).digest()[:3])
    out = BytesIO()
    Image.new("RGB", (WIDTH, HEIGHT), colour).save(out, "WEBP")
    return out.getvalue()


def do(jobs: Sequence[CollectJob]) -> Generator[Outcome]:
    """Measures as workers do; only the picture is none of the mesh."""
    for job in jobs:
        try:
            facts = measured(job, Path(job.file).read_bytes())
        except Exception as error:
            yield failed(job, str(error))
            continue
        picture = base64.b64encode(webp(job.id)).decode()
        shows = shown(facts.sha256 or "", portrait(facts))
        # by way of JSON, as between processes
        yield json.loads(json.dumps(Outcome(
            id=job.id, facts=facts.to_dict(), picture=picture, shows=shows, problem=""
        )))  # fmt: skip


def interrupted_after(count: int) -> Callable[[Sequence[CollectJob]], Generator[Outcome]]:
    def some(jobs: Sequence[CollectJob]) -> Generator[Outcome]:
        yield from do(jobs[:count])
        raise KeyboardInterrupt

    return some


def collect(repository: Path, by=do, files=None, **how) -> Report:
    catalogue = read_repository(repository)
    assert catalogue.errors == []
    files = files or Mirror(repository.parent / "mirror")
    return Collector(catalogue.sources, files, **how).run(by, lambda what, part: None)


def written(repository: Path) -> dict[str, bytes]:
    return {
        file.relative_to(repository).as_posix(): file.read_bytes()
        for file in sorted(repository.rglob("*"))
        if file.is_file() and file.name != "source.yaml"
    }


def test_C8_facts_and_pictures_lie_beside_the_source(repository: Path) -> None:
    report = collect(repository)
    assert report.summary == "4 collected"
    assert set(written(repository)) == {
        "far/facts.json", "far/pictures/shapes-cube.webp", "far/pictures/shapes-mixed.webp",
        "far/pictures/structures-valence-3.webp", "far/pictures/structures-valence-5.webp",
    }  # fmt: skip
    (source,) = read_repository(repository).sources
    for mesh in source.meshes:
        facts = mesh.facts
        assert mesh.picture and facts.quality and facts.structure and facts.validity and facts.histogram
        assert (
            facts.quality.keys() == METRICS.keys() and facts.groups is not None and facts.findings is not None
        )
    lines = (repository / "far" / "facts.json").read_text("utf-8").splitlines()
    assert sum(line.startswith('    "s') for line in lines) == 4  # a line each


def test_C8_what_is_done_is_not_done_again(repository: Path) -> None:
    collect(repository)
    before = written(repository)
    assert collect(repository).summary == "4 done before"
    assert collect(repository, check=True).summary == "4 unchanged"
    assert written(repository) == before
    assert collect(repository, again=True).summary == "4 collected"
    assert written(repository) == before


def test_C8_interrupted_twice_and_resumed_it_comes_to_the_same(repository: Path, tmp_path: Path) -> None:
    collect(repository)
    whole = written(repository)
    shutil.rmtree(repository / "far" / "pictures")
    (repository / "far" / "facts.json").unlink()
    for count in (1, 2):
        with pytest.raises(KeyboardInterrupt):
            collect(repository, interrupted_after(count))
    assert sum(name.endswith(".webp") for name in written(repository)) == 3
    assert collect(repository).summary == "1 collected, 3 done before"
    assert written(repository) == whole


def test_C8_a_mesh_that_fails_is_told_and_the_rest_is_done(repository: Path) -> None:
    broken = repository.parent / "mirror" / "data" / "shapes" / "cube.mesh"
    broken.write_text("MeshVersionFormatted 1\nDimension 3\nVertices\nlots\n")
    report = collect(repository)
    assert report.summary == "3 collected, 1 failed"
    assert "cube.mesh" in report.failed["far/shapes-cube"] and "line 4" in report.failed["far/shapes-cube"]
    assert not (repository / "far" / "pictures" / "shapes-cube.webp").exists()


def test_C8_a_file_that_changed_is_told(repository: Path) -> None:
    collect(repository)
    data = repository.parent / "mirror" / "data"
    shutil.copyfile(data / "structures/valence-3.mesh", data / "shapes/cube.mesh")
    assert collect(repository).summary == "4 done before"
    report = collect(repository, check=True)
    assert report.summary == "3 unchanged, 1 changed"
    ((before, now),) = report.changed.values()
    assert before != now == hashlib.sha256((data / "shapes/cube.mesh").read_bytes()).hexdigest()


def test_C8_another_file_than_source_yaml_names_is_refused(repository: Path) -> None:
    file = repository / "far" / "source.yaml"
    file.write_text(file.read_text() + f"    sha256: {'0' * 64}\n")
    report = collect(repository)
    assert "another file than source.yaml names" in report.failed["far/shapes-mixed"]
    assert report.summary == "3 collected, 1 failed"


def test_C8_what_a_mirror_lacks_is_counted(repository: Path) -> None:
    (repository.parent / "mirror" / "data" / "shapes" / "cube.mesh").unlink()
    report = collect(repository)
    assert report.summary == "3 collected, 1 not in the mirror" and report.absent == ["far/shapes-cube"]


def test_C8_a_body_that_is_said_to_stand_otherwise_is_portrayed_anew(repository: Path) -> None:
    collect(repository)
    file = repository / "far" / "source.yaml"
    file.write_text(file.read_text().replace("meshes:", 'up: "y"\nmeshes:'))
    assert collect(repository).summary == "4 collected"
    (source,) = read_repository(repository).sources
    assert all(mesh.facts.view and list(mesh.facts.view["up"]) == [0, 1, 0] for mesh in source.meshes)


def test_C8_facts_of_an_earlier_version_stay_until_they_are_measured_anew(repository: Path) -> None:
    old = {"cells": 7, "sj_min": 0.5}
    file = repository / "far" / "facts.json"
    file.write_text(json.dumps({"note": "x", "meshes": {"shapes/cube.mesh": old}}))
    with pytest.raises(KeyboardInterrupt):
        collect(repository, interrupted_after(1))
    (source,) = read_repository(repository).sources
    cube = next(mesh for mesh in source.meshes if mesh.slug == "shapes-cube")
    assert cube.cells == 7 and cube.collected and cube.collected.version == 1
    assert collect(repository).summary == "3 collected, 1 done before"


def test_C8_one_mesh_of_a_source_can_be_meant(repository: Path) -> None:
    assert collect(repository, only=["far/shapes-cube"]).summary == "1 collected"


class Near(Fetcher):
    """Fetches from the mirror, and knows each file by the beginning of its hash."""

    def __init__(self, mirror: Mirror) -> None:
        super().__init__(Path())
        self._mirror, self.sent, self.forgotten = mirror, 0, 0

    def fetch(self, address: str, etag: str = "") -> Fetched:
        file = self._mirror.find(address)
        assert file
        now = f'"{hashlib.sha256(file.read_bytes()).hexdigest()[:8]}"'
        if etag == now:
            return Fetched(None, etag)
        self.sent += 1
        return Fetched(file, now)

    def forget(self, address: str) -> None:
        self.forgotten += 1


def test_C8_a_server_is_asked_whether_a_file_has_changed(repository: Path) -> None:
    mirror = Mirror(repository.parent / "mirror")
    collect(repository)  # by way of the mirror: no server has told anything yet
    first, second = Near(mirror), Near(mirror)
    assert collect(repository, files=first, check=True).summary == "4 unchanged"
    assert (first.sent, first.forgotten) == (4, 4)
    assert collect(repository, files=second, check=True).summary == "4 unchanged"
    assert second.sent == 0
