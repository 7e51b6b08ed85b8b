"""HexaLab: read, measure, filter and draw hexahedral meshes."""

from __future__ import annotations

from .errors import HexaLabError, MeshReadError, MeshWriteError
from .mesh import KINDS, Mesh

__version__ = "1.0.0"

__all__ = ["KINDS", "HexaLabError", "Mesh", "MeshReadError", "MeshWriteError"]
