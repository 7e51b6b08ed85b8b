"""The verbs that need a server or a browser, and what is said where a verb's package is missing."""

from __future__ import annotations

import io
import json
import os
import socket
import subprocess
import sys
from argparse import Namespace
from pathlib import Path

import pytest

import hexalab
from hexalab import catalogue, cli
from hexalab.cli import export
from hexalab.cli.progress import Progress
from hexalab.hosts.offers import FileOffer
from tests.tools import needs

ROOT = Path(__file__).resolve().parents[3]

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")


def test_A2_a_taken_port_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "index.html").write_text("<!doctype html>")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        assert cli.main(["serve", "--out", str(tmp_path), "--port", str(port)]) == cli.MISUSE
    assert capsys.readouterr().err.startswith(f"hexalab: port {port} can't be used: ")


@pytest.mark.parametrize("words", [("serve", "--out")])
def test_A2_a_site_that_is_not_there_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]
) -> None:
    assert cli.main([*words, str(tmp_path / "none")]) == cli.MISUSE
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert "none" in err


OUTPUTS = {"render": ["-o", "x.png"], "export": ["-o", "x.html"]}


@pytest.mark.parametrize(
    ("verb", "package", "remedy"),
    [
        ("build", "site_builder", "in a clone of the repository"),
        ("validate", "yaml", "in a clone of the repository"),
        ("render", "playwright", "pip install 'hexalab[render]'"),
        ("export", "playwright", "pip install 'hexalab[render]'"),
    ],
)
def test_A2_a_verb_whose_package_is_missing_says_what_to_install(
    mesh_file: Path, verb: str, package: str, remedy: str
) -> None:
    words = [verb, str(mesh_file), *OUTPUTS.get(verb, [])]
    script = (
        f"import sys; sys.modules[{package!r}] = None; from hexalab import cli; sys.exit(cli.main({words!r}))"
    )
    path = os.pathsep.join(map(str, (ROOT / "core", ROOT)))
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": path},
    )
    assert (done.returncode, done.stdout) == (cli.MISUSE, "")
    assert len(done.stderr.splitlines()) == 1
    assert package in done.stderr and remedy in done.stderr


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["FILE"], "--out"),
        (["none.mesh", "-o", "p.png"], "none.mesh"),
        (["FILE", "-o", "p.png", "--width", "9000"], "1 to 8192"),
        (["FILE", "-o", "p.png", "--status", "none.json"], "none.json: no such file"),
        (["FILE", "-o", "p.png", "--status", "FILE"], "not JSON"),
        (["FILE", "-o", "p.png", "--status", "list.json"], "expected a JSON object"),
        (["FILE", "-o", "p.png", "--with", "none.mesh"], "none.mesh: the file can't be read"),
        (["FILE", "-o", "p.png", "--with", "list.json"], "list.json"),
        (["FILE", "-o", "p.png", "--with", "broken.stl"], "broken.stl"),
        (["none.mesh", "-o", "p.png", "--with", "FILE"], "none.mesh"),
        (["FILE", "-o", "p.svg", "--with", "FILE", "--transparent"], "figure.transparent"),
    ],
)
def test_A2_a_mistake_in_rendering_is_told_before_a_browser_starts(
    mesh_file: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    words: list[str],
    told: str,
) -> None:
    needs("playwright")
    monkeypatch.chdir(mesh_file.parent)
    Path("list.json").write_text("[1]")
    Path("broken.stl").write_text("solid nothing")
    assert cli.main(["render", *(mesh_file.name if word == "FILE" else word for word in words)]) == cli.MISUSE
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert told in err
    assert not list(Path().glob("p*"))


