"""Criteria: how they are read, what is wrong in them, and what they decide."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hexalab
from hexalab import HexaLabError
from hexalab.diagnosis import FINDINGS
from hexalab.formats import read_bytes
from hexalab.mesh import Mesh
from hexalab.report import (
    CriteriaError,
    FindingCriterion,
    InvalidCriterion,
    MetricCriterion,
    checked,
    collect,
    read_criteria,
)
from tests.core.conftest import grid_points
from tests.tools import needs, tool

from .decks import BAD, deck, two_kinds

EXAMPLE = """
criteria:
  - metric: scaled_jacobian      # a metric's id
    minimum: 0.2
    share: 0.01
    group: STEEL
  - metric: volume
    minimum: 1e-3
    maximum: 2
  - invalid: 0
  - finding: nonmanifold_faces
  - finding: components
    at_most: 2
    """
EXAMPLES = Path(__file__).resolve().parents[3] / "docs" / "examples"

READ = [
    MetricCriterion("scaled_jacobian", 0.2, None, 0.01, "STEEL"),
    MetricCriterion("volume", 0.001, 2),
    InvalidCriterion(0),
    FindingCriterion("nonmanifold_faces"),
    FindingCriterion("components", 2),
]


def test_yaml_and_json_say_the_same(tmp_path: Path) -> None:
    needs("yaml")
    yaml = tool("yaml")
    (tmp_path / "criteria.yaml").write_text(EXAMPLE)
    assert read_criteria(tmp_path / "criteria.yaml") == READ, "1e-3 is a number"
    document = yaml.safe_load(EXAMPLE.replace("1e-3", "0.001"))
    (tmp_path / "criteria.json").write_text(json.dumps(document))
    assert read_criteria(tmp_path / "criteria.json") == READ
    assert checked(document["criteria"]) == READ, "the list alone"


def test_the_example_is_read() -> None:
    needs("yaml")
    found = read_criteria(EXAMPLES / "criteria.yaml")
    assert len(found) == 7 and found[-1] == FindingCriterion("components", 1)


def test_without_pyyaml_json_is_read_and_yaml_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "yaml", None)
    (tmp_path / "criteria.json").write_text('{"criteria": [{"invalid": 0}]}')
    (tmp_path / "criteria.yml").write_text("criteria: [{invalid: 0}]")
    assert read_criteria(tmp_path / "criteria.json") == [InvalidCriterion(0)]
    with pytest.raises(HexaLabError, match=r"criteria\.yml: .*pip install 'hexalab\[report\]'"):
        read_criteria(tmp_path / "criteria.yml")


WRONG: list[tuple[Any, str]] = [
    ({}, "criteria: found nothing, expected a list"),
    ([], "criteria: found an empty list, expected one criterion at least"),
    ({"criterions": []}, "criterions: found a key that is not known, expected criteria alone"),
    (["scaled_jacobian"], r"criteria\[0\]: found 'scaled_jacobian', expected an entry with one of metric, invalid"),
    ([{"minimum": 1}], r"criteria\[0\]: found the keys minimum, expected one of metric, invalid, finding"),
    ([{"invalid": 0, "finding": "components"}], r"criteria\[0\]: found invalid and finding in one entry"),
    ([{"invalid": 0}, {"metric": "scaled jacobian", "minimum": 0}],
     r"criteria\[1\]\.metric: found 'scaled jacobian', expected the id of a metric; did you mean scaled_jacobian\?"),
    ([{"metric": ["volume"], "minimum": 0}], r"criteria\[0\]\.metric: found \['volume'\]"),
    ([{"metric": "volume"}], r"criteria\[0\]: found a metric without bounds, expected minimum, maximum, or both"),
    ([{"metric": "volume", "minimum": "0.2x"}], r"criteria\[0\]\.minimum: found '0\.2x', expected a number"),
    ([{"metric": "volume", "minimum": True}], r"criteria\[0\]\.minimum: found true, expected a number"),
    ([{"metric": "volume", "minimum": None}], r"criteria\[0\]\.minimum: found nothing, expected a number"),
    ([{"metric": "volume", "minimum": float("nan")}], r"criteria\[0\]\.minimum: found nan"),
    ([{"metric": "volume", "minimum": 2, "maximum": 1}], r"criteria\[0\]: found minimum 2 above maximum 1"),
    ([{"metric": "volume", "minimum": 0, "share": 5}], r"criteria\[0\]\.share: found 5, expected a number from 0 to 1"),
    ([{"metric": "volume", "minimum": 0, "at_most": 5}],
     r"criteria\[0\]\.at_most: found a key that is not known, expected one of metric, minimum, maximum, share, group"),
    ([{"invalid": -1}], r"criteria\[0\]\.invalid: found -1, expected a number of 0 or more"),
    ([{"invalid": 0.5}], r"criteria\[0\]\.invalid: found 0\.5"),
    ([{"finding": "nonmanifold"}], r"criteria\[0\]\.finding: .* did you mean nonmanifold_faces\?"),
    ([{"finding": "xyz"}], r"criteria\[0\]\.finding: .* one of all_inverted, "),
    ([{"invalid": 0, "group": ""}], r"criteria\[0\]\.group: found '', expected the name or the id of a group of cells"),
]  # fmt: skip


@pytest.mark.parametrize(("document", "words"), WRONG)
def test_what_is_wrong_is_told_with_its_place(document: Any, words: str) -> None:
    with pytest.raises(CriteriaError, match=rf"^gate\.json: {words}"):
        checked(document, "gate.json")


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("gate.json", "{", "the criteria are not JSON: "),
        ("gate.json", '{"criteria": [{"invalid": 0, "invalid": 9}]}', "'invalid' stands twice"),
        ("gate.yaml", "criteria: [", "the criteria are not YAML: "),
        (
            "gate.yaml",
            "criteria:\n  - metric: volume\n    minimum: 0\n    minimum: 1\n",
            "'minimum' stands twice",
        ),
        ("gate.yaml", "criteria: !!python/object/apply:os.getcwd []", "not YAML"),
    ],
)
def test_a_file_that_is_no_document_is_told(tmp_path: Path, name: str, text: str, words: str) -> None:
    if name.endswith("yaml"):
        needs("yaml")
    (tmp_path / name).write_text(text)
    with pytest.raises(HexaLabError, match=re.escape(words)) as told:
        read_criteria(tmp_path / name)
    assert str(tmp_path / name) in str(told.value)


def test_bytes_that_are_no_text_are_told(tmp_path: Path) -> None:
    (tmp_path / "gate.json").write_bytes(b'{"\xff')
    with pytest.raises(HexaLabError, match="byte 2 is not UTF-8"):
        read_criteria(tmp_path / "gate.json")


def test_findings_are_those_that_the_diagnosis_has() -> None:
    source = Path(hexalab.diagnosis.__file__).read_text("utf-8")
    named = set(re.findall(r'yield Finding\(\s*f?"([a-z_{}.]+)"', source))
    lost = {name for name in FINDINGS if name.startswith("lost_")}
    assert named - {"lost_{part.called}"} | lost == set(FINDINGS)


def line(*values: float, **fields: Any) -> Mesh:
    """A row of boxes of the given volumes, on a unit square."""
    points, cells = grid_points((len(values), 1, 1))
    ends = np.concatenate([[0], np.cumsum(values)])
    points[:, 0] = ends[points[:, 0].astype(int)]
    return Mesh.from_cells(points, cells, **fields)


def state(mesh: Mesh, **criterion: Any) -> str:
    (check,) = collect(mesh, criteria=checked([criterion]))["verdict"]["checks"]
    return str(check["state"])


def test_bounds_and_shares_are_counted() -> None:
    mesh = line(1, 2, 3, 4)
    assert state(mesh, metric="volume", minimum=1) == "passed", "the bound itself is within"
    assert state(mesh, metric="volume", minimum=1.001) == "missed"
    assert state(mesh, metric="volume", minimum=1.001, share=0.25) == "passed"
    assert state(mesh, metric="volume", minimum=1.001, share=0.2499) == "missed"
    assert state(mesh, metric="volume", minimum=2.5, maximum=3.5, share=0.74) == "missed"
    assert state(mesh, metric="volume", minimum=2.5, maximum=3.5, share=0.75) == "passed"
    assert state(mesh, metric="volume", maximum=0, share=1) == "passed"


def test_a_share_is_exact_for_every_number_of_cells() -> None:
    for cells in (3, 7, 10, 29):
        mesh = line(*[1.0] * cells)
        for few in range(cells):
            bad = line(*[0.5] * few, *[1.0] * (cells - few))
            assert state(bad, metric="volume", minimum=0.9, share=few / cells) == "passed", (cells, few)
        assert state(mesh, metric="volume", minimum=1.1, share=(cells - 0.5) / cells) == "missed"
    assert 0.29 * 100 < 29
    hundred = line(*[0.5] * 29, *[1.0] * 71)
    assert state(hundred, metric="volume", minimum=0.9, share=0.29) == "passed"


def test_the_cells_that_miss_it_are_told_the_worst_first() -> None:
    mesh = line(5, 1, 2, 9, cell_numbers=np.array([40, 30, 20, 10]))
    (check,) = collect(mesh, criteria=checked([{"metric": "volume", "minimum": 2.5, "maximum": 4}]))[
        "verdict"
    ]["checks"]
    assert (check["count"], check["numbers"]) == (4, [10, 30, 40, 20]), (
        "9 is off by 5, 1 by 1.5, 5 by 1, 2 by 0.5"
    )
    assert check["values"] == pytest.approx([9, 1, 5, 2])
    assert check["found"] == "4 of 4 cells (100 %) miss it."


def test_what_is_not_finite_misses_every_bound() -> None:
    mesh = line(1, 0, 1)
    assert not np.isfinite(hexalab.quality(mesh, "mean_aspect_frobenius")).all()
    assert state(mesh, metric="mean_aspect_frobenius", maximum=1e300) == "missed"
    assert state(mesh, metric="mean_aspect_frobenius", minimum=0) == "missed", "though infinity is above it"
    (check,) = collect(mesh, criteria=[MetricCriterion("mean_aspect_frobenius", 0)])["verdict"]["checks"]
    assert (check["numbers"], check["values"]) == ([1], [None])


def test_kinds_without_the_metric_are_not_asked() -> None:
    mesh = two_kinds()
    (check,) = collect(mesh, criteria=[MetricCriterion("skew", minimum=5)])["verdict"]["checks"]
    assert check["count"] == 2
    tetrahedra = Mesh(mesh.coordinates, mesh.corners[:, mesh.kinds == 3], mesh.kinds[mesh.kinds == 3])
    assert state(tetrahedra, metric="skew", minimum=5) == "not measured"


def test_a_group_is_asked_alone() -> None:
    mesh = read_bytes(deck(), "part.inp")
    assert state(mesh, metric="scaled_jacobian", minimum=0.99, group="alu") == "passed", "in any letter case"
    assert state(mesh, metric="scaled_jacobian", minimum=0, group="elset:ALU") == "passed"
    assert state(mesh, metric="scaled_jacobian", minimum=0, group="STEEL") == "missed"
    assert state(mesh, invalid=0, group="ALU") == "passed"
    assert state(mesh, invalid=0, group="STEEL") == "missed"
    assert state(mesh, invalid=1) == "passed"
    with pytest.raises(HexaLabError, match=r"no group 'IRON'; it has .*elset:STEEL"):
        state(mesh, invalid=0, group="IRON")


def test_a_group_may_be_called_by_a_number_alone() -> None:
    mesh = line(1, 2, cell_data={"reference": np.array([3, 4])})
    assert state(mesh, metric="volume", minimum=1.5, group=4) == "passed"
    assert state(mesh, metric="volume", minimum=1.5, group="reference:3") == "missed"


def test_findings_are_counted() -> None:
    mesh = read_bytes(deck(), "part.inp")
    assert state(mesh, finding="unreferenced_vertices") == "missed"
    assert state(mesh, finding="unreferenced_vertices", at_most=1) == "passed"
    assert state(mesh, finding="nonmanifold_faces") == "passed"
    (check,) = collect(mesh, criteria=[FindingCriterion("invalid_corner_cells")])["verdict"]["checks"]
    assert check["numbers"] == [BAD]


def test_checks_stand_in_the_order_of_the_criteria() -> None:
    low = [MetricCriterion("volume", 0), MetricCriterion("diagonal", 0)]
    wanted = [FindingCriterion("components"), low[0], InvalidCriterion(3), low[1]]
    checks = collect(line(1, 1), criteria=wanted)["verdict"]["checks"]
    assert [check["of"] for check in checks] == ["components", "volume", "invalid", "diagonal"]
