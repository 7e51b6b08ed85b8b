"""Which pictures are taken, from where, and that none is taken twice (SPEC C2, C7)."""

from __future__ import annotations

import json
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from hexalab.hosts.browser import BrowserMissing
from hexalab.hosts.headless import RenderError
from hexalab.status import DEFAULTS, VERSION, check, merge
from site_builder import build
from site_builder.model.facts import Facts
from site_builder.pages.picture_pages import CHAPTERS, interval, key_groups
from site_builder.pictures import Album, Shot, studio, take_missing
from site_builder.pictures.collection import Collection
from site_builder.pictures.portrait import portrait
from site_builder.reading.repository import read_repository

ROOT = Path(__file__).resolve().parents[3]


@pytest.mark.parametrize(
    ("facts", "expected"),
    [
        ({"cells": 1}, "whole"),
        ({"cells": 500}, "cut"),
        ({"cells": 500_000}, "cut"),
        ({"cells": 64, "sj_not_positive": 1}, "bad cells"),
        ({"cells": 81, "findings": [{"id": "components", "count": 3}]}, "whole"),
        ({"cells": 76, "kinds": {"hexahedron": 70, "wedge": 6}, "sj_not_positive": 1}, "cut"),
    ],
)
def test_C2_what_a_thumbnail_shows_follows_from_the_facts(facts, expected):
    status = portrait(Facts(**facts))
    filters = status["filters"]
    gone = filters["planes"]["items"][0]["offset"]
    shown = "cut" if gone else "bad cells" if "quality" in filters else "whole"
    assert status["camera"]["fit"] is True  # the viewer fits it to the picture
    assert shown == expected
    assert check(status)[1] == []


def test_C2_small_meshes_have_round_cells_and_large_ones_lines():
    modes = [portrait(Facts(cells=cells))["separation"]["mode"] for cells in (100, 10_000, 1_000_000)]
    assert modes == ["rounded", "darkness_coded_edges", "lines"]


def test_C8_wires_are_left_out_where_they_would_cover_all_else():
    few, many = ({"4": 95 + more, "3": 5 - more} for more in (0, -1))
    modes = [
        portrait(Facts.from_dict({"cells": 100, "interior_edge_valence": valence})).get("irregular")
        for valence in (few, many)
    ]
    assert modes == [None, {"mode": 0}]


def test_C8_faults_are_seen_within_their_body():
    status = portrait(Facts(cells=100, sj_not_positive=3))
    assert status["see_through"]["cells"] == "quality" and 0 < status["see_through"]["opacity"] < 0.3


@pytest.fixture
def own(demo, tmp_path):
    """The demo's repository, measured, and the folder of its cache."""
    build(demo, tmp_path / "site", runtime=False)
    catalogue = read_repository(demo)
    for mesh in catalogue.meshes:
        if mesh.local:
            mesh.facts = Facts(sha256="0" * 63 + str(len(mesh.slug) % 10), cells=8)
    return catalogue


def test_C7_a_picture_is_known_by_mesh_and_status(own, tmp_path):
    album = Album(tmp_path)
    mesh = next(mesh for mesh in own.meshes if mesh.local)
    shot = Shot(mesh, {"silhouette": 1})
    album.keep(shot, b"png")
    assert album.picture(Shot(mesh, {"silhouette": 1})).read_bytes() == b"png"
    assert album.picture(Shot(mesh, {"silhouette": 0})) is None
    assert album.picture(Shot(mesh, {"silhouette": 1}, width=10)) is None
    mesh.facts = Facts(sha256="f" * 64)
    assert album.picture(Shot(mesh, {"silhouette": 1})) is None


def test_C7_no_browser_starts_when_every_picture_is_there(own, tmp_path, monkeypatch):
    album = Album(tmp_path)
    shots = [Shot(mesh) for mesh in own.meshes if mesh.local]
    for shot in shots:
        album.keep(shot, b"png")
    monkeypatch.setattr(studio, "Studio", None)
    assert take_missing(shots, tmp_path, album, lambda what, part: None) == (0, "")


