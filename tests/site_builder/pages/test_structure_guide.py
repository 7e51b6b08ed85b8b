"""The guide's page on structure: what it tells is what the program says (SPEC T)."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from hexalab.cli.structure import described
from hexalab.structure import facts_of, structure
from site_builder.model.facts import Facts
from site_builder.pages.pages import Pages
from site_builder.pages.structure_guide import CHAPTERS, COMPARED, DESCRIBED, EXAMPLE, PRINTED
from site_builder.pictures.collection import Collection
from site_builder.reading.repository import read_repository

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="module")
def catalogue():
    """Our own repository; the meshes that the page names have their structure."""
    from hexalab import read

    catalogue = read_repository(ROOT / "repository")
    for mesh in catalogue.meshes:
        if mesh.local and mesh.id in {*COMPARED, DESCRIBED}:
            traced = structure(read(mesh.local))
            facts = facts_of(traced)
            mesh.facts = Facts(sha256="1" * 64, cells=traced.mesh.cell_count, structure=facts)
    return catalogue


@pytest.fixture(scope="module")
def page(catalogue):
    return Pages(catalogue, set(), Collection(catalogue)).structure()


def test_T6_the_script_prints_what_the_page_says():
    mesh = ROOT / "repository" / f"{DESCRIBED}.mesh"
    done = subprocess.run([sys.executable, EXAMPLE, mesh], capture_output=True, text=True, check=True)
    assert done.stdout == PRINTED.read_text("utf-8")


def test_T6_the_page_has_what_the_command_line_prints(catalogue, page):
    mesh = next(mesh for mesh in catalogue.meshes if mesh.id == DESCRIBED)
    assert described(mesh.file_name, mesh.facts.structure) in page
    assert "7 boxes" in page


def test_T4_contents_and_sections_agree(page):
    assert re.findall(r'<h2 id="([^"]+)">', page) == [anchor for anchor, _ in CHAPTERS]
    titles = re.findall(r'<h2 id="[^"]+">([^<]+)</h2>', page)
    assert titles == [title for _, title in CHAPTERS]


def test_T3_meshes_are_compared_by_numbers(page):
    rows = re.findall(r'<tr><th scope="row"><a[^>]*>([^<]*)</a></th>(.*?)</tr>', page)
    cells = {name: re.findall(r"<td[^>]*>([^<]*)</td>", row) for name, row in rows}
    assert cells["Walls that wind"] == ["polycube", "1,191", "57", "20.89", "0 %"]
    assert cells["Octree-like transition"] == ["", "1,208", "524", "2.31", "34.2 %"]
    assert len(cells) == len(COMPARED)


def test_T4_a_picture_leads_to_the_viewer_under_its_settings(page):
    assert "viewer/index.html?mesh=shapes/sphere#status=" in page
