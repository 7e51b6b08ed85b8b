"""What each small file of `cases/` gives, on the command line and in the page: the table that both tests read.

The values are VTK's, meshio's, gmsh's or CalculiX's, or follow from the format's manual; the tests of each format say
which. All cells are unit cubes, halves or sixths of one, but for the few that say otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

CASES = Path(__file__).parent / "cases"

CUBE = 1.0
UNIT = (1.0, 1.0)


@dataclass(frozen=True)
class Row:
    """What one file gives."""

    kinds: dict[str, int]
    """Cells by their kind; none if the file is refused."""

    volume: float = CUBE
    """Sum over the cells, signs and all."""

    scaled_jacobian: tuple[float, float] = UNIT
    """Least and greatest."""

    notes: tuple[str, ...] = ()
    """Words of each thing that is told about the reading, and no more than these."""

    attributes: tuple[tuple[str, float, float], ...] = ()
    """Name, least and greatest value of attributes that it must hold."""

    groups: tuple[str, ...] = ()
    """Names of its named groups of cells and vertices."""

    refused: str = ""
    """Words of the refusal."""

    refused_in_page: str = ""
    """Words of the page's refusal, where only the page refuses."""


ONE = {"hexahedron": 1}
TWO = {"hexahedron": 2}
TETRAHEDRON = {"tetrahedron": 1}
SIXTH = 1 / 6
CORNER = (2**-0.5, 2**-0.5)
"""Scaled Jacobian of the tetrahedron at a cube's corner, at its three equal corners: a right angle between an edge and
the diagonal of a face, over edges of 1, sqrt 2 and sqrt 2, times the sqrt 2 that makes the regular one 1."""

ROWS = {
    "abaqus-elset.inp": Row(TWO, 2.0, groups=("STEEL", "RUBBER")),
    "abaqus-empty-fields.inp": Row(ONE),
    "abaqus-include-only.inp": Row({}, refused="it includes mesh.inp"),
    "abaqus-node-redefined.inp": Row(
        ONE,
        1.75,  # integral of 1 + xy + yz + zx: a corner of the unit cube moved by (1, 1, 1)
        (0.2721655, 0.2721655),
        notes=("1 node has more than one place: the last definition counts",),
    ),
    "abaqus-nodes-in-instances.inp": Row(TWO, 2.0),
    "abaqus-short-node-rows-silent.inp": Row(ONE),
    "abaqus-short-node-rows.inp": Row(ONE),
    "abaqus-surplus-nodes.inp": Row(ONE, notes=("1 element has more nodes than the 8 of type C3D8",)),
    "all-inverted.mesh": Row(TETRAHEDRON, SIXTH, CORNER, notes=("Every cell was inverted",)),
    "avs-ucd.inp": Row(ONE, attributes=(("material", 1, 1),)),
    "calculix-f3d8.inp": Row(ONE, groups=("EALL", "NALL")),
    "gmsh-1.msh": Row(ONE),
    "gmsh-4.0.msh": Row(ONE),
    "gmsh-element-node-data.msh": Row(ONE, notes=("‘stress’ ($ElementNodeData)",)),
    "gmsh-one-node-too-many.msh": Row(ONE, notes=("$Nodes holds more than it announces",)),
    "gmsh-partitioned.msh": Row(TWO, 2.0, groups=("rock",)),
    "gmsh-physical-names.msh": Row(ONE, groups=("rock",)),
    "medit-int-max.mesh": Row(ONE, attributes=(("reference", 2147483647, 2147483647),)),
    "medit-real-references.mesh": Row(ONE, notes=("written as numbers with a decimal point",)),
    "mfem.mesh": Row(ONE, attributes=(("attribute", 1, 1),)),
    "ovm-ascii.ovm": Row(TETRAHEDRON, SIXTH, CORNER, notes=("(1 of 1), against the format's convention",)),
    "ovm-inward-one-inverted.ovm": Row({"hexahedron": 3}, 1.0, (-1.0, 1.0)),
    "ovm-no-ascii.ovm": Row(
        TETRAHEDRON,
        SIXTH,
        CORNER,
        notes=("it is read as ASCII", "(1 of 1), against the format's convention"),
    ),
    "polyhedron-lattice-cube.vtu": Row(ONE),
    "vtk-int1.vtk": Row(ONE, notes=("‘int1’ is taken as int",)),
    "vtk-nan-ind.vtk": Row(ONE, notes=("‘-nan(ind)’",)),
    "vtk-polyvertex-of-8.vtk": Row({}, refused="no volumetric cells"),
    "vtk-quadratic-quad.vtk": Row({}, refused="no volumetric cells"),
    "vtk-triangle-strip-of-8.vtk": Row({}, refused="no volumetric cells"),
    "vtk-type12-of-20.vtk": Row(ONE, notes=("Their first 8 are taken as the corners",)),
    "vtu-lagrange-wedge.vtu": Row({"hexahedron": 1, "wedge": 1}, 1.5, (0.8164966, 1.0)),
    "vtu-lz4.vtu": Row({}, refused="vtkLZ4DataCompressor"),
    "vtu-lzma.vtu": Row(ONE, refused_in_page="vtkLZMADataCompressor"),
}
