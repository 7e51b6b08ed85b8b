"""What is remembered between builds does not grow for ever (SPEC C7)."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from site_builder.kept import is_kept, prune, remember, remembered


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


def test_C7_what_was_interrupted_is_not_remembered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A build that is killed while it writes leaves no half of a file that later builds would trust."""
    file = tmp_path / "built" / "index-1"
    whole = Path.write_bytes

    def killed(path: Path, data: bytes) -> int:
        whole(path, data[:2])
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_bytes", killed)
        with pytest.raises(KeyboardInterrupt):
            remember(file, lambda: b"all of it")
    assert not file.exists()
    assert remember(file, lambda: b"all of it").read_bytes() == b"all of it"
    assert remember(file, lambda: b"something else").read_bytes() == b"all of it", "it is remembered"


def test_C7_what_is_made_of_something_else_is_made_anew(tmp_path: Path) -> None:
    made = []
    for number, parts in enumerate([(b"ab",), (b"a", b"b"), (b"abc",), (b"ab",)]):
        made.append(remembered(tmp_path, "sum", parts, lambda number=number: b"%d" % number))
    assert made == [b"0", b"1", b"2", b"0"], "where a part ends counts, too"
    assert remembered(None, "sum", (b"ab",), lambda: b"x") == b"x", "without a folder nothing is remembered"
