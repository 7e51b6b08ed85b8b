"""The table of all meshes: what it says, and that its files say the same."""

import csv
import io
import json
from pathlib import Path

import pytest

from hexalab.quality import METRICS
from hexalab.summary import STATISTICS
from site_builder.model.catalogue import Catalogue, MeshEntry, Source
from site_builder.model.facts import Facts
from site_builder.tables import families, files
from site_builder.tables.columns import COLUMNS, PLAIN
from site_builder.tables.field import field_of
from site_builder.tables.summary import by_family, by_year, of_all

ROOT = "https://hex.example.org/"


def source(slug: str, year: int, kind: str = "article-journal") -> Source:
    reference = {
        "id": slug, "type": kind, "title": f"On {slug}", "author": [{"family": "Li"}, {"family": "Wu"}],
        "issued": {"date-parts": [[year]]},
    }  # fmt: skip
    return Source(slug, Path(slug), reference, "authors")


def entry(of: Source, slug: str, **facts: object) -> MeshEntry:
    same_as = str(facts.pop("same_as", ""))
    made = MeshEntry(
        of, slug, slug, "url", f"{slug}.mesh", f"{slug}.mesh", remote=f"https://far.org/{slug}.mesh"
    )
    made.facts, made.same_as = Facts(**facts), same_as
    of.meshes.append(made)
    return made


def validity(valid: int, invalid: int, undecided: int) -> dict[str, int]:
    return {"valid": valid, "invalid": invalid, "undecided": undecided}


@pytest.fixture
def catalogue() -> Catalogue:
    old, new, own = source("old", 2012), source("new", 2020), source("own", 2024, "dataset")
    entry(old, "a", cells=10, sj_min=0.5, validity=validity(10, 0, 0))
    entry(old, "a-vtk", cells=10, same_as="a")
    entry(old, "b", cells=30, sj_min=-0.25, validity=validity(29, 1, 0))
    entry(new, "c", cells=1000, sj_min=0.125, validity=validity(999, 0, 1))
    entry(new, "d")
    entry(own, "e", cells=1, sj_min=1.0, validity=validity(1, 0, 0))
    return Catalogue(Path(), sources=[old, new, own])


def rows_of(data: bytes) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(data.decode())))


def test_C3_columns_are_named_once_and_explained():
    names = [column.name for column in COLUMNS]
    assert len(set(names)) == len(names)
    assert {f"{metric}_{statistic}" for metric in METRICS for statistic in STATISTICS} <= set(names)
    assert len(names) == len(PLAIN) + len(METRICS) * len(STATISTICS)
    for column in COLUMNS:
        assert column.meaning.endswith(".") and column.name.isidentifier()
        assert column.kind in ("text", "address", "whole", "number", "truth")
    units = {column.name: column.unit for column in COLUMNS}
    assert units["volume_variance"] == "length⁶" and units["smallest_face_angle_variance"] == "degrees²"
    assert units["characteristic_length_min"] == "length" and units["volume_not_finite"] == ""


def test_C3_a_row_for_each_mesh_and_empty_what_nobody_knows(catalogue: Catalogue):
    a, copy, _, _, d, e = rows_of(files.as_csv(files.table_of(catalogue.meshes, ROOT, set())))
    assert (a["id"], a["year"], a["authors"], a["cells"]) == ("old/a", "2012", "Li; Wu", "10")
    assert (a["own"], e["own"], copy["same_as"], a["same_as"]) == ("false", "true", "old/a", "")
    assert (a["page"], a["address"]) == (f"{ROOT}sources/old/a/", "https://far.org/a.mesh")
    assert {d[name] for name in ("cells", "sha256", "picture", "cells_valid", "scaled_jacobian_min")} == {""}


def test_C3_the_demos_facts_are_in_its_table(site: Path):
    pair, turned, row, *_ = rows_of((site / files.CSV).read_bytes())
    index = json.loads((site / "index.json").read_text("utf-8"))
    facts = [mesh["facts"] for mesh in index["sources"][0]["meshes"]]
    for line, known in zip((pair, turned, row), facts, strict=True):
        for metric, numbers in known["quality"].items():
            for statistic, value in numbers.items():
                found = line[f"{metric}_{statistic}"]
                assert (None if found == "" else float(found)) == value, (metric, statistic)
    assert (pair["hexahedra"], pair["vertices"], pair["blocks"], pair["sheets"]) == ("2", "12", "1", "4")
    assert (turned["cells_invalid"], turned["measured"]) == ("1", "true")
    assert "inverted_cells" in turned["findings"].split()
    assert (row["class"], row["irregular_edges"], row["depth"]) == ("regular", "0", "0")


def test_C3_parquet_says_the_same_with_types_units_and_meanings(catalogue: Catalogue):
    parquet = pytest.importorskip("pyarrow.parquet")
    table = files.table_of(catalogue.meshes, ROOT, set())
    data = files.as_parquet(table)
    read = parquet.read_table(io.BytesIO(data))
    assert read.column_names == [column.name for column in COLUMNS]
    assert [list(row.values()) for row in read.to_pylist()] == table
    field = read.schema.field("extent_x")
    assert (str(field.type), field.metadata) == (
        "double",
        {b"unit": b"length", b"meaning": b"Extent along x."},
    )
    assert str(read.schema.field("cells").type) == "int64"
    assert files.as_parquet(table) == data, "the same bytes"


def test_C7_parquet_is_written_once(catalogue: Catalogue, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("pyarrow")
    table = files.table_of(catalogue.meshes, ROOT, set())
    first = files.files_of(table, tmp_path)
    monkeypatch.setattr(files, "as_parquet", None)
    assert files.files_of(table, tmp_path) == first
    monkeypatch.setattr(files, "installed", lambda: False)
    assert list(files.files_of(table, tmp_path)) == [files.CSV]


def test_C3_the_field_is_what_was_published_each_mesh_once(catalogue: Catalogue):
    field = field_of(catalogue.meshes)
    assert [mesh.slug for mesh in field.meshes] == ["a", "b", "c", "d"]
    assert (field.own, field.doubled) == (1, 1)
    whole = of_all(field)
    assert (whole.sources, whole.meshes, whole.measured, whole.cells) == (2, 4, 3, 30)
    assert (whole.lowest, whole.middle, whole.mean) == (-0.25, 0.125, 0.125)
    assert whole.valid == pytest.approx(1 / 3), "an undecided cell makes no valid mesh"
    old, new = by_year(field)
    assert (old.name, old.meshes, new.name, new.measured, new.cells) == ("2012", 2, "2020", 1, 1000)


def test_C3_families_stand_in_their_order_and_who_is_not_told_at_the_end(
    catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
):
    told = {"grid": "Grids", "sweep": "Sweeping", "none": "No mesh", "": families.NOT_TOLD}
    monkeypatch.setattr("site_builder.tables.summary.family_names", lambda: told)
    for mesh, method in zip(catalogue.meshes, ("sweep", "", "grid", "sweep", "", ""), strict=True):
        mesh.method = method
    rows = by_family(field_of(catalogue.meshes))
    assert [(row.name, row.meshes) for row in rows] == [("Grids", 1), ("Sweeping", 2), ("not told", 1)]
    assert (rows[-1].measured, rows[-1].cells, rows[-1].valid) == (0, None, None)
    line = rows_of(files.as_csv(files.table_of(catalogue.meshes, ROOT, set())))[0]
    assert line["method"] == "sweep"
