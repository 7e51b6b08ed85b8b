"""`hexalab.catalogue` before a site of its own. SPEC C9."""

from __future__ import annotations

import copy
import gzip
import hashlib
import json
import pickle
import sys
import threading
from collections.abc import Iterator
from dataclasses import asdict
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

import hexalab
from hexalab import catalogue

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="meshes are fetched natively")


class Site:
    """A site whose files may change; the requests for each are counted."""

    def __init__(self) -> None:
        self.files: dict[str, bytes] = {}
        self.asked: list[str] = []
        site = self

        class Handler(BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                site.asked.append(self.path)
                data = site.files.get(self.path)
                self.send_response(200 if data is not None else 404)
                self.send_header("Content-Length", str(len(data or b"")))
                self.end_headers()
                self.wfile.write(data or b"")

            def log_message(self, *_: object) -> None:
                """Stay quiet."""

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server.server_address[1]}/site"

    def has(self, meshes: list[dict[str, Any]], version: int = 2) -> None:
        row = {
            "slug": "smith-2020", "title": "A Method", "authors": ["Ada Smith"], "year": 2020, "venue": "SGP",
            "doi": "10.1/2", "licence": "authors", "meshes": meshes,
            "citations": {"text": "Smith, A. (2020).", "bibtex": "@article{smith}", "csl": "[]"},
        }  # fmt: skip
        document = {"version": version, "url": "http://elsewhere.org/", "sources": [row]}
        self.files["/site/index.json"] = json.dumps(document).encode()


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Site]:
    made = Site()
    monkeypatch.setenv("HEXALAB_CATALOGUE", made.address)
    monkeypatch.setenv("HEXALAB_CACHE", str(tmp_path / "cache"))
    catalogue._listed.cache_clear()
    yield made
    made.server.shutdown()
    made.server.server_close()
    catalogue._listed.cache_clear()


def row(slug: str, address: str, data: bytes | None = None) -> dict[str, Any]:
    sha256 = hashlib.sha256(data).hexdigest() if data is not None else None
    return {
        "slug": slug, "name": slug.title(), "url": address, "cells": 8, "sha256": sha256, "picture": None,
        "method": None, "model": None, "same_as": None, "facts": {"bytes": 1},
    }  # fmt: skip


@pytest.fixture
def mesh(grid: Any) -> bytes:
    return bytes(grid(2, 2, 2))


def test_C9_sources_and_citations_are_listed(site: Site, mesh: bytes):
    site.has([row("cube", "meshes/smith/cube.mesh", mesh)])
    (source,) = catalogue.sources()
    assert (source.slug, source.title, source.authors, source.year) == (
        "smith-2020",
        "A Method",
        ("Ada Smith",),
        2020,
    )
    (entry,) = source.meshes
    assert (entry.id, entry.name, entry.cells) == ("smith-2020/cube", "Cube", 8)
    assert entry.address == f"{site.address}/meshes/smith/cube.mesh"
    assert catalogue.cite("smith-2020/cube") == "Smith, A. (2020)."
    assert catalogue.cite("smith-2020", "bibtex") == "@article{smith}"
    assert site.asked == ["/site/index.json"], "asked for once"


def test_C9_entries_tell_all_that_is_known_and_nothing_of_it_can_be_changed(site: Site, mesh: bytes):
    known = {"bytes": 7, "vertices": 27, "quality": {"scaled_jacobian": {"min": 0.5}}}
    told = {
        "method": "sweeping",
        "model": "cube",
        "same_as": "smith-2020/ball",
        "picture": "pictures/cube.webp",
    }
    site.has([row("cube", "cube.mesh", mesh) | told | {"facts": known}, row("bare", "bare.mesh")])
    cube, bare = catalogue.sources()[0].meshes
    assert (cube.method, cube.model, cube.same_as) == ("sweeping", "cube", "smith-2020/ball")
    assert cube.picture == f"{site.address}/pictures/cube.webp"
    assert cube.bytes == 7 and cube.facts["quality"]["scaled_jacobian"]["min"] == 0.5
    for change in (
        lambda facts: facts.update(vertices=28),
        lambda facts: facts.pop("vertices"),
        lambda facts: facts["quality"].clear(),
        lambda facts: facts["quality"]["scaled_jacobian"].__setitem__("min", 1),
        lambda facts: facts.__ior__({"vertices": 28}),
    ):
        with pytest.raises(TypeError, match="can't be changed"):
            change(cube.facts)
    assert json.loads(json.dumps(cube.facts)) == known == pickle.loads(pickle.dumps(cube)).facts
    assert asdict(cube)["facts"] == known and copy.deepcopy(cube) == cube
    assert (bare.method, bare.model, bare.same_as, bare.picture, dict(bare.facts)) == (
        "",
        "",
        "",
        "",
        {"bytes": 1},
    )
    assert len({cube, bare}) == 2 and "quality" not in repr(cube)


