"""Reports as they are written: well formed, escaped, with the file's own numbers, the same for the same input."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab import Group, HexaLabError
from hexalab.formats import read_bytes
from hexalab.mesh import Mesh
from hexalab.report import FORMS, About, ReportPicture, checked, collect, form_of, written

from .decks import BAD, ELEMENTS, UNUSED, deck
from .decks import EMPTY as NOTHING

EMPTY = {"meta", "link", "br", "img", "rect", "path"}
PICTURE = ReportPicture("The <mesh>.", 'All "of" it.', "data:image/png;base64,AAAA")
CRITERIA = [
    {"metric": "scaled_jacobian", "minimum": 0.2, "group": "STEEL"},
    {"metric": "volume", "minimum": 0},
    {"finding": "components"},
]


class Page(HTMLParser):
    """Holds tags against each other, and collects what a reader sees."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.rows: list[list[str]] = []
        self.words = ""
        self.feed(text)
        self.close()
        assert self.open == [], f"never closed: {self.open}"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in EMPTY:
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open and self.open[-1] == tag, f"</{tag}> within {self.open}"
        self.open.pop()

    def handle_data(self, data: str) -> None:
        if "style" in self.open:
            return
        self.words += data
        if {"td", "th"} & set(self.open):
            self.rows[-1][-1] += data


def facts(data: bytes = deck(), criteria: Any = None, name: str = "part.inp", **about: Any) -> dict[str, Any]:
    asked = checked(criteria) if criteria else []
    return collect(
        read_bytes(data, name), About(name, len(data), hashlib.sha256(data).hexdigest(), **about), asked
    )


def page(*args: Any, **kwargs: Any) -> Page:
    return Page(written(facts(*args, **kwargs), "html", [PICTURE]))


def test_the_page_is_well_formed_and_holds_everything() -> None:
    found = page(unit="mm", notes=("Something is left out.",))
    ids = [attributes["id"] for _, attributes in found.tags if "id" in attributes]
    assert len(ids) == len(set(ids))
    assert {"file", "checks", "pictures", "counts", "validity", "findings", "groups", "quality"} <= set(ids)
    words = found.words
    for expected in (
        "part.inp", hashlib.sha256(deck()).hexdigest(), f"{len(deck()):,} bytes", "Abaqus", "Volume (mm³)",
        "Failed", "4 hexahedra", "STEEL (elset)", "Something is left out.", f"HexaLab {hexalab.__version__}",
        f"numpy {np.__version__}", "2.000 × 2.000 × 1.000 mm",
    ):  # fmt: skip
        assert expected in words, expected


def test_the_page_tells_numbers_of_the_file_and_no_rows() -> None:
    found = page()
    rows = {row[1] if row[0] in ("error", "warning", "note") else row[0]: row for row in found.rows}
    assert rows["invalid"][1:] == ["1", str(BAD)]
    assert rows["1 cell is invalid at a corner: the Jacobian is not positive there."][2] == f"cells {BAD}"
    assert rows["1 vertex belongs to no cell."][2] == f"vertices {UNUSED}"
    worst = next(row for row in found.rows if row[0] == "Scaled Jacobian" and len(row) == 3)
    told = [int(one) for one in re.findall(r"(\d+) \(", worst[1])]
    assert told[0] == BAD and sorted(told) == sorted(ELEMENTS)


def test_every_metric_has_its_row_and_its_histogram() -> None:
    found = page()
    rows = {row[0]: row for row in found.rows if len(row) == 7}
    assert {metric.name for metric in hexalab.METRICS.values()} <= set(rows)
    quality = hexalab.quality(read_bytes(deck(), "part.inp"), "scaled_jacobian")
    assert rows["Scaled Jacobian"][1:] == [
        "0.5 to 1", f"{quality.min():.3f}", f"{quality.mean():.3f}", f"{quality.max():.3f}",
        str(int((quality < 0.5).sum())), "0",
    ]  # fmt: skip
    drawings = [attributes for tag, attributes in found.tags if tag == "svg"]
    assert len(drawings) == len(hexalab.METRICS)
    assert all(attributes["role"] == "img" and attributes["aria-label"] for attributes in drawings)


