"""The pages of the demo: valid, complete for machines, and harmless whatever the YAML holds."""

import json
import re
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import pytest

from hexalab.quality import METRICS
from site_builder import build
from site_builder.pages import interface

ROOT = Path(__file__).resolve().parents[3]
VALIDATOR = ROOT / "node_modules" / ".bin" / "html-validate"

ATTACK = "\"'><script>alert(1)</script><img src=x onerror=alert(1)>{{7*7}}</title></script>"


class Page(HTMLParser):
    """The elements of a page as (tag, attributes), its text, and its scripts' contents."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str]]] = []
        self.text = ""
        self.data: list[str] = []
        self._inside = ""
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, {name: value or "" for name, value in attributes}))
        self._inside = tag if tag in ("script", "style") else ""

    def handle_endtag(self, tag):
        self._inside = ""

    def handle_data(self, data):
        if self._inside == "script":
            self.data.append(data)
        else:
            self.text += data

    def meta(self, name):
        return [
            a["content"]
            for t, a in self.elements
            if t == "meta" and name in (a.get("name"), a.get("property"))
        ]


def pages(root):
    return {file.relative_to(root).as_posix(): Page(file.read_text("utf-8")) for file in root.rglob("*.html")}


def json_ld(page):
    (text,) = [data for data in page.data if '"@context"' in data]
    return json.loads(text)


@pytest.fixture(scope="module")
def attacked(tmp_path_factory):
    """The demo with an attack in every field of text."""
    import shutil

    import yaml

    folder = tmp_path_factory.mktemp("attacked")
    shutil.copytree(Path(__file__).parents[1] / "demo", folder / "repository")

    def poison(value, key=""):
        if isinstance(value, dict):
            return {name: poison(inner, name) for name, inner in value.items()}
        if isinstance(value, list):
            return [poison(inner, key) for inner in value]
        safe = (
            "type",
            "licence",
            "file",
            "made",
            "url",
            "sha256",
            "base_url",
            "address",
            "issued",
            "ORCID",
            "first",
            "names",
            "method",
            "domain",
            "model",
        )
        if key in safe or not isinstance(value, str):
            return value
        if key == "DOI":
            return "10.5555/" + ATTACK.replace(" ", "")
        if key in ("pdf", "web", "URL"):
            return "https://example.org/?a='&b=javascript:alert(1)#x".replace("'", "%27")
        return value + ATTACK if key in ("volume", "issue", "page") else ATTACK + value

    for file in (folder / "repository").rglob("*.yaml"):
        data = poison(yaml.safe_load(file.read_text("utf-8")))
        if "meshes" in data:
            for mesh in data["meshes"]:
                mesh["name"] = ATTACK + "name"
                mesh["description"] = ATTACK + "description"
                mesh["slug"] = re.sub(
                    r"[^a-z]+", "-", (mesh.get("file") or mesh.get("made") or mesh["url"]).lower()
                )
                mesh["slug"] = mesh["slug"].strip("-")
            data["licence_note"] = ATTACK + "note"
            data["reference"]["abstract"] = ATTACK + "abstract"
        file.write_text(yaml.safe_dump(data, allow_unicode=True), "utf-8")
    build(folder / "repository", folder / "site", runtime=False)
    return folder / "site"


def test_C2_an_attack_in_any_field_comes_out_as_text(attacked):
    found = pages(attacked)
    assert len(found) == 19 + interface.installed()
    for name, page in found.items():
        assert "49" not in page.text.split("alert(1)>")[-1][:2], name
        for tag, attributes in page.elements:
            assert not any(attribute.startswith("on") for attribute in attributes), (name, tag, attributes)
            assert "style" not in attributes, (name, tag)
            if tag == "script":
                assert "src" in attributes or attributes.get("type") == "application/ld+json", name
            if tag == "img":
                assert attributes["src"] != "x", name
            for attribute in ("href", "src", "action"):
                address = attributes.get(attribute, "")
                assert re.match(r"(https?://|[\w./#?=&%-]+$|$)", address), (name, address)
        assert (
            json_ld(page)
            if name.split("/")[0] not in ("about", "embed", "gallery", "guide", "models", "offline", "python")
            else True
        )
    front = found["index.html"].text
    assert "<script>alert(1)</script>" in front
    assert "{{7*7}}" in front
    mesh = found["sources/small/pair-mesh/index.html"]
    assert "<img src=x onerror=alert(1)>" in mesh.text
    assert mesh.text.count("<script>") >= 3


def test_C2_pages_under_attack_are_still_valid_html(attacked):
    check_html(attacked)


def test_C2_every_page_is_valid_html(site):
    check_html(site)


def check_html(root):
    if not VALIDATOR.exists():
        pytest.skip("html-validate isn't installed")
    config = Path(__file__).with_name("htmlvalidate.json")
    files = [str(file) for file in sorted(root.rglob("*.html"))]
    done = subprocess.run([VALIDATOR, "--config", config, *files], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-4000:]


def test_C2_a_source_page_cites_and_links(site):
    page = pages(site)["sources/far/index.html"]
    assert (
        "Núñez, A. M., van der Berg, J., & Li, W. (2021, December). Hexahedra & their <friends>."
        in page.text.replace("(2021)", "(2021, December)")
    )
    assert "@article{far," in page.text
    links = [attributes.get("href") for tag, attributes in page.elements if tag == "a"]
    assert "https://doi.org/10.5555/meshes.2021.7" in links
    assert "https://meshes.example.org/paper.pdf" in links
    assert "../../sources/far/far.bib" in links
    assert "https://meshes.example.org/data%20sets/far/one%20folder/first.mesh" in links
    assert "belong to the authors" in page.text


def test_C2_a_collection_of_our_own_is_cited_by_its_address(site):
    page = pages(site)["sources/small/index.html"]
    address = "https://meshes.example.org/hex/sources/small/"
    assert f"[Dataset]. Small Press. {address}" in page.text
    assert f"url = {{{address}}}" in page.text
    assert f"UR  - {address}" in (site / "sources/small/small.ris").read_text("utf-8")
    assert "citation" not in json_ld(page)


def test_C2_a_mesh_page_has_its_facts(site):
    page = pages(site)["sources/small/pair/index.html"]
    links = [attributes.get("href") for tag, attributes in page.elements if tag == "a"]
    assert "../../../viewer/index.html?mesh=small/pair" in links
    assert "../../../meshes/small/pair.mesh" in links
    assert "Scaled Jacobian" in page.text
    assert "Relative Size Squared" in page.text
    assert "CC0-1.0" in page.text
    assert ("g", {"class": "bars"}) in page.elements
    assert any(tag == "path" and a.get("d", "").endswith("V116") for tag, a in page.elements), "a bar"
    turned = pages(site)["sources/small/parts-turned/index.html"]
    assert "negative volume" in turned.text
    assert "invalid" in turned.text


def test_T6_a_source_page_has_sheets_and_blocks_where_they_are_known(site):
    found = pages(site)
    small, far = (found[f"sources/{slug}/index.html"].text for slug in ("small", "far"))
    assert "Irregular edgesSheetsBlocksValidity" in small
    assert "Irregular edgesValidity" in far
    assert re.search(r"A row\s+5\s+24\s+[\d.]+\s+[\d.]+\s+0\s+7\s+1\s+valid", small)


def test_C2_what_is_not_known_is_not_guessed(site):
    page = pages(site)["sources/far/second/index.html"]
    assert "4,200" in page.text
    assert "min SJ –" not in pages(site)["index.html"].text
    assert "Nobody has measured this mesh" in page.text
    assert "Quality" not in page.text
    row = next(row for row in page.text.split("Vertices")[1:])
    assert row.strip().startswith("–")


def test_C3_json_ld_has_what_schema_org_and_dataset_search_ask_for(site):
    for name, page in pages(site).items():
        if not name.startswith("sources/"):
            continue
        data = json_ld(page)
        assert data["@context"] == "https://schema.org/"
        assert data["@type"] == "Dataset"
        assert data["name"]
        assert 50 <= len(data["description"]) <= 5000
        for key in (
            "identifier",
            "url",
            "creator",
            "distribution",
            "keywords",
            "measurementTechnique",
            "includedInDataCatalog",
            "isAccessibleForFree",
            "datePublished",
        ):
            assert data[key], (name, key)
        assert data["identifier"] == data["url"], "a paper's DOI isn't the data's"
        assert data["url"] == "https://meshes.example.org/hex/" + name.removesuffix("index.html")
        assert all(
            creator["@type"] in ("Person", "Organization") and creator["name"] for creator in data["creator"]
        )
        for download in data["distribution"]:
            assert download["@type"] == "DataDownload"
            assert download["contentUrl"].startswith("https://")
            assert download["encodingFormat"]
        assert ("license" in data) == ("sources/small" in name)
        assert ("conditionsOfAccess" in data) == ("sources/far" in name)


def test_C3_a_papers_doi_is_what_to_cite(site):
    for page in ("far", "far/second"):
        assert json_ld(pages(site)[f"sources/{page}/index.html"])["citation"] == (
            "https://doi.org/10.5555/meshes.2021.7"
        )


def test_C3_no_two_pages_describe_themselves_alike(site):
    described = [
        json_ld(page)["description"] for name, page in pages(site).items() if name.startswith("sources/")
    ]
    assert len(set(described)) == len(described)


def test_C3_a_mesh_says_what_was_measured(site):
    data = json_ld(pages(site)["sources/small/pair/index.html"])
    measured = {row["name"]: row for row in data["variableMeasured"] if isinstance(row, dict)}
    assert measured["number of cells"]["value"] == 2
    assert measured["number of sheets"]["value"] == 4
    assert measured["number of blocks of the base complex"]["value"] == 1
    assert measured["Scaled Jacobian"]["minValue"] == pytest.approx(1)
    assert all(row["@type"] == "PropertyValue" for row in measured.values())
    names = [row for row in data["variableMeasured"] if isinstance(row, str)]
    assert sorted([*names, "Scaled Jacobian"]) == sorted(metric.name for metric in METRICS.values())
    published = json_ld(pages(site)["sources/far/one-folder-first/index.html"])
    values = {row["name"]: row for row in published["variableMeasured"] if isinstance(row, dict)}
    assert values["Scaled Jacobian"]["minValue"] == 0.04871634353271195
    assert values["number of irregular interior edges"]["value"] == 8
    assert "number of sheets" not in values, "nobody has traced it"


def test_C3_highwire_tags(site):
    page = pages(site)["sources/far/index.html"]
    assert page.meta("citation_title") == ["Hexahedra & their <friends>"]
    assert page.meta("citation_author") == ["Núñez, Ana María", "van der Berg, J.", "Li, Wei"]
    assert page.meta("citation_publication_date") == ["2021/12"]
    assert page.meta("citation_doi") == ["10.5555/meshes.2021.7"]
    assert page.meta("citation_firstpage") == ["101"]
    assert page.meta("citation_lastpage") == ["120"]
    assert page.meta("citation_pdf_url") == ["https://meshes.example.org/paper.pdf"]


def test_C3_open_graph_and_canonical_addresses(site):
    for name, page in pages(site).items():
        if name == "embed/index.html":
            assert page.meta("robots") == ["noindex"], "a frame's inside is no page to be found"
            continue
        assert page.meta("og:title"), name
        assert page.meta("og:url") == ["https://meshes.example.org/hex/" + name.removesuffix("index.html")]
        canonical = [a["href"] for t, a in page.elements if t == "link" and a.get("rel") == "canonical"]
        assert canonical == page.meta("og:url")


def test_O3_every_page_has_the_strict_policy_and_nothing_from_elsewhere(site):
    for name, page in pages(site).items():
        (policy,) = [
            a["content"] for t, a in page.elements if a.get("http-equiv") == "Content-Security-Policy"
        ]
        assert "default-src 'none'" in policy
        links = [a.get("href", "") for t, a in page.elements if t == "a"]
        remote = any(re.match(r"https://.*\.(mesh|vtk|vtu)$", link) for link in links)
        reach = "'self' https:" if remote else "'self'"  # to keep files of other hosts offline
        if name != "embed/index.html":  # which fetches nothing but its poster
            assert f"connect-src {reach};" in policy, name
        assert not re.search(r"unsafe|https?:|\*", policy.replace(f"connect-src {reach};", "")), (
            "catalogue pages need no address but the site's own"
        )
        for tag, attributes in page.elements:
            if tag in ("script", "img", "iframe") or (
                tag == "link" and attributes.get("rel") == "stylesheet"
            ):
                assert "://" not in attributes.get("src", "") + attributes.get("href", ""), (
                    name,
                    tag,
                    attributes,
                )


def test_V8_pictures_and_headings_can_be_read_aloud(site):
    for name, page in pages(site).items():
        assert sum(tag == "h1" for tag, _ in page.elements) == 1, name
        assert dict(page.elements)["html"] == {"lang": "en"}
        for tag, attributes in page.elements:
            if tag == "img":
                assert "alt" in attributes and attributes["width"] and attributes["height"], name
