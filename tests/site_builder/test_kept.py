"""What is remembered between builds does not grow for ever (SPEC C7)."""

from __future__ import annotations

import os
from pathlib import Path

from site_builder.kept import is_kept, prune


def kept(cache: Path, name: str, used: float, size: int = 100) -> Path:
    file = cache / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(bytes(size))
    os.utime(file, (used, used))
    return file


def test_C7_what_nobody_has_used_for_longest_is_forgotten(tmp_path: Path) -> None:
    old, older, new = (
        kept(tmp_path, name, used)
        for name, used in (("pictures/a.png", 20), ("made/x/b.mesh", 10), ("facts/c.json", 30))
    )
    other = kept(tmp_path, "runtime-1/d", 1)
    assert prune(tmp_path, since=40, most=250) == 1
    assert [file.exists() for file in (old, older, new, other)] == [True, False, True, True]


def test_C7_what_was_used_just_now_stays_however_much_it_is(tmp_path: Path) -> None:
    files = [kept(tmp_path, f"preview/{number}", number) for number in range(5)]
    assert is_kept(files[0]) and not is_kept(tmp_path / "preview" / "gone")
    assert prune(tmp_path, since=1000, most=0) == 4
    assert [file.exists() for file in files] == [True, False, False, False, False]
