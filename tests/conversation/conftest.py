"""The meshes that are talked about are those of the core's tests."""

from tests.core.conftest import attributed, grid, twisted

__all__ = ["attributed", "grid", "twisted"]
