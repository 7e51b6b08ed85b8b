"""Words and rows that the written forms of a report share."""

from __future__ import annotations

from typing import Any

from ..group_facts import called
from ..words import NO_UNIT, NOTHING, SYMBOLS, count, counted, number, titled, unit_of

Facts = dict[str, Any]
Rows = list[tuple[str, str]]

GROUPS_TOLD = 100
WORST_TOLD = 5
LAYERS_TOLD = 12

SIGNS = {"passed": "✓", "missed": "✗", "not measured": "–"}
"""What stands beside a state, so that no colour is needed."""


def title_of(facts: Facts) -> str:
    """The report's heading."""
    return f"Report of {facts['file']['name'] or 'a mesh'}"


def verdict_of(facts: Facts) -> tuple[str, str]:
    """The verdict in a word, and in a sentence."""
    verdict = facts["verdict"]
    checks = verdict["checks"]
    missed = sum(check["state"] == "missed" for check in checks)
    by = {
        ("criteria",): "Judged by the criteria that were given.",
        (
            "diagnosis",
        ): "No criteria were given: judged by certified validity and the errors of the diagnosis.",
    }.get(
        tuple(verdict["by"]), "Judged by the criteria that were given, certified validity and the diagnosis."
    )
    few = f"{count(missed)} of {counted(len(checks), 'check')} missed. " if missed else ""
    return ("Passed" if verdict["passed"] else "Failed"), few + by


def file_rows(facts: Facts) -> Rows:
    """What tells the file from others."""
    file = facts["file"]
    rows = [
        ("Name", file["name"] or NOTHING),
        ("SHA-256", file["sha256"] or "not known"),
        ("Size", "not known" if file["bytes"] is None else f"{count(file['bytes'])} bytes"),
        ("Format", file["format_name"] or NOTHING),
    ]
    if file["included"]:
        told = "; ".join(f"{row['name']}, SHA-256 {row['sha256']}" for row in file["included"])
        rows.append(("Included files", told))
    if file["unit"] != NO_UNIT:
        rows.append(("Unit of length", SYMBOLS.get(file["unit"], file["unit"])))
    return rows


def count_rows(facts: Facts) -> Rows:
    """How much there is of everything."""
    counts = facts["counts"]
    low, high = facts["extent"]
    unit = unit_of(facts["file"]["unit"], 1)
    sides = " × ".join(
        number(None if b is None or a is None else b - a) for a, b in zip(low, high, strict=True)
    )
    return [
        ("Cells", count(counts["cells"])),
        ("Kinds", ", ".join(counted(many, kind) for kind, many in counts["kinds"].items()) or "none"),
        ("Vertices", count(counts["vertices"]) + among((counts["unreferenced_vertices"], "unreferenced"))),
        (
            "Faces",
            count(counts["faces"])
            + among(
                (counts["boundary_faces"], "on the boundary"),
                (counts["nonmanifold_faces"], "shared by more than two cells"),
            ),
        ),
        ("Edges", count(counts["edges"])),
        ("Inner edges by valence", _valences(counts["interior_edge_valence"])),
        ("Boundary edges by valence", _valences(counts["boundary_edge_valence"])),
        ("Cells by depth", _layers(counts["cells_per_depth"])),
        ("Parts", count(counts["components"])),
        ("Cells repeating a vertex", count(counts["cells_repeating_a_vertex"])),
        ("Extent", f"{sides} {unit}".rstrip()),
    ]


def validity_rows(facts: Facts) -> list[list[str]]:
    """State, number of cells, their numbers."""
    validity = facts["validity"]
    return [
        ["valid", count(validity["valid"]), ""],
        *(
            [state, count(validity[state]), some(validity[f"{state}_cells"], validity[state])]
            for state in ("invalid", "undecided")
        ),
    ]


def finding_rows(facts: Facts) -> list[list[str]]:
    """Severity, message, what it concerns."""
    return [
        [one["severity"], one["message"], _on(one["on"], one["numbers"], one["concerned"])]
        for one in facts["findings"]
    ]


def check_rows(facts: Facts) -> list[list[str]]:
    """State, what was asked, what was found, and where."""
    return [
        [
            f"{SIGNS[one['state']]} {one['state']}",
            one["title"],
            one["found"],
            _on(one["on"], _valued(one), one["count"]),
        ]
        for one in facts["verdict"]["checks"]
    ]


