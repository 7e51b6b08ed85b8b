"""What the scripts that make HexaLab's own meshes share: flat patterns, solids, sweeps and a writer.

A flat pattern is a pair (points (n, 2), quads (m, 4)), quads counter-clockwise; a solid is a pair (points (n, 3),
cells (m, 8)), corners as in VTK_HEXAHEDRON. All is deterministic: the same numbers on every machine, up to the six
digits that are written.
"""
