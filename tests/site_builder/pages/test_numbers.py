"""The page with the numbers of the field, and what describes its table to machines."""

import csv
import hashlib
import json
import re
from pathlib import Path

import pytest

from hexalab.quality import METRICS
from site_builder import build
from site_builder.pages.words import whole_percent
from site_builder.plots import kept
from site_builder.tables import files
from site_builder.tables.columns import COLUMNS, PLAIN

ADDRESS = "https://meshes.example.org/hex/"


def header(site: Path) -> list[str]:
    with (site / files.CSV).open(encoding="utf-8", newline="") as lines:
        return next(csv.reader(lines))


def page_of(site: Path) -> str:
    return (site / "numbers" / "index.html").read_text("utf-8")


def test_C3_every_column_is_explained_on_the_page(site: Path):
    html = page_of(site)
    explained = re.findall(r'<th scope="row"><code>(\w+)</code>', html)
    assert explained == [column.name for column in PLAIN] + list(METRICS)
    assert header(site) == [column.name for column in COLUMNS]
    for address in (files.CSV, files.PARQUET):
        if (site / address).is_file():
            assert f'href="../{address}" download' in html


def test_C2_the_page_has_a_summary_and_plots_that_link(site: Path):
    html = page_of(site)
    assert "2 published meshes of 1 source; 1 of them is measured" in html
    row = re.search(r"[Pp]olycube</th>(.*?)</tr>", html)
    assert row and re.findall(r">([^<]+)</td>", row[1]) == [
        "1", "2", "1", "2,522", "0.049", "0.049", "0.049", "–",
    ]  # fmt: skip
    if kept.installed():
        assert html.count('href="../sources/far/one-folder-first/" tabindex="-1"') == 4
        assert "1 mesh whose blocks are not known" not in html, "a plot without a point is left out"
        assert html.count("3 meshes of our own making") == 4


def test_C3_croissant_describes_the_very_files(site: Path):
    data = json.loads((site / "croissant.json").read_text("utf-8"))
    assert (data["@type"], data["conformsTo"]) == ("sc:Dataset", "http://mlcommons.org/croissant/1.1")
    for needed in ("name", "description", "url", "license", "creator", "datePublished", "version", "citeAs"):
        assert data[needed], needed
    assert data["license"].startswith("https://creativecommons.org/publicdomain/zero/")
    assert "belong to their authors" in data["description"].replace("belong \n", "belong ")
    assert data["datePublished"] == "2024-01-01" and data["citation"] == [
        "https://doi.org/10.5555/meshes.2021.7"
    ]
    described = {}
    for file in data["distribution"]:
        content = (site / file["contentUrl"].removeprefix(ADDRESS)).read_bytes()
        assert file["@type"] == "cr:FileObject" and file["encodingFormat"]
        assert (file["sha256"], file["contentSize"]) == (
            hashlib.sha256(content).hexdigest(),
            f"{len(content)} B",
        )
        described[file["@id"]] = file["contentUrl"]
    assert described["meshes.csv"] == ADDRESS + files.CSV
    assert (site / files.PARQUET).is_file() == ("meshes.parquet" in described)


def test_C3_croissant_has_every_column_with_its_type(site: Path):
    data = json.loads((site / "croissant.json").read_text("utf-8"))
    (records,) = data["recordSet"]
    fields = records["field"]
    assert [field["source"]["extract"]["column"] for field in fields] == header(site)
    assert len({field["@id"] for field in fields}) == len(fields)
    assert all(field["@id"].startswith(f"{records['@id']}/") for field in fields)
    assert records["key"] == {"@id": "meshes/id"}
    types = {field["name"]: field["dataType"] for field in fields}
    assert types["cells"] == "sc:Integer" and types["own"] == "sc:Boolean" and types["page"] == "sc:URL"
    assert types["volume_mean"] == "sc:Float" and types["name"] == "sc:Text"
    about = {field["name"]: field["description"] for field in fields}
    assert about["volume_variance"] == "Volume: variance, of the population. Unit: length⁶."
    assert all(field["source"]["fileObject"] == {"@id": "meshes.csv"} for field in fields)


def test_C3_the_page_leads_machines_to_it(site: Path):
    html = page_of(site)
    assert 'rel="describedby"' in html and 'href="../croissant.json"' in html
    (text,) = re.findall(r'<script type="application/ld\+json">(.*?)</script>', html)
    data = json.loads(text)
    assert data["@type"] == "Dataset" and data["url"] == f"{ADDRESS}numbers/"
    assert [file["@type"] for file in data["distribution"]] == ["DataDownload"] * len(data["distribution"])


def test_C7_a_site_without_the_libraries_says_what_it_lacks(
    demo: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    for part in (files, kept):
        monkeypatch.setattr(part, "installed", lambda: False)
    report = build(demo, tmp_path / "site", runtime=False)
    assert {files.NOT_INSTALLED, kept.NOT_INSTALLED} <= set(report.notes)
    html = page_of(tmp_path / "site")
    assert "<svg" not in html and "meshes.parquet" not in html and "meshes.csv" in html
    assert len(json.loads((tmp_path / "site" / "croissant.json").read_text())["distribution"]) == 1


@pytest.mark.parametrize(
    ("part", "words"), [(None, "–"), (1, "100 %"), (0.9999, "99 %"), (0, "0 %"), (0.5, "50 %")]
)
def test_C2_only_all_is_100_percent(part: float | None, words: str):
    assert whole_percent(part) == words
