"""SPEC R6: gzip by content and within bounds; files that are no meshes."""

from __future__ import annotations

import gzip
import io
import zlib
from pathlib import Path

import pytest

from hexalab.errors import MeshReadError, MeshWriteError
from hexalab.formats import FORMATS, container, read, read_bytes, write
from tests.core.formats.samples import check, grid
from tests.core.formats.test_medit import text_of

SAMPLE = grid(4, 3, 2)
DATA = text_of(SAMPLE).encode()


def test_R6_gzip_by_content_not_by_name(tmp_path: Path) -> None:
    for name in ("x.mesh", "x.mesh.gz", "x.gz", "noname", ""):
        check(read_bytes(gzip.compress(DATA), name), SAMPLE)
    (tmp_path / "x.mesh").write_bytes(gzip.compress(DATA))
    check(read(tmp_path / "x.mesh"), SAMPLE)
    check(read(io.BytesIO(gzip.compress(DATA))), SAMPLE)


def test_R6_several_members_and_padding() -> None:
    parts = gzip.compress(DATA[:500]) + gzip.compress(DATA[500:])
    check(read_bytes(parts, "x.mesh"), SAMPLE)
    check(read_bytes(parts + b"\0" * 100, "x.mesh"), SAMPLE)


@pytest.mark.parametrize("data", [bytearray(DATA), memoryview(DATA), memoryview(gzip.compress(DATA))])
def test_R6_any_bytes_like(data) -> None:
    check(read_bytes(data, "x.mesh"), SAMPLE)


@pytest.mark.parametrize("cut", [2, 9, 11, 40, 200, -9, -1])
def test_R10_gzip_cut_short(cut: int) -> None:
    with pytest.raises(MeshReadError, match="gzip stream"):
        read_bytes(gzip.compress(DATA)[:cut], "x.mesh")


def test_R10_gzip_damaged() -> None:
    data = bytearray(gzip.compress(DATA))
    data[60] ^= 255
    with pytest.raises(MeshReadError, match=r"x\.mesh.*gzip stream is damaged"):
        read_bytes(bytes(data), "x.mesh")
    with pytest.raises(MeshReadError, match="gzipped twice"):
        read_bytes(gzip.compress(gzip.compress(DATA)), "x.mesh")


def test_R10_gzip_bomb_is_refused_while_inflating(monkeypatch: pytest.MonkeyPatch) -> None:
    stream = zlib.compressobj(9, wbits=31)
    bomb = b"".join(stream.compress(b"0 " * 2**19) for _ in range(100)) + stream.flush()
    monkeypatch.setattr(container, "ALWAYS_FINE", 2**22)
    with pytest.raises(MeshReadError, match="inflates to more than"):
        read_bytes(bomb, "bomb.mesh")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "empty"),
        (b" \n\n", "empty"),
        (b"\0\0\0\0", "empty"),
        (gzip.compress(b"", mtime=0), "empty"),
        (b"\x89PNG\r\n\x1a\n....", "PNG picture"),
        (b"\xff\xd8\xff\xe0", "JPEG"),
        (b"%PDF-1.4", "PDF"),
        (b"PK\x03\x04....", "zip archive"),
        (b"\x89HDF\r\n\x1a\n", "HDF5"),
        (b"OVMB\n\r\n\xff....", r"binary \.ovmb"),
        ("MeshVersionFormatted 1".encode("utf-16"), "UTF-16"),
    ],
)
def test_R10_what_is_no_mesh_is_named(data: bytes, words: str) -> None:
    for name in ("x.mesh", "x.vtk", "x.vtu", "x"):
        with pytest.raises(MeshReadError, match=words) as caught:
            read_bytes(data, name)
        assert caught.value.file == name


def test_R10_unknown_content_and_name() -> None:
    with pytest.raises(MeshReadError, match=r"expected one of \.mesh, "):
        read_bytes(b"some notes on meshes", "x.txt")
    for row in FORMATS:
        with pytest.raises(MeshReadError):
            read_bytes(b"solid cube\nfacet normal 0 0 1", "x" + row.extensions[0])
        with pytest.raises(MeshReadError):
            read_bytes(b"\x07\x01\x80\xff" * 50, "x" + row.extensions[0])


def test_R10_files_that_are_not_there(tmp_path: Path) -> None:
    with pytest.raises(MeshReadError, match="No such file"):
        read(tmp_path / "none.mesh")
    with pytest.raises(MeshReadError, match="can't be read"):
        read(tmp_path)
    mesh = read_bytes(DATA, "x.mesh")
    with pytest.raises(MeshWriteError, match=r"expected one of \.mesh, \.vtk, \.vtu"):
        write(mesh, tmp_path / "x.stl")
    with pytest.raises(MeshWriteError, match="can't be written"):
        write(mesh, tmp_path / "none" / "x.mesh")
