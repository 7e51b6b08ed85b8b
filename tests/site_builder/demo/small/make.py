"""Five cubes in a row."""

import gzip


def row():
    corners = [(x, y, z) for x in range(6) for z in (0, 1) for y in (0, 1)]
    cells = [
        [4 * x + k + 1 for k in (0, 4, 5, 1, 2, 6, 7, 3)]
        for x in range(5)
    ]  # fmt: skip
    lines = ["MeshVersionFormatted 2", "Dimension 3", f"Vertices {len(corners)}"]
    lines += [f"{x} {y} {z} 0" for x, y, z in corners]
    lines += [f"Hexahedra {len(cells)}"] + [" ".join(map(str, cell)) + " 0" for cell in cells] + ["End", ""]
    return gzip.compress("\n".join(lines).encode(), mtime=0)


FILES = {"row.mesh.gz": row}
