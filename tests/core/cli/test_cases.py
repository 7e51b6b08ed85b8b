"""Small files of real tools' kinds, that were once read wrongly or refused: what the command line tells of each."""

from __future__ import annotations

import json
from typing import Any

import pytest

from hexalab import cli, read
from tests.core.formats.case_rows import CASES, ROWS, Row
from tests.published import SHARED
from tests.tools import needs

READ = {name: row for name, row in ROWS.items() if not row.refused}
REFUSED = {name: row for name, row in ROWS.items() if row.refused}


def test_each_file_has_its_row() -> None:
    assert {path.name for path in CASES.iterdir()} == set(ROWS)


@pytest.mark.skipif(not (SHARED / "cases").is_dir(), reason="needs the folder of cases, which is not here")
def test_the_files_are_those_that_were_handed_on() -> None:
    handed_on = {path.name: path.read_bytes() for path in (SHARED / "cases" / "formats").iterdir()}
    assert {name: (CASES / name).read_bytes() for name in handed_on} == handed_on


@pytest.mark.parametrize("name", READ)
def test_info_tells_what_the_row_says(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    row = READ[name]
    if row.refused_in_page:
        needs("_lzma")
    assert cli.main(["info", "--json", str(CASES / name)]) == 0
    facts = json.loads(capsys.readouterr().out)
    assert facts["kinds"] == row.kinds
    quality = facts["quality"]
    assert quality["volume"]["mean"] * facts["cells"] == pytest.approx(row.volume)
    assert_told(row, quality["scaled_jacobian"], facts["findings"])


@pytest.mark.parametrize("name", REFUSED)
def test_info_refuses_in_the_words_of_the_row(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["info", str(CASES / name)]) == 2
    out, error = capsys.readouterr()
    assert not out
    assert REFUSED[name].refused in error
    assert name in error
    assert "Traceback" not in error


@pytest.mark.parametrize("name", [name for name, row in READ.items() if row.groups])
def test_groups_are_what_the_row_says(name: str) -> None:
    groups = read(CASES / name).groups
    assert tuple(group.name for group in groups) == READ[name].groups
    assert all(group.count for group in groups)


@pytest.mark.parametrize("name", [name for name, row in READ.items() if row.attributes])
def test_attributes_are_what_the_row_says(name: str) -> None:
    data = read(CASES / name).cell_data
    for array, least, greatest in READ[name].attributes:
        assert (int(data[array].min()), int(data[array].max())) == (least, greatest)


def assert_told(row: Row, scaled_jacobian: dict[str, Any], findings: list[dict[str, Any]]) -> None:
    """Hold the row against what is told, by the command line or by the page."""
    assert (scaled_jacobian["min"], scaled_jacobian["max"]) == pytest.approx(row.scaled_jacobian)
    notes = [finding["message"] for finding in findings if finding["id"] in ("reading", "turned_round")]
    assert len(notes) == len(row.notes), notes
    for words in row.notes:
        assert any(words in note for note in notes), (words, notes)
