"""The viewer's typedefs of what crosses the door, held against the answers of a real session."""

from __future__ import annotations

import inspect
import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.formats import read_bytes, write_bytes
from hexalab.groups import Features
from hexalab.mesh import Mesh
from hexalab.packing import unpack
from hexalab.session import DESCRIBED, Session, prepared
from hexalab.session.door import METHODS, Door
from hexalab.session.traced import STEPS
from hexalab.session.warm_up import grid
from hexalab.status import DEFAULTS
from hexalab.structure import TABLES
from tests.core.session.test_groups import row_of_cubes
from tests.core.session.typedefs import Shapes, Typedef, parts, typedefs

RECORDS = typedefs("geometry/records.js")
ANSWERS = typedefs("state/answers.js") | {name: RECORDS[name] for name in RECORDS if name != "MeshFrame"}
ASKED = typedefs("core/types.js")["Methods"].properties
REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
ONE = write_bytes(grid(1), "mesh")
OPAQUE = ("PartialStatus", "SeparationMode")

ROW = re.compile(r"\{ args: \[(?P<args>.*)\], answer: (?P<answer>.*) \}")


def rows() -> dict[str, re.Match[str]]:
    """Each method's arguments and answer as the typedef has them."""
    found = {method: ROW.fullmatch(kind) for method, kind in ASKED.items()}
    assert all(found.values())
    return {method: row for method, row in found.items() if row}


class Conversation:
    """A door that is asked as the page asks, its answers unpacked."""

    def __init__(self, offers: dict[str, Callable[[], Mesh]] | None = None) -> None:
        one = {"one": lambda: prepared(read_bytes(ONE, "one.mesh"))}
        self._door = Door(Session(offers or one))

    def ask(self, method: str, *arguments: Any, data: bytes | None = None) -> Any:
        """Ask one question; `data` is its last argument."""
        given = arguments if data is None else (*arguments, data)
        blocks = [one for one in given if isinstance(one, bytes)]
        told = [{"$bytes": blocks.index(one)} if isinstance(one, bytes) else one for one in given]
        answer = unpack(self._door.answer(method, json.dumps(told), blocks).joined())
        assert "error" not in answer, answer
        return answer["result"]


def answers(attributed: bytes, infinite: bytes) -> Iterator[tuple[str, Any]]:
    """Every method's answers: on a mesh with attributes, and on one with values that are not finite."""
    core = Conversation()
    yield "open_offered", core.ask("open_offered", "one")
    yield "open", core.ask("open", "grid.vtk", data=attributed)
    yield "update", core.ask("update", {}, False)
    yield "update", core.ask("update", {"colour": {"by": "quality"}}, True)
    yield "save_cells", core.ask("save_cells", "mesh", ["volume"], ["cell:load"])
    for part in DESCRIBED:
        yield "describe", core.ask("describe", part)
    cut = {"planes": {**DEFAULTS["filters"]["planes"], "items": [{**PLANE, "offset": 0.5}, PLANE]}}
    yield (
        "update",
        core.ask(
            "update", {"filters": cut, "separation": {"mode": "rounded"}, "see_through": {"cells": "cut"}}
        ),
    )
    yield "update", core.ask("update", {"arrows": {"attribute": "point:flow"}})
    for by in ("attribute", "kind", "sides"):
        yield "update", core.ask("update", {"colour": {"by": by, "attribute": "cell:load"}})
    yield "check", core.ask("check", {"filters": {"peel": {"depth": -1}}})
    yield "check", core.ask("check", {"app": {}, "camera": {"offset": 1}})
    for quantity in ("scaled_jacobian", "volume", "cell:load"):
        yield "quality", core.ask("quality", quantity)
        yield "histogram", core.ask("histogram", quantity, 10, True)
        yield "worst", core.ask("worst", quantity, 3)
        yield "values", core.ask("values", quantity)
    yield "validity", core.ask("validity")
    yield "report", core.ask("report", "xml", {"sha256": ""}, [], [{"invalid": 0}], True)
    yield "report_poses", core.ask("report_poses", "mm")
    yield from grouped_answers()
    yield "inspect", core.ask("inspect", 0)
    for quantity in ("relative_size_squared", "point:flow", "cell:load"):
        yield "value", core.ask("value", 0, quantity)
    yield from structured_answers()
    yield from compared_answers(attributed)
    yield "measure_sizes", core.ask("measure_sizes")
    yield "cell_view", core.ask("cell_view", 0)
    yield "cut_to", core.ask("cut_to", 0, [0, 0, 1])
    yield "neighbour", core.ask("neighbour", 0)
    yield "open", core.ask("open", "infinite.vtk", data=infinite)
    yield "update", core.ask("update", {"colour": {"by": "attribute", "attribute": "cell:load"}})
    yield "quality", core.ask("quality", "cell:load")
    yield "histogram", core.ask("histogram", "cell:load")
    described = core.ask("describe")
    yield "describe", described
    yield "finding_cells", core.ask("finding_cells", described["findings"][0]["id"])


