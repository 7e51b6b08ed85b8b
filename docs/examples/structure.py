"""What a mesh consists of, and whether quality is lost where it is irregular: `python structure.py sphere.mesh`."""

import sys

import numpy as np

import hexalab

mesh = hexalab.read(sys.argv[1])
structure = hexalab.structure(mesh)  # each part is traced when it is first asked for

graph, sheets, blocks = structure.graph, structure.sheets, structure.base_complex.blocks
print(f"{graph.arcs} arcs, {len(graph.nodes)} nodes, {sheets.count} sheets, {blocks.count} blocks")

# Arcs as their vertices, in order
for arc, valence in zip(structure.arcs[:2], graph.valence[:2], strict=True):
    print(f"an arc of valence {valence} from vertex {arc[0]} to {arc[-1]}, {len(arc) - 1} edges")

# Three sheets cross each cell; two of them cross each other in every cell that both hold
a, b, c = structure.sheet_of_cells[:, 0]
both = (structure.sheet_of_cells == a).any(axis=0) & (structure.sheet_of_cells == b).any(axis=0)
print(f"the first cell is in sheets {a}, {b} and {c}; the first two cross in {both.sum()} cells")
print(f"sheets that never come to the boundary: {np.flatnonzero(sheets.closed).tolist()}")

# Quality by block, and by the number of faces on the way to the nearest irregular edge
quality = hexalab.quality(mesh, "scaled_jacobian")
of_blocks = [quality[structure.block_of_cells == block].mean() for block in range(blocks.count)]
print("mean Scaled Jacobian of each block:", *np.round(of_blocks, 3))
distance = structure.irregular_distance_of_cells
for faces in range(distance.max() + 1):
    print(f"{faces} faces away: {quality[distance == faces].mean():.3f}")
