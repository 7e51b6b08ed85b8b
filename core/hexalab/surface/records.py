"""What leaves the core to be drawn: flat arrays in the number types of the graphics card."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats32 = NDArray[np.float32]
Int16s = NDArray[np.int16]
Bytes = NDArray[np.uint8]
UInt32s = NDArray[np.uint32]


@dataclass(frozen=True)
class Surface:
    """The surface of the shown cells, closed, its normals outward.

    Positions are drawing coordinates: the mesh's frame is centred on the origin and its diagonal is 1.

    Attributes
    ----------
    mode : str
        A name of `MODES`.
    positions : (3 N,) float32
    normals : (4 N,) int16
        Unit vectors times 32767, the fourth number 0.
    cells : (N,) uint32
        Cell of each vertex.
    inside : (N,) uint8
        0 on the mesh's boundary, 255 on what filters expose. Where a cell is rounded from the one into the
        other, the edge between them counts as boundary.
    quads : (4 Q,) uint32 or None
        Vertices of each quad, to be drawn as triangles 0 1 2 and 0 2 3; None if they stand four by four. A
        triangle repeats its last vertex.
    faces : (Q,) uint32
        Cell times 8 plus the face's place in `hexalab.cells.FACES`, for each quad.
    edges : (6 E,) float32
        End points of the lines to draw, each edge once; only in the modes that draw lines.
    edge_cells : (E,) uint8
        Number of shown cells around each edge, at most 255; only with darkness-coded edges.
    edge_faces : (2 E,) uint32
        Places in `faces` of two that meet at each edge, the same twice where there is but one.
    two_sided : bool
        Whether each quad is there twice, to be seen from both of its sides.
    """

    mode: str
    positions: Floats32
    normals: Int16s
    cells: UInt32s
    inside: Bytes
    quads: UInt32s | None
    faces: UInt32s
    edges: Floats32
    edge_cells: Bytes
    edge_faces: UInt32s
    two_sided: bool = False

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))


@dataclass(frozen=True)
class Silhouette:
    """Boundary faces of the hidden cells: quads four by four, laid out as in `Surface`."""

    positions: Floats32
    normals: Int16s

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))


NO_SILHOUETTE = Silhouette(np.empty(0, np.float32), np.empty(0, np.int16))
"""Of nothing."""


@dataclass(frozen=True)
class Irregular:
    """The irregular structure: interior edges with other than four cells, boundary edges with other than two.

    Everything is in drawing coordinates; in each list what belongs to interior edges stands first.

    Attributes
    ----------
    edges : (6 E,) float32
        End points.
    valence : (E,) uint8
        Number of cells around, at most 255.
    boundary : (E,) uint8
        1 if the edge lies on the mesh's boundary.
    ends_on_boundary : (E,) uint8
        1 where the edge's first vertex lies on the mesh's boundary, plus 2 where the second does.
    barbs : (6 B,) float32
        From an end of an irregular edge (the root) to 45 % of the way along a neighbouring edge of a face
        around it.
    barb_valence, barb_boundary : (B,) uint8
        Of the edge that it belongs to.
    paper : (12 P,) float32
        Flaps, one for each face around each irregular edge: the edge's two ends, then 45 % of the way along
        the neighbouring edges.
    paper_valence, paper_boundary : (P,) uint8
        Of the edge that it belongs to.
    counts : dict
        Number of irregular edges by valence, `{"interior": {"3": n, ...}, "boundary": {...}}`.
    """

    edges: Floats32
    valence: Bytes
    boundary: Bytes
    ends_on_boundary: Bytes
    barbs: Floats32
    barb_valence: Bytes
    barb_boundary: Bytes
    paper: Floats32
    paper_valence: Bytes
    paper_boundary: Bytes
    counts: dict[str, dict[str, int]] = field(default_factory=dict)

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))


@dataclass(frozen=True)
class Marks:
    """What is drawn over the surface: faces, edges and points, each with a colour of the palette of marks.

    Attributes
    ----------
    faces : (12 F,) float32
        Corners, four by four; a triangle repeats its last one.
    edges : (6 E,) float32
        End points.
    points : (3 P,) float32
    face_colours, edge_colours, point_colours : (F,), (E,), (P,) uint8
    counts : dict of str to int
        How many there are of what was asked for: "corners", "edges", "faces" (features), "sharp", "nodes",
        "interfaces".
    """

    faces: Floats32
    face_colours: Bytes
    edges: Floats32
    edge_colours: Bytes
    points: Floats32
    point_colours: Bytes
    counts: dict[str, int] = field(default_factory=dict)

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))


@dataclass(frozen=True)
class Curves:
    """Curves and points of the structure, each with a row of the viewer's styles.

    Attributes
    ----------
    edges : (6 E,) float32
        End points.
    points : (3 P,) float32
    edge_rows, point_rows : (E,), (P,) uint8
        Of edges: arcs by valence (0 for two and fewer, to 4 for six and more), 5 the base complex, from 6 on
        chords. Of points: 0 the nodes of arcs, 1 vertices of the base complex.
    edge_faint, point_faint : (E,), (P,) uint8
        1 where something else was chosen.
    """

    edges: Floats32
    edge_rows: Bytes
    edge_faint: Bytes
    points: Floats32
    point_rows: Bytes
    point_faint: Bytes

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))


@dataclass(frozen=True)
class Arrows:
    """Vectors of an attribute on some faces of the shown cells' surface, spread evenly over it.

    Attributes
    ----------
    positions : (3 N,) float32
        Middles of the faces in drawing coordinates.
    vectors : (3 N,) float32
        The vectors over the length of the attribute's longest, wherever in the mesh that is.
    inward : (N,) uint8
        1 where the vector points into the face's own cell: drawn from the middle on it would be hidden.
    cells : (N,) uint32
        Cell that each face belongs to.
    longest : float or None
        Length of the longest finite vector in the file's unit; None if none is finite, or the length passes what
        a number holds.
    not_finite, zero : int
        Faces of the whole surface without an arrow, as their vector is not finite, or nothing beside the longest.
    """

    positions: Floats32
    vectors: Floats32
    inward: Bytes
    cells: UInt32s
    longest: float | None
    not_finite: int
    zero: int

    def arrays(self) -> dict[str, Any]:
        """All fields by name, not copied."""
        return dict(vars(self))