def test_C2_a_picture_that_fails_costs_only_itself(own, tmp_path, monkeypatch):
    class Stand:
        """In the studio's place: small meshes come out, the large one doesn't."""

        def __init__(self, site):
            self.site = site

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def take(self, shot):
            if shot.mesh.cells == 1000:
                raise RenderError("out of memory")
            return b"png"

    monkeypatch.setattr(studio, "Studio", Stand)
    here = [mesh for mesh in own.meshes if mesh.local]
    for number, mesh in enumerate(here):
        mesh.facts = Facts(sha256=f"{number:064}", cells=1000 if number == 0 else 10)
    album, shots = Album(tmp_path), [Shot(mesh) for mesh in here]
    taken, trouble = take_missing(shots, tmp_path, album, lambda what, part: None)
    assert taken == len(here) - 1
    assert trouble == f"1 of {len(here)} pictures are missing: out of memory"
    assert [bool(album.picture(shot)) for shot in shots] == [False] + [True] * (len(here) - 1)


def test_C2_without_a_browser_the_site_is_built_all_the_same(demo, tmp_path, monkeypatch):
    def missing(playwright):
        raise BrowserMissing("no Chromium found")

    monkeypatch.setattr("hexalab.hosts.browser.executable", missing)
    with ThreadPoolExecutor(
        1
    ) as thread:  # Playwright runs once in a thread, and in this one the tests' browser may
        report = thread.submit(build, demo, tmp_path / "site").result()
    assert report.taken == 0
    assert len(report.notes) == 1
    assert report.notes[0].startswith("3 of 3 pictures are missing: no Chromium found")
    assert report.notes[0] in report.summary
    assert (tmp_path / "site/viewer/index.html").is_file()
    assert (tmp_path / "site/gallery/index.html").is_file()


def test_S2_links_carry_the_status_as_the_viewer_reads_it(own):
    status = {"camera": {"distance": 2.25}, "separation": {"mode": "rounded"}, "background": "#ffffff"}
    shot = Shot(own.meshes[0], status)
    script = (
        'import { statusFromHash } from "./static/viewer/state/link.js";'
        "console.log(JSON.stringify(await statusFromHash(process.argv[1])))"
    )
    done = subprocess.run(
        ["node", "--input-type=module", "--eval", script, shot.address.partition("#")[2]],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert json.loads(done.stdout) == {"version": VERSION, **status}
    assert f"?mesh={own.meshes[0].id}#" in shot.address


def test_C2_every_setting_of_gallery_and_guide_is_one(tmp_path):
    catalogue = read_repository(ROOT / "repository")
    for mesh in catalogue.meshes:
        if mesh.source.own:
            mesh.local, mesh.facts = mesh.local or tmp_path, Facts(sha256="1" * 64, cells=100)
    collection = Collection(catalogue)
    figures, *rows = collection.gallery
    assert len(rows) == 9
    setting = {figure.shot.status["figure"].get("panels", {}).get("setting") for figure in figures.figures}
    assert setting > {"separation", "lighting", "peel", "regularisation", "silhouette", "irregular"}
    modes = [[figure.shot.status["separation"]["mode"] for figure in row.figures] for row in rows[:4]]
    lights = [[figure.shot.status["lighting"]["mode"] for figure in row.figures] for row in rows[:4]]
    assert modes == [[mode] * 4 for mode in ("lines", "darkness_coded_edges", "fissure", "rounded")]
    assert lights == [["none", "direct", "screen_space_ao", "object_space_ao"]] * 4
    for address, shot in collection.figures.items():
        clean, problems = check(shot.status)
        assert not problems, f"{address}: {problems}"
        assert merge(DEFAULTS, clean) != DEFAULTS
    anchors = {anchor for anchor, _ in CHAPTERS}
    assert set(collection.guide) <= anchors


def test_V8_the_guide_names_the_keys_that_the_viewer_obeys():
    groups = key_groups()
    assert {"caps": ["Ctrl", "Z"], "what": "Undo"} in groups["Page"]
    assert set(groups) == {"Mesh", "Filters", "Drawing", "View", "Page"}


def test_Q2_ranges_in_words():
    assert interval((0, 1)) == "0 to 1"
    assert interval((-1, 1)) == "−1 to 1"
    assert interval((1, float("inf"))) == "from 1"
    assert interval((float("-inf"), float("inf"))) == "any number"
