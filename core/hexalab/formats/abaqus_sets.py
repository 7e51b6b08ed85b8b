"""Sets, surfaces and sections of an Abaqus deck as its lines define them, scope by scope.

Sources: Abaqus Keywords Guide (*ELSET, *NSET, *SURFACE, *SOLID SECTION), "Input syntax rules"; CalculiX' manual.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..arrays import Array
from .abaqus_deck import Block, decoded
from .abaqus_rows import parsed

ELSET, NSET = "ELSET", "NSET"
NO_NUMBERS = np.zeros(0, dtype=np.int64)
WHITE = b" \t\r\n\v\f,"
SEPARATORS = re.compile(rb"[\s,]*[,\n][\s,]*")
LONGEST_RANGE = 100_000_000
"""More members than that are no range that *ELSET, GENERATE means."""


@dataclass
class SetLines:
    """What one keyword puts into a set.

    Parameters
    ----------
    kind : str
        ELSET or NSET.
    name : str
        As it is written; letter case does not count.
    numbers : list of (n,) int64
        Numbers of elements or nodes.
    names : list of str
        Other sets, or "INSTANCE.SET" and "INSTANCE.NUMBER" as the assembly may write them.
    instance : str
        Instance whose numbers and names they are, where the keyword says so.
    of : str
        What the names are of, where that is another kind: an NSET may be made of an ELSET.
    internal : bool
        Whether a program made the set for its own use.
    """

    kind: str
    name: str
    numbers: list[Array] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    instance: str = ""
    of: str = ""
    internal: bool = False


@dataclass
class SurfaceLines:
    """What one *SURFACE holds: rows of a set or an element's number, and a face ("S1", "" for all free ones)."""

    name: str
    of_nodes: bool
    rows: list[tuple[str, str]]
    internal: bool = False


@dataclass
class Definitions:
    """All that is defined in one scope, in the order of the deck.

    Parameters
    ----------
    sets, surfaces : lists
    materials : list of (str, str)
        Material and element set of each *SOLID SECTION and the like.
    """

    sets: list[SetLines] = field(default_factory=list)
    surfaces: list[SurfaceLines] = field(default_factory=list)
    materials: list[tuple[str, str]] = field(default_factory=list)

    def __add__(self, other: Definitions) -> Definitions:
        """Those of a part, then those of its instance."""
        return Definitions(
            self.sets + other.sets, self.surfaces + other.surfaces, self.materials + other.materials
        )

    def put(self, kind: str, name: str, numbers: Array) -> None:
        """Put what a block of elements or nodes defines into a set."""
        self.sets.append(SetLines(kind, name, [numbers]))

    def read(self, block: Block) -> None:
        """Take what a keyword defines; one that defines no set is passed over."""
        keyword = block.keyword
        options, internal = keyword.options, "INTERNAL" in keyword.options
        if keyword.name in (ELSET, NSET):
            self.read_set(block, keyword.name, internal)
        elif keyword.name == "SURFACE" and options.get("NAME"):
            rows = [(first, rest.upper()) for first, rest in pairs(block)]
            of_nodes = keyword.option("TYPE") == "NODE"
            self.surfaces.append(SurfaceLines(plain(options["NAME"]), of_nodes, rows, internal))
        elif keyword.name.endswith("SECTION") and options.get("MATERIAL") and options.get(ELSET):
            self.materials.append((plain(options["MATERIAL"]), plain(options[ELSET])))

    def read_set(self, block: Block, kind: str, internal: bool) -> None:
        """*ELSET, *NSET: numbers and names of sets; with GENERATE rows of first, last, step."""
        options = block.keyword.options
        name = plain(options.get(kind, ""))
        if not name:
            return
        lines = SetLines(kind, name, instance=plain(options.get("INSTANCE", "")), internal=internal)
        if kind == NSET and options.get(ELSET):
            lines.names, lines.of = [plain(options[ELSET])], ELSET
        text = block.source.data[block.begin : block.end].replace(b"\r", b"\n").strip(WHITE)
        words = SEPARATORS.sub(b",", text)
        whole = whole_numbers(words) if words else NO_NUMBERS
        if "GENERATE" in options:
            lines.numbers += generated(block)
        elif whole is not None:
            lines.numbers.append(whole)
        else:
            found = [plain(decoded(word)) for word in words.split(b",")]
            digits = [word for word in found if word.isdigit()]
            lines.numbers.append(np.array(digits, dtype=np.int64))
            lines.names += [word for word in found if word and not word.isdigit()]
        self.sets.append(lines)


def whole_numbers(words: bytes) -> NDArray[np.int64] | None:
    """Numbers between commas; None where one is none."""
    values = parsed(words, np.int64)
    return None if values is None else values.astype(np.int64)


def generated(block: Block) -> list[Array]:
    """The numbers of rows of first, last and step; raises MeshReadError where they are no range."""
    out: list[Array] = []
    for row in block.numbers():
        first, last, step = [*row, 1.0][:3] if len(row) == 2 else [*row, 0.0, 0.0][:3]
        if not (np.isfinite([first, last, step]).all() and step >= 1 and 0 <= last - first < LONGEST_RANGE):
            raise block.error(
                f"*{block.keyword.name}, GENERATE has the row {first:g}, {last:g}, {step:g}, "
                "expected first, last and step of a range"
            )
        out.append(np.arange(int(first), int(last) + 1, int(step), dtype=np.int64))
    return out


def pairs(block: Block) -> list[tuple[str, str]]:
    """The first two fields of each line."""
    text = decoded(block.source.data[block.begin : block.end])
    lines = (line.strip() for line in text.splitlines())
    fields = [[plain(word.strip()) for word in line.split(",")] for line in lines if line]
    return [(row[0], row[1] if len(row) > 1 else "") for row in fields if row[0]]


def plain(name: str) -> str:
    """A name without quotes around it."""
    return name.strip("\"' ")
