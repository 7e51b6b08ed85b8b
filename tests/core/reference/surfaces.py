"""Small surfaces whose content is known, files of them, and comparison with what a reader made of these."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hexalab.reference import TriangleSurface
from tests.tools import tool

vtk = tool("vtk")
meshio = tool("meshio")
numpy_support = tool("vtk.util.numpy_support")

Table = NDArray[Any]

CUBE = np.array([[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)])
CUBE_QUADS = np.array(
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]], dtype=np.int64
)
"""The unit cube's six faces, seen counter-clockwise from outside."""


def ball(rounds: int = 2, seed: int = 3) -> tuple[Table, Table]:
    """(V, 3) points and (T, 3) triangles of a shaken ball: an octahedron, each triangle of which is cut in four."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    table = [np.array(point, dtype=float) for point in points]
    for _ in range(rounds):
        between: dict[frozenset[int], int] = {}
        finer = []
        for a, b, c in triangles:
            for edge in (frozenset((a, b)), frozenset((b, c)), frozenset((c, a))):
                if edge not in between:
                    between[edge] = len(table)
                    table.append(sum(table[end] for end in edge) / 2)  # type: ignore[arg-type]
            ab, bc, ca = between[frozenset((a, b))], between[frozenset((b, c))], between[frozenset((c, a))]
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    places = np.array(table)
    places /= np.linalg.norm(places, axis=1)[:, None]
    places += np.random.default_rng(seed).uniform(-0.05, 0.05, places.shape)
    return np.float32(places).astype(float), np.array(triangles)


def poly_data(points: Table, *rows: Any, strips: Any = (), lines: Any = ()) -> Any:
    """VTK's polygons: rows of vertex ids of any lengths."""
    data = vtk.vtkPolyData()
    places = vtk.vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_support.numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(places)
    for some, put in ((rows, data.SetPolys), (strips, data.SetStrips), (lines, data.SetLines)):
        cells = vtk.vtkCellArray()
        for row in some:
            cells.InsertNextCell(len(row), [int(one) for one in row])
        if len(some):
            put(cells)
    return data


def written(writer: Any, data: Any, **calls: Any) -> bytes:
    """The bytes that one of VTK's writers makes; calls are its methods with their arguments."""
    writer.SetInputData(data)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "surface"
        writer.SetFileName(str(path))
        for name, argument in calls.items():
            getattr(writer, name)(*(() if argument is None else (argument,)))
        assert writer.Write()
        return next(Path(folder).iterdir()).read_bytes()  # some add an ending to the name


def by_meshio(
    points: Table, blocks: list[tuple[str, Table]], file_format: str, ending: str = "", **options: Any
) -> bytes:
    """The bytes that meshio writes; the ending tells some formats in text from binary."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"surface{ending}"
        meshio.write(path, meshio.Mesh(points, blocks), file_format=file_format, **options)
        return path.read_bytes()


def found_by_vtk(reader: Any, data: bytes) -> Table:
    """(n, 3, 3) the triangles that one of VTK's readers finds in the bytes of a file."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "surface"
        path.write_bytes(data)
        reader.SetFileName(str(path))
        return cut_by_vtk(reader.GetOutputPort())


def cut_by_vtk(port: Any) -> Table:
    """(n, 3, 3) the triangles that vtkTriangleFilter makes."""
    cut = vtk.vtkTriangleFilter()
    cut.SetInputConnection(port)
    cut.PassVertsOff()
    cut.PassLinesOff()
    cut.Update()
    out = cut.GetOutput()
    places = numpy_support.vtk_to_numpy(out.GetPoints().GetData()).astype(float)
    ids = numpy_support.vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return places[ids]


def corners(surface: TriangleSurface) -> Table:
    """(n, 3, 3) the triangles' corners."""
    return np.moveaxis(surface.points[:, surface.triangles], 0, 2).swapaxes(0, 1)


def in_one_form(triangles: Any) -> list[tuple[tuple[float, ...], ...]]:
    """The triangles in one order, each beginning with its smallest corner: a matter of how they go round, not where."""
    out = []
    for row in np.asarray(triangles).tolist():
        a, b, c = map(tuple, row)
        out.append(min((a, b, c), (b, c, a), (c, a, b)))
    return sorted(out)


def assert_same(surface: TriangleSurface, triangles: Any) -> None:
    """Whether a surface has just those triangles, (n, 3, 3) corners, with the same side outside."""
    assert in_one_form(corners(surface)) == in_one_form(triangles)
    assert surface.triangles.dtype == np.int32 and surface.points.dtype == np.float64
