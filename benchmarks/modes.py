"""A walk through every mode, filter, colour and light of the viewer, and what must be drawn at each step.

The steps are partial statuses, applied one after the other; what each shows is computed natively by the core, and for
the flat modes once more from the topology alone.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, TypedDict

import numpy as np

import hexalab
from hexalab.arrays import Floats
from hexalab.filters.stack import FilterStack
from hexalab.status import DEFAULTS, SCHEMA, merge
from hexalab.surface import MODES, DrawnMesh, extract_surface

Status = dict[str, Any]

LIGHTS = ("direct", "screen_space_ao", "object_space_ao")
MAPS = SCHEMA["properties"]["colour"]["properties"]["map"]["enum"]
SILHOUETTES = (0, 0.5, 1)
IRREGULAR_MODES = range(7)

WALK = """async (steps) => {
    const found = [];
    for (const step of steps) {
        const rejections = await window.hexalab.setStatus(step);
        found.push({ rejections, shown: window.hexalab.summary().shown, drawn: window.hexalab.drawn() });
    }
    return found;
}"""
"""Runs in the page: applies each step and tells what is shown and drawn once its picture stands."""


class ShownCounts(TypedDict):
    """Cells that are shown, and the faces between them and what is not."""

    cells: int
    faces: int


class DrawnCounts(TypedDict):
    """What is in the buffers: faces, edges, and cells that own a face."""

    faces: int
    edges: int
    cells: int


class Walked(TypedDict):
    """What the page tells after a step: what the status was refused for, what is shown and what is drawn."""

    rejections: list[dict[str, str]]
    shown: ShownCounts
    drawn: DrawnCounts


@dataclass(frozen=True)
class Step:
    """One change of the settings.

    Parameters
    ----------
    name : str
    partial : dict
        Part of a status document.
    """

    name: str
    partial: Status = field(default_factory=dict)


def steps(mesh: hexalab.Mesh) -> Iterator[Step]:
    """All modes, filters, colours and lights, one change at a time."""
    middle = float(np.nanmedian(hexalab.quality(mesh, "scaled_jacobian")))
    yield Step("whole", {**DEFAULTS, "lighting": {"mode": "direct"}})
    for mode in MODES:
        yield Step(f"{mode}, whole", {"separation": {"mode": mode}, **_planes(0)})
        yield Step(f"{mode}, cut", _planes(0.5))
        yield Step(f"{mode}, peel", {"filters": {"peel": {"depth": 1}}})
        yield Step(f"{mode}, worse half", _band("inside", middle))
        yield Step(f"{mode}, regularised", {"filters": {"regularisation": {"strength": 1}}})
        for light in LIGHTS:
            yield Step(f"{mode}, {light}", {"lighting": {"mode": light}})
        yield Step(f"{mode}, filters off", {"filters": DEFAULTS["filters"], "lighting": {"mode": "direct"}})
    yield Step("lines", {"separation": {"mode": "lines"}})
    yield Step("cut by any corner", _planes(0.3, (0.3, -1, 0.2), rule="any_corner"))
    yield Step("two planes", _two_planes())
    yield Step("better half", _band("outside", middle))
    yield Step("stronger regularisation", {"filters": {"regularisation": {"strength": 3}}})
    yield Step(
        "no regularisation", {"filters": {"regularisation": {"strength": 0}, "quality": {"items": []}}}
    )
    yield Step("cells by hand", {"filters": {"picking": {"hidden": [0], "shown": [mesh.cell_count - 1]}}})
    yield Step("one cell", {"filters": {"picking": {"isolated": True, "hidden": [], "shown": [0]}}})
    yield Step("nothing", {"filters": {**DEFAULTS["filters"], **_planes(1)["filters"]}})
    yield Step("cut", {"filters": {**DEFAULTS["filters"], **_planes(0.5)["filters"]}})
    for silhouette in SILHOUETTES:
        yield Step(f"silhouette {silhouette}", {"silhouette": silhouette})
    for irregular in IRREGULAR_MODES:
        yield Step(
            f"irregular {irregular}", {"irregular": {"mode": irregular, "boundary": irregular % 2 == 0}}
        )
    yield Step("by kind", {"colour": {"by": "kind"}})
    for name in MAPS:
        yield Step(f"by quality, {name}", {"colour": {"by": "quality", "map": name}})
    yield Step("by sides", {"colour": {"by": "sides"}})


def _planes(offset: float, normal: tuple[float, float, float] = (1, 0.4, 0.2), **more: Any) -> Status:
    item = {"enabled": True, "normal": list(normal), "offset": offset}
    return {"filters": {"planes": {"rule": "barycentre", "items": [item], **more}}}


def _two_planes() -> Status:
    first = {"enabled": True, "normal": [0, 1, 0], "offset": 0.35}
    return _planes(0, items=[first, {"enabled": True, "normal": [-1, 0, 1], "offset": 0.3}])


def _band(keep: str, maximum: float) -> Status:
    item = {"quantity": "scaled_jacobian", "keep": keep, "minimum": None, "maximum": maximum}
    return {"filters": {"quality": {"items": [item]}}}


class Native:
    """The core's own answer to each step, without browser and worker.

    Parameters
    ----------
    mesh : Mesh
    """

    def __init__(self, mesh: hexalab.Mesh) -> None:
        self.mesh = mesh
        self._drawn_mesh = DrawnMesh(mesh)
        self._stack = FilterStack(mesh, self._quality)
        self._values: dict[str, Floats] = {}
        self._status = DEFAULTS
        self._made: tuple[Any, dict[str, int]] = (None, {})

    def after(self, step: Step) -> dict[str, int]:
        """What must be shown and drawn once a step is applied: cells, faces, faces drawn, edges, cells drawn."""
        self._status = merge(self._status, step.partial)
        key = (self._status["filters"], self._status["separation"])
        if self._made[0] != key:
            self._made = (key, self._answer())
        return self._made[1]

    def _answer(self) -> dict[str, int]:
        shown = self._stack.apply(self._status["filters"])
        separation = self._status["separation"]
        mode = separation["mode"]
        surface = extract_surface(self._drawn_mesh, shown, mode, separation["gap"], separation["radius"])
        faces = len(self.mesh.topology.interface(shown).rows)
        flat = mode in ("lines", "darkness_coded_edges")
        return {
            "cells": int(shown.sum()),
            "faces": faces,
            "faces drawn": faces if flat else len(surface.faces),
            "edges drawn": len(surface.edges) // 6,
            "cells drawn": len(np.unique(surface.cells)),
        }

    def _quality(self, quantity: str) -> Floats:
        if quantity not in self._values:
            self._values[quantity] = hexalab.quality(self.mesh, quantity)
        return self._values[quantity]


def found_in_page(answer: Walked) -> dict[str, int]:
    """What the page tells after a step, under the names of `Native.after`."""
    shown, drawn = answer["shown"], answer["drawn"]
    return {
        "cells": shown["cells"],
        "faces": shown["faces"],
        "faces drawn": drawn["faces"],
        "edges drawn": drawn["edges"],
        "cells drawn": drawn["cells"],
    }


def differences(mesh: hexalab.Mesh, walk: list[Step], answers: list[Walked]) -> list[str]:
    """Where the page's answers to a walk are not the core's."""
    native = Native(mesh)
    wrong = []
    for step, answer in zip(walk, answers, strict=True):
        expected, found = native.after(step), found_in_page(answer)
        wrong += [f"{step.name}: {rejection}" for rejection in answer["rejections"]]
        wrong += [
            f"{step.name}: {what} {found[what]}, natively {number}"
            for what, number in expected.items()
            if found[what] != number
        ]
    return wrong