def test_the_histogram_is_to_scale() -> None:
    told = facts()
    row = next(one for one in told["metrics"] if one["id"] == "scaled_jacobian")
    text = written(told, "html")
    drawing = text[text.index("Histogram of Scaled Jacobian") :].split("</svg>")[0]
    bars = re.findall(
        r'class="bar( outside)?" x="([\d.]+)" y="[\d.]+" width="[\d.]+" height="([\d.]+)"', drawing
    )
    counts, low, high = (row["histogram"][name] for name in ("counts", "low", "high"))
    places = [place for place, many in enumerate(counts) if many]
    assert len(bars) == len(places)
    heights = np.array([float(tall) for _, _, tall in bars])
    assert heights / heights.max() == pytest.approx(
        np.array([counts[one] for one in places]) / max(counts), abs=0.02
    )
    step = (high - low) / len(counts)
    assert [bool(outside) for outside, _, _ in bars] == [low + (place + 0.5) * step < 0.5 for place in places]


def test_the_page_asks_nobody_and_runs_nothing() -> None:
    text = written(facts(), "html", [PICTURE])
    found = Page(text)
    (policy,) = (attributes["content"] for _, attributes in found.tags if "http-equiv" in attributes)
    style = text.split("<style>")[1].split("</style>")[0]
    known = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
    assert policy == f"default-src 'none'; style-src 'sha256-{known}'; img-src data:"
    assert not any(tag in ("script", "link", "iframe", "base") for tag, _ in found.tags)
    assert not any(
        name == "style" or name.startswith("on") for _, attributes in found.tags for name in attributes
    )
    assert "http:" not in text and "https:" not in text
    assert all(attributes["alt"] for tag, attributes in found.tags if tag == "img")


def test_tables_are_headed_for_those_who_hear_them() -> None:
    found = page()
    heads = [attributes for tag, attributes in found.tags if tag == "th"]
    assert heads and all(attributes.get("scope") in ("col", "row") for attributes in heads)
    regions = [attributes for tag, attributes in found.tags if attributes.get("class") == "scroll"]
    assert regions and all(
        attributes["tabindex"] == "0" and attributes["aria-labelledby"] for attributes in regions
    )


HOSTILE = '<script>alert("1")</script>&|`*_[x](javascript:alert(1))\x00\x1b\udc80.inp'


@pytest.fixture
def hostile() -> dict[str, Any]:
    mesh = read_bytes(deck(), "part.inp")
    group = Group('<img src=x onerror="y">|', "elset", [0, 1])
    odd = Mesh(mesh.coordinates, mesh.corners, mesh.kinds, groups=(group,), notes=["<b>bold</b> | note"])
    return collect(odd, About(HOSTILE, 1), checked([{"invalid": 0, "group": group.name}]))


def test_hostile_names_stay_names(hostile: dict[str, Any]) -> None:
    text = written(hostile, "html", [ReportPicture("<i>", '"><script>', 'x" onerror="y')])
    text.encode()
    found = Page(text)
    assert not {"script", "i", "b"} & {tag for tag, _ in found.tags}
    assert not any("onerror" in attributes for _, attributes in found.tags)
    assert '<script>alert("1")</script>' in found.words and "\x00" not in text and "\x1b" not in text
    marked = written(hostile, "md")
    assert "<script>" not in marked.replace("\\<script\\>", "") and "](javascript" not in marked.replace(
        "\\](", ""
    )
    rows = [line for line in marked.splitlines() if line.startswith("| ")]
    table = [line for line in rows if "onerror" in line]
    assert table and all(len(re.findall(r"(?<!\\)\|", line)) in (5, 8) for line in table), "no column more"
    tree = ElementTree.fromstring(written(hostile, "xml").encode())
    assert tree[0].attrib["name"].startswith("<script>")


