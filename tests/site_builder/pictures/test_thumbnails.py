"""Thumbnails: kept by content, shown by the next build, missed by nobody."""

import struct
import zlib

from site_builder import build
from site_builder.build import BuildReport
from site_builder.pictures.thumbnails import HEIGHT, WIDTH, Thumbnails
from site_builder.reading.repository import read_repository


def png(width, height):
    """A white picture."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = (b"\0" + b"\xff" * width) * height
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )


def measured(demo, cache):
    """The catalogue with facts, as a build knows it."""
    from site_builder.measuring.measurer import Measurer

    catalogue = read_repository(demo)
    for mesh in catalogue.meshes:
        if mesh.local:
            mesh.facts = Measurer(cache).facts(mesh.local)
    return catalogue


def test_C2_a_thumbnail_is_shown_by_the_next_build(demo, tmp_path):
    cache = tmp_path / "cache"
    out = tmp_path / "site"
    build(demo, out, runtime=False)
    thumbnails = Thumbnails(cache)
    wanted = thumbnails.wanted(measured(demo, cache))
    assert [mesh.id for mesh in wanted] == ["small/pair", "small/parts-turned"]
    thumbnails.keep(wanted[0], png(WIDTH, HEIGHT))
    report = build(demo, out, runtime=False)
    assert isinstance(report, BuildReport)
    assert report.measured == 0
    page = (out / "sources/small/pair/index.html").read_text("utf-8")
    assert 'src="../../../pictures/small/pair.png"' in page
    assert 'content="https://meshes.example.org/hex/pictures/small/pair.png"' in page
    assert (out / "pictures/small/pair.png").read_bytes() == png(WIDTH, HEIGHT)
    assert 'src="pictures/small/pair.png"' in (out / "index.html").read_text("utf-8")
    assert [mesh.id for mesh in thumbnails.wanted(measured(demo, cache))] == ["small/parts-turned"]


def test_C2_a_changed_mesh_wants_another_thumbnail(demo, tmp_path):
    cache = tmp_path / "cache"
    catalogue = measured(demo, cache)
    thumbnails = Thumbnails(cache)
    for mesh in thumbnails.wanted(catalogue):
        thumbnails.keep(mesh, png(3, 2))
    assert thumbnails.wanted(measured(demo, cache)) == []
    file = demo / "small" / "pair.mesh"
    file.write_text(file.read_text().replace("2 1 1 0", "2.5 1 1 0"))
    assert [mesh.id for mesh in thumbnails.wanted(measured(demo, cache))] == ["small/pair"]
