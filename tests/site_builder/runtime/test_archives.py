"""Archives whose bytes depend on their content alone; a wheel's RECORD, read back by the package `wheel`."""

from __future__ import annotations

import io
import zipfile
from pathlib import Path

import pytest
from wheel.wheelfile import WheelError, WheelFile

from site_builder.runtime.archives import packed, unpacked

FILES = {
    "one/__init__.py": b"",
    "one/code.py": b"x = 1\n" * 100,
    "one/tests/test_code.py": b"",
    "one-1.0.dist-info/RECORD": b"one/gone.py,sha256=abc,3\n",
    "one-1.0.dist-info/WHEEL": b"Wheel-Version: 1.0\n",
}


def zipped(files: dict[str, bytes]) -> bytes:
    """By Python's own means: today's date, the order given, a folder too."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr("one/", b"")
        for name, data in files.items():
            archive.writestr(name, data)
    return out.getvalue()


def test_the_same_files_give_the_same_bytes_in_whatever_order_they_come() -> None:
    backwards = dict(reversed(FILES.items()))
    assert packed(FILES) == packed(backwards) == packed(unpacked(packed(FILES)))
    with zipfile.ZipFile(io.BytesIO(packed(FILES))) as archive:
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
        assert archive.getinfo("one/code.py").compress_size < 100


def test_folders_and_unwanted_files_are_left_out() -> None:
    assert unpacked(zipped(FILES)) == FILES
    kept = unpacked(zipped(FILES), [r"(^|/)tests/", r"^one/__init__\.py$"])
    assert sorted(kept) == ["one-1.0.dist-info/RECORD", "one-1.0.dist-info/WHEEL", "one/code.py"]


def test_a_wheels_record_names_what_the_wheel_holds(tmp_path: Path) -> None:
    """The package `wheel` compares every file that it reads with RECORD."""
    path = tmp_path / "one-1.0-py3-none-any.whl"
    path.write_bytes(packed(unpacked(zipped(FILES))))
    with WheelFile(path) as wheel:
        names = [name for name in wheel.namelist() if not name.endswith("/RECORD")]
        assert sorted([*names, "one-1.0.dist-info/RECORD"]) == sorted(FILES)
        assert {name: wheel.read(name) for name in names} == {name: FILES[name] for name in names}
    path.write_bytes(zipped(FILES))
    with WheelFile(path) as stale, pytest.raises(WheelError):
        stale.read("one/code.py")
