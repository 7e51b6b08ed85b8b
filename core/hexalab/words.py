"""Numbers, counts and units as people read them."""

from __future__ import annotations

SMALLEST_PLAIN = 0.0005
LARGEST_PLAIN = 1e6
NOTHING = "-"
PLURALS = (("hedron", "hedra"), ("vertex", "vertices"), ("box", "boxes"))

SYMBOLS = {"um": "µm"}
EXPONENTS = {1: "", 2: "²", 3: "³"}
NO_UNIT = "none"


def number(value: float | None) -> str:
    """Write a number with three decimals, with an exponent where it would read 0 or be long."""
    if value is None:
        return NOTHING
    if value and not SMALLEST_PLAIN <= abs(value) < LARGEST_PLAIN:
        return f"{value:.2e}"
    return f"{value:,.3f}"


def count(value: int | None) -> str:
    """Write a count with its thousands apart."""
    return NOTHING if value is None else f"{value:,}"


def counted(value: int, noun: str) -> str:
    """Write a count and what is counted: "1 cell", "2 vertices", "1,000 hexahedra"."""
    if value != 1:
        noun = next((noun[: -len(one)] + many for one, many in PLURALS if noun.endswith(one)), f"{noun}s")
    return f"{count(value)} {noun}"


def unit_of(unit: str, power: int) -> str:
    """The unit of what is a power of a length: "mm³"; empty where none was named, or where it has none."""
    return "" if not power or unit == NO_UNIT else f"{SYMBOLS.get(unit, unit)}{EXPONENTS[power]}"


def titled(name: str, power: int, unit: str) -> str:
    """A name with the unit of its values: "Volume (mm³)"."""
    told = unit_of(unit, power)
    return f"{name} ({told})" if told else name
