"""How numbers and findings are put into words: the same everywhere on the site."""

from __future__ import annotations

import math
import re

from markupsafe import Markup, escape

from ..model.facts import Facts

NOT_KNOWN = "–"

_MARKS = re.compile(r"((?<=\w)[_.]+)(?=[^\W_])")
"""What parts of a file's name stand between; `static/catalogue/results.js` has it too."""

SHORT = {
    "good": "valid",
    "positive": "SJ > 0",
    "invalid": "invalid",
    "warning": "undecided",
    "": "not measured",
}
"""A mark's word by its state."""


def count(number: int | None) -> str:
    """A count with separators: 1,000,000."""
    return NOT_KNOWN if number is None else f"{number:,}"


def number(value: float | None) -> str:
    """A measurement: three significant decimals, an exponent where they would read 0."""
    if value is None or not math.isfinite(value):
        return NOT_KNOWN
    if value == 0:
        return "0"
    size = abs(value)
    if size < 0.0005 or size >= 1e6:
        mantissa, exponent = f"{value:.3e}".split("e")
        text = f"{mantissa}e{int(exponent)}"
    elif size >= 1000:
        text = f"{value:,.0f}"
    else:
        text = f"{value:.3f}"
    return text.replace("-", "−")


def share(part: int, whole: int) -> str:
    """A part of a whole as a percentage."""
    return percent(part / whole) if whole else "0 %"


def percent(part: float) -> str:
    """A percentage that never rounds something to nothing: 0.125 is 12.5 %."""
    if not part:
        return "0 %"
    return f"{100 * part:.1f} %" if part >= 0.001 else "under 0.1 %"


def whole_percent(part: float | None) -> str:
    """A part of one as a whole percentage: 98 %; only all is 100 %."""
    if part is None:
        return NOT_KNOWN
    return "100 %" if part == 1 else f"{min(100 * part, 99):.0f} %"


def file_size(size: int | None) -> str:
    """Bytes as people read them: 1.4 MB."""
    if size is None:
        return NOT_KNOWN
    for unit, limit in (("B", 1e3), ("kB", 1e6), ("MB", 1e9)):
        if size < limit:
            value = size / (limit / 1e3)
            return f"{value:.0f} {unit}" if unit == "B" or value >= 100 else f"{value:.1f} {unit}"
    return f"{size / 1e9:.1f} GB"


def breakable(name: str) -> Markup:
    """A name that breaks after its marks, if it has to: file names are long words."""
    return Markup(_MARKS.sub(r"\1<wbr>", str(escape(name))))


def plural(number_of: int, noun: str, nouns: str = "") -> str:
    """A count with its noun: "1 cell", "2 cells", "2 meshes"; thousands apart."""
    return f"{number_of:,} {noun if number_of == 1 else nouns or noun + 's'}"


def structure_word(facts: Facts) -> str:
    """The exact class of a mesh that is traced as a whole, regular or polycube; "" if it has none."""
    structure = facts.structure
    return "" if structure is None or "skipped" in structure else structure["class"] or ""


def structure_line(facts: Facts) -> str:
    """The structure in one sentence; "" if nothing is known of it."""
    irregular, edges = facts.irregular_edges, facts.interior_edges
    if irregular is None or edges is None:
        return ""
    if irregular:
        return (
            f"{count(irregular)} of {count(edges)} interior edges ({share(irregular, edges)}) are irregular, "
            f"{_valences(facts.interior_edge_valence or {})}."
        )
    word = structure_word(facts)
    if not word:
        return "No interior edge is irregular."
    return f"{word.capitalize()}: no interior edge is irregular, {plural(facts.blocks or 0, 'block')}."


def _valences(valence: dict[int, int]) -> str:
    parts = [f"{count(n)} of valence {v}" for v, n in sorted(valence.items()) if v != 4]
    if len(parts) == 1:
        return f"all {parts[0].split(' ', 1)[1]}"
    return ", ".join(parts[:-1]) + " and " + parts[-1]


def verdict(facts: Facts) -> tuple[str, str]:
    """Whether the mesh is valid: a state ("good", "positive", "invalid", "warning" or "") and the words for it."""
    cells = facts.cells or 0
    if facts.validity is not None:
        invalid, undecided = facts.validity["invalid"], facts.validity["undecided"]
        if invalid:
            return "invalid", f"{count(invalid)} of {plural(cells, 'cell')} certified invalid"
        if undecided:
            return "warning", f"validity of {plural(undecided, 'cell')} undecided"
        return "good", "every cell certified valid"
    if facts.sj_not_positive is None:
        return "", ""
    bad = facts.sj_not_positive + (facts.sj_not_finite or 0)
    if bad:
        return (
            "invalid",
            f"{count(bad)} of {plural(cells, 'cell')} with a Scaled Jacobian that isn't positive",
        )
    return "positive", "Scaled Jacobian positive in every cell, not certified"


def short_verdict(facts: Facts) -> tuple[str, str]:
    """The same in one word."""
    state, _ = verdict(facts)
    return state, SHORT[state]


_KINDS = {"hexahedron": "hexahedra", "tetrahedron": "tetrahedra", "wedge": "wedges", "pyramid": "pyramids"}


def kinds(numbers: dict[str, int] | None) -> str:
    """Cells by kind, if there is more than one: "32 hexahedra, 4 wedges"."""
    if not numbers or len(numbers) < 2:
        return ""
    return ", ".join(f"{n:,} {kind if n == 1 else _KINDS[kind]}" for kind, n in numbers.items())
