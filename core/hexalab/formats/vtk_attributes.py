"""Point and cell data of a legacy `.vtk` file: SCALARS, VECTORS, FIELD and the rest (SPEC R8)."""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .assembly import Assembly, free_name
from .byte_order import native
from .group_arrays import attach
from .text import Text
from .tokens import INTEGER, quoted
from .vtk_values import Values, decoded

COMPONENTS = {
    "vectors": 3,
    "normals": 3,
    "tensors": 9,
    "tensors6": 6,
    "global_ids": 1,
    "pedigree_ids": 1,
    "edge_flags": 1,
}
"""Sections of the form `KEYWORD name type` and how many numbers each entry has."""

SECTIONS = frozenset(COMPONENTS) | {
    "point_data",
    "cell_data",
    "field",
    "metadata",
    "scalars",
    "color_scalars",
    "lookup_table",
    "texture_coordinates",
}
"""All sections, in lower case."""

BLANK_LINE = re.compile(rb"\n[ \t]*\r?\n|\Z")


class Attributes:
    """Reads the sections that follow the geometry.

    Parameters
    ----------
    text, values
        The file and its numbers.
    out : Assembly
        Gets the arrays when `finish` is called.
    """

    def __init__(self, text: Text, values: Values, out: Assembly) -> None:
        self.text = text
        self.values = values
        self.out = out
        self.entries = 0
        self.target: dict[str, Array] | None = None
        self.point_data: dict[str, Array] = {}
        self.cell_data: dict[str, Array] = {}
        self.numbers: dict[str, Array] = {}

    def section(self, keyword: str) -> None:
        """Read the section of that keyword (lower case), which has just been taken."""
        if keyword in ("point_data", "cell_data"):
            self.entries = self.text.count("points" if keyword == "point_data" else "cells", 0)
            self.target = self.point_data if keyword == "point_data" else self.cell_data
        elif keyword == "metadata":
            self.skip_metadata()
        elif keyword == "field":
            self.field()
        elif keyword == "scalars":
            self.scalars()
        elif keyword == "lookup_table":
            self.text.word()
            self.array(
                "", self.text.count("colours"), 4, "f4" if not self.values.binary else "u1", keep=False
            )
        elif keyword == "color_scalars":
            name = decoded(self.text.word())
            width = self.width(self.text.integer("the number of components"))
            self.array(name, self.entries, width, "f4" if not self.values.binary else "u1")
        elif keyword == "texture_coordinates":
            name = decoded(self.text.word())
            width = self.width(self.text.integer("the number of components"))
            self.array(name, self.entries, width, self.values.number_type(self.text.word()))
        else:
            name = decoded(self.text.word())
            self.array(name, self.entries, COMPONENTS[keyword], self.values.number_type(self.text.word()))
            if keyword == "global_ids" and self.target is not None:
                self.take_numbers(*self.target.popitem())

    def take_numbers(self, name: str, values: Array) -> None:
        """Keep global ids as the numbers of vertices or cells where they are whole; else as an attribute."""
        assert self.target is not None
        if values.dtype.kind in "iu" and values.shape[1] == 1:
            self.numbers["point" if self.target is self.point_data else "cell"] = values[:, 0]
        else:
            self.target[name] = values

    def scalars(self) -> None:
        """`SCALARS name type [components]`, then an optional line `LOOKUP_TABLE name`."""
        text = self.text
        start = text.word_offset()
        words = text.line().split()
        if len(words) not in (2, 3) or (len(words) == 3 and not INTEGER.fullmatch(words[2])):
            raise text.error(
                "SCALARS should be followed by a name, a type and at most a number of components", start
            )
        width = self.width(int(words[2][:9])) if len(words) == 3 else 1
        code = self.values.number_type(words[1])
        if text.data[text.position : text.position + 40].lstrip().upper().startswith(b"LOOKUP_TABLE"):
            text.word()
            text.line()
        elif self.values.binary:
            text.position -= 1
        self.array(
            decoded(words[0]),
            self.entries,
            width,
            code,
            begun=text.data[text.position - 1 : text.position] == b"\n",
        )

    def field(self) -> None:
        """`FIELD name n`, then n arrays, each `name components tuples type`."""
        text = self.text
        text.word()
        for _ in range(text.count("arrays of a field")):
            if text.peek().upper() == b"METADATA":
                text.word()
                self.skip_metadata()
            name = text.word()
            width = self.width(text.integer(f"the number of components of {quoted(name)}"))
            tuples = text.integer(f"the number of entries of {quoted(name)}")
            self.array(decoded(name), tuples, width, self.values.number_type(text.word()))

    def array(
        self, name: str, tuples: int, width: int, code: str, keep: bool = True, begun: bool = False
    ) -> None:
        """Read one array and keep it, if it belongs to points or cells."""
        if tuples < 0:
            raise self.text.error(f"the array {quoted(name.encode())} announces {tuples} entries")
        if code == "string":
            self.values.skip_strings(tuples * width)
            return
        if not begun:
            self.values.begin()
        values, _ = self.values.take(tuples * width, code, f"the array {quoted(name.encode())}")
        if keep and self.target is not None:
            self.target[free_name(self.target, name)] = native(values).reshape(tuples, width)

    def width(self, components: int) -> int:
        """A number of components, checked."""
        if not 0 < components <= 10_000:
            raise self.text.error(f"{components} components are announced, expected 1 or more")
        return components

    def skip_metadata(self) -> None:
        """Go behind the empty line that ends it."""
        match = BLANK_LINE.search(self.text.data, self.text.position)
        self.text.position = match.end() if match else len(self.text.data)

    def finish(self, cell_count: int, kept: NDArray[np.intp] | None) -> None:
        """Hand the arrays over; cell arrays lose the entries of cells that are left out."""
        point_count = 0 if self.out.coordinates is None else self.out.coordinates.shape[1]
        for arrays, count, what in (
            (self.point_data, point_count, "vertices"),
            (self.cell_data, cell_count, "cells"),
        ):
            for name, values in arrays.items():
                if len(values) != count:
                    self.out.note(
                        f"The array {quoted(name)} has {len(values)} entries for {count} {what}: left out."
                    )
        self.out.point_data = self.point_data
        fitting = {name: values for name, values in self.cell_data.items() if len(values) == cell_count}
        self.out.cell_data = attach(self.out.features, fitting, kept)
        self.out.vertex_numbers = self.numbers.get("point")
        numbers = self.numbers.get("cell")
        if numbers is not None and len(numbers) == cell_count:
            self.out.cell_numbers = numbers if kept is None else numbers[kept]
