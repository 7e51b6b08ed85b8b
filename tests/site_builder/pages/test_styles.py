"""The style sheets: parts by component, put together in the order of one table."""

import re
from statistics import median

import pytest

from hexalab import HexaLabError
from site_builder.pages.assets import assets
from site_builder.pages.styles import SHEETS, STYLES, style_sheets


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "room").mkdir()
    (tmp_path / "tokens.css").write_text(":root { --ink: #000; }\n")
    (tmp_path / "room" / "a.css").write_text(".a { color: red; }\n")
    (tmp_path / "room" / "b.css").write_text('.b::before { content: "é"; }\n', "utf-8")
    return tmp_path


def test_the_parts_come_in_the_order_of_the_table(folder):
    sheets = style_sheets(folder, {"one": ("tokens", "room/b", "room/a"), "two": ("tokens", "room/a")})
    assert sheets == {
        "one": ':root { --ink: #000; }\n\n.b::before { content: "é"; }\n\n.a { color: red; }\n',
        "two": ":root { --ink: #000; }\n\n.a { color: red; }\n",
    }


def test_a_part_that_no_sheet_has_is_an_error(folder):
    with pytest.raises(HexaLabError, match=r"no sheet .* has room/b\.css"):
        style_sheets(folder, {"one": ("tokens", "room/a")})


def test_a_part_that_is_not_there_is_an_error(folder):
    with pytest.raises(HexaLabError, match=r"there is no room/c\.css"):
        style_sheets(folder, {"one": ("tokens", "room/a", "room/b", "room/c")})


def test_nothing_is_left_out_and_nothing_comes_twice():
    lines = dict.fromkeys(SHEETS, 0)
    for file in STYLES.rglob("*.css"):
        text = file.read_text("utf-8")
        room = file.relative_to(STYLES).parts[0]
        for name, sheet in style_sheets().items():
            assert sheet.count(text) == (room == name or room not in SHEETS), (name, file)
            lines[name] += sheet.count(text) * (text.count("\n") + 1)
    assert lines == {name: sheet.count("\n") + 1 for name, sheet in style_sheets().items()}


def test_tokens_come_first_and_paper_last():
    assert all(parts[0] == "tokens" for parts in SHEETS.values())
    assert SHEETS["catalogue"][-1] == "catalogue/print", "paper overrules the screen"


def test_the_parts_are_short():
    lines = {file: len(file.read_text("utf-8").splitlines()) for file in STYLES.rglob("*.css")}
    assert max(lines.values()) <= 400
    assert median(lines.values()) < 150


def test_a_page_links_one_sheet_and_the_site_has_no_other(site):
    sheets = assets().styles
    assert {f"styles/{file.name}" for file in (site / "styles").rglob("*")} == set(sheets.values())
    for page in site.rglob("*.html"):
        links = re.findall(r'<link rel="stylesheet" href="([^"]*)"', page.read_text("utf-8"))
        sheet = sheets["embed" if page.parent.name == "embed" else "catalogue"]
        assert [(page.parent / link).resolve() for link in links] == [site.resolve() / sheet]
    assert (site / sheets["viewer"]).read_text("utf-8") == style_sheets()["viewer"]
