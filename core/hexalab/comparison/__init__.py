"""Two meshes beside each other, or a mesh and a reference surface: distances, changes of metrics (SPEC S6, S7)."""

from .bodies import holds_surface, read_body
from .cell_data import with_comparison
from .connectivity import difference_in_cells, fingerprint
from .counterpart import Counterpart, change_of, counterpart_of, moved
from .distances import Measuring, both_ways
from .facts import (
    change_counts,
    compare,
    differences,
    displacement_facts,
    surface_distances,
    surface_facts,
)
from .quantities import CHANGE, DISPLACEMENT, DISTANCE, QUANTITIES, cellwise_values, largest_of_corners
from .triangle_distance import Frames, closest_points, frames_of, squared_distances
from .triangle_index import Nearest, TriangleIndex
from .volumes import volume_of, volume_ratio

__all__ = [
    "CHANGE",
    "DISPLACEMENT",
    "DISTANCE",
    "QUANTITIES",
    "Counterpart",
    "Frames",
    "Measuring",
    "Nearest",
    "TriangleIndex",
    "both_ways",
    "cellwise_values",
    "change_counts",
    "change_of",
    "closest_points",
    "compare",
    "counterpart_of",
    "difference_in_cells",
    "differences",
    "displacement_facts",
    "fingerprint",
    "frames_of",
    "holds_surface",
    "largest_of_corners",
    "moved",
    "read_body",
    "squared_distances",
    "surface_distances",
    "surface_facts",
    "volume_of",
    "volume_ratio",
    "with_comparison",
]
