"""Pages are rendered again if something they are made of has changed, and only then (SPEC C7)."""

from __future__ import annotations

from pathlib import Path

import pytest

from site_builder import build
from site_builder.pages.pages import Pages


@pytest.fixture
def rendered(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Pages that are rendered from now on."""
    pages: list[str] = []
    render = Pages._render

    def told(self, template: str, page: str, **values: object) -> str:
        pages.append(page)
        return render(self, template, page, **values)

    monkeypatch.setattr(Pages, "_render", told)
    return pages


def site(folder: Path) -> dict[str, bytes]:
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*.html")}


def test_C7_what_has_not_changed_is_not_rendered_again(
    demo: Path, tmp_path: Path, rendered: list[str]
) -> None:
    out = tmp_path / "site"
    build(demo, out, runtime=False)
    first, pages = site(out), len(rendered)
    rendered.clear()
    build(demo, out, runtime=False)
    assert site(out) == first
    assert pages > len(rendered) and not any(page.startswith("sources/") for page in rendered)


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("far/source.yaml", "title: ", "title: Not "),
        ("far/facts.json", '"cells": 844', '"cells": 845'),
        ("catalogue.yaml", "title: ", "title: Not "),
    ],
)
def test_C7_what_has_changed_is_rendered_as_if_nothing_were_remembered(
    demo: Path, tmp_path: Path, rendered: list[str], file: str, before: str, after: str
) -> None:
    build(demo, tmp_path / "site", runtime=False, cache=tmp_path / "cache")
    text = (demo / file).read_text("utf-8")
    assert before in text
    (demo / file).write_text(text.replace(before, after, 1), "utf-8")
    rendered.clear()
    build(demo, tmp_path / "site", runtime=False, cache=tmp_path / "cache")
    assert "sources/far/" in rendered
    build(demo, tmp_path / "anew", runtime=False, cache=tmp_path / "none")
    assert site(tmp_path / "site") == site(tmp_path / "anew")