def test_C9_the_packages_own_index_is_gzipped(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    source = {
        "slug": "s", "title": "T", "authors": ["A"], "year": 2020, "venue": "", "doi": None, "licence": "authors",
        "citations": {"text": "A. (2020)."}, "meshes": [row("m", "https://far.org/m.mesh")],
    }  # fmt: skip
    source["meshes"].append(row("own", "meshes/own.mesh") | {"picture": "pictures/own.png"})
    place = tmp_path / "catalogue.json.gz"
    place.write_bytes(gzip.compress(json.dumps({"version": 2, "url": "", "sources": [source]}).encode()))
    monkeypatch.delenv("HEXALAB_CATALOGUE", raising=False)
    monkeypatch.setattr(catalogue, "PLACES", (place,))
    catalogue._listed.cache_clear()
    (found,) = catalogue.sources()
    far, own = found.meshes
    assert (found.doi, far.address, own.address, own.picture) == (
        "",
        "https://far.org/m.mesh",
        "meshes/own.mesh",
        "",
    )
    with pytest.raises(hexalab.HexaLabError, match="HEXALAB_CATALOGUE"):
        catalogue.load("s/own")
    catalogue._listed.cache_clear()


@pytest.mark.parametrize("known", [True, False])
def test_C9_a_mesh_is_fetched_once_and_checked_each_time(site: Site, mesh: bytes, known: bool):
    site.has([row("cube", "a%20b/cube.mesh", mesh if known else None)])
    site.files["/site/a%20b/cube.mesh"] = mesh
    for _ in range(2):
        assert catalogue.load("smith-2020/cube").cell_count == 8
    assert site.asked.count("/site/a%20b/cube.mesh") == 1
    path = catalogue.fetch("smith-2020/cube")
    assert (path.name, path.read_bytes()) == ("cube.mesh", mesh)
    path.write_bytes(mesh[:-5])  # a disk that forgets
    assert catalogue.load("smith-2020/cube").cell_count == 8
    assert site.asked.count("/site/a%20b/cube.mesh") == 2


def test_C9_another_file_than_the_catalogue_names_is_refused_and_not_kept(
    site: Site, mesh: bytes, tmp_path: Path
):
    site.has([row("cube", "cube.mesh", mesh)])
    site.files["/site/cube.mesh"] = mesh + b"\n"
    with pytest.raises(
        hexalab.HexaLabError, match=r"another file than the catalogue names: found SHA-256 [0-9a-f]{9}"
    ):
        catalogue.load("smith-2020/cube")
    assert not [file for file in (tmp_path / "cache").rglob("*") if file.is_file()]


def test_C9_what_is_not_there_is_said(site: Site, mesh: bytes):
    site.has([row("cube", "cube.mesh", mesh), row("own", "ftp://elsewhere/own.mesh")])
    for ask, said in (
        (lambda: catalogue.load("jones/cube"), "no source 'jones'"),
        (lambda: catalogue.load("smith-2020/ball"), "has no mesh 'ball', but cube, own"),
        (lambda: catalogue.load("smith-2020"), "has no mesh ''"),
        (lambda: catalogue.cite("smith-2020", "mla"), "no style 'mla', but text, bibtex, csl"),
        (
            lambda: catalogue.load("smith-2020/cube"),
            r"cube.mesh could not be fetched: the server answered 404",
        ),
        (lambda: catalogue.load("smith-2020/own"), "HEXALAB_CATALOGUE"),
    ):
        with pytest.raises(hexalab.HexaLabError, match=said):
            ask()


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"nonsense", "found no index"),
        (b"{}", "found no index"),
        (b'{"version": 1, "sources": []}', "an index of version 1, expected 2"),
        (b'{"version": 3}', "version 3, expected 2"),
        (None, "404"),
    ],
)
def test_C9_an_index_that_is_none_is_said(site: Site, data: bytes | None, said: str):
    if data is not None:
        site.files["/site/index.json"] = data
    with pytest.raises(hexalab.HexaLabError, match=said):
        catalogue.sources()


def test_C9_a_site_that_does_not_answer_is_said(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("HEXALAB_CATALOGUE", "http://127.0.0.1:9/")
    with pytest.raises(hexalab.HexaLabError, match=r"index\.json could not be fetched"):
        catalogue.sources()
    monkeypatch.setenv("HEXALAB_CATALOGUE", "file:///etc/")
    with pytest.raises(hexalab.HexaLabError, match="expected an address that begins with http"):
        catalogue.sources()


def test_C9_without_an_index_that_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    monkeypatch.delenv("HEXALAB_CATALOGUE", raising=False)
    monkeypatch.setattr(catalogue, "PLACES", (tmp_path / "none.json.gz",))
    catalogue._listed.cache_clear()
    with pytest.raises(hexalab.HexaLabError, match="has no catalogue"):
        catalogue.sources()
    catalogue._listed.cache_clear()
