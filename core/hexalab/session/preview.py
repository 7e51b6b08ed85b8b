"""The first picture of a mesh as one block of bytes: what the catalogue shows before Python runs."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import status as documents
from ..packing import pack
from .opened import Opened
from .picture import Picture

RECORDS = ("surface", "silhouette", "see_through", "irregular", "arrows", "marks", "curves", "colour")
"""What of a picture it holds."""


def preview_of(opened: Opened, settings: dict[str, Any] | None) -> bytes:
    """Pack summary and first picture, drawn under a checked part of a status."""
    opened.described("edges")
    picture = Picture(opened)
    whole = documents.merge(documents.DEFAULTS, settings or {})
    records = picture.update(documents.core_part(whole))
    mesh = opened.mesh
    summary = {
        "name": mesh.name,
        "cells": mesh.cell_count,
        "vertices": mesh.vertex_count,
        **opened.placed,
    }
    shown = {"shown_cells": int(np.count_nonzero(picture.shown)), "shown_faces": picture.shown_faces()}
    return pack({"summary": summary, **shown, **{name: records[name] for name in RECORDS if name in records}})
