"""Watching files. SPEC A5."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from queue import SimpleQueue

import pytest

from hexalab.hosts.watching import Looks, Watch

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

OLD, NEW, NEWER = (1, 10, 5), (2, 10, 5), (3, 12, 5)


def told(first: tuple[int, int, int] | None, *looks: tuple[int, int, int] | None) -> list[bool]:
    seen = Looks(first)
    return [seen.news(look) for look in looks]


def test_A5_a_file_that_stays_is_no_news():
    assert told(OLD, OLD, OLD, OLD) == [False, False, False]


def test_A5_a_new_version_is_told_once_when_it_has_come_to_rest():
    assert told(OLD, NEW, NEW, NEW) == [False, True, False]


def test_A5_a_file_that_grows_is_waited_for():
    assert told(OLD, NEW, NEWER, (4, 20, 5), (4, 20, 5)) == [False, False, False, True]


def test_A5_a_file_that_vanishes_and_comes_back_is_told_both_times():
    assert told(OLD, None, None, None, NEW, NEW) == [False, True, False, False, True]


def test_A5_an_atomic_replacement_that_leaves_a_gap_of_one_look_is_one_change():
    assert told(OLD, None, NEW, NEW) == [False, False, True]


def test_A5_the_same_version_that_comes_back_is_no_news_unless_it_was_told_gone():
    assert told(OLD, None, OLD, OLD) == [False, False, False]
    assert told(OLD, None, None, OLD, OLD) == [False, True, False, True]


def test_A5_files_are_watched_through_renames_and_removal(tmp_path: Path):
    file, news = tmp_path / "a.mesh", SimpleQueue()
    file.write_text("one")
    watch = Watch({"0": file}, lambda name, there: news.put((name, there)), interval=0.02)
    try:
        for text in ("two", "three"):
            (tmp_path / "new").write_text(text)
            os.replace(tmp_path / "new", file)
            assert news.get(timeout=20) == ("0", True)
        file.unlink()
        assert news.get(timeout=20) == ("0", False)
        file.write_text("four")
        assert news.get(timeout=20) == ("0", True)
    finally:
        watch.close()
    assert news.empty()
