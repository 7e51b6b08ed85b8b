"""The report that the page makes: the command line's, with pictures that the viewer takes."""

from __future__ import annotations

import base64
import hashlib
import io
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

import hexalab
from hexalab.png_text import read_settings
from hexalab.report import About, MetricCriterion, ReportPicture, collect, written

from ..test_ui_page import AXE, violations
from .asking import HALF, PLAIN, put, run, take

pytestmark = pytest.mark.browser

IMAGE = re.compile(r'<img src="data:image/png;base64,([^"]+)" alt="([^"]+)">')


def about(path: Path, unit: str = "none") -> About:
    data = path.read_bytes()
    return About(path.name, len(data), hashlib.sha256(data).hexdigest(), unit)


def pictures(text: str) -> list[tuple[bytes, str]]:
    return [(base64.b64decode(data), alt) for data, alt in IMAGE.findall(text)]


def test_the_page_makes_the_report_of_the_command_line_with_pictures(viewer: Page, brick: Path) -> None:
    put(viewer, {"unit": "mm", **HALF})
    before = viewer.evaluate("() => window.hexalab.getStatus()")
    text = take(viewer, "report").decode()
    assert viewer.evaluate("() => window.hexalab.getStatus()") == before, "settings are what they were"
    taken = pictures(text)
    titles = re.findall(r"<figcaption>([^<]+)</figcaption></figure>", text)[:3]
    facts = collect(hexalab.read(brick), about(brick, "mm"))
    shown = [
        ReportPicture(title, alt, f"data:image/png;base64,{base64.b64encode(data).decode()}")
        for title, (data, alt) in zip(titles, taken, strict=True)
    ]
    assert text == written(facts, "html", shown)


def test_the_pictures_show_the_whole_a_cut_and_the_worst_cell(viewer: Page) -> None:
    put(viewer, HALF, PLAIN, {"silhouette": 0, "colour": {"by": "kind"}})
    taken = [data for data, _ in pictures(take(viewer, "report").decode())]
    assert len(taken) == 3
    seen = [np.asarray(Image.open(io.BytesIO(data)).convert("RGB")).astype(int) for data in taken]
    assert {one.shape for one in seen} == {(709, 1063, 3)}, "90 x 60 mm at 300 dots per inch, on any screen"
    drawn = [(one.min(axis=2) < 235).mean() for one in seen]
    assert all(part > 0.03 for part in drawn), "each shows something"
    coloured = [(one.max(axis=2) - one.min(axis=2) > 60).mean() for one in seen]
    assert coloured[0] < 0.02 < min(coloured[1:]), "the first is not coloured by quality"
    whole, cut, worst = (read_settings(data) for data in taken)
    assert whole["filters"]["planes"]["items"][0]["offset"] == 0, "nothing of what was set by hand"
    assert (
        cut["filters"]["planes"]["items"][0]["offset"] == 0.5 and cut["colour"]["metric"] == "scaled_jacobian"
    )
    assert worst["filters"]["picking"]["isolated"] and 0 in worst["filters"]["picking"]["shown"]
    assert whole["lighting"]["mode"] == "object_space_ao"


def test_criteria_decide_in_the_page_too(viewer: Page, brick: Path) -> None:
    asked = [{"metric": "volume", "minimum": 1.5}]
    ask = """([form, wanted]) =>
      window.hexalab.report(form, wanted).then(({ passed }) => passed, ({ message }) => message)"""
    assert viewer.evaluate(ask, ["json", {"criteria": asked}]) is False
    assert viewer.evaluate(ask, ["json", {"criteria": [{"metric": "volume", "minimum": 0.5}]}]) is True
    assert "criteria[0]: found the keys metrics" in viewer.evaluate(
        ask, ["json", {"criteria": [{"metrics": 1}]}]
    )
    assert "found no form of a report" in viewer.evaluate(ask, ["pdf", {}])
    told = json.loads(take(viewer, "report", "json", {"criteria": asked}))
    assert told == collect(hexalab.read(brick), about(brick), [MetricCriterion("volume", 1.5)])


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (360, 740)])
def test_axe_finds_nothing_in_the_report(
    viewer: Page, chromium: Browser, tmp_path: Path, scheme: Any, size: tuple[int, int]
) -> None:
    path = tmp_path / "report.html"
    asked = [{"metric": "volume", "minimum": 1.5}, {"invalid": 0}]
    path.write_bytes(take(viewer, "report", "html", {"criteria": asked, "strict": True}))
    viewport = {"width": size[0], "height": size[1]}
    context = chromium.new_context(viewport=viewport, offline=True, color_scheme=scheme)  # type: ignore[arg-type]
    page = context.new_page()
    told: list[str] = []
    page.on("console", lambda message: told.append(message.text))
    page.add_init_script(AXE.read_text())
    page.goto(path.as_uri())
    assert page.locator("img").count() == 3
    assert page.evaluate("() => [...document.images].every((one) => one.naturalWidth > 0)")
    assert violations(page) == []
    assert page.evaluate("() => document.documentElement.scrollWidth") <= size[0]
    assert told == []
    context.close()


def test_the_command_line_takes_the_same_pictures(
    brick: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page, text = tmp_path / "r.html", tmp_path / "r.md"
    assert run(["report", str(brick), "-o", str(page), "-o", str(text), "--unit", "mm"]) == 0
    assert capsys.readouterr().err == ""
    taken = [data for data, _ in pictures(page.read_text("utf-8"))]
    beside = [tmp_path / f"r-{place}.png" for place in (1, 2, 3)]
    assert taken == [path.read_bytes() for path in beside]
    assert [read_settings(data)["unit"] for data in taken] == ["mm"] * 3
    assert "![The whole mesh, seen three quarters from above.](<r-1.png>)" in text.read_text("utf-8")
