"""`hexalab collect` with real pictures: at once, interrupted, side by side, on a cluster: the same bytes (SPEC C8)."""

from __future__ import annotations

import json
import shutil
import signal
import subprocess
import sys
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from .cluster import ENVIRONMENT, cluster
from .ui import until
from .viewing import ROOT

pytestmark = pytest.mark.browser

SOURCE = """reference:
  type: article-journal
  title: Far away
  author:
    - {{ family: Far, given: Fara }}
  issued: 2020
  DOI: 10.1000/far
licence: authors
base_url: https://far.example/data/
meshes:
{rows}"""
MESHES = {
    "structures/valence-3.mesh": "structures/valence-3.mesh",
    "structures/valence-5.mesh": "structures/valence-5.mesh",
    "faults/invalid-corner.mesh": "faults/invalid-corner.mesh",
    "broken.vtk": "",
}
"""Address of a mesh below the source's, and what it is a copy of; of nothing, it can't be read."""

ENVIRON = {**ENVIRONMENT, "PYTHONPATH": f"{ROOT / 'core'}:{ROOT}"}


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a mirror, and a repository that nothing was collected in."""
    place = tmp_path_factory.mktemp("collect")
    (place / "bare" / "far").mkdir(parents=True)
    rows = "".join(f"  - url: {name}\n" for name in MESHES)
    (place / "bare" / "far" / "source.yaml").write_text(SOURCE.format(rows=rows))
    for name, original in MESHES.items():
        target = place / "mirror" / "data" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if original:
            shutil.copyfile(ROOT / "repository" / original, target)
        else:
            target.write_text("this is no mesh\n")
    return place


def words(place: Path, repository: str, *more: str | Path) -> list[str]:
    """The command that collects into a repository, which is made if it isn't there."""
    if not (place / repository).exists():
        shutil.copytree(place / "bare", place / repository)
    first = [sys.executable, "-m", "hexalab", "collect", "--repository", str(place / repository)]
    return [*first, "--mirror", str(place / "mirror"), *map(str, more)]


def says(command: list[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, env=ENVIRON, timeout=300)


def written(repository: Path) -> dict[str, bytes]:
    return {
        file.relative_to(repository).as_posix(): file.read_bytes()
        for file in sorted(repository.rglob("*"))
        if file.is_file()
    }


@pytest.fixture(scope="module")
def alone(place: Path) -> dict[str, bytes]:
    """What comes of it in one go, one mesh after the other."""
    done = says(words(place, "alone"))
    assert done.returncode == 1, done.stderr
    assert "far/broken: broken.vtk, line 1" in done.stderr and done.stderr.count("\n") == 1, done.stderr
    assert done.stdout == "3 collected, 1 failed\n"
    return written(place / "alone")


def test_C8_pictures_are_small_and_show_something(alone: dict[str, bytes]) -> None:
    pictures = {name: data for name, data in alone.items() if name.endswith(".webp")}
    assert len(pictures) == 3
    for name, data in pictures.items():
        image = Image.open(BytesIO(data))
        assert (image.format, image.size) == ("WEBP", (480, 320)), name
        assert len(data) < 30_000 and len(image.convert("RGB").getcolors(2**20) or []) > 500, name


def test_C8_of_an_invalid_mesh_the_body_is_seen_around_its_faults(alone: dict[str, bytes]) -> None:
    image = Image.open(BytesIO(alone["far/pictures/faults-invalid-corner.webp"])).convert("RGB")
    pixels = np.asarray(image).reshape(-1, 3)
    red = int(((pixels[:, 0] > 120) & (pixels[:, 1:] < 70).all(axis=1)).sum())
    faint = int(((pixels.min(axis=1) > 225) & (pixels.min(axis=1) < 252)).sum())
    assert red > 300 and faint > red


def test_C8_interrupted_twice_it_comes_to_the_same(place: Path, alone: dict[str, bytes]) -> None:
    for count in (1, 2):
        process = subprocess.Popen(
            words(place, "resumed", "--jobs", "1"),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRON,
        )  # fmt: skip
        facts = place / "resumed" / "far" / "facts.json"
        until(lambda facts=facts, count=count: facts.is_file() and len(rows(facts)) >= count, 120)
        process.send_signal(signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
        assert process.returncode == 130, complaint
        assert "the same command goes on" in complaint and "Traceback" not in complaint
    done = says(words(place, "resumed", "--jobs", "2"))
    assert "done before" in done.stdout and done.returncode == 1
    assert written(place / "resumed") == alone


def rows(facts: Path) -> dict[str, object]:
    return dict(json.loads(facts.read_text("utf-8"))["meshes"])


def test_C8_a_cluster_comes_to_the_same(place: Path, alone: dict[str, bytes], tmp_path: Path) -> None:
    pytest.importorskip("distributed")
    with cluster(tmp_path, 2) as (file, _):
        done = says(words(place, "clustered", "--scheduler", file))
    assert done.returncode == 1, done.stderr
    assert written(place / "clustered") == alone


def test_C8_what_can_not_be_is_said_in_a_line(place: Path, tmp_path: Path) -> None:
    for more, said in (
        (["nowhere"], "nowhere: "),
        (["--mirror", str(tmp_path / "gone")], "there is no such folder"),
        (["--jobs", "0"], "expected a number from 1"),
        (["--scheduler", "tcp://127.0.0.1:9"], "no scheduler answers"),
    ):
        done = says(words(place, "wrong", *more))
        assert done.returncode == 2 and said in done.stderr and done.stderr.count("\n") == 1, done.stderr
