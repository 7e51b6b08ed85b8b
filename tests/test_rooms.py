"""The order of rooms, as docs/architecture.md shows it: a room knows only those that stand before it.

Imports are read from the files as text, those inside functions and JSDoc types too.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "architecture.md"

JS_IMPORT = re.compile(r"""(?:\bfrom\s+|\bimport\s*\(?\s*)["'](\.{1,2}/[^"']+)["']""")
HOUSES = {
    "The core": ROOT / "core" / "hexalab",
    "The site builder": ROOT / "site_builder",
    "The viewer": ROOT / "static" / "viewer",
}
"""Heading of a table in docs/architecture.md to the folder whose rooms it orders."""

OFFLINE = ROOT / "static" / "offline"
"""What viewer, catalogue and service worker share: it knows none of them."""

Edge = tuple[Path, Path]


def rooms_of(heading: str) -> list[str]:
    """The first column of the table below a heading: rooms, low to high; several may share a row."""
    text = PAGE.read_text("utf-8")
    section = text.split(f"### {heading}\n", 1)[1].split("\n#", 1)[0]
    rows = [line.split("|")[1] for line in section.splitlines() if line.startswith("| `")]
    return [name for row in rows for name in re.findall(r"`([^`]+)`", row)]


def room_of(file: Path, house: Path) -> str:
    """A folder's name with a slash, or the name of a file that lies beside the folders."""
    first, *rest = file.relative_to(house).parts
    return f"{first}/" if rest else first


def python_imports(file: Path, package: Path) -> Iterator[Path]:
    """Files of a package that one of its files imports."""
    top = package.parent
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        names: list[list[str]] = []
        if isinstance(node, ast.Import):
            names = [alias.name.split(".") for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            here = list(file.relative_to(top).parent.parts)
            base = here[: len(here) - node.level + 1] if node.level else []
            module = base + (node.module.split(".") if node.module else [])
            names = [[*module, alias.name] for alias in node.names]
        for name in names:
            for length in (len(name), len(name) - 1):
                path = top.joinpath(*name[:length])
                found = [path.with_suffix(".py"), path / "__init__.py"]
                hit = next(
                    (one for one in found if length and one.is_file() and package in one.parents), None
                )
                if hit:
                    yield hit
                    break


def javascript_imports(file: Path) -> Iterator[Path]:
    for address in JS_IMPORT.findall(file.read_text("utf-8")):
        yield (file.parent / address).resolve()


def edges_of(house: Path) -> list[Edge]:
    if house.name == "viewer":
        files = sorted(house.rglob("*.js"))
        edges = [(file, other) for file in files for other in javascript_imports(file)]
        return [(file, other) for file, other in edges if other.parent != OFFLINE]
    files = sorted(house.rglob("*.py"))
    return [(file, other) for file in files for other in python_imports(file, house) if other != file]


@pytest.mark.parametrize("heading", HOUSES)
def test_X1_every_room_stands_in_the_table_and_every_row_is_a_room(heading: str) -> None:
    house = HOUSES[heading]
    files = [file for file in house.rglob("*") if file.suffix in (".py", ".js", ".mjs")]
    assert {room_of(file, house) for file in files} == set(rooms_of(heading))


@pytest.mark.parametrize("heading", HOUSES)
def test_X1_a_room_knows_only_those_before_it(heading: str) -> None:
    house, order = HOUSES[heading], rooms_of(heading)
    edges = edges_of(house)
    assert len(edges) > 50, "imports were found at all"
    wrong = [
        f"{file.relative_to(house)} imports {other.relative_to(house)}"
        for file, other in edges
        if order.index(room_of(file, house)) < order.index(room_of(other, house))
    ]
    assert not wrong, f"order: {', '.join(order)}"


@pytest.mark.parametrize("heading", HOUSES)
def test_X1_no_files_import_each_other_in_a_circle(heading: str) -> None:
    """Types of JavaScript may: they are gone when it runs."""
    house = HOUSES[heading]
    known: dict[Path, set[Path]] = {}
    for file, other in edges_of(house):
        if house.name != "viewer" or re.search(
            rf"""\bfrom\s+["'][^"']*{re.escape(other.name)}["']""", file.read_text("utf-8")
        ):
            known.setdefault(file, set()).add(other)
    done: set[Path] = set()

    def follow(file: Path, way: tuple[Path, ...]) -> None:
        assert file not in way, " -> ".join(str(one.relative_to(house)) for one in (*way, file))
        if file not in done:
            for other in known.get(file, ()):
                follow(other, (*way, file))
            done.add(file)

    for file in known:
        follow(file, ())


def test_X1_the_core_knows_no_site_builder() -> None:
    for file in (ROOT / "core" / "hexalab").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom):
                assert not (node.module or "").startswith("site_builder"), file
            if isinstance(node, ast.Import):
                assert not any(alias.name.startswith("site_builder") for alias in node.names), file


def test_X1_what_all_pages_share_knows_none_of_them() -> None:
    files = list(OFFLINE.glob("*.js"))
    assert files
    for file in files:
        assert {other.parent for other in javascript_imports(file)} <= {OFFLINE}