def group_rows(facts: Facts) -> list[list[str]]:
    """Name, what it is of, members, volume, least and mean Scaled Jacobian, invalid cells."""
    return [
        [
            called(one),
            one["kind"],
            count(one["count"]),
            number(one.get("volume")),
            number(one.get("scaled_jacobian_min")),
            number(one.get("scaled_jacobian_mean")),
            count(one.get("invalid")),
        ]
        for one in facts["groups"][:GROUPS_TOLD]
    ]


def feature_rows(facts: Facts) -> list[list[str]]:
    """What there is of each dimension, how much, how much is not of the mesh, in which groups."""
    return [
        [
            name,
            count(part["count"]),
            count(part["lost"]),
            some(
                [f"{called(row)}: {count(row['count'])}" for row in part["groups"]], len(part["groups"]), 12
            ),
        ]
        for name, part in facts["features"].items()
        if part["count"]
    ]


def metric_rows(facts: Facts) -> list[list[str]]:
    """Name, acceptable range, least, mean, largest, outside, not finite."""
    unit = facts["file"]["unit"]
    return [
        [
            titled(one["name"], one["length_power"], unit),
            range_of(one["acceptable_range"]),
            *(number(one[name]) for name in ("min", "mean", "max")),
            count(one["outside_acceptable"]) if one["acceptable_range"] else NOTHING,
            count(one["not_finite"]),
        ]
        for one in measured(facts)
    ]


def worst_rows(facts: Facts) -> list[list[str]]:
    """Name, the worst cells with their values, those without a finite value."""
    return [
        [
            one["name"],
            ", ".join(f"{row['number']} ({number(row['value'])})" for row in one["worst"][:WORST_TOLD])
            or NOTHING,
            some(one["not_finite_cells"], one["not_finite"], WORST_TOLD) or NOTHING,
        ]
        for one in measured(facts)
    ]


def measured(facts: Facts) -> list[Facts]:
    """The metrics that some cell has."""
    return [one for one in facts["metrics"] if one["count"] or one["not_finite"]]


def unmeasured(facts: Facts) -> str:
    """A sentence about those that none has; empty if there are none."""
    names = [one["name"] for one in facts["metrics"] if not one["count"] and not one["not_finite"]]
    return f"No cell has {', '.join(names)}." if names else ""


def range_of(ends: list[float | None] | None) -> str:
    """A range in words."""
    low, high = ends or (None, None)
    if low is None and high is None:
        return NOTHING
    if low is None or high is None:
        return f"at most {high:g}" if low is None else f"at least {low:g}"
    return f"{low:g} to {high:g}"


def some(items: list[Any], of: int, most: int = 20) -> str:
    """The first of so many, and how many more there are."""
    told = ", ".join(map(str, items[:most]))
    rest = of - min(len(items), most)
    return f"{told}, and {count(rest)} more" if told and rest > 0 else told


def among(*parts: tuple[int, str]) -> str:
    """Parts of a count in brackets, those that there are."""
    told = ", ".join(f"{count(many)} {what}" for many, what in parts if many)
    return f" ({told})" if told else ""


def made_by(facts: Facts) -> str:
    """The versions that made the report."""
    made = facts["made_by"]
    return f"Made by HexaLab {made['hexalab']}, Python {made['python']}, numpy {made['numpy']}."


NUMBERED = (
    "Cells and vertices are told by the file's own numbers; where it has none, by their places in the file."
)


def _on(on: str, items: list[Any], of: int) -> str:
    told = some(items, of)
    return f"{on} {told}" if told else ""


def _valued(check: Facts) -> list[Any]:
    if not check["values"]:
        return list(check["numbers"])
    pairs = zip(check["numbers"], check["values"], strict=True)
    return [f"{one} ({'not finite' if value is None else number(value)})" for one, value in pairs]


def _valences(counts: dict[str, int]) -> str:
    return ", ".join(f"{valence}: {count(many)}" for valence, many in counts.items()) or "none"


def _layers(per_depth: list[int]) -> str:
    told = "; ".join(count(many) for many in per_depth[:LAYERS_TOLD])
    more = len(per_depth) - LAYERS_TOLD
    return f"{told} and {counted(more, 'layer')} more" if more > 0 else told or "none"
