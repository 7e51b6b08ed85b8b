"""What a session has to draw of the structure, cell by cell; and what is on the screen after some updates."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache, cached_property
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hexalab
from hexalab.mesh import Mesh
from hexalab.session import Session, prepared
from hexalab.status import DEFAULTS
from tests.core.structure.brute_force import FACES, FIRST, OPPOSITE, Slow
from tests.core.structure.members import slow_of, things, traced_rows
from tests.core.topology.brute_force import BruteForce

REPOSITORY = Path(__file__).resolve().parents[3] / "repository"
MESHES = (
    "layouts/nodes-of-six", "layouts/hoops", "structures/mixed", "structures/collapsed",
    "structures/self-crossing", "shapes/t-junction",
)  # fmt: skip
RECORDS = ("surface", "silhouette", "see_through", "irregular", "arrows", "marks", "curves", "colour")
NOWHERE = 99_999
"""A number that no sheet, chord, block or arc has."""

Cells = NDArray[np.bool_]
Settings = dict[str, Any]


@cache
def mesh_of(name: str) -> Mesh:
    """A mesh of ours."""
    return prepared(hexalab.read(REPOSITORY / f"{name}.mesh"))


@cache
def truth_of(name: str) -> Truth:
    """What is to be drawn of it."""
    return Truth(mesh_of(name))


def session_of(name: str) -> Session:
    """A session with a mesh of ours open."""
    session = Session({name: lambda: mesh_of(name)})
    session.open_offered(name)
    return session


class Screen:
    """What is on the screen of a session: the record of each kind that came last.

    Parameters
    ----------
    session : Session
    """

    def __init__(self, session: Session) -> None:
        self.session = session
        self.records: dict[str, Any] = {}

    def update(self, changed: Settings | None = None, **how: bool) -> set[str]:
        """Update, and return which records came."""
        answer = self.session.update(changed, **how)
        came = {name: answer[name] for name in RECORDS if name in answer}
        self.records |= came
        return set(came)

    def faces(self, name: str) -> list[int]:
        """The faces of a surface, ascending; none where no such record has come."""
        return sorted(self.records[name]["faces"].tolist()) if name in self.records else []

    def lines(self) -> int:
        """How many curves' lines there are."""
        return len(self.records["curves"]["edge_rows"]) if "curves" in self.records else 0


