"""Meshes that a host has at hand. SPEC A5."""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path
from typing import Any

import pytest

from hexalab import MeshReadError
from hexalab.hosts.offers import (
    BytesOffer,
    FileOffer,
    SurfaceOffer,
    compared_offers,
    file_offers,
    listed,
    other_bytes,
    other_file,
    stamp_of,
)

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")


def test_A5_a_version_is_read_once_and_a_new_one_again(tmp_path: Path, grid: Any):
    file = tmp_path / "a.mesh"
    file.write_bytes(grid(2, 1, 1))
    offer = FileOffer(file, "a.mesh")
    first = offer.mesh()
    assert (first.cell_count, offer.mesh() is first) == (2, True)
    file.write_bytes(grid(3, 1, 1))
    assert offer.mesh().cell_count == 3


def test_A5_what_can_not_be_read_is_told_each_time_and_read_when_it_can(tmp_path: Path, grid: Any):
    file = tmp_path / "a.mesh"
    file.write_bytes(grid(2, 1, 1)[:60])
    offer = FileOffer(file, "a.mesh")
    offer.read_ahead().join()
    for _ in range(2):
        with pytest.raises(MeshReadError):
            offer.mesh()
    file.unlink()
    with pytest.raises(MeshReadError, match="No such file"):
        offer.mesh()
    file.write_bytes(grid(2, 1, 1))
    assert offer.mesh().cell_count == 2


def test_A5_a_file_is_identified_by_its_bytes(tmp_path: Path):
    file = tmp_path / "a.mesh"
    assert FileOffer(file, "a").sha256() == ""
    file.write_bytes(b"abc")
    assert FileOffer(file, "a").sha256() == hashlib.sha256(b"abc").hexdigest()


def test_A5_files_of_one_name_are_told_apart(tmp_path: Path):
    names = [
        offer.name
        for offer in file_offers([tmp_path / "a/x.mesh", tmp_path / "b/x.mesh", tmp_path / "y.mesh"]).values()
    ]
    assert names == [str(tmp_path / "a/x.mesh"), str(tmp_path / "b/x.mesh"), "y.mesh"]


def test_A5_a_version_is_known_by_time_size_and_inode(tmp_path: Path):
    file = tmp_path / "a"
    assert stamp_of(file) is None
    file.write_text("x")
    first = stamp_of(file)
    assert stamp_of(file) == first
    os.utime(file, ns=(1, 1))
    assert stamp_of(file) != first


OFF = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
FACES = (
    b"MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles 1\n1 2 3 0\nEnd\n"
)


def test_S6_the_other_is_a_mesh_or_a_surface_by_what_is_in_it(tmp_path: Path, grid: Any):
    files = {"a.mesh": grid(2, 1, 1), "b.off": OFF, "c.mesh": FACES, "d.dat": OFF}
    for name, data in files.items():
        (tmp_path / name).write_bytes(data)
        for other in (other_file(tmp_path / name), other_bytes(name, data, {})):
            assert other.name == name and other.size() == len(data)
            assert other.hasher()() == hashlib.sha256(data).hexdigest()
            assert isinstance(other, SurfaceOffer) == (name != "a.mesh")
            if isinstance(other, SurfaceOffer):
                assert other.surface().count == 1 and other.surface() is other.surface()
            else:
                assert other.mesh().cell_count == 2 and other.mesh() is other.mesh()


@pytest.mark.parametrize("data", [b"nonsense", OFF[:20], FACES.replace(b"Triangles 1\n1 2 3 0\n", b"")])
def test_S6_what_is_neither_a_mesh_nor_a_surface_is_told(tmp_path: Path, data: bytes):
    file = tmp_path / "a.mesh"
    file.write_bytes(data)
    with pytest.raises(MeshReadError, match=r"a\.mesh"):
        other_file(file)
    with pytest.raises(MeshReadError, match=r"a\.mesh"):
        other_bytes("a.mesh", data, {})
    with pytest.raises(MeshReadError, match="none"):
        other_file(tmp_path / "none.mesh")


def test_S6_pages_are_told_which_offers_are_surfaces(tmp_path: Path, grid: Any):
    (tmp_path / "a.mesh").write_bytes(grid(2, 1, 1))
    (tmp_path / "b.off").write_bytes(OFF)
    told = listed(compared_offers([tmp_path / "a.mesh", tmp_path / "b.off"]))
    assert [(one["name"], one["surface"]) for one in told] == [("a.mesh", False), ("b.off", True)]
    assert not listed({"0": BytesOffer("a.mesh", b"")})[0]["surface"]
