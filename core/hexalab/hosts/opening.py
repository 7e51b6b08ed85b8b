"""Opening a page in the user's browser, where there is one to see."""

from __future__ import annotations

import os
import sys
import webbrowser
from collections.abc import Mapping


def has_screen(environment: Mapping[str, str] = os.environ, platform: str = sys.platform) -> bool:
    """Whether a window can be opened here: not over SSH, nor on a machine without a screen."""
    if "SSH_CONNECTION" in environment and "DISPLAY" not in environment:
        return False
    if platform in ("win32", "darwin"):
        return True
    return bool(
        environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY") or environment.get("BROWSER")
    )


def open_page(address: str) -> bool:
    """Open an address in the user's browser; whether that was tried without a failure."""
    try:
        return webbrowser.open(address)
    except webbrowser.Error:
        return False