@pytest.mark.parametrize(
    ("other", "told"),
    [
        ("none", "none: no such file"),
        ("empty", "empty: there is no mesh and no surface in it"),
        ("broken.stl", "broken.stl"),
    ],
)
def test_B2_what_a_batch_can_not_be_compared_with_is_told_before_anything_starts(
    mesh_file: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    other: str,
    told: str,
) -> None:
    needs("playwright")
    monkeypatch.chdir(mesh_file.parent)
    Path("empty").mkdir()
    Path("broken.stl").write_text("solid nothing")
    assert cli.main(["batch", mesh_file.name, "--with", other, "-o", "out"]) == cli.MISUSE
    out, err = capsys.readouterr()
    assert out == "" and told in err and len(err.splitlines()) == 1
    assert not Path("out").exists()


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_A2_progress_shows_on_a_terminal_only() -> None:
    terminal, pipe = Terminal(), io.StringIO()
    for stream in (terminal, pipe):
        with Progress(stream) as tell:
            tell("reading", 0.5)
            tell("done", 2)
    assert pipe.getvalue() == ""
    assert "█" * 12 + "░" * 12 + " reading" in terminal.getvalue()
    assert terminal.getvalue().endswith("\r\x1b[K")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ([], "--out"),
        (["-o", "x.step"], "expected one of .mesh, .vtk, .vtu"),
        (["-o", "x.html.gz"], "found another ending"),
        (["-o", "x.vtu", "--slices", "3"], "--slices is for a page of one file; x.vtu is a mesh"),
        (["-o", "x.glb", "--metrics", "volume"], "--metrics is for a mesh of the shown cells or a page"),
        (["-o", "x.vtu", "--metrics", "none"], "there is no metric 'none'"),
        (["-o", "x.vtu", "--attributes", "cell:none"], "no attribute 'cell:none'"),
        (["-o", "x.html", "--metrics", "none"], "there is no metric 'none'"),
        (["-o", "x.html", "--slices", "0,2"], "places from 0 to 1"),
        (["-o", "x.zip", "--frames", "1"], "a number from 2 to 720"),
        (["-o", "x.webm", "--seconds", "0"], "seconds up to 120"),
    ],
)
def test_A8_what_can_not_be_exported_is_told_before_anything_starts(
    mesh_file: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path,
    capsys: pytest.CaptureFixture[str], words: list[str], told: str,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(
        sys.modules, "hexalab.hosts.browser", None
    )  # a browser would be an error of another kind
    assert cli.main(["export", str(mesh_file), *words]) == cli.MISUSE
    out, err = capsys.readouterr()
    assert out == "" and told in err and len(err.splitlines()) == 1
    assert {path.name for path in tmp_path.iterdir()} <= {mesh_file.name}


def test_A8_shown_cells_are_exported_by_the_core_alone(
    mesh_file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "hexalab.hosts.browser", None)
    whole = hexalab.read(mesh_file)
    status = {"silhouette": 7, "filters": {"quality": {"items": [
        {"quantity": "volume", "keep": "inside", "minimum": None, "maximum": None}
    ]}}}  # fmt: skip
    (tmp_path / "s.json").write_text(json.dumps(status))
    out = tmp_path / "part.vtu.gz"
    words = ["export", str(mesh_file), "-o", str(out), "--metrics", "volume,skew", "--attributes", "none"]
    assert cli.main([*words, "--status", str(tmp_path / "s.json")]) == 0
    told, err = capsys.readouterr()
    part = hexalab.read(out)
    assert told.startswith(f"{out}: {whole.cell_count} of {whole.cell_count} cell")
    assert told.endswith(f", {out.stat().st_size:,} bytes\n")
    assert "silhouette: found 7" in err
    assert set(part.cell_data) == {"volume", "skew"}
    assert part.cell_data["volume"].tolist() == hexalab.quality(whole, "volume").tolist()


def test_A7_a_page_has_the_reference_that_the_catalogue_knows(
    mesh_file: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    offer = FileOffer(mesh_file, "grid.mesh")
    entry = catalogue.Entry("doe-2025/grid", "Grid", "https://example.org/grid.mesh", sha256=offer.sha256())
    source = catalogue.Source(
        "doe-2025", "Hexes", ("Jane Doe",), 2025, "CGF", "10.1111/cgf.0", "authors", {"text": "Doe (2025). Hexes."},
        (entry,),
    )  # fmt: skip
    monkeypatch.setattr(catalogue, "sources", lambda: [source])
    monkeypatch.delenv(catalogue.ADDRESS_VARIABLE, raising=False)
    typed = Namespace(reference=None, link=None)
    told = {"reference": "Doe (2025). Hexes.", "doi": "10.1111/cgf.0", "link": ""}
    assert export.origin(typed, offer) == told
    monkeypatch.setenv(catalogue.ADDRESS_VARIABLE, "https://hexes.example/")
    link = "https://hexes.example/viewer/?mesh=doe-2025/grid"
    assert export.origin(typed, offer) == {**told, "link": link}
    assert export.origin(Namespace(reference="mine", link=None), offer) == {"reference": "mine", "link": ""}

    def nowhere() -> list[catalogue.Source]:
        raise hexalab.HexaLabError("there is no list")

    monkeypatch.setattr(catalogue, "sources", nowhere)
    assert export.origin(typed, offer) == {"reference": "", "link": ""}
