"""Writing meshes as text: six digits, so that every machine writes the same bytes."""

import gzip

import numpy as np


def medit(points, hexahedra, **others):
    """A Medit .mesh file; `others` are arrays of corners by keyword, as Tetrahedra=(n, 4)."""
    parts = ["MeshVersionFormatted 2\n\nDimension 3\n\n", f"Vertices\n{len(points)}\n"]
    parts += _rows(_numbers(points), "%.6g %.6g %.6g 0\n")
    for keyword, corners in {"Hexahedra": hexahedra, **others}.items():
        corners = np.asarray(corners, dtype=int) + 1
        if len(corners):
            parts.append(f"\n{keyword}\n{len(corners)}\n")
            parts += _rows(corners, "%d " * corners.shape[1] + "0\n")
    parts.append("\nEnd\n")
    return "".join(parts).encode()


def vtk(points, cells, title, cell_data=None, point_data=None):
    """A VTK legacy 3.0 ASCII file of hexahedra, with scalars by name."""
    parts = [f"# vtk DataFile Version 3.0\n{title}\nASCII\nDATASET UNSTRUCTURED_GRID\n"]
    parts.append(f"POINTS {len(points)} double\n")
    parts += _rows(_numbers(points), "%.6g %.6g %.6g\n")
    parts.append(f"CELLS {len(cells)} {9 * len(cells)}\n")
    parts += _rows(cells, "8 " + "%d " * 7 + "%d\n")
    parts.append(f"CELL_TYPES {len(cells)}\n" + "12\n" * len(cells))
    for section, count, data in (("CELL", len(cells), cell_data), ("POINT", len(points), point_data)):
        if data:
            parts.append(f"{section}_DATA {count}\n")
        for name, values in (data or {}).items():
            parts.append(f"SCALARS {name} double 1\nLOOKUP_TABLE default\n")
            parts += _rows(_numbers(values)[:, None], "%.6g\n")
    return "".join(parts).encode()


def packed(data):
    """The bytes gzipped, without a time stamp."""
    return gzip.compress(data, 6, mtime=0)


def _numbers(values):
    return np.round(np.asarray(values, dtype=float), 6) + 0.0


def _rows(table, row, chunk=20_000):
    """Format a table row by row, many rows at a time."""
    for start in range(0, len(table), chunk):
        part = table[start : start + chunk]
        yield (row * len(part)) % tuple(part.ravel().tolist())
