"""A picture that stays in the saved notebook, where no kernel and no script are."""

from __future__ import annotations

import base64
from html import escape

LIVE = "hexalab-live"
"""Class of the widget's element while a viewer is in it."""


def still(png: bytes, words: str, height: int) -> str:
    """HTML of the picture; hidden while a live view stands before it.

    Parameters
    ----------
    png : bytes
        With its settings inside; b"" while there is none.
    words : str
        What it shows.
    height : int
        Of the view in pixels, beyond which the picture does not go.
    """
    if not png:
        return '<span class="hexalab-still"></span>'
    data = base64.b64encode(png).decode()
    return (
        '<div class="hexalab-still"><style>'
        f".jp-OutputArea-child:has(.{LIVE}) ~ .jp-OutputArea-child:has(.hexalab-still),"
        f".output_area:has(.{LIVE}) ~ .output_area:has(.hexalab-still),"
        f".output:has(.{LIVE}) ~ .output:has(.hexalab-still) {{ display: none }}"
        "</style>"
        f'<img alt="{escape(words)}" title="{escape(words)}" src="data:image/png;base64,{data}"'
        f' style="max-width: 100%; max-height: {height}px"></div>'
    )
