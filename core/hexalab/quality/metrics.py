"""The table of metrics as data: ranges, ideal value, normalisation, formula, and where Verdict's answer surprises."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, sqrt
from typing import Literal

import numpy as np

from ..arrays import Array, Floats
from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from .normalisation import (
    BETWEEN_EXTREMES,
    DOWN_TO_ONE,
    DOWN_TO_ZERO,
    IDENTITY,
    SHARE_OF_HIGHEST,
    Normalisation,
    is_empty,
)

Range = tuple[float, float]


@dataclass(frozen=True)
class Metric:
    """One quality metric: a row of `METRICS`.

    Parameters
    ----------
    id, name, symbol : str
        Snake-case id, name on the screen, the paper's short id (SJ, DIA, ...).
    full_range : (low, high)
        Values that a hexahedron can take.
    acceptable_range : (low, high) or None
        The paper's table (after Verdict's manual); None where neither gives one.
    unit_cube : float or None
        Value for the unit cube; None where it depends on the rest of the mesh.
    better : {"high", "low"}
        Which of two values is better.
    normalisation : Normalisation
        The paper's phi and its inverse.
    length_power : int
        Dimension of the values: the power of a length that they carry, 3 for a volume, 1 for a length, 0 for none.
        A mesh that is scaled by s has values times s**length_power.
    kinds : tuple of int
        Cell kinds (see `hexalab.cells.KINDS`) that have the metric.
    formula : str
        For a hexahedron with corner edges u, v, w (right-handed) and principal axes X, Y, Z, the sums of the four
        edges of each direction. After C. J. Stimpson, C. D. Ernst, P. Knupp, P. P. Pebay, D. Thompson, "The Verdict
        Geometric Quality Library", SAND2007-1751.
    remark : str
        Where it is not defined (here: the infinity at the worst end; Verdict's sentinel is 1e30), where VTK's Verdict
        departs from the definition, or a value that surprises.
    variant : str
        Which it is of several that go by this name in the field, for the screen; empty if there is but one.
    """

    id: str
    name: str
    symbol: str
    full_range: Range
    acceptable_range: Range | None
    unit_cube: float | None
    better: Literal["high", "low"]
    normalisation: Normalisation
    length_power: int
    kinds: tuple[int, ...]
    formula: str
    remark: str = ""
    variant: str = ""

    def normalise(self, values: Array, low: float, high: float) -> Floats:
        """Map native values to [0, 1], 1 best (the paper's phi).

        Parameters
        ----------
        values : (n,) float64
            Native values.
        low, high : float
            Smallest and largest finite value over the mesh.

        Returns
        -------
        (n,) float64
            NaN where the value is not finite; 1 everywhere if the range is empty.
        """
        values = np.asarray(values, dtype=np.float64)
        finite = np.isfinite(values)
        if is_empty(self.normalisation, low, high, self.length_power > 0):
            return np.where(finite, 1.0, np.nan)
        with np.errstate(invalid="ignore"):
            normal = np.clip(self.normalisation.forward(values, low, high), 0.0, 1.0)
        return np.where(finite, normal, np.nan)

    def denormalise(self, normal: Array, low: float, high: float) -> Floats:
        """Map [0, 1] back to native values: the inverse of `normalise`, where that has one.

        What was clamped (a Scaled Jacobian below 0) is not recovered; of an empty range comes its one value.
        """
        normal = np.asarray(normal, dtype=np.float64)
        if is_empty(self.normalisation, low, high, self.length_power > 0):
            return np.full(normal.shape, low)
        return np.asarray(self.normalisation.inverse(normal, low, high), dtype=np.float64)

    @property
    def worst(self) -> float:
        """The infinity at the worst end: what stands for Verdict's sentinel."""
        return -inf if self.better == "high" else inf


ALL = (HEXAHEDRON, WEDGE, PYRAMID, TETRAHEDRON)
HEX = (HEXAHEDRON,)
HEX_TET = (HEXAHEDRON, TETRAHEDRON)
HEX_WEDGE = (HEXAHEDRON, WEDGE)
HEX_WEDGE_TET = (HEXAHEDRON, WEDGE, TETRAHEDRON)

SHORT_EDGE = "Not defined where an edge, squared, is below 2.2e-15 of the squared diagonal of the cell's box."
FLAT_CORNER = "where a corner's determinant is not above 2.2e-15 of the cubed diagonal of the cell's box."
SIZE = (
    "Verdict's size of a hexahedron is the mean determinant of its corners. 0 for a cell without a positive size, and "
    "for all where the mean volume is not positive. VTK 9.6 gives 0 to cells of edges below 1e-5 of the file's unit, "
    "too: not taken over."
)
"""Quirks that several metrics share; each kernel's docstring has its own thresholds."""

_ROWS = (
    Metric("diagonal", "Diagonal", "DIA", (0, 1), (0.65, 1), 1, "high", IDENTITY, 0, HEX,
        "shortest over longest of the four space diagonals",
        "Not defined where all of them vanish."),
    Metric("distortion", "Distortion", "DIS", (-inf, inf), (0.5, 1), 1, "high", BETWEEN_EXTREMES, 0,
        HEX_WEDGE_TET, "smallest determinant of corners and 2 x 2 x 2 Gauss points, over the volume",
        "Both are signed, so that an inverted cell may get 1. Not defined where the volume is 0. The manual leaves the "
        "points open; these are VTK's. Tetrahedra: 1.", variant="with corners"),
    Metric("edge_ratio", "Edge Ratio", "ER", (1, inf), None, 1, "low", DOWN_TO_ONE, 0, HEX_WEDGE_TET,
        "longest over shortest edge",
        "VTK 9.6 looks for a hexahedron's longest edge among 01, 12, 23, 30, 45 and 56 alone, so that its values "
        "are too small, even below 1: not taken over. " + SHORT_EDGE),
    Metric("jacobian", "Jacobian", "J", (-inf, inf), (0, inf), 1, "high", BETWEEN_EXTREMES, 3, ALL,
        "min of u.(v x w) at the eight corners and X.(Y x Z) / 64", variant="with the centre"),
    Metric("max_edge_ratio", "Maximum Edge Ratio", "MER", (1, inf), (1, 1.3), 1, "low", DOWN_TO_ONE, 0, HEX,
        "longest over shortest of X, Y, Z",
        "Not defined where one of them is below 2.2e-15 of the box diagonal.", variant="of principal axes"),
    Metric("max_aspect_frobenius", "Maximum Aspect Frobenius", "MAAF", (1, inf), (1, 3), 1, "low", DOWN_TO_ONE,
        0, HEX_WEDGE, "max over corners of |A| |A^-1| / 3, A = (u, v, w)",
        "Not defined " + FLAT_CORNER + " Wedges: aspects of the corners' tetrahedra over those of the unit wedge, "
        "which VTK 9.6 rounds."),
    Metric("mean_aspect_frobenius", "Mean Aspect Frobenius", "MEAF", (1, inf), (1, 3), 1, "low", DOWN_TO_ONE,
        0, HEX_WEDGE, "mean over corners of |A| |A^-1| / 3, A = (u, v, w)",
        "As for the maximum."),
    Metric("oddy", "Oddy", "ODD", (0, inf), (0, 0.5), 0, "low", DOWN_TO_ZERO, 0, HEX,
        "max over corners and centre of (|A^T A|^2 - |A|^4 / 3) / det(A)^(4/3)",
        "Not defined " + FLAT_CORNER + " VTK 9.6 compares determinants with 2.2e-15 in the file's unit, so that cells "
        "of edges below 1.3e-5 have none: not taken over.", variant="with the centre"),
    Metric("relative_size_squared", "Relative Size Squared", "RSS", (0, 1), (0.5, 1), None, "high", IDENTITY, 0,
        HEX_TET, "min(D, 1/D)^2, D the cell's size over the mean volume of the mesh's cells of its kind", SIZE),
    Metric("scaled_jacobian", "Scaled Jacobian", "SJ", (-1, 1), (0.5, 1), 1, "high", IDENTITY, 0, ALL,
        "min over corners and centre of u.(v x w) / (|u| |v| |w|)",
        SHORT_EDGE + " Rounding may pass 1 by 1e-15.", variant="with the centre"),
    Metric("shape", "Shape", "SHA", (0, 1), (0.3, 1), 1, "high", IDENTITY, 0, ALL,
        "min over corners of 3 det(A)^(2/3) / |A|^2",
        "The manual says “at the element corners” and has the centre in its formula; VTK leaves it out. 0 "
        + FLAT_CORNER, variant="at corners"),
    Metric("shape_and_size", "Shape and Size", "SHAS", (0, 1), (0.2, 1), None, "high", IDENTITY, 0, HEX_TET,
        "shape times relative size squared", SIZE),
    Metric("shear", "Shear", "SHE", (0, 1), (0.3, 1), 1, "high", IDENTITY, 0, HEX,
        "min over corners of u.(v x w) / (|u| |v| |w|), 0 where not positive",
        "The manual says “at the element corners” and has the centre in its formula; VTK leaves it out. 0 also where "
        "an edge is short, as for the Scaled Jacobian, and " + FLAT_CORNER, variant="at corners"),
    Metric("shear_and_size", "Shear and Size", "SHES", (0, 1), (0.2, 1), None, "high", IDENTITY, 0, HEX,
        "shear times relative size squared", SIZE),
    Metric("skew", "Skew", "SKE", (0, inf), (0, 0.5), 0, "low", DOWN_TO_ZERO, 0, HEX,
        "largest |cosine| between X, Y, Z",
        "Not defined where one of them is below 4.4e-15 of the box diagonal.", variant="of principal axes"),
    Metric("stretch", "Stretch", "STR", (0, inf), (0.25, 1), 1, "high", SHARE_OF_HIGHEST, 0, HEX,
        "sqrt(3) shortest edge / longest space diagonal",
        "Not defined where all diagonals vanish."),
    Metric("taper", "Taper", "TAP", (0, inf), (0, 0.5), 0, "low", DOWN_TO_ZERO, 0, HEX,
        "max of |XY| / min(|X|, |Y|) and the same of XZ and YZ, XY the mixed second difference",
        "Not defined where X, Y or Z is below 2.2e-15 of the box diagonal."),
    Metric("volume", "Volume", "VOL", (-inf, inf), (0, inf), 1, "high", BETWEEN_EXTREMES, 3, ALL,
        "signed volume of the trilinear cell",
        "VTK 9.6 integrates, too; the manual's X.(Y x Z) / 64 is another number.", variant="by integration"),
    Metric("dimension", "Dimension", "DIM", (0, inf), None, 1 / sqrt(3), "high", SHARE_OF_HIGHEST, 1, HEX,
        "volume / sqrt(2 sum of squared volume gradients)",
        "Not defined where all of them vanish.", variant="of Pronto"),
    Metric("equiangle_skew", "Equiangle Skew", "EAS", (0, 3), None, 0, "low", DOWN_TO_ZERO, 0, ALL,
        "max over face angles of (angle - 90) / 90 and (90 - angle) / 90, in degrees",
        "The widest angle of a face that is not convex is beyond 180 degrees, so that values pass 1; faces with an "
        "edge below 2.2e-15 of the longest count as -1. Tetrahedra: dihedral angles count too."),
    Metric("nodal_jacobian_ratio", "Nodal Jacobian Ratio", "NJR", (-inf, 1), None, 1, "high", BETWEEN_EXTREMES,
        0, HEX, "smallest over largest u.(v x w) of the eight corners",
        "Not defined where the largest is not above 2.2e-15 of the cubed diagonal of the cell's box.",
        variant="at corners"),
    Metric("sicn", "Inverse Condition Number", "SICN", (-1, 1), None, 1, "high", IDENTITY, 0, ALL,
        "min over corners of 3 det(A) / (|A| |adj A|), A from the ideal cell's edges to the cell's",
        "Gmsh's minSICN. The ideal cells have edges of 1; a pyramid has the corners of its base. 0 where a corner has "
        "no extent.", variant="signed, as in Gmsh"),
    Metric("gauss_jacobian_ratio", "Gauss Jacobian Ratio", "GJR", (-inf, 1), None, 1, "high", BETWEEN_EXTREMES,
        0, HEX, "smallest over largest u.(v x w) of the 2 x 2 x 2 Gauss points",
        "What finite-element programs call the Jacobian ratio of a linear hexahedron that is integrated fully. Not "
        "defined where the largest is not above 2.2e-15 of the cubed diagonal of the cell's box.",
        variant="2 x 2 x 2 points"),
    Metric("warpage", "Warpage", "WAR", (0, 2), (0, 0.7), 0, "low", DOWN_TO_ZERO, 0, (*HEX_WEDGE, PYRAMID),
        "max over quadrilateral faces of 1 - min(n0.n2, n1.n3)^3, n the unit normals at its corners",
        "Verdict's of quadrilaterals; the manual gives the acceptable range, 0.3 to 1, for 1 minus this. A corner "
        "without a normal counts as planar.",
        variant="of faces"),
    Metric("smallest_face_angle", "Smallest Face Angle", "SFA", (0, 90), (45, 90), 90, "high", SHARE_OF_HIGHEST, 0,
        ALL, "smallest angle between two edges of a face, in degrees",
        "The acceptable range is Verdict's of quadrilaterals. Of a face with two corners in one place, the angles of "
        "the triangle count.", variant="degrees"),
    Metric("largest_face_angle", "Largest Face Angle", "LFA", (60, 360), (60, 135), 90, "low", DOWN_TO_ZERO, 0,
        ALL, "largest angle between two edges of a face, in degrees",
        "Beyond 180 where a face is not convex. The acceptable range ends as Verdict's of quadrilaterals.",
        variant="degrees"),
    Metric("characteristic_length", "Characteristic Length", "CL", (-inf, inf), (0, inf), 1, "high",
        BETWEEN_EXTREMES, 1, ALL, "volume over the area of the largest face",
        "As LS-DYNA's of solid elements, which bounds their time step. The area is half the cross product of the "
        "diagonals. Not defined where no face has an area.", variant="volume over largest face"),
)  # fmt: skip

METRICS: dict[str, Metric] = {metric.id: metric for metric in _ROWS}
"""All metrics by id: the eighteen of the paper's table, in its order, Verdict's three others, and six that engineers
ask for beside."""