def grouped_answers() -> Iterator[tuple[str, Any]]:
    """Answers on a mesh with groups, features and numbers of its own."""
    mesh = row_of_cubes()
    edges = np.array([[0, 1], [1, 2], [0, 27]], dtype=np.int32).T
    features = (Features(1, edges, {"reference": np.array([3, 4, 4])}),)
    core = Conversation({"row": lambda: replace(mesh, features=features)})
    yield "open_offered", core.ask("open_offered", "row")
    yield "describe", core.ask("describe", "groups")
    yield "update", core.ask("update", {"colour": {"by": "group", "grouping": "elset"}})
    yield "update", core.ask("update", {"marks": {"interfaces": "material", "nodes": ["nset:N"]}})
    yield "group_table", core.ask("group_table")
    yield "interfaces", core.ask("interfaces", "elset")
    yield "interfaces", core.ask("interfaces", "material")
    yield "numbers", core.ask("numbers")
    yield "find", core.ask("find", "cell", 50, [0, 0, 1])
    yield "find", core.ask("find", "vertex", 5)
    yield "cell_list", core.ask("cell_list", [0, 1], "elset", "BAD")
    yield "inspect", core.ask("inspect", 2)


def structured_answers() -> Iterator[tuple[str, Any]]:
    """Answers on a mesh whose structure is traced, but for cells of other kinds."""
    mixed = read_bytes((REPOSITORY / "structures" / "mixed.mesh").read_bytes(), "mixed.mesh")
    core = Conversation({"mixed": lambda: prepared(mixed)})
    yield "open_offered", core.ask("open_offered", "mixed")
    yield "inspect", core.ask("inspect", 0)
    for _ in STEPS:
        yield "trace", core.ask("trace")
    yield "structure_facts", core.ask("structure_facts")
    yield "structure_facts", core.ask("structure_facts", True)
    for table in TABLES:
        yield "structure_table", core.ask("structure_table", table, "interior")
        yield "structure_csv", core.ask("structure_csv", table)
    yield "sheet_pairs", core.ask("sheet_pairs")
    whole = Conversation()
    whole.ask("open_offered", "one")
    yield "structure_facts", whole.ask("structure_facts")
    for numbers in ([0], []):
        yield "structure_box", core.ask("structure_box", "sheets", numbers)
    for cell in (0, mixed.cell_count - 1):
        yield "inspect", core.ask("inspect", cell)
        yield "value", core.ask("value", cell, "structure:sheets")
    yield "save_cells", core.ask("save_cells", "vtu", [], None, True)
    for kind, form in (
        ("arcs", "cells"),
        ("sheets", "surfaces"),
        ("chords", "surfaces"),
        ("blocks", "cells"),
    ):
        look = {"kind": kind, "form": form, "chosen": [0], "curves": True, "explode": 0.5}
        yield "update", core.ask("update", {"structure": look, "colour": {"by": "chosen"}}, False, True)


def compared_answers(attributed: bytes) -> Iterator[tuple[str, Any]]:
    """Answers of two cores that are told of each other's mesh; and on a mesh beside a reference surface."""
    moved = read_bytes(attributed, "grid.vtk")
    coordinates = moved.coordinates.copy()
    coordinates[0, 0] -= 0.5
    after = write_bytes(replace(moved, coordinates=coordinates), "vtk")
    one, other = Conversation(), Conversation()
    one.ask("open", "before.vtk", data=attributed)
    other.ask("open", "after.vtk", data=after)
    mark = one.ask("fingerprint")
    yield "fingerprint", mark
    for to in (mark, ""):
        handed = other.ask("hand_over", to)
        yield "hand_over", handed
        told = {name: handed[name] for name in ("name", "vertices", "cells", "volume")}
        blocks = [handed[name].tobytes() for name in ("points", "triangles")]
        coordinates = None if handed["coordinates"] is None else handed["coordinates"].tobytes()
        yield "compare_with", one.ask("compare_with", told, *blocks, coordinates, True)
        yield "measure_distance", one.ask("measure_distance")
        yield "distance_facts", one.ask("distance_facts", False, 2.0)
        yield "distance_csv", one.ask("distance_csv")
        if coordinates:
            yield "metric_changes", one.ask("metric_changes", "volume")
            yield "quality", one.ask("quality", "change:volume")
            yield "value", one.ask("value", 0, "compare:displacement")
            look = {"colour": {"by": "attribute", "attribute": "change:volume"}}
            yield "update", one.ask("update", {**look, "compare": {"reference": {"shown": True}}})
            yield "update", one.ask("update", {"arrows": {"attribute": "compare:displacement"}})
    yield "compare_with_offered", one.ask("compare_with_offered", "one")
    yield "compare_with_surface", one.ask("compare_with_surface", "one.stl", data=TRIANGLE)
    yield "measure_distance", one.ask("measure_distance", True)
    yield "distance_facts", one.ask("distance_facts", True)
    yield "stop_comparing", one.ask("stop_comparing")


