"""VTK's Verdict as truth: its values for cells given by their corners, and samples of hexahedra to ask it about."""

from __future__ import annotations

import numpy as np

from hexalab.cells import COLLAPSE, HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from hexalab.mesh import Mesh
from hexalab.quality import METRICS
from tests.tools import tool

vtk, numpy_support = tool("vtk"), tool("vtk.util.numpy_support")

NAMES = {
    "diagonal": "Diagonal",
    "distortion": "Distortion",
    "edge_ratio": "EdgeRatio",
    "jacobian": "Jacobian",
    "max_edge_ratio": "MaxEdgeRatio",
    "max_aspect_frobenius": "MaxAspectFrobenius",
    "mean_aspect_frobenius": "MedAspectFrobenius",
    "oddy": "Oddy",
    "relative_size_squared": "RelativeSizeSquared",
    "scaled_jacobian": "ScaledJacobian",
    "shape": "Shape",
    "shape_and_size": "ShapeAndSize",
    "shear": "Shear",
    "shear_and_size": "ShearAndSize",
    "skew": "Skew",
    "stretch": "Stretch",
    "taper": "Taper",
    "volume": "Volume",
    "dimension": "Dimension",
    "equiangle_skew": "EquiangleSkew",
    "nodal_jacobian_ratio": "NodalJacobianRatio",
}
"""Names of our metrics in `vtkMeshQuality`."""

KINDS = {HEXAHEDRON: ("Hex", 12), WEDGE: ("Wedge", 13), PYRAMID: ("Pyramid", 14), TETRAHEDRON: ("Tet", 10)}

CUBE = np.array(
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float
)
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
IDEAL = {
    HEXAHEDRON: CUBE,
    TETRAHEDRON: np.array([[0, 0, 0], [1, 0, 0], [0.5, 0.75**0.5, 0], [0.5, 0.75**0.5 / 3, (2 / 3) ** 0.5]]),
    PYRAMID: np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 0.5**0.5]]),
    WEDGE: np.array([[0, 0, 0], [0.5, 0.75**0.5, 0], [1, 0, 0], [0, 0, 1], [0.5, 0.75**0.5, 1], [1, 0, 1]]),
}
"""Own corners of the ideal cell of each kind, in VTK's order."""


def quality(points: np.ndarray, cells: np.ndarray, metric: str, kind: int = HEXAHEDRON) -> np.ndarray:
    """Verdict's values of cells (C, k) over points (V, 3); the test is skipped where VTK is absent."""
    numpy_to_vtk = numpy_support.numpy_to_vtk
    prefix, cell_type = KINDS[kind]
    count, corners = cells.shape
    grid, vtk_points, array = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=1))
    offsets = np.arange(0, corners * count + 1, corners, dtype=np.int64)
    ids = np.ascontiguousarray(cells, dtype=np.int64).ravel()
    array.SetData(*(numpy_support.numpy_to_vtkIdTypeArray(part, deep=1) for part in (offsets, ids)))
    grid.SetPoints(vtk_points)
    grid.SetCells(cell_type, array)
    filter_ = vtk.vtkMeshQuality()
    filter_.SetInputData(grid)
    name = "MeanAspectFrobenius" if kind == WEDGE and metric.startswith("mean") else NAMES[metric]
    getattr(filter_, f"Set{prefix}QualityMeasureTo{name}")()
    filter_.Update()
    return numpy_support.vtk_to_numpy(filter_.GetOutput().GetCellData().GetArray("Quality")).copy()


ROUNDED = {
    (WEDGE, "max_aspect_frobenius"): 1.16477 * 3 * 1.5 ** (1 / 3) / 4,
    (WEDGE, "mean_aspect_frobenius"): 1.16477 * 3 * 1.5 ** (1 / 3) / 4,
    (WEDGE, "distortion"): 0.866025 / 0.866026,
}
"""What makes the definition's value of Verdict's, where it has rounded a constant: a wedge's aspect is relative to
that of the unit wedge's corners, 4 / (3 1.5^(1/3)); its two roundings of sqrt(3) / 2 should cancel."""

NOT_TAKEN_OVER = {(HEXAHEDRON, "edge_ratio")}
"""What Verdict computes of half of the edges: see `longest_over_shortest`."""


