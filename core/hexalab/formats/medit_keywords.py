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

FEATURES = {
    "edges": (1, 2),
    "triangles": (2, 3),
    "quadrilaterals": (2, 4),
    "quads": (2, 4),
}
"""Sections of elements of lower dimension: dimension, vertices in a row (without the reference)."""

MARKS = {
    "corners": 0,
    "requiredvertices": 0,
    "ridges": 1,
    "requirededges": 1,
}
"""Sections that name some of the vertices, or of the edges: dimension of what they name."""

CURVED = {
    "edgesp2": "edges", "edgesp3": "edges", "edgesp4": "edges",
    "trianglesp2": "triangles", "trianglesp3": "triangles", "trianglesp4": "triangles",
    "quadrilateralsq2": "quadrilaterals", "quadrilateralsq3": "quadrilaterals", "quadrilateralsq4": "quadrilaterals",
}  # fmt: skip
"""Sections of the same that are curved: counted, and left out."""

_SKIPPED = """
angleofcornerbound boundingbox bypass com comments cornersandridges coveragebound dsolattetrahedra
dsolattriangles dsolatvertices edgereferenceelement edgesp1ordering edgesp2ordering edgesp3ordering
edgesp4ordering equivalentedges extraverticesatedges extraverticesathexahedra extraverticesatprisms
extraverticesatquadrilaterals extraverticesattetrahedra extraverticesattriangles fault_badshape
fault_freeedge fault_inter fault_multi fault_nonmanifold fault_overlap fault_smalltri fault_toonear
floatingpointprecision functionalid geometry hexahedrareferenceelement hexahedraq2ordering
hexahedraq3ordering hexahedraq4ordering identifier incidentcell interlaces internaledges iterations
meshonhost multivertices normalattrianglevertices normalatquadrilateralvertices normalatvertices normals
periodic prismreferenceelement prismsp2ordering prismsp3ordering prismsp4ordering privatetable
pyramidreferenceelement pyramidsp2ordering pyramidsp3ordering pyramidsp4ordering
quadrilateralreferenceelement quadrilateralsq2ordering quadrilateralsq3ordering quadrilateralsq4ordering
referencestrings requiredhexahedra requiredprisms requiredpyramids requiredquadrilaterals requiredtetrahedra
requiredtriangles reserved skin smoothsurface solatboundary solatedges solathexahedra solatpentahedra
solatpyramids solatquadrilaterals solattetrahedra solattriangles solatvertices subdomain subdomainfromgeom
subdomainfrommesh tangentatedges tangentatvertices tangents tetrahedrareferenceelement tetrahedrap2ordering
tetrahedrap3ordering tetrahedrap4ordering time trianglereferenceelement trianglesp1ordering
trianglesp2ordering trianglesp3ordering trianglesp4ordering vertexongeometricedge
vertexongeometricquadrilateral vertexongeometrictriangle vertexongeometricvertex vertexonsupportedge
vertexonsupportquadrilateral vertexonsupporttriangle vertexonsupportvertex verticesongeometricedges
verticesongeometrictriangles verticesongeometricvertices
"""

SKIPPED = frozenset(_SKIPPED.split())
"""Every other section, in lower case: known and not used."""