TRIANGLE = b"""solid one
facet normal 0 0 1
outer loop
vertex 0 0 2
vertex 1 0 2
vertex 0 1 2
endloop
endfacet
endsolid one
"""

PLANE = {"enabled": True, "normal": [1, 0, 0], "offset": 0}


@pytest.fixture(scope="module")
def infinite(attributed: bytes) -> bytes:
    """The mesh with attributes, of which one has no finite value, and a cell turned inside out."""
    mesh = read_bytes(attributed, "grid.vtk")
    corners = mesh.corners.copy()
    corners[:, 1] = corners[[4, 5, 6, 7, 0, 1, 2, 3], 1]
    load = np.full(mesh.cell_count, np.inf)
    return write_bytes(type(mesh)(mesh.coordinates, corners, mesh.kinds, cell_data={"load": load}), "vtk")


def test_A1_the_typedefs_name_what_may_be_asked_with_its_arguments() -> None:
    assert sorted(ASKED) == sorted(METHODS)
    for method, row in rows().items():
        parameters = list(inspect.signature(getattr(Session, method)).parameters.values())[1:]
        told = [argument.split(":")[0] for argument in parts(row["args"], ",")]
        marks = {inspect.Parameter.empty: ""}
        assert told == [one.name + marks.get(one.default, "?") for one in parameters], method


def test_A1_the_typedefs_of_answers_are_what_a_session_answers(attributed: bytes, infinite: bytes) -> None:
    shapes = Shapes(ANSWERS, OPAQUE)
    told = rows()
    asked = set()
    for method, answer in answers(attributed, infinite):
        asked.add(method)
        kind = told[method]["answer"]
        if kind == "Partial<Description>":
            whole = ANSWERS["Description"].properties
            kind = "Described"
            shapes.known[kind] = Typedef("object", whole, set(whole))
        assert shapes.wrong(answer, kind, method) == []
    preview = Session()
    preview.open("grid.vtk", attributed)
    assert shapes.wrong(unpack(preview.preview()), "Preview") == []
    arrows = {"attribute": "point:flow"}
    for other in (
        {"silhouette": 0, "irregular": {"mode": 0}},
        {"see_through": {"cells": "all"}, "arrows": arrows},
        {"marks": {"sharp_angle": 30}},
        {"structure": {"kind": "sheets", "form": "surfaces", "curves": True}},
    ):
        assert shapes.wrong(unpack(preview.preview(other)), "Preview") == []
    assert asked == set(METHODS)
    never = {
        f"{name}.{one}"
        for name, found in shapes.known.items()
        for one in found.properties
        if (name, one) not in shapes.met and name != "Description"
    }
    assert never == set(), "no answer has these"
    optional = {(name, one) for name, found in ANSWERS.items() for one in found.optional}
    assert optional <= shapes.missed, "every answer has these: they are not optional"


def test_A1_describe_in_one_is_the_whole_description(attributed: bytes) -> None:
    core = Conversation()
    core.ask("open", "grid.vtk", data=attributed)
    assert Shapes(ANSWERS).wrong(core.ask("describe"), "Description") == []


@pytest.mark.parametrize(
    ("value", "kind", "expected"),
    [
        (None, "number | null", True),
        (1.5, "number", True),
        (True, "number", False),
        ([1, 2], "[number, number]", True),
        ([1, 2, 3], "[number, number]", False),
        ([[1, None], None], "([number, number | null] | null)[]", True),
        ({"a": "b"}, "Record<string, number>", False),
        ("inside", '"inside" | "outside"', True),
        ("beside", '"inside" | "outside"', False),
        (np.zeros(1, np.float32), "Float32Array", True),
        (np.zeros(1), "Float32Array", False),
        ({"a": 1}, "{ a: number, b: number }", False),
    ],
)
def test_the_reader_of_types_tells_right_from_wrong(value: Any, kind: str, expected: bool) -> None:
    assert (Shapes({}).wrong(value, kind) == []) is expected
