"""Meshes that a host has at hand. SPEC A5."""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path
from typing import Any

import pytest

from hexalab import MeshReadError
from hexalab.hosts.offers import FileOffer, file_offers, stamp_of

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
