"""The tags of a VTK XML file, with their places in the bytes.

Not an XML parser: VTK's files are not always XML (raw appended data follows the tags), and arrays of a
hundred megabytes stand between two tags, which are best left where they are. Entities that a document
defines itself are not expanded, so there is nothing to blow up.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from .file import File
from .tokens import quoted

TAG = re.compile(
    rb"<!--.*?-->|<\?.*?\?>|<(/?)([A-Za-z_][\w.:-]*)((?:\s+[\w.:-]+\s*=\s*(?:\"[^\"<]*\"|'[^'<]*'))*)\s*(/?)>",
    re.DOTALL,
)
ATTRIBUTE = re.compile(rb"([\w.:-]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
ENTITY = re.compile(r"&(#\d{1,7}|#x[0-9a-fA-F]{1,6}|amp|lt|gt|quot|apos);")
NAMED = {"amp": "&", "lt": "<", "gt": ">", "quot": '"', "apos": "'"}
DEEPEST = 64


@dataclass
class Element:
    """An element: its name, attributes, children, and where its content begins and ends."""

    name: str
    attributes: dict[str, str]
    begin: int
    end: int = -1
    children: list[Element] = field(default_factory=list)

    def all(self, name: str) -> list[Element]:
        """Children of that name."""
        return [child for child in self.children if child.name == name]

    def first(self, name: str) -> Element | None:
        """The first child of that name."""
        return next(iter(self.all(name)), None)


def parse(file: File, last: str) -> Element:
    """The tree of elements, read up to the element named `last` or the end; its root has no name.

    Raises
    ------
    MeshReadError
        The tags do not match.
    """
    root = Element("", {}, 0, len(file.data))
    open_elements = [root]
    for match in TAG.finditer(file.data):
        if match[2] is None:
            continue
        name = match[2].decode()
        if match[1]:
            if len(open_elements) == 1 or open_elements[-1].name != name:
                expected = quoted(open_elements[-1].name) if open_elements[-1].name else "an opening tag"
                raise file.error(
                    f"the end of {quoted(name)} stands where {expected} should end", line_at=match.start()
                )
            open_elements.pop().end = match.start()
            continue
        element = Element(name, attributes_of(match[3]), match.end(), match.end())
        open_elements[-1].children.append(element)
        if name == last:
            element.end = len(file.data)
            return root
        if not match[4]:
            open_elements.append(element)
            if len(open_elements) > DEEPEST:
                raise file.error(f"elements are nested more than {DEEPEST} deep", line_at=match.start())
    if len(open_elements) > 1:
        raise file.error(
            f"the file ends inside {quoted(open_elements[-1].name)}: it is cut short",
            line_at=len(file.data),
        )
    return root


def attributes_of(text: bytes) -> dict[str, str]:
    """The attributes of a tag; their values with entities replaced."""
    return {
        match[1].decode(): ENTITY.sub(replaced, (match[2] or match[3] or b"").decode("utf-8", "replace"))
        for match in ATTRIBUTE.finditer(text)
    }


def replaced(match: re.Match[str]) -> str:
    """The character that an entity stands for."""
    code = match[1]
    if not code.startswith("#"):
        return NAMED[code]
    number = int(code[2:], 16) if code[1] == "x" else int(code[1:])
    return chr(number) if number <= 0x10FFFF else "\N{REPLACEMENT CHARACTER}"
