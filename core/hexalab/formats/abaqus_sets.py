"""Names of the sets and surfaces of an Abaqus deck, for a note: they are not shown."""

from __future__ import annotations

from .abaqus_deck import Keyword

SETS = {"ELSET": "element set", "NSET": "node set", "SURFACE": "surface"}
"""Keywords that define them, and what they are called."""

NAMED_BY = {"ELEMENT": "ELSET", "NODE": "NSET"}
"""Keywords that put what they define into a set, by the option of that name."""

MOST_NAMES = 5


class Sets:
    """Gathers names; of those that differ in letter case only, the first."""

    def __init__(self) -> None:
        self.names: dict[str, dict[str, str]] = {kind: {} for kind in SETS}

    def add(self, keyword: Keyword) -> None:
        """Look for sets in a keyword; those that Abaqus/CAE makes for itself are not counted."""
        kind = NAMED_BY.get(keyword.name, keyword.name)
        if kind not in SETS or "INTERNAL" in keyword.options:
            return
        option = "NAME" if kind == "SURFACE" else kind
        name = keyword.options.get(option, "").strip("\"' ")
        if name:
            self.names[kind].setdefault(name.upper(), name[:60])

    def note(self) -> str:
        """What to note: "2 element sets (A, B) and 1 surface (Top) are not shown."; "" if there are none."""
        parts = []
        for kind, called in SETS.items():
            names = list(self.names[kind].values())
            if names:
                shown = ", ".join(names[:MOST_NAMES])
                more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
                parts.append(f"{len(names)} {called}{'s' * (len(names) > 1)} ({shown}{more})")
        if not parts:
            return ""
        several = len(parts) > 1 or sum(map(len, self.names.values())) > 1
        listed = " and ".join([", ".join(parts[:-1]), parts[-1]]) if len(parts) > 1 else parts[0]
        return f"{listed} {'are' if several else 'is'} not shown."
