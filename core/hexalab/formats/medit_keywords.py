"""The words of the Medit format (libMeshb's list): what each section holds."""

from __future__ import annotations

from ..cells import HEXAHEDRON, PYRAMID, TETRAHEDRON, WEDGE
from .assembly import WEDGE_OF_OTHERS

CELLS = {
    "hexahedra": (HEXAHEDRON, 8, 8),
    "hexaedra": (HEXAHEDRON, 8, 8),
    "prisms": (WEDGE, 6, 6),
    "pentahedra": (WEDGE, 6, 6),
    "wedges": (WEDGE, 6, 6),
    "pyramids": (PYRAMID, 5, 5),
    "tetrahedra": (TETRAHEDRON, 4, 4),
    "tetrahedrap2": (TETRAHEDRON, 4, 10),
    "tetrahedrap3": (TETRAHEDRON, 4, 20),
    "tetrahedrap4": (TETRAHEDRON, 4, 35),
    "pyramidsp2": (PYRAMID, 5, 14),
    "pyramidsp3": (PYRAMID, 5, 30),
    "pyramidsp4": (PYRAMID, 5, 55),
    "prismsp2": (WEDGE, 6, 18),
    "prismsp3": (WEDGE, 6, 40),
    "prismsp4": (WEDGE, 6, 75),
    "hexahedraq2": (HEXAHEDRON, 8, 27),
    "hexahedraq3": (HEXAHEDRON, 8, 64),
    "hexahedraq4": (HEXAHEDRON, 8, 125),
}
"""Section in lower case: kind, corners, vertices in a row (without the reference)."""

ORDERS = {WEDGE: WEDGE_OF_OTHERS}
"""Where a kind's own corners stand in a row, if not in VTK's order."""

SURFACE = {"triangles": "triangles", "quadrilaterals": "quadrilaterals", "quads": "quadrilaterals"}
"""Sections of faces: skipped, but told of where nothing else is there."""

_SKIPPED = """
angleofcornerbound boundingbox bypass com comments corners cornersandridges coveragebound
dsolattetrahedra dsolattriangles dsolatvertices edgereferenceelement edges edgesp1ordering edgesp2
edgesp2ordering edgesp3 edgesp3ordering edgesp4 edgesp4ordering equivalentedges extraverticesatedges
extraverticesathexahedra extraverticesatprisms extraverticesatquadrilaterals
extraverticesattetrahedra extraverticesattriangles fault_badshape fault_freeedge fault_inter
fault_multi fault_nonmanifold fault_overlap fault_smalltri fault_toonear floatingpointprecision
functionalid geometry hexahedrareferenceelement hexahedraq2ordering hexahedraq3ordering
hexahedraq4ordering identifier incidentcell interlaces internaledges iterations meshonhost
multivertices normalattrianglevertices normalatquadrilateralvertices normalatvertices normals
periodic prismreferenceelement prismsp2ordering prismsp3ordering prismsp4ordering privatetable
pyramidreferenceelement pyramidsp2ordering pyramidsp3ordering pyramidsp4ordering
quadrilateralreferenceelement quadrilateralsq2 quadrilateralsq2ordering quadrilateralsq3
quadrilateralsq3ordering quadrilateralsq4 quadrilateralsq4ordering referencestrings requirededges
requiredhexahedra requiredprisms requiredpyramids requiredquadrilaterals requiredtetrahedra
requiredtriangles requiredvertices reserved ridges skin smoothsurface solatboundary solatedges
solathexahedra solatpentahedra solatpyramids solatquadrilaterals solattetrahedra solattriangles
solatvertices subdomain subdomainfromgeom subdomainfrommesh tangentatedges tangentatvertices
tangents tetrahedrareferenceelement tetrahedrap2ordering tetrahedrap3ordering tetrahedrap4ordering
time trianglereferenceelement trianglesp1ordering trianglesp2 trianglesp2ordering trianglesp3
trianglesp3ordering trianglesp4 trianglesp4ordering vertexongeometricedge
vertexongeometricquadrilateral vertexongeometrictriangle vertexongeometricvertex vertexonsupportedge
vertexonsupportquadrilateral vertexonsupporttriangle vertexonsupportvertex verticesongeometricedges
verticesongeometrictriangles verticesongeometricvertices
"""

SKIPPED = frozenset(_SKIPPED.split())
"""Every other section, in lower case: known and not used."""
