"""The plots over the whole catalogue: right places, links, nothing that a strict policy forbids."""

import re
from itertools import combinations
from math import log10
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from site_builder.model.catalogue import MeshEntry, Source
from site_builder.model.facts import Facts
from site_builder.plots import drawing, kept
from site_builder.plots.families import COLOURS, SHAPES
from site_builder.plots.kept import Drawn, drawn
from site_builder.tables.field import Field, field_of

STYLES = Path(__file__).resolve().parents[3] / "static" / "styles" / "catalogue" / "plots.css"
SVG = "{http://www.w3.org/2000/svg}"

pytest.importorskip("matplotlib")


def mesh(
    name: str, year: int, cells: int, sj_min: float | None, blocks: int = 0, irregular: int = 0
) -> MeshEntry:
    reference = {
        "id": "s", "type": "article-journal", "title": "T", "author": [{"family": "Li"}],
        "issued": {"date-parts": [[year]]},
    }  # fmt: skip
    source = Source(f"s-{year}", Path(), reference, "authors")
    structure = {"base_complex": {"blocks": blocks}, "irregular": {}, "sheets": {}}
    facts = Facts(
        cells=cells, sj_min=sj_min, sj_mean=sj_min and (1 + sj_min) / 2, structure=structure,
        interior_edge_valence={4: 1000 - irregular, 5: irregular},
    )  # fmt: skip
    slug = re.sub("[^a-z]+", "-", name)
    return MeshEntry(
        source, slug, name, "url", f"{slug}.mesh", slug, remote="https://x.org/m.mesh", facts=facts
    )


@pytest.fixture
def field() -> Field:
    meshes = [
        mesh("first", 2011, 100, 0.25, 1, 10),
        mesh("second", 2011, 10_000, 0.75, 100),
        mesh('a <b> & "c"', 2019, 1_000, -0.5, 10, 100),
        mesh("not traced", 2019, 5_000, 0.5),
        mesh("not measured", 2023, 700, None),
    ]
    copy = mesh("again", 2011, 100, None)
    copy.same_as = "first"
    return field_of([*meshes, copy])


@pytest.fixture
def plots(field: Field, tmp_path: Path) -> dict[str, Drawn]:
    return {one.plot.id: one for one in drawn(field, tmp_path, "../")}


class Picture:
    """A plot as it is read again."""

    def __init__(self, plot: Drawn) -> None:
        self.tree = ElementTree.fromstring(
            plot.svg.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
        )
        self.points = {
            link.get("href").split("/")[-2]: (
                link.find(f"{SVG}title").text,
                self.place(link.find(f"{SVG}use")),
            )
            for link in self.tree.iter(f"{SVG}a")
        }
        self.labels = {text.text: self.place(text) for text in self.tree.iter(f"{SVG}text")}

    @staticmethod
    def place(element: ElementTree.Element) -> tuple[float, float]:
        return float(element.get("x")), float(element.get("y"))


def test_C2_points_stand_where_the_labels_say(plots: dict[str, Drawn]):
    picture = Picture(plots["size-and-worst-cell"])
    (at_100, _), (at_10k, _) = picture.labels["100"], picture.labels["10,000"]
    quarter, three, half, zero, low = (picture.labels[word][1] for word in ("0.25", "0.75", "0.5", "0", "−1"))
    places = {name: place for name, (_, place) in picture.points.items()}
    assert places["first"][0] == pytest.approx(at_100, abs=0.11)
    assert places["second"][0] == pytest.approx(at_10k, abs=0.11)
    expected = at_100 + (log10(5_000) - 2) / 2 * (at_10k - at_100)
    assert places["not-traced"][0] == pytest.approx(expected, abs=0.11)
    assert places["first"][1] - places["second"][1] == pytest.approx(quarter - three, abs=0.21)
    assert places["not-traced"][1] - places["first"][1] == pytest.approx(half - quarter, abs=0.21)
    assert places["a-b-c-"][1] - places["first"][1] == pytest.approx((zero + low) / 2 - quarter, abs=0.21)
    assert (low - zero) * 5 == pytest.approx((zero - half) * 2, abs=1), "below 0 a fifth of the scale"


def test_C2_a_share_of_nothing_stands_at_0_before_the_logarithms(plots: dict[str, Drawn]):
    picture = Picture(plots["irregularity-and-mean"])
    assert picture.points["second"][1][0] == pytest.approx(picture.labels["0"][0], abs=0.11)
    assert picture.points["first"][1][0] == pytest.approx(picture.labels["1 %"][0], abs=0.11)
    assert picture.points["a-b-c-"][1][0] == pytest.approx(picture.labels["10 %"][0], abs=0.11)
    assert "2 meshes are at 0, which has no logarithm." in plots["irregularity-and-mean"].notes


