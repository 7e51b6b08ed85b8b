"""What `pip install hexalab` brings, tried in environments of their own, where there is no Node (SPEC A4)."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
import urllib.request
import venv
import zipfile
from collections.abc import Iterator
from email.parser import HeaderParser
from pathlib import Path

import pytest

from hexalab.cli import VERBS
from hexalab.hosts.browser import NAMES
from tests.core.conftest import grid_points, medit

ROOT = Path(__file__).parents[2]
EXTRAS = {"view", "notebook", "render", "cluster", "report", "site"}
RENDER = ("playwright", "rich")


def run(*words: str | Path, **options: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, **options)  # type: ignore[call-overload,no-any-return]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Wheel and sdist, as `make wheel` builds them."""
    out = tmp_path_factory.mktemp("dist")
    done = run(sys.executable, "-m", "site_builder.cli.wheel", out, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    (wheel,), (sdist,) = out.glob("*.whl"), out.glob("*.tar.gz")
    return {"wheel": wheel, "sdist": sdist}


class Place:
    """An environment with the distribution in it; nothing else is on its path."""

    def __init__(self, folder: Path, what: Path) -> None:
        self.folder = folder
        venv.create(folder / "env", with_pip=True)
        self.scripts = folder / "env" / "bin"
        self.python = self.scripts / "python"
        self.install(str(what))

    def install(self, *what: str) -> None:
        done = self.does(self.python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *what)
        assert done.returncode == 0, done.stderr

    @property
    def environment(self) -> dict[str, str]:
        kept = {
            name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")
        }
        found = next(filter(None, map(shutil.which, NAMES)), "")
        return {"HEXALAB_CHROMIUM": found, **kept, "PATH": str(self.scripts)}

    def does(self, *words: str | Path) -> subprocess.CompletedProcess[str]:
        return run(*words, cwd=self.folder, env=self.environment)

    def says(self, *words: str | Path) -> subprocess.CompletedProcess[str]:
        """What the program says."""
        return self.does(self.scripts / "hexalab", *words)


@pytest.fixture(scope="module", params=["wheel", "sdist"])
def place(
    request: pytest.FixtureRequest, built: dict[str, Path], tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Place]:
    folder = tmp_path_factory.mktemp(request.param)
    (folder / "grid.mesh").write_bytes(medit(*grid_points((3, 2, 2))))
    yield Place(folder, built[request.param])


def test_A4_the_same_sources_give_the_same_bytes(built: dict[str, Path], tmp_path: Path) -> None:
    digest = {kind: hashlib.sha256(file.read_bytes()).hexdigest() for kind, file in built.items()}
    for file in (ROOT / "build" / "viewer").iterdir():
        os.utime(file)
    mask = os.umask(0o077)
    try:
        assert run(sys.executable, "-m", "site_builder.cli.wheel", tmp_path, cwd=ROOT).returncode == 0
    finally:
        os.umask(mask)
    again = {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in tmp_path.iterdir()}
    assert again == {built[kind].name: digest[kind] for kind in built}
    with tarfile.open(built["sdist"]) as pack:
        pack.extractall(tmp_path / "source", filter="data")
    (source,) = (tmp_path / "source").iterdir()
    command = ["-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path / "wheel")]
    done = run(sys.executable, *command, cwd=source, env={**os.environ, "PATH": ""})
    assert done.returncode == 0, done.stderr
    (wheel,) = (tmp_path / "wheel").iterdir()
    assert hashlib.sha256(wheel.read_bytes()).hexdigest() == digest["wheel"], "of the sdist, without Node"


def test_A4_the_wheel_holds_package_and_viewer_and_needs_numpy_alone(built: dict[str, Path]) -> None:
    with zipfile.ZipFile(built["wheel"]) as pack:
        names = pack.namelist()
        metadata = HeaderParser().parsestr(
            pack.read(next(name for name in names if name.endswith("METADATA"))).decode()
        )
    assert {name.split("/")[0] for name in names} == {"hexalab", f"hexalab-{metadata['Version']}.dist-info"}
    viewer = {name.removeprefix("hexalab/viewer/") for name in names if name.startswith("hexalab/viewer/")}
    assert viewer == {
        "index.html", "frame.html", "sheet.txt", "viewer.js", "notebook.js", "viewer.css", "icon.svg",
    }  # fmt: skip
    assert not [name for name in names if name.endswith((".map", ".wasm", ".whl")) or "pyodide" in name]
    needed = metadata.get_all("Requires-Dist") or []
    assert [one for one in needed if "extra ==" not in one] == ["numpy<3,>=2.2"]
    assert set(metadata.get_all("Provides-Extra") or []) == EXTRAS
    assert metadata["License-Expression"] == "MIT"


def test_A4_a_clone_in_which_nothing_is_built_says_so(built: dict[str, Path], tmp_path: Path) -> None:
    with tarfile.open(built["sdist"]) as pack:
        pack.extractall(tmp_path, filter="data")
    (source,) = tmp_path.iterdir()
    (source / "build" / "viewer" / "index.html").unlink()
    done = run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", cwd=source)
    assert done.returncode != 0 and "`make wheel` builds it" in done.stderr


def test_A4_numpy_is_all_that_comes_along_and_the_library_works(place: Place) -> None:
    listed = place.does(
        place.python, "-m", "pip", "list", "--format=freeze", "--disable-pip-version-check"
    ).stdout
    assert {line.split("==")[0] for line in listed.split()} - {"pip", "setuptools"} == {"hexalab", "numpy"}
    code = (
        "import hexalab, importlib.util as u\n"
        "mesh = hexalab.read('grid.mesh')\n"
        "print(mesh.cell_count, hexalab.quality(mesh, 'scaled_jacobian').min(), u.find_spec('site_builder'))"
    )
    done = place.does(place.python, "-c", code)
    assert done.stdout == "12 1.0 None\n", done.stderr
    code = "import hexalab.catalogue as c; print(len(c.sources()), c.cite('bukenberger-2022-at-most-hexa/cylinder-g'))"
    told = place.does(place.python, "-c", code).stdout
    assert int(told.split()[0]) >= 30 and "https://doi.org/10.1111/cgf.14393" in told
    code = (
        "import hexalab.catalogue as c\n"
        "known = [mesh.facts for source in c.sources() for mesh in source.meshes]\n"
        "print(sum('quality' in facts for facts in known))"
    )
    assert int(place.does(place.python, "-c", code).stdout) > 600


@pytest.mark.parametrize("verb", [verb for verb, row in VERBS.items() if row.module.startswith("hexalab.")])
def test_A4_every_verb_of_the_package_tells_how_it_is_used(place: Place, verb: str) -> None:
    done = place.says(verb, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith(f"usage: hexalab {verb}")


def test_A4_verbs_that_need_no_more_work(place: Place) -> None:
    assert '"cells": 12' in place.says("info", "grid.mesh", "--json").stdout
    assert "scaled_jacobian" in place.says("quality", "grid.mesh", "--json").stdout
    assert place.says("convert", "grid.mesh", "grid.vtu").returncode == 0
    assert (place.folder / "grid.vtu").stat().st_size > 100
    version = place.says("--version").stdout.split()[-1]
    assert re.fullmatch(r"\d+\.\d+\.\d+", version)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["render", "grid.mesh", "-o", "x.png"], "hexalab[render]"),
        (["batch", ".", "-o", "out"], "hexalab[render]"),
        (["batch", ".", "-o", "out", "--scheduler", "tcp://127.0.0.1:9"], "hexalab[cluster]"),
        (["build"], "clone of the repository"),
        (["validate"], "clone of the repository"),
    ],
)
def test_A4_a_verb_whose_extra_is_missing_says_which(place: Place, words: list[str], said: str) -> None:
    done = place.says(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert said in done.stderr and done.stderr.count("\n") == 1


def test_A4_the_viewer_is_served_out_of_the_package(place: Place) -> None:
    command = [str(place.scripts / "hexalab"), "view", "--no-browser", "grid.mesh"]
    program = subprocess.Popen(
        command, stdout=subprocess.PIPE, text=True, cwd=place.folder, env=place.environment
    )
    assert program.stdout
    try:
        address = re.findall(r"http\S+", program.stdout.readline())[0].split("#")[0]
        page = urllib.request.urlopen(address, timeout=20).read().decode()
        script = re.findall(r'src="([^"]+\.js)"', page)[0]
        assert len(urllib.request.urlopen(address + script, timeout=20).read()) > 500_000
    finally:
        program.terminate()
        program.wait()
        program.stdout.close()


def test_A4_pictures_come_with_the_extra(place: Place, tmp_path: Path) -> None:
    if place.folder.name.startswith("sdist"):
        pytest.skip("the same package: tried once")
    pins = dict(re.findall(r"^([\w-]+)==(\S+)", (ROOT / "requirements.txt").read_text(), re.MULTILINE))
    place.install(*(f"{name}=={pins[name]}" for name in RENDER))
    (place.folder / "look.json").write_text('{"lighting": {"mode": "none"}}')
    look = ["--status", "look.json", "--width", "80", "--height", "60"]
    done = place.says("render", "grid.mesh", "-o", "grid.png", *look)
    assert done.returncode == 0, done.stderr
    assert (place.folder / "grid.png").read_bytes().startswith(b"\x89PNG")
    done = place.says("export", "grid.mesh", "-o", "grid.html")
    assert done.returncode == 0, done.stderr
    assert (place.folder / "grid.html").read_bytes().startswith(b"<!doctype html>")
    done = place.says("batch", "grid.mesh", "-o", "out.zip", *look)
    assert (done.returncode, done.stdout) == (0, "out.zip: 1 of 1 meshes\n"), done.stderr
