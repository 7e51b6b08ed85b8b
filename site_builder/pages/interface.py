"""What the page of the Python interface is filled with: `hexalab.__all__`, as the docstrings tell it.

Griffe reads the source without running it and parts each docstring into its sections; the page's look is the site's.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from markupsafe import Markup, escape

import hexalab

CORE = Path(hexalab.__file__).resolve().parents[1]

GROUPS = (
    (
        "Reading and writing",
        ("read", "write", "FORMATS", "WRITERS", "MeshReadError", "MeshWriteError", "HexaLabError"),
    ),
    ("The mesh", ("Mesh", "KINDS", "select_cells", "summarise")),
    ("Groups and features", ("Group", "Features", "groups_of")),
    (
        "The file's numbers",
        (
            "cell_numbers",
            "vertex_numbers",
            "cells_numbered",
            "vertices_numbered",
            "cell_list",
            "LIST_FORMS",
        ),
    ),
    ("Quality", ("quality", "quality_many", "METRICS", "Metric", "statistics", "histogram")),
    ("Structure", ("structure", "Structure")),
    ("Comparing", ("compare", "read_reference", "TriangleSurface")),
    ("Validity and diagnosis", ("certify", "Validity", "diagnose", "Finding")),
    ("In a notebook", ("show",)),
)
"""The page's sections, and the public names in each."""

NOT_INSTALLED = "the page of the Python interface is left out: griffelib is not installed"

SECTIONS = {
    "parameters": "Parameters", "other parameters": "Parameters", "attributes": "Attributes",
    "returns": "Returns", "yields": "Yields", "raises": "Raises",
}  # fmt: skip
"""Sections of a docstring that are lists, by Griffe's word for them."""


@dataclass
class Entry:
    """A parameter, a returned value, an exception or a property; `name` may be empty."""

    name: str
    type: str
    text: Markup


@dataclass
class Item:
    """A public name, or a method of one.

    Parameters
    ----------
    name : str
        As it is written after ``hexalab.``; the section's anchor, too.
    kind : str
        ``function``, ``class`` or ``table``.
    signature : str
        How it is called; empty for what is not.
    text : Markup
        What the docstring says before its sections.
    sections : dict of str to list of Entry
        The docstring's lists by their titles, in its order.
    methods : list of Item
    """

    name: str
    kind: str
    signature: str
    text: Markup
    sections: dict[str, list[Entry]] = field(default_factory=dict)
    methods: list[Item] = field(default_factory=list)


def installed() -> bool:
    """Whether the tool that reads the docstrings is here."""
    return find_spec("griffe") is not None


def interface_values() -> dict[str, Any]:
    """Values of the template."""
    return {
        "heading": "Python interface",
        "description": "Every public name of the Python package hexalab: what it takes, gives and raises.",
        "groups": interface(),
    }


@cache
def interface() -> list[tuple[str, list[Item]]]:
    """The public names in their groups, out of the source's docstrings.

    Raises
    ------
    ImportError
        Griffe is not installed; `installed` tells.
    """
    import griffe

    package = griffe.load("hexalab", search_paths=[CORE], docstring_parser="numpy", resolve_aliases=True)
    return [(title, [_item(name, _target(package, name)) for name in names]) for title, names in GROUPS]


def _target(package: Any, name: str) -> Any:
    """What a name of the package stands for; `quality` is a room, too, and the name is the function's in it."""
    found = package[name].final_target if package[name].is_alias else package[name]
    return _target(found, name) if found.is_module else found


def _item(name: str, found: Any) -> Item:
    kind = "table" if found.is_attribute else found.kind.value
    item = Item(name, kind, _signature(name, found), Markup())
    for section in found.docstring.parsed if found.docstring else ():
        if section.kind.value == "text":
            item.text += prose(section.value)
        elif section.kind.value in SECTIONS:
            item.sections.setdefault(SECTIONS[section.kind.value], []).extend(map(_entry, section.value))
    if found.is_class:
        members = list(_public(found))
        properties = [Entry(m.name, "", prose(m.docstring.value)) for m in members if m.is_attribute]
        if properties:
            item.sections["Properties"] = properties
        item.methods = [_item(f"{name}.{m.name}", m) for m in members if m.is_function]
    return item


def _public(found: Any) -> Iterator[Any]:
    """Methods and properties that are meant to be used: named without an underscore, and explained."""
    for member in found.members.values():
        if not member.name.startswith("_") and member.docstring:
            yield member


def _signature(name: str, found: Any) -> str:
    """`quality(mesh, metric)`: names and defaults; the types stand in the list below."""
    if found.is_attribute or not [p for p in found.parameters if p.name != "self"]:
        return ""
    parts = []
    bare = False
    for parameter in found.parameters:
        if parameter.name in ("self", "cls"):
            continue
        star = {"variadic positional": "*", "variadic keyword": "**"}.get(parameter.kind.value, "")
        if parameter.kind.value == "keyword-only" and not bare:
            parts.append("*")
            bare = True
        default = "" if star or parameter.default is None else f"={_default(str(parameter.default))}"
        parts.append(f"{star}{parameter.name}{default}")
    return f"{name}({', '.join(parts)})"


def _default(code: str) -> str:
    """A default that a reader can use: a literal or a public name; of anything else only that there is one."""
    return (
        code
        if code in hexalab.__all__ or re.fullmatch(r"None|True|False|[\d.]+|'.*'|\".*\"", code)
        else "..."
    )


def _entry(row: Any) -> Entry:
    return Entry(getattr(row, "name", ""), _type(row.annotation), prose(row.description))


def _type(annotation: Any) -> str:
    """The type in the docstring's words; a choice among words as "high" or "low"."""
    text = "" if annotation is None else str(annotation)
    words = re.findall(r"'([^']*)'", text)
    return " or ".join(f'"{word}"' for word in words) if re.fullmatch(r"[({]'[^(){}]*'[)}]", text) else text


def prose(text: str) -> Markup:
    """A docstring's text as HTML: paragraphs, names in backquotes as code, public ones linked.

    >>> prose("A row of `METRICS`.")
    Markup('<p>A row of <a href="#METRICS"><code>METRICS</code></a>.</p>')
    """
    paragraphs = (" ".join(part.split()) for part in re.split(r"\n\s*\n", text.strip()) if part.strip())
    return Markup("").join(Markup("<p>{}</p>").format(_inline(paragraph)) for paragraph in paragraphs)


def _inline(text: str) -> Markup:
    return Markup(re.sub(r"``?([^`]+)``?", lambda found: _code(found[1]), str(escape(text))))


def _code(name: str) -> str:
    code = f"<code>{name}</code>"
    return f'<a href="#{name}">{code}</a>' if name in hexalab.__all__ else code