def of_corners(corners: np.ndarray, metric: str, kind: int = HEXAHEDRON) -> np.ndarray:
    """Verdict's values of cells given by corner coordinates (C, k, 3), less what depends on the file's unit and place.

    NaN where it returns its sentinel; where that comes of the root of a negative mean volume, the manual's 0.

    Its absolute thresholds suit cells of about one unit near the origin. So each cell is scaled by a power of two, and
    moved where it is far away (which is exact there); what carries a unit is scaled back.
    """
    count, k = corners.shape[:2]
    if (kind, metric) in NOT_TAKEN_OVER:
        return longest_over_shortest(corners)
    size = np.ptp(corners, axis=1).max(axis=1)
    size = np.where(size > 0, size, 1)
    if "size" in metric:
        size = np.full(count, size.max())
    power = np.frexp(size)[1]
    far = np.abs(corners).max(axis=(1, 2)) > 16 * size
    moved = corners - np.where(far[:, None], corners[:, 0], 0)[:, None]
    near = np.ldexp(moved, -power[:, None, None])
    values = quality(near.reshape(-1, 3), np.arange(count * k).reshape(count, k), metric, kind)
    values[~(np.abs(values) < 1e30)] = 0 if "size" in metric else np.nan
    return np.ldexp(values, METRICS[metric].length_power * power) * ROUNDED.get((kind, metric), 1)


def longest_over_shortest(corners: np.ndarray) -> np.ndarray:
    """The manual's edge ratio of hexahedra (C, 8, 3); NaN where an edge is short, as for the other metrics."""
    lengths = np.array([np.linalg.norm(corners[:, a] - corners[:, b], axis=1) for a, b in EDGES])
    box = np.linalg.norm(np.ptp(corners, axis=1), axis=1)
    short = lengths.min(axis=0) ** 2 <= 10 * np.finfo(float).eps * box**2
    with np.errstate(all="ignore"):
        return np.where(short, np.nan, lengths.max(axis=0) / lengths.min(axis=0))


def mesh_of(corners: np.ndarray, kind: int = HEXAHEDRON) -> Mesh:
    """Mesh of separate cells given by corner coordinates (C, k, 3)."""
    count, k = corners.shape[:2]
    own = np.arange(count * k).reshape(count, k).T
    return Mesh(corners.reshape(-1, 3).T, own[list(COLLAPSE[kind])], np.full(count, kind, np.uint8))


def samples(kind: int = HEXAHEDRON, count: int = 400, seed: int = 1) -> dict[str, np.ndarray]:
    """Random cells (C, k, 3) by name: sound, inverted, flat, tiny, huge, far from the origin."""
    random, ideal = np.random.default_rng(seed), IDEAL[kind]
    shape = (count, *ideal.shape)
    sound = ideal + random.uniform(-0.2, 0.2, shape)
    return {
        "sound": sound,
        "wild": random.normal(size=shape),
        "inverted": sound * [-1, 1, 1],
        "flat": sound * [1, 1, 1e-6],
        "tiny": sound * 1e-12,
        "huge": sound * 1e12,
        "all scales": sound * 10 ** random.uniform(-12, 12, (count, 1, 1)),
        "off the origin": sound + random.normal(size=(count, 1, 3)) * 100,
    }


def hexahedra(count: int = 400, seed: int = 2) -> dict[str, np.ndarray]:
    """More random hexahedra: stretched, twisted, of irregular corners, near the thresholds of Verdict."""
    random = np.random.default_rng(seed)
    angles = random.uniform(0, 2 * np.pi, count)
    turn = np.stack([np.cos(angles), np.sin(angles), -np.sin(angles), np.cos(angles)], axis=1).reshape(
        -1, 2, 2
    )
    twisted = np.tile(CUBE - 0.5, (count, 1, 1))
    twisted[:, 4:, :2] = twisted[:, 4:, :2] @ turn
    return {
        "stretched": (CUBE + random.uniform(-0.3, 0.3, (count, 8, 3)))
        * 10 ** random.uniform(-6, 6, (count, 1, 3)),
        "twisted": twisted * [1, 1, 2] + random.uniform(-0.05, 0.05, (count, 8, 3)),
        "far away": CUBE * 1e-3
        + random.uniform(-2e-4, 2e-4, (count, 8, 3))
        + 300 * random.normal(size=(count, 1, 3)),
        "irregular": CUBE + random.uniform(-0.6, 0.6, (count, 8, 3)),
        "needles": (CUBE + random.uniform(-0.3, 0.3, (count, 8, 3)))
        * np.concatenate([10 ** random.uniform(-9, 0, (count, 1, 2)), np.ones((count, 1, 1))], axis=2),
        "below thresholds": (CUBE + random.uniform(-0.2, 0.2, (count, 8, 3)))
        * 10 ** random.uniform(-17, -3, (count, 1, 1)),
    }


def assert_equal(ours: np.ndarray, theirs: np.ndarray, noise: float = 0.0) -> None:
    """Finite values agree to 1e-9 relative (or `noise` absolute); what is NaN is infinite or NaN on our side."""
    sentinel = np.isnan(theirs)
    np.testing.assert_array_equal(~np.isfinite(ours), sentinel)
    np.testing.assert_allclose(ours[~sentinel], theirs[~sentinel], rtol=1e-9, atol=noise)
