"""The kinds of cells, and their corners, faces and edges.

Every cell has eight corners, numbered as in VTK_HEXAHEDRON: 0-3 around one face, 4-7 above them. A cell of fewer
corners repeats some of them, so that its missing faces and edges vanish by themselves::

    hexahedron   0 1 2 3 4 5 6 7
    wedge        0 2 1 1 3 5 4 4
    pyramid      0 1 2 3 4 4 4 4
    tetrahedron  0 1 2 2 3 3 3 3

A kind's own corners are numbered as VTK and Verdict do. For a wedge of positive volume this means that the normal of
0 1 2 points away from 3 4 5 (Verdict's `wedge_volume` and vtkCellSizeFilter agree; Medit, Gmsh and Abaqus number a
wedge the other way round), so its collapse takes 0 2 1 for the lower face.
"""

KINDS = ("hexahedron", "wedge", "pyramid", "tetrahedron")
"""Names of the cell kinds; a cell's entry in `Mesh.kinds` is an index into it."""

HEXAHEDRON, WEDGE, PYRAMID, TETRAHEDRON = range(4)

COLLAPSE = (
    (0, 1, 2, 3, 4, 5, 6, 7),
    (0, 2, 1, 1, 3, 5, 4, 4),
    (0, 1, 2, 3, 4, 4, 4, 4),
    (0, 1, 2, 2, 3, 3, 3, 3),
)
"""For each kind, which of its own corners stands at each of the eight places."""

CORNERS_OF_KIND = ((0, 1, 2, 3, 4, 5, 6, 7), (0, 2, 1, 4, 6, 5), (0, 1, 2, 3, 4), (0, 1, 2, 4))
"""For each kind, the places among the eight where its own corners stand, in its own (VTK's) order."""

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
"""The six faces of a cell by corner places, counter-clockwise seen from outside."""

EDGES = (
    (0, 1), (1, 2), (2, 3), (3, 0),
    (4, 5), (5, 6), (6, 7), (7, 4),
    (0, 4), (1, 5), (2, 6), (3, 7),
)  # fmt: skip
"""The twelve edges of a cell by corner places."""