def test_C2_every_point_leads_to_its_mesh_and_tells_its_values(plots: dict[str, Drawn]):
    picture = Picture(plots["size-and-worst-cell"])
    assert picture.points["first"][0] == "first, Li 2011: 100 cells, min SJ 0.250"
    assert picture.points["a-b-c-"][0] == 'a <b> & "c", Li 2019: 1,000 cells, min SJ −0.500'
    links = [link.get("href") for link in picture.tree.iter(f"{SVG}a")]
    assert "../sources/s-2011/first/" in links and len(links) == 4
    assert Picture(plots["size-and-blocks"]).points["first"][0] == "first, Li 2011: 100 cells, 1 block"


def test_C2_what_is_not_drawn_is_counted_in_words(plots: dict[str, Drawn]):
    assert plots["size-and-blocks"].notes == [
        "3 meshes are drawn.",
        "Left out: 1 mesh whose blocks are not known; 1 mesh that nobody has measured yet; "
        "and 1 file that holds a mesh in another format.",
    ]
    assert (
        "1 mesh is at 0 or below it, where the scale is 5 times smaller."
        in plots["size-and-worst-cell"].notes
    )


def test_C2_years_have_their_columns_their_points_and_those_without_any(plots: dict[str, Drawn]):
    picture = Picture(plots["years"])
    assert [str(year) in picture.labels for year in range(2011, 2024)] == [True] * 13
    assert {"Meshes", "Smallest Scaled Jacobian", "Year of publication"} <= set(picture.labels)
    for name, year in (("first", "2011"), ("not-traced", "2019")):
        assert picture.points[name][1][0] == pytest.approx(picture.labels[year][0], abs=30)


def test_O3_nothing_in_a_plot_needs_an_inline_style(plots: dict[str, Drawn]):
    assert len(plots) == 5
    for plot in plots.values():
        assert not re.search(r"style|<script|xlink|/home|/work|20\d\d-\d\d-\d\d|Matplotlib", plot.svg)
        ids = re.findall(r' id="([^"]+)"', plot.svg)
        assert len(set(ids)) == len(ids) and all(one.startswith(plot.name) for one in ids)
        assert not re.search(r"\d\.\d\d", re.sub(r"<title>.*?</title>|<text.*?</text>", "", plot.svg))
        picture = ElementTree.fromstring(plot.svg.replace("<svg ", f'<svg xmlns="{SVG[1:-1]}" ', 1))[0]
        assert picture.get("role") == "img" and {child.tag for child in picture[:2]} == {
            f"{SVG}title",
            f"{SVG}desc",
        }


def test_C7_the_same_numbers_give_the_same_bytes_and_are_drawn_once(
    field: Field, plots: dict[str, Drawn], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    again = drawn(field, tmp_path / "elsewhere", "../")
    assert [one.svg for one in again] == [one.svg for one in plots.values()]
    monkeypatch.setattr(drawing, "draw", None)
    assert [one.svg for one in drawn(field, tmp_path, "../")] == [one.svg for one in again]
    field.meshes[0].facts.sj_min = 0.3
    with pytest.raises(TypeError):
        drawn(field, tmp_path, "../")


def test_C7_without_matplotlib_or_meshes_there_are_no_plots(
    field: Field, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    assert drawn(field_of([]), tmp_path, "../") == []
    monkeypatch.setattr(kept, "installed", lambda: False)
    assert drawn(field, tmp_path, "../") == []


EYES = {
    "most": np.eye(3),
    "deuteranopes": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    "protanopes": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "tritanopes": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
}  # fmt: skip
"""What others see of linear sRGB: Machado, Oliveira, Fernandes 2009, severity 1."""

XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def linear(colour: str) -> np.ndarray:
    channels = np.array([int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)])
    return np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)


def lab(seen: np.ndarray) -> np.ndarray:
    x, y, z = np.cbrt(np.maximum(XYZ @ np.clip(seen, 0, 1) / XYZ.sum(1), 0.008856))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


@pytest.mark.parametrize("eyes", EYES)
@pytest.mark.parametrize(("scheme", "paper", "contrast"), [(0, "#fbfaf7", 3), (1, "#14161a", 4)])
def test_V8_colours_are_told_apart_and_stand_out(eyes: str, scheme: int, paper: str, contrast: float):
    css = STYLES.read_text("utf-8").split("prefers-color-scheme: dark")[scheme]
    tones = re.findall(r"--tone-\w+: (#\w{6})", css)
    assert len(tones) == COLOURS + 1
    for one, other in combinations(tones, 2):
        difference = np.linalg.norm(lab(EYES[eyes] @ linear(one)) - lab(EYES[eyes] @ linear(other)))
        assert difference >= 19, (one, other)
    for tone in tones:
        bright, dark = sorted(((XYZ @ linear(colour))[1] + 0.05 for colour in (tone, paper)), reverse=True)
        assert bright / dark >= contrast, tone


def test_V8_no_two_families_look_alike():
    assert len({(number % len(SHAPES), number % COLOURS) for number in range(40)}) == 40
