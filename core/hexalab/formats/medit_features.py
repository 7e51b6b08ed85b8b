"""Elements of lower dimension of a Medit file (SPEC R13): edges, triangles, quadrilaterals; what is marked of them."""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array
from ..errors import MeshReadError
from ..groups import Group
from .assembly import Assembly
from .feature_blocks import FeatureBlock
from .ids import narrowed, whole_tags, within_int32
from .medit_keywords import FEATURES, MARKS
from .text import Text

NEXT_KEYWORD = re.compile(rb"(?<!\S)[A-Za-z]\S*")
REFERENCE = "reference"
MARK = "mark"
"""Origin of the groups that the sections `MARKS` name: "corners", "ridges", "required"."""


class MarkedElements:
    """Gathers elements and what names some of them; both formats end with it.

    Parameters
    ----------
    out : Assembly
        Gets the features.
    """

    def __init__(self, out: Assembly) -> None:
        self.out = out
        self.edges: list[FeatureBlock] = []
        self.marks: dict[str, Array] = {}

    def add(self, keyword: str, corners: Array, references: Array) -> None:
        """Add elements: (k, n) vertices counted from 1, (n,) references."""
        dimension, _ = FEATURES[keyword]
        block = FeatureBlock(dimension, within_int32(corners) - 1, {REFERENCE: narrowed(references)})
        (self.edges if dimension == 1 else self.out.features).append(block)

    def mark(self, keyword: str, numbers: Array) -> None:
        """Mark vertices or edges, (n,) counted from 1."""
        self.marks[keyword] = np.concatenate([self.marks.get(keyword, numbers[:0]), numbers - 1])

    def finish(self) -> None:
        """Hand the features over."""
        points = {keyword: rows for keyword, rows in self.marks.items() if MARKS[keyword] == 0}
        if points:
            vertices = np.unique(np.concatenate(list(points.values())))
            groups = [
                Group(marked(keyword), MARK, np.searchsorted(vertices, rows))
                for keyword, rows in points.items()
            ]
            self.out.features.append(FeatureBlock(0, vertices[None], {}, groups))
        if not self.edges:
            return
        start = 0
        for block in self.edges:
            for keyword, rows in self.marks.items():
                if MARKS[keyword] == 1:
                    own = rows[(rows >= start) & (rows < start + block.count)] - start
                    block.groups.append(Group(marked(keyword), MARK, own))
            start += block.count
        self.out.features += self.edges


def marked(keyword: str) -> str:
    """What vertices or edges are called that a section names."""
    return "required" if keyword.startswith("required") else keyword


class FeatureSections:
    """Reads such sections of an ASCII file; one that can't be read costs the features, not the mesh.

    Parameters
    ----------
    text : Text
    out : Assembly
    """

    def __init__(self, text: Text, out: Assembly) -> None:
        self.text = text
        self.out = out
        self.elements = MarkedElements(out)

    def section(self, keyword: str) -> None:
        """Read the section of a keyword (lower case), which has just been taken."""
        position = self.text.position
        try:
            count = self.text.count(keyword)
            if keyword in FEATURES:
                _, width = FEATURES[keyword]
                rows = self.table(keyword, count, width)
                self.elements.add(keyword, rows[:, :width].T, rows[:, width])
            else:
                rows = self.table(keyword, count, 1)
                self.elements.mark(keyword, rows[:, 0])
        except MeshReadError as error:
            self.text.position = self.next_keyword(position)
            self.out.note(f"{keyword.capitalize()} were left out. {error}.")

    def next_keyword(self, position: int) -> int:
        """Where the next keyword begins."""
        match = NEXT_KEYWORD.search(self.text.data, position)
        return match.start() if match else len(self.text.data)

    def table(self, keyword: str, count: int, width: int) -> Array:
        """(count, width + 1) whole numbers: of each row its vertices and the reference, 0 where rows have none."""
        text, what = self.text, keyword.capitalize()
        begin = text.position
        end = self.next_keyword(begin)
        try:
            values: Array | None = text.between(begin, end, np.intp, what)
        except MeshReadError:
            values = whole_tags(text.between(begin, end, np.float64, what))
        if values is None:
            raise text.error(f"a number of {what} is not whole", begin)
        if not count:
            return np.zeros((0, width + 1), dtype=np.int64)
        if len(values) == count * (width + 1):
            return values.reshape(count, width + 1)
        if len(values) == count * width:
            return np.concatenate([values.reshape(count, width), np.zeros((count, 1), np.int64)], axis=1)
        raise text.error(
            f"{what} has {len(values)} numbers for {count} rows, expected {width} or {width + 1} for each",
            begin,
        )
