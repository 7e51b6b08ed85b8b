"""Two meshes beside each other, or a mesh and a reference surface: exact distances."""

from .triangle_distance import Frames, closest_points, frames_of, squared_distances
from .triangle_index import Nearest, TriangleIndex

__all__ = ["Frames", "Nearest", "TriangleIndex", "closest_points", "frames_of", "squared_distances"]