class Truth:
    """A mesh by dictionaries.

    Parameters
    ----------
    mesh : Mesh
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self.rows = traced_rows(mesh)

    @cached_property
    def slow(self) -> Slow:
        """The structure of the cells that are traced."""
        return slow_of(self.mesh)

    @cached_property
    def sides(self) -> list[list[tuple[int, int]]]:
        """The sides, (cell, local), of each face."""
        return list(BruteForce(self.mesh.cells.tolist()).face_sides.values())

    @cached_property
    def whole(self) -> dict[str, list[set[int]]]:
        """Cells of all sheets, chords, and blocks that all irregular edges enforce."""
        return things(self.mesh)

    @cached_property
    def interior(self) -> dict[str, list[set[int]]]:
        """The same, of blocks those that the inside alone enforces."""
        return things(self.mesh, inside_only=True)

    def members(self, kind: str, complex: str) -> list[set[int]]:
        """The cells of all things of a kind."""
        return (self.interior if complex == "interior" else self.whole)[kind]

    def mask(self, kind: str, numbers: list[int], complex: str) -> Cells:
        """Cells in some of them."""
        members = self.members(kind, complex)
        out = np.zeros(self.mesh.cell_count, bool)
        for number in numbers:
            if number < len(members):
                out[sorted(members[number])] = True
        return out

    def solid(self, look: Settings, shown: Cells) -> Cells:
        """Which cells are drawn as such."""
        kind, chosen = look["kind"], look["chosen"]
        if kind == "arcs" or (kind != "none" and look["form"] == "surfaces"):
            return np.zeros_like(shown)
        return shown & self.mask(kind, chosen, look["complex"]) if kind != "none" and chosen else shown

    def labels(self, look: Settings) -> NDArray[np.int64]:
        """The piece of each cell; one for all that is not in pieces."""
        out = np.zeros(self.mesh.cell_count, np.int64)
        if look["kind"] == "blocks" and look["form"] == "cells" and look["explode"]:
            for number, cells in enumerate(self.members("blocks", look["complex"])):
                out[sorted(cells)] = number + 1
        return out

    def around(self, cells: Cells, look: Settings) -> list[int]:
        """Faces that are seen of some cells, ascending."""
        labels = self.labels(look)
        return sorted(
            8 * cell + local
            for sides in self.sides
            for cell, local in sides
            if cells[cell]
            and not any(
                cells[other] and labels[other] == labels[cell] and (other, side) != (cell, local)
                for other, side in sides
            )
        )

    def within(self, look: Settings, shown: Cells) -> list[int]:
        """Faces that dual surfaces and walls are named by, ascending."""
        kind, complex = look["kind"], look["complex"]
        number = {id(cells): place for place, cells in enumerate(self.members(kind, complex))}
        wanted = {place for place in number.values() if not look["chosen"] or place in look["chosen"]}
        return sorted(
            self._crossed(wanted, shown) if kind == "sheets" else self._walls(wanted, complex, shown)
        )

    def _crossed(self, wanted: set[int], shown: Cells) -> Iterator[int]:
        label: dict[Any, int] = {}
        sheet = self.slow.sheets()
        for cell in self.slow.cells:
            for ends in FIRST:
                label.setdefault(sheet[frozenset(cell[p] for p in ends)], len(label))
        for row, cell in zip(self.rows, self.slow.cells, strict=True):
            for ends, pair in zip(FIRST, OPPOSITE, strict=True):
                if shown[row] and label[sheet[frozenset(cell[p] for p in ends)]] in wanted:
                    yield from (8 * row + side for side in pair)

    def _walls(self, wanted: set[int], complex: str, shown: Cells) -> Iterator[int]:
        slow, inside_only = self.slow, complex == "interior"
        block = slow.blocks(inside_only)
        for face in slow.walls(inside_only=inside_only):
            cells = slow.face_cells[face]
            if len(cells) < 2 or not wanted & {block[cell] for cell in cells}:  # type: ignore[comparison-overlap]
                continue
            if not any(shown[self.rows[cell]] for cell in cells):
                continue
            for cell in cells:
                for local, places in enumerate(FACES):
                    if {slow.cells[cell][place] for place in places} == face:
                        yield 8 * self.rows[cell] + local

    def curve_count(self, look: Settings, shown: Cells) -> int:
        """Lines of arcs, chords and the base complex; of blocks drawn apart only that there are some."""
        slow, count = self.slow, 0
        if look["kind"] == "arcs":
            count += len(slow.irregular if look["boundary"] else slow.irregular - slow.boundary_edges)
        if look["kind"] == "chords" and look["form"] == "surfaces":
            chord = slow.chords()
            label: dict[Any, int] = {}
            for row, cell in zip(self.rows, slow.cells, strict=True):
                for begin, _ in OPPOSITE:
                    face = frozenset(cell[p] for p in FACES[begin])
                    number = label.setdefault(chord[face], len(label))
                    count += bool(shown[row] and (not look["chosen"] or number in look["chosen"]))
        if look["curves"]:
            complex_faces = slow.walls(inside_only=look["complex"] == "interior") | slow.boundary
            on = [edge for edge, faces in slow.edge_faces.items() if faces <= complex_faces]
            label_of = dict(zip(self.rows, self.labels(look)[self.rows].tolist(), strict=True))
            count += sum(len({label_of[self.rows[cell]] for cell in slow.edge_cells[edge]}) for edge in on)
        return count


def all_looks(mesh: Mesh) -> Iterator[Settings]:
    """Every combination of the settings of structure, with nothing chosen, with some, and with what there is not."""
    del mesh
    for kind, form, complex, boundary, curves, explode, chosen in product(
        ("none", "arcs", "sheets", "chords", "blocks"), ("cells", "surfaces"), ("whole", "interior"),
        (False, True), (False, True), (0, 0.5), ([], [0, 3, NOWHERE], [NOWHERE]),
    ):  # fmt: skip
        yield {
            "kind": kind, "form": form, "complex": complex, "boundary": boundary, "curves": curves,
            "explode": explode, "chosen": chosen,
        }  # fmt: skip


PLAIN: Settings = DEFAULTS["structure"]
"""Nothing of the structure is looked at."""
