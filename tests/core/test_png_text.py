"""Settings inside PNG pictures (SPEC S3), read back by a PNG library where one is there."""

from __future__ import annotations

import json
import zlib
from pathlib import Path

import pytest

from hexalab.png_text import PngError, read_settings, read_text
from tests.core.pictures import chunk, png, write_text
from tests.published import picture
from tests.tools import tool

TEXT = '{"version": 1, "name": "è ∎"}'


CARRIERS = [
    chunk(b"iTXt", b"hexalab\0\0\0\0\0" + TEXT.encode()),
    chunk(b"iTXt", b"hexalab\0\1\0en\0key\0" + zlib.compress(TEXT.encode())),
    chunk(b"zTXt", b"hexalab\0\0" + zlib.compress(b'{"version": 1}')),
    chunk(b"tEXt", b"hexalab\0" + b'{"version": 1}'),
]


@pytest.mark.parametrize("carrier", CARRIERS)
def test_S3_each_kind_of_text_chunk_is_read(carrier: bytes) -> None:
    other = chunk(b"tEXt", b"Software\0other")
    assert read_settings(png(other, carrier))["version"] == 1


@pytest.mark.parametrize("carrier", CARRIERS)
def test_S3_writing_replaces_and_stands_before_IEND(carrier: bytes) -> None:
    other = chunk(b"tEXt", b"Software\0other")
    data = write_text(png(other, carrier), TEXT)
    assert read_text(data) == TEXT
    assert data.count(b"hexalab\0") == 1
    assert read_text(data, "Software") == "other"
    assert data.endswith(chunk(b"iTXt", b"hexalab\0\0\0\0\0" + TEXT.encode()) + chunk(b"IEND", b""))


def test_S3_a_png_library_reads_what_we_write(tmp_path: Path) -> None:
    vtk = tool("vtkmodules.vtkIOImage")
    reader = vtk.vtkPNGReader()
    path = tmp_path / "picture.png"
    path.write_bytes(write_text(png(), "{}"))
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetOutput().GetDimensions() == (1, 1, 1)
    assert reader.GetErrorCode() == 0


@pytest.mark.parametrize("name", [f"original-{number}.png" for number in (1, 3, 4, 5)])
def test_S3_pictures_of_the_original_are_read_and_rewritten(name: str) -> None:
    data = picture(name).read_bytes()
    settings = read_settings(data)
    assert settings["rendering"]["lighting"] == "AO"
    again = write_text(data, json.dumps({"version": 1}))
    assert read_settings(again) == {"version": 1}
    assert abs(len(again) - len(data)) < 3000


LARGE = zlib.compress(bytes(17 * 1024 * 1024))


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"", "not a PNG"),
        (b"GIF89a" + bytes(40), "not a PNG"),
        (png()[:-4], "cut off"),
        (png()[:50], "cut off"),
        (png(), "no settings"),
        (png(chunk(b"tEXt", b"hexalab\0{")), "not JSON"),
        (png(chunk(b"iTXt", b"hexalab\0\0\0\0\0\xff")), "not UTF-8"),
        (png(chunk(b"zTXt", b"hexalab\0\0abc")), "decompressed"),
        (png(chunk(b"zTXt", b"hexalab\0\0" + LARGE)), "larger than"),
    ],
)
def test_S3_what_carries_no_settings_is_told(data: bytes, words: str) -> None:
    with pytest.raises(PngError, match=words):
        read_settings(data)
