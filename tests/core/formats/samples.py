"""Small meshes whose content is known, and comparison with what a reader made of them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from hexalab.cells import CORNERS_OF_KIND, KINDS
from hexalab.mesh import Mesh

HEXAHEDRON, WEDGE, PYRAMID, TETRAHEDRON = range(4)
VTK_TYPES = (12, 13, 14, 10)
MESHIO_NAMES = ("hexahedron", "wedge", "pyramid", "tetra")


HEX_22 = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 1 "all $Nodes"
$EndPhysicalNames
$Nodes
8
101 0 0 0
2 1 0 0
33 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
1000000 0 1 1
$EndNodes
$Elements
3
9 2 2 5 6 101 2 33
4 5 3 8 9 1 101 2 33 4 5 6 7 1000000
70 4 0 101 2 33 5
$EndElements
"""
"""A hexahedron, a tetrahedron and a triangle in `.msh` 2.2, with gaps in the numbers."""

INP_NODES = """*HEADING
 a cube, *NODE is only a word here
** a comment
*Node, NSET=all
  100, 0., 0., 0.
  20,  1., 0., 0.
   3,  1., 1., 0.
4,0,1,0
5 , 0. , 0. , 1.
6,1.,0.,1.
** another comment, 1, 2, 3
7,1.,1.,1.
8000,0.,1.,1.
"""
INP_CELLS = """*ELEMENT, TYPE=C3D8R, ELSET=solid
11, 100, 20, 3, 4, 5, 6, 7,
8000
*SOLID SECTION, ELSET=solid, MATERIAL=steel
1.0,
*NODE PRINT, NSET=all
U,
*ELEMENT OUTPUT
S
"""
"""A hexahedron in `.inp`: its nodes, and its element between other sections."""


@dataclass
class Sample:
    """Points, and cells as (kind, vertex ids in VTK's order)."""

    points: np.ndarray
    cells: list[tuple[int, list[int]]]
    point_data: dict[str, np.ndarray] = field(default_factory=dict)
    cell_data: dict[str, np.ndarray] = field(default_factory=dict)

    def rows_of(self, kind: int) -> np.ndarray:
        """(n, k) ids of the cells of one kind."""
        size = len(CORNERS_OF_KIND[kind])
        return np.array([ids for k, ids in self.cells if k == kind], dtype=int).reshape(-1, size)

    def grouped(self) -> Sample:
        """The same with cells ordered by kind, for formats with a section for each."""
        order = sorted(range(len(self.cells)), key=lambda i: self.cells[i][0])
        data = {name: values[order] for name, values in self.cell_data.items()}
        return Sample(self.points, [self.cells[i] for i in order], self.point_data, data)


def grid(nx: int, ny: int, nz: int, seed: int = 1) -> Sample:
    """A shaken grid of hexahedra."""
    random = np.random.default_rng(seed)
    z, y, x = np.meshgrid(np.arange(nz + 1), np.arange(ny + 1), np.arange(nx + 1), indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1) + random.uniform(-0.1, 0.1, (x.size, 3))
    at = np.arange(x.size).reshape(x.shape)
    cells = []
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                low, high = at[k], at[k + 1]
                ring = [(j, i), (j, i + 1), (j + 1, i + 1), (j + 1, i)]
                cells.append((HEXAHEDRON, [int(low[p]) for p in ring] + [int(high[p]) for p in ring]))
    return Sample(points, cells)


def mixed() -> Sample:
    """A hexahedron with a pyramid on it, a wedge at its side, a tetrahedron at the pyramid,
    interleaved; a loose vertex; attributes of each shape."""
    points = np.array(
        [
            [0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1],
            [0.5, 0.5, 2], [2, 0.5, 0], [2, 0.5, 1], [1.5, 0.5, 2], [9, 9, 9],
        ],
        dtype=float,
    )  # fmt: skip
    cells = [
        (TETRAHEDRON, [5, 6, 8, 11]),
        (HEXAHEDRON, [0, 1, 2, 3, 4, 5, 6, 7]),
        (WEDGE, [1, 2, 9, 5, 6, 10]),
        (PYRAMID, [4, 5, 6, 7, 8]),
        (HEXAHEDRON, [4, 5, 6, 7, 0, 1, 2, 3]),
    ]
    return Sample(
        points,
        cells,
        {"height": points[:, 2].copy(), "shift": np.linspace(-1, 1, 39).reshape(13, 3)},
        {"part": np.array([3, -1, 2, 7, 5], dtype=np.int32), "flow": np.arange(15.0).reshape(5, 3)},
    )


def check(mesh: Mesh, sample: Sample, tolerance: float = 0) -> None:
    """Assert that the mesh is the sample, cell by cell and vertex by vertex."""
    assert mesh.coordinates.dtype == np.float64 and mesh.coordinates.flags.c_contiguous
    assert mesh.corners.dtype == np.int32 and mesh.corners.flags.c_contiguous
    if tolerance:
        np.testing.assert_allclose(mesh.points, sample.points, rtol=tolerance, atol=tolerance)
    else:
        np.testing.assert_array_equal(mesh.points, sample.points)
    assert [KINDS[kind] for kind in mesh.kinds] == [KINDS[kind] for kind, _ in sample.cells]
    found = [
        mesh.corners[list(CORNERS_OF_KIND[kind]), cell].tolist()
        for cell, kind in enumerate(mesh.kinds.tolist())
    ]
    assert found == [list(ids) for _, ids in sample.cells]
    assert all(set(mesh.corners[:, i]) == set(ids) for i, (_, ids) in enumerate(sample.cells))


def check_data(mesh: Mesh, sample: Sample) -> None:
    """Assert that the mesh has the sample's attributes."""
    for found, wanted in ((mesh.point_data, sample.point_data), (mesh.cell_data, sample.cell_data)):
        assert set(found) == set(wanted)
        for name, values in wanted.items():
            assert found[name].shape == values.shape
            np.testing.assert_array_equal(found[name], values)
            assert found[name].dtype.isnative


def signed_volumes(mesh: Mesh) -> np.ndarray:
    """(C,) volume of each cell from its outward faces: the divergence theorem over fans of triangles."""
    from hexalab.cells import FACES

    total = np.zeros(mesh.cell_count)
    for a, b, c, d in FACES:
        p, q, r, s = (mesh.points[mesh.corners[place]] for place in (a, b, c, d))
        for u, v, w in ((p, q, r), (p, r, s)):
            total += np.einsum("ij,ij->i", u, np.cross(v, w)) / 6
    return total