def test_markdown_has_tables_of_one_width_and_links_pictures() -> None:
    text = written(facts(criteria=CRITERIA), "md", [ReportPicture("Whole.", "All of it.", "my report-1.png")])
    assert "![All of it.](<my report-1.png>)" in text
    widths: list[int] = []
    for line in text.splitlines():
        if not line.startswith("|"):
            widths = []
            continue
        widths.append(len(re.findall(r"(?<!\\)\|", line)))
        assert widths[0] == widths[-1], line
    assert f"cells {BAD}" in text and "## Groups" in text and "| Scaled Jacobian | 0.5 to 1 |" in text


def junit(told: dict[str, Any]) -> ElementTree.Element:
    return ElementTree.fromstring(written(told, "xml").encode())


def test_junit_has_a_case_for_each_criterion_and_each_error() -> None:
    tree = junit(facts(criteria=CRITERIA))
    (suite,) = tree
    cases = suite.findall("testcase")
    assert [case.attrib["classname"] for case in cases] == [
        "hexalab.metric", "hexalab.metric", "hexalab.finding", "hexalab.finding",
    ]  # fmt: skip
    for element in (tree, suite):
        assert [element.attrib[name] for name in ("tests", "failures", "errors", "skipped")] == [
            "4",
            "1",
            "0",
            "1",
        ]
    failure = cases[0].find("failure")
    assert failure is not None and f"cells {BAD} (" in failure.attrib["message"]
    assert cases[0].attrib["name"] == "Scaled Jacobian of elset:STEEL: at least 0.2"
    assert cases[3].find("skipped") is not None, "nothing asked for it, so that it decides nothing"
    assert suite.attrib["name"] == "part.inp"
    properties = {one.attrib["name"]: one.attrib["value"] for one in suite.iter("property")}
    assert properties["SHA-256"] == hashlib.sha256(deck()).hexdigest()


def test_junit_without_criteria_fails_what_the_diagnosis_calls_an_error() -> None:
    (suite,) = junit(facts())
    assert (suite.attrib["tests"], suite.attrib["failures"], suite.attrib["skipped"]) == ("2", "2", "0")
    (sound,) = junit(facts(deck(bad=False)))
    assert (sound.attrib["tests"], sound.attrib["failures"]) == ("1", "0")


def test_junit_names_an_error_that_a_criterion_asks_for_once() -> None:
    (suite,) = junit(facts(criteria=[{"finding": "invalid_corner_cells"}]))
    assert (suite.attrib["tests"], suite.attrib["failures"], suite.attrib["skipped"]) == ("1", "1", "0")


def test_json_is_the_facts() -> None:
    told = facts(criteria=CRITERIA)
    assert json.loads(written(told, "json")) == told


@pytest.mark.parametrize("form", [row.id for row in FORMS])
def test_the_same_input_gives_the_same_bytes(form: str) -> None:
    one, other = (written(facts(criteria=CRITERIA), form, [PICTURE]).encode() for _ in range(2))
    assert one == other


@pytest.mark.parametrize("form", [row.id for row in FORMS])
def test_a_mesh_of_nothing_is_told(form: str) -> None:
    text = written(collect(NOTHING), form)
    if form == "html":
        Page(text)
    assert "NaN" not in text and "None" not in text


def test_forms_are_found_by_the_ending() -> None:
    assert [form_of(name).id for name in ("html", "a/b.MD", "x.y.json", "xml")] == [
        "html",
        "md",
        "json",
        "xml",
    ]
    for name in ("report.pdf", "report", "a.html/report"):
        with pytest.raises(HexaLabError, match=r"expected one of \.html \(a page\)"):
            form_of(name)


def test_many_groups_are_cut_short_and_that_is_told() -> None:
    mesh = read_bytes(deck(), "part.inp")
    groups = tuple(Group(f"g{place}", "elset", [0]) for place in range(130))
    many = Mesh(mesh.coordinates, mesh.corners, mesh.kinds, groups=groups)
    told = collect(many)
    assert len(told["groups"]) == 130
    for form in ("html", "md"):
        assert "And 30 groups more, which the report in JSON lists." in written(told, form)
