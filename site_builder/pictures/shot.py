"""A picture to be taken: which mesh, under which status, how large."""

from __future__ import annotations

import base64
import hashlib
import json
import zlib
from dataclasses import dataclass, field
from typing import Any

from hexalab.status import VERSION

from ..model.catalogue import MeshEntry

WIDTH, HEIGHT = 720, 480
"""Pixels: twice what a card shows."""

STYLE = 5
"""Raise it to have every picture taken anew, when the viewer draws otherwise than before."""

Status = dict[str, Any]


@dataclass(frozen=True)
class Shot:
    """One picture of a mesh of the catalogue.

    Parameters
    ----------
    mesh : MeshEntry
        Its file lies in the site.
    status : dict
        What of the status differs from the defaults; with a section `figure` a figure is made, of the size it has.
    width, height : int
        Pixels.
    part : str
        Selector of a part of the viewer's page to photograph instead of the drawing; "body" for the whole window.
    press : str
        Selector of what is clicked before.
    beside : MeshEntry, optional
        The mesh that it is compared with.
    """

    mesh: MeshEntry
    status: Status = field(default_factory=dict)
    width: int = WIDTH
    height: int = HEIGHT
    part: str = ""
    press: str = ""
    beside: MeshEntry | None = None

    @property
    def key(self) -> str:
        """Hash of all that the picture depends on; "" while the mesh's content isn't known."""
        if not self.mesh.sha256:
            return ""
        parts = [
            STYLE,
            self.mesh.sha256,
            self.status,
            self.width,
            self.height,
            self.part,
            *filter(None, [self.press, self.beside and self.beside.sha256]),
        ]
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]

    @property
    def address(self) -> str:
        """Address below the site's root that opens the mesh under this status in the viewer."""
        beside = f"&with={self.beside.id}" if self.beside else ""
        return f"viewer/index.html?mesh={self.mesh.id}{beside}#status={packed(self.status)}"

    @property
    def text(self) -> str:
        """The status as a document that can be pasted into the viewer."""
        return json.dumps(self.status, indent=2, ensure_ascii=False)


def packed(status: Status) -> str:
    """A status as the viewer's links carry it: deflated JSON in base64url (static/viewer/state/link.js)."""
    text = json.dumps({"version": VERSION, **status}, separators=(",", ":"))
    deflate = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = deflate.compress(text.encode()) + deflate.flush()
    return base64.urlsafe_b64encode(data).decode().rstrip("=")
