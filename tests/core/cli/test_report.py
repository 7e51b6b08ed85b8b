"""`hexalab report`: files, exit codes, and one line on stderr for what is missed or wrong."""

from __future__ import annotations

import base64
import hashlib
import json
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from hexalab import cli
from hexalab.hosts import offers
from tests.core.report.decks import BAD, deck

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Run:
    def call(*words: Any) -> tuple[int, str, str]:
        code = cli.main(["report", *map(str, words)])
        out, err = capsys.readouterr()
        return code, out, err

    return call


@pytest.fixture
def part(tmp_path: Path) -> Path:
    path = tmp_path / "part.inp"
    path.write_bytes(deck())
    return path


def gate(tmp_path: Path, *entries: dict[str, Any]) -> Path:
    path = tmp_path / "gate.json"
    path.write_text(json.dumps({"criteria": entries}))
    return path


def test_it_writes_each_form_in_one_go(run: Run, part: Path, tmp_path: Path) -> None:
    outs = [tmp_path / f"r.{ending}" for ending in ("html", "md", "json", "xml")]
    words = [word for out in outs for word in ("-o", out)]
    code, out, err = run(part, *words, "--no-pictures", "--unit", "mm")
    assert (code, err) == (0, "")
    assert out.splitlines() == [f"{path}: failed, {path.stat().st_size:,} bytes" for path in outs]
    facts = json.loads(outs[2].read_text("utf-8"))
    assert facts["file"] == {
        "name": "part.inp", "format": "inp", "format_name": "Abaqus", "bytes": len(deck()),
        "sha256": hashlib.sha256(deck()).hexdigest(), "included": [], "unit": "mm",
    }  # fmt: skip
    assert facts["notes"] == []
    assert outs[0].read_text("utf-8").startswith("<!doctype html>") and "Volume (mm³)" in outs[0].read_text(
        "utf-8"
    )
    assert outs[1].read_text("utf-8").startswith("# Report of part.inp")
    assert ElementTree.parse(outs[3]).getroot().tag == "testsuites"
    before = [path.read_bytes() for path in outs]
    run(part, *words, "--no-pictures", "--unit", "mm")
    assert [path.read_bytes() for path in outs] == before, "the same input gives the same bytes"


def test_a_report_is_no_judgement_but_strict_is(run: Run, part: Path, tmp_path: Path) -> None:
    out = tmp_path / "r.json"
    assert run(part, "-o", out)[0] == 0
    assert json.loads(out.read_text())["verdict"]["passed"] is False
    code, _, err = run(part, "-o", out, "--strict")
    assert code == 1
    assert len(err.splitlines()) == 2 and all(f"cells {BAD}" in line for line in err.splitlines())
    part.write_bytes(deck(bad=False))
    assert run(part, "-o", out, "--strict")[::2] == (0, "")


def test_criteria_decide_the_exit_code(run: Run, part: Path, tmp_path: Path) -> None:
    out = tmp_path / "r.xml"
    tight = gate(tmp_path, {"metric": "scaled_jacobian", "minimum": 0.2})
    code, _, err = run(part, "-o", out, "--criteria", tight)
    assert code == 1
    told = f"Scaled Jacobian: at least 0.2: 1 of 4 cells (25 %) miss it. cells {BAD} ("
    assert err.startswith(f"hexalab: {part}: missed: {told}")
    loose = gate(tmp_path, {"metric": "scaled_jacobian", "minimum": 0.2, "share": 0.25})
    assert run(part, "-o", out, "--criteria", loose)[::2] == (0, "")
    assert run(part, "-o", out, "--criteria", loose, "--strict")[0] == 1
    (suite,) = ElementTree.parse(out).getroot()
    assert (suite.attrib["tests"], suite.attrib["failures"]) == ("3", "2")


def test_misuse_is_told_in_one_line_and_writes_nothing(run: Run, part: Path, tmp_path: Path) -> None:
    out = tmp_path / "r.json"
    unknown, absent = gate(tmp_path, {"metric": "sj", "minimum": 0}), tmp_path / "absent.json"
    iron = tmp_path / "iron.json"
    iron.write_text('[{"invalid": 0, "group": "IRON"}]')
    for words, told in (
        ((part, "-o", tmp_path / "r.pdf"), "found no form of a report, expected one of .html"),
        ((tmp_path / "none.inp", "-o", out), "none.inp"),
        ((part, "-o", out, "--criteria", absent), "absent.json: no such file"),
        ((part, "-o", out, "--criteria", unknown), "criteria[0].metric: found 'sj'"),
        ((part, "-o", out, "--criteria", iron), "no group 'IRON'"),
        ((part,), "required: -o/--out"),
    ):
        code, printed, err = run(*words)
        assert (code, printed) == (2, "") and len(err.splitlines()) == 1 and told in err, err
        assert not out.exists()


def test_without_a_browser_the_report_says_that_it_lacks_pictures(
    run: Run, part: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("exporting", "headless", "rendering"):
        monkeypatch.delitem(sys.modules, f"hexalab.hosts.{name}", raising=False)
    monkeypatch.setitem(sys.modules, "playwright.sync_api", None)
    monkeypatch.setitem(sys.modules, "playwright", None)
    outs = [tmp_path / "r.html", tmp_path / "r.json"]
    code, _, err = run(part, "-o", outs[0], "-o", outs[1])
    told = "Pictures are left out: the package playwright is not installed (pip install 'hexalab[render]')"
    assert code == 0 and err.startswith(f"hexalab: {told[:60]}") and len(err.splitlines()) == 1
    assert told[:60] in outs[0].read_text("utf-8") and "<img" not in outs[0].read_text("utf-8")
    assert json.loads(outs[1].read_text())["notes"] == [], "it never has pictures"


def test_pictures_are_in_the_page_and_beside_the_markdown(
    run: Run, part: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    taken = [{"title": f"Picture {k}.", "alt": "seen", "data": bytes([k])} for k in range(3)]
    monkeypatch.setattr("hexalab.cli.report.pictures", lambda offer, unit: (taken, ""))
    run(part, "-o", tmp_path / "r.html", "-o", tmp_path / "r.md")
    page, text = ((tmp_path / name).read_text("utf-8") for name in ("r.html", "r.md"))
    for place, one in enumerate(taken):
        assert f'src="data:image/png;base64,{base64.b64encode(one["data"]).decode()}"' in page
        assert f"![seen](<r-{place + 1}.png>)" in text
        assert (tmp_path / f"r-{place + 1}.png").read_bytes() == one["data"]


def test_a_file_that_changes_meanwhile_is_told(
    run: Run, part: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = offers.FileOffer.mesh

    def meanwhile(offer: offers.FileOffer) -> Any:
        found = read(offer)
        part.write_bytes(deck() + b"** more\n")
        return found

    monkeypatch.setattr(offers.FileOffer, "mesh", meanwhile)
    code, _, err = run(part, "-o", tmp_path / "r.json")
    assert code == 2 and "was changed while it was read" in err and not (tmp_path / "r.json").exists()
