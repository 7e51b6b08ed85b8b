"""Reading YAML that strangers send: bounded, without aliases, and with the line of every field.

`read_yaml` gives the data as plain dictionaries and lists, and a table of lines by field path, so that whoever finds a
wrong field later can say where it stands::

    document = read_yaml(Path("source.yaml"))
    document.data["reference"]["title"]
    document.line(("reference", "title"))
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

import yaml

LARGEST_DOCUMENT = 2_000_000
"""Bytes of a YAML file that is still read; the largest source of the catalogue needs a twentieth of it."""

DEEPEST_NESTING = 20

FieldPath = tuple[str | int, ...]

_UNSEEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ufeff\ufffe\uffff]")
"""Control characters, separators of lines, and what turns the direction of text: no HTML or none that reads true."""


class DocumentError(Exception):
    """A YAML file can't be read, or a field of it is wrong.

    Parameters
    ----------
    message : str
        What was found and what was expected.
    file : Path
    line : int
        1-based; 0 if the whole file is meant.
    path : tuple of str and int
        The field.
    """

    def __init__(self, message: str, file: Path, line: int = 0, path: FieldPath = ()) -> None:
        super().__init__(message)
        self.message = message
        self.file = file
        self.line = line
        self.path = path

    @property
    def field(self) -> str:
        """The field's path as people write it: ``meshes[2].url``."""
        return field_name(self.path)

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else str(self.file)
        return f"{place}: {self.field}: {self.message}" if self.path else f"{place}: {self.message}"


def field_name(path: FieldPath) -> str:
    """The path of a field as people write it: ``meshes[2].url``."""
    text = ""
    for part in path:
        text += f"[{part}]" if isinstance(part, int) else f".{part}" if text else part
    return text


@dataclass
class Document:
    """What a YAML file holds, and where."""

    file: Path
    data: Any
    lines: dict[FieldPath, int] = field(default_factory=dict)

    def line(self, path: FieldPath) -> int:
        """The 1-based line of a field, or of the nearest field around it that the file has."""
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 1)

    def error(self, message: str, path: FieldPath) -> DocumentError:
        """An error about a field of this file."""
        return DocumentError(message, self.file, self.line(path), path)


def read_yaml(file: Path) -> Document:
    """Read a YAML file.

    Raises
    ------
    DocumentError
        The file is too large, isn't UTF-8 or YAML, uses aliases, repeats a key or nests too deep.
    """
    size = file.stat().st_size
    if size > LARGEST_DOCUMENT:
        raise DocumentError(f"{size:,} bytes, but at most {LARGEST_DOCUMENT:,} are read", file)
    try:
        text = file.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise DocumentError(f"byte {error.start} isn't UTF-8 text", file) from None
    return parse_yaml(text, file)


class _Loader(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # type: ignore[misc]
    """PyYAML's safe loader with the plain scalars of YAML 1.2: ``010`` and ``1:30`` and ``no`` are what they look like.

    What looks like a date stays text, too, and numbers too long to be meant are not computed.
    """

    yaml_implicit_resolvers: ClassVar[dict[str, Any]] = {}


for _tag, _form, _first in (
    ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
    ("int", r"[-+]?(?:0|[1-9][0-9]{0,17})", list("-+0123456789")),
    (
        "float",
        r"[-+]?(?:[0-9]{1,18}\.[0-9]{0,18}|\.[0-9]{1,18})(?:[eE][-+]?[0-9]{1,3})?",
        list("-+.0123456789"),
    ),
):
    _Loader.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(rf"(?:{_form})\Z"), _first)


def parse_yaml(text: str, file: Path) -> Document:
    """Read YAML from text; `file` is named in errors."""
    try:
        _refuse_aliases(text, file, _Loader)
        loader = _Loader(text)
        try:
            node = loader.get_single_node()
            if node is None:
                raise DocumentError("nothing in it; a mapping was expected", file, 1)
            document = Document(file, None)
            for path, line in _walk(node, (), file):
                document.lines[path] = line
            document.data = loader.construct_document(node)
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = _line(mark)
        found = text.splitlines()[line - 1 : line]
        hint = " (a tab; YAML is indented with spaces)" if found and re.match(r" *\t", found[0]) else ""
        raise DocumentError(f"not YAML: {error.problem or error.context}{hint}", file, line) from None
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        message = f"not YAML: the character U+{ord(text[error.position]):04X} is not allowed"
        raise DocumentError(message, file, line) from None
    except (yaml.YAMLError, ValueError) as error:
        raise DocumentError(f"not YAML: {error}", file, 1) from None
    return document


def _line(mark: Any) -> int:
    """The 1-based line of PyYAML's mark; the first where it has none."""
    return int(mark.line) + 1 if mark else 1


def _refuse_aliases(text: str, file: Path, base: Any) -> None:
    """Aliases can blow a small file up to gigabytes; nothing here needs them. Bounds the nesting too."""
    depth = 0
    for event in yaml.parse(text, Loader=base):
        if isinstance(event, yaml.AliasEvent):
            raise DocumentError("aliases (*name) are not allowed here", file, _line(event.start_mark))
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > DEEPEST_NESTING:
                message = f"nested more than {DEEPEST_NESTING} levels deep"
                raise DocumentError(message, file, _line(event.start_mark))
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


def _walk(node: yaml.Node, path: FieldPath, file: Path) -> Iterator[tuple[FieldPath, int]]:
    yield path, node.start_mark.line + 1
    if isinstance(node, yaml.ScalarNode) and (found := _UNSEEN.search(node.value)):
        message = f"the character U+{ord(found[0]):04X}, which nobody sees, is not allowed"
        raise DocumentError(message, file, node.start_mark.line + 1, path)
    if isinstance(node, yaml.MappingNode):
        seen: set[str] = set()
        for key, value in node.value:
            line = key.start_mark.line + 1
            if not isinstance(key, yaml.ScalarNode) or key.tag != "tag:yaml.org,2002:str":
                raise DocumentError("a key must be a word", file, line, path)
            if key.value in seen:
                raise DocumentError(f"the key {key.value!r} stands here twice", file, line, path)
            seen.add(key.value)
            inner = (*path, key.value)
            yield from _walk(value, inner, file)
            yield inner, line
    elif isinstance(node, yaml.SequenceNode):
        for index, value in enumerate(node.value):
            yield from _walk(value, (*path, index), file)
