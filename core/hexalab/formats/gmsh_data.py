"""$NodeData and $ElementData of a `.msh` file: named values by node or element number."""

from __future__ import annotations

import re

import numpy as np

from ..arrays import Array
from .gmsh_numbers import Numbers
from .ids import whole_tags
from .tokens import quoted

QUOTED = re.compile(rb'\s*"([^"\n]*)"')

GROUP = re.compile(rb'^[ \t]*([0-3])[ \t]+(\d{1,10})[ \t]+"([^"\r\n]*)"', re.M)
"""A line of $PhysicalNames: a group's dimension, number and name."""


def names_of_groups(content: bytes) -> dict[tuple[int, int], str]:
    """The names in a section $PhysicalNames, by dimension and number."""
    found = GROUP.findall(content)
    return {
        (int(dimension), int(number)): name.decode("utf-8", "replace") for dimension, number, name in found
    }


def title_of(content: bytes) -> str:
    """The name in a section of values that is not read, in quotes."""
    match = re.search(rb'"([^"\n]*)"', content)
    return quoted(match[1] if match and match[1] else b"unnamed")


def read_data(numbers: Numbers, section: bytes) -> tuple[str, str, Array, Array]:
    """Read one section, from behind its name to before its end.

    Returns
    -------
    section, name : str
    tags : (n,) int64
        Numbers of nodes or elements.
    values : (n, k) float64
    """
    text = numbers.text
    names = []
    for _ in range(numbers.count(text.integer("the number of string tags"), 2, "string tags")):
        match = QUOTED.match(text.data, text.position)
        if match:
            text.position = match.end()
            names.append(match[1].decode("utf-8", "replace"))
        else:
            names.append(text.word().decode("utf-8", "replace"))
    for _ in range(numbers.count(text.integer("the number of real tags"), 2, "real tags")):
        text.word()
    count = numbers.count(text.integer("the number of integer tags"), 2, "integer tags")
    integers = [text.integer("an integer tag") for _ in range(count)]
    if len(integers) < 3 or not 1 <= integers[1] <= 1000:
        raise numbers.error(
            f"{section.decode()} has the integer tags {integers[:4]}, expected step, width, entries"
        )
    width, entries = integers[1], numbers.count(integers[2], 2, "entries")
    what = section.decode()
    name = names[0] if names else "unnamed"
    if not numbers.binary:
        rows = numbers.doubles(entries * (1 + width), what).reshape(entries, 1 + width)
        tags = whole_tags(rows[:, 0])
        if tags is None:
            raise numbers.error(f"a row of {what} has a number that is not whole")
        return what, name, tags, rows[:, 1:]
    numbers.begin()
    dtype = np.dtype([("tag", numbers.order + "i4"), ("values", numbers.order + "f8", (width,))])
    packed = np.frombuffer(numbers.bytes(entries * dtype.itemsize, what), dtype)
    return what, name, packed["tag"].astype(np.int64), packed["values"].astype(np.float64)
