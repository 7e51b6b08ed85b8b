"""The verbs that hand over to the site builder: what they pass on and how they answer."""

from __future__ import annotations

from pathlib import Path

import pytest

from hexalab import cli


def test_A2_build_names_what_is_wrong_in_the_repository(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "repository" / "Bad Name").mkdir(parents=True)
    words = ["build", "--repository", str(tmp_path / "repository"), "--out", str(tmp_path / "site")]
    assert cli.main(words) == cli.FINDING
    out, err = capsys.readouterr()
    assert out == ""
    assert "no source.yaml" in err
    assert "Traceback" not in err


def test_C6_a_new_source_is_refused_until_it_is_filled_in(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["new-source", "A cube", "--repository", str(tmp_path)]
    assert cli.main(words) == 0
    out, err = capsys.readouterr()
    file = Path(out.split(":")[0])
    assert file.is_file() and file.parent.parent == tmp_path
    assert f"hexalab validate {file.parent}" in out
    assert err == ""
    assert cli.main(["validate", str(file.parent)]) == cli.FINDING
    out, err = capsys.readouterr()
    assert out.startswith("## Refused") and "source.yaml" in out
    assert err == ""
    assert cli.main(words) == cli.MISUSE
    assert "there already" in capsys.readouterr().err


@pytest.mark.parametrize("words", [("build", "--repository"), ("validate",)])
def test_A2_a_folder_that_is_not_there_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: tuple[str, ...]
) -> None:
    assert cli.main([*words, str(tmp_path / "none")]) == cli.MISUSE
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert "none" in err


@pytest.mark.parametrize("verb", ["build", "validate", "new-source"])
def test_A2_help_for_every_verb_of_the_clone(capsys: pytest.CaptureFixture[str], verb: str) -> None:
    assert cli.main([verb, "--help"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert out.startswith(f"usage: hexalab {verb}")
    assert cli.VERBS[verb].module.startswith("site_builder.")
