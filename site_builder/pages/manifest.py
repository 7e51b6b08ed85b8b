"""The web app manifest: what makes the site installable, and the desktop open meshes with it.

Members after https://www.w3.org/TR/appmanifest/, https://wicg.github.io/manifest-incubations/ (file handlers, launch
handler) and https://w3c.github.io/web-share-target/.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from hexalab.formats import FORMATS

from ..model.catalogue import Catalogue
from ..pictures.collection import Figure

THEME, PAPER = "#0b6e74", "#fbfaf7"
"""`--accent` and `--paper` of `static/styles/tokens.css`."""

ICONS = {
    "icons/icon-192.png": (192, "any"),
    "icons/icon-512.png": (512, "any"),
    "icons/maskable-512.png": (512, "maskable"),
}
"""Address of each icon to its side in pixels and its purpose."""

APPLE_ICON = ("icons/icon-180.png", 180)
"""What iOS puts on its home screen: it rounds the corners itself, and takes no manifest's icon."""


def endings() -> list[str]:
    """Endings of the files that the viewer reads, with the dot."""
    return sorted({extension for one in FORMATS for extension in one.extensions})


def manifest(
    catalogue: Catalogue, screens: Mapping[str, Figure], sizes: Mapping[str, tuple[int, int]]
) -> str:
    """The manifest's text.

    Parameters
    ----------
    catalogue : Catalogue
    screens : dict of str to Figure
        Pictures of the window by its form: "wide", "narrow".
    sizes : dict of str to (int, int)
        Widths and heights of the pictures that the site has, by address.
    """
    document: dict[str, Any] = {
        "name": catalogue.title,
        "short_name": "HexaLab",
        "description": "Look into hexahedral meshes, judge their quality, cite where they come from.",
        "lang": "en",
        "dir": "ltr",
        "start_url": "./viewer/index.html",
        "scope": "./",
        "display": "standalone",
        "theme_color": THEME,
        "background_color": PAPER,
        "categories": ["science", "graphics", "education"],
        "icons": [
            {"src": address, "sizes": f"{side}x{side}", "type": "image/png", "purpose": purpose}
            for address, (side, purpose) in ICONS.items()
        ]
        + [{"src": "icon.svg", "sizes": "any", "type": "image/svg+xml", "purpose": "any"}],
        "screenshots": [
            {
                "src": figure.address,
                "sizes": "x".join(map(str, sizes[figure.address])),
                "type": "image/png",
                "form_factor": form,
                "label": figure.title,
            }
            for form, figure in screens.items()
            if figure.address in sizes
        ],
        "shortcuts": [
            {"name": "Open a mesh", "url": "./viewer/index.html", "icons": [_shortcut_icon()]},
            {"name": "Catalogue", "url": "./index.html", "icons": [_shortcut_icon()]},
        ],
        "file_handlers": [
            {
                "action": "./viewer/index.html",
                "accept": {"application/x-hexahedral-mesh": endings()},
                "launch_type": "single-client",
            }
        ],
        "launch_handler": {"client_mode": ["focus-existing", "auto"]},
        "share_target": {
            "action": "./share",
            "method": "POST",
            "enctype": "multipart/form-data",
            "params": {
                "title": "title",
                "text": "text",
                "url": "url",
                "files": [
                    {"name": "files", "accept": ["application/octet-stream", "text/plain", *endings()]}
                ],
            },
        },
    }
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _shortcut_icon() -> dict[str, str]:
    return {"src": "icons/icon-192.png", "sizes": "192x192", "type": "image/png"}
