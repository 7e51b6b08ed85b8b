"""Texts within HTML and XML, by Python alone: a browser's has no `html` and no `xml`."""

from __future__ import annotations

MARKS = str.maketrans({mark: f"&#{ord(mark)};" for mark in "&<>\"'\t\n"})
"""What might end a text or an attribute, or become a blank in one."""


def escape(text: str) -> str:
    """A text that stands for itself, within an attribute too.

    >>> escape('<a "b">')
    '&#60;a &#34;b&#34;&#62;'
    """
    return text.translate(MARKS)


def quoted(text: str) -> str:
    """The same as the value of an attribute, in quotes."""
    return f'"{escape(text)}"'
