"""The programs: each takes a path and gives a `Reading`, or raises with what it has to say."""

from __future__ import annotations

import gzip
import io
import tempfile
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

import gmsh
import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from hexalab import formats
from hexalab.arrays import Array
from hexalab.cells import CORNERS_OF_KIND, KINDS

from .facts import Reading

OTHER_WEDGE = [0, 2, 1, 3, 5, 4]
"""VTK's wedge from that of Medit, Gmsh and Abaqus."""

CORNERS = {"hexahedron": 8, "wedge": 6, "pyramid": 5, "tetrahedron": 4}
VTK_KINDS = {
    10: "tetrahedron", 12: "hexahedron", 13: "wedge", 14: "pyramid", 24: "tetrahedron", 25: "hexahedron",
    26: "wedge", 27: "pyramid", 29: "hexahedron", 31: "wedge", 32: "wedge", 33: "hexahedron", 37: "pyramid",
    71: "tetrahedron", 72: "hexahedron", 73: "wedge", 74: "pyramid", 78: "tetrahedron", 79: "hexahedron",
    80: "wedge", 81: "pyramid",
}  # fmt: skip
MESHIO_NAMES = {"medit:ref": "reference", "gmsh:physical": "physical", "gmsh:geometrical": "entity"}
"""Names of ours for what meshio calls otherwise."""

VTK_TURNED = (31, 32, 73, 80)
"""Wedges of VTK 9.6 that are numbered the other way round than its types 13 and 26."""

VOXEL_ORDER = [0, 1, 3, 2, 4, 5, 7, 6]


class NotRead(Exception):
    """The program does not read such a file; its own words follow."""


def by_hexalab(path: Path) -> Reading:
    """Our own reading."""
    mesh = formats.read(path)  # as it stands in the file: not turned round
    cells = mesh.cells
    kinds = {name: cells[mesh.kinds == kind][:, CORNERS_OF_KIND[kind]] for kind, name in enumerate(KINDS)}
    return Reading(mesh.points, kinds, dict(mesh.cell_data), dict(mesh.point_data))


def by_vtk(path: Path) -> Reading:
    """VTK's readers of `.vtk`, `.vtu` and AVS UCD `.inp`."""
    readers = {
        ".vtk": vtk.vtkUnstructuredGridReader,
        ".vtu": vtk.vtkXMLUnstructuredGridReader,
        ".inp": vtk.vtkAVSucdReader,
        ".ucd": vtk.vtkAVSucdReader,
    }
    if path.suffix.lower() not in readers:
        raise NotRead("no reader")
    reader = readers[path.suffix.lower()]()
    complaints = _complaints(reader)
    reader.SetFileName(str(path))
    for call in ("ReadAllScalarsOn", "ReadAllVectorsOn", "ReadAllFieldsOn"):
        getattr(reader, call, lambda: None)()
    reader.Update()
    grid = reader.GetOutput()
    if complaints or not grid or not grid.GetNumberOfPoints():
        raise NotRead(complaints[0] if complaints else "nothing in it")
    points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    if not grid.GetNumberOfCells():
        return Reading(points, {})
    types = vtk_to_numpy(grid.GetCellTypesArray())
    array = grid.GetCells()
    offsets, ids = vtk_to_numpy(array.GetOffsetsArray()), vtk_to_numpy(array.GetConnectivityArray())
    corners: dict[str, list[Array]] = {kind: [] for kind in CORNERS}
    for number in np.unique(types).tolist():
        begin = offsets[:-1][types == number]
        kind = "hexahedron" if number == 11 else VTK_KINDS.get(number)
        if kind is None:
            continue
        rows = ids[begin[:, None] + np.arange(CORNERS[kind])]
        if number == 11:
            rows = rows[:, VOXEL_ORDER]
        corners[kind].append(rows[:, OTHER_WEDGE] if number in VTK_TURNED else rows)
    kept = np.isin(types, [*VTK_KINDS, 11])
    cell_arrays, point_arrays = (
        {
            data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())
            if data.GetArray(i)
        }
        for data in (grid.GetCellData(), grid.GetPointData())
    )
    return Reading(
        points,
        {kind: np.concatenate(rows) for kind, rows in corners.items() if rows},
        {name: rows[kept] for name, rows in cell_arrays.items()},
        point_arrays,
    )


def _complaints(reader: vtk.vtkAlgorithm) -> list[str]:
    """What VTK reports while it reads, as it comes."""
    said: list[str] = []

    def hear(_object: object, _event: str) -> None:
        said.append("VTK reports an error")

    reader.AddObserver("ErrorEvent", hear)
    return said


def by_meshio(path: Path) -> Reading:
    """The readers of meshio, as it chooses them by the name's ending."""
    said = io.StringIO()
    try:
        with redirect_stdout(said), redirect_stderr(said):
            mesh = meshio.read(path)
    except SystemExit:
        raise NotRead(said.getvalue().strip()[:200]) from None
    of_vtk = path.suffix.lower() in (".vtk", ".vtu")
    corners: dict[str, list[Array]] = {kind: [] for kind in CORNERS}
    kept = []
    for place, block in enumerate(mesh.cells):
        kind = _meshio_kind(block.type)
        if kind is None:
            continue
        rows = np.asarray(block.data)[:, : CORNERS[kind]]
        turned = kind == "wedge" and (
            block.type != "wedge15" or not of_vtk
        )  # of VTK it turns linear wedges itself, and type 26 is as they are
        corners[kind].append(rows[:, OTHER_WEDGE] if turned else rows)
        kept.append(place)
    points = np.asarray(mesh.points, dtype=float)
    if points.shape[1] < 3:
        points = np.pad(points, ((0, 0), (0, 3 - points.shape[1])))
    return Reading(
        points,
        {kind: np.concatenate(rows) for kind, rows in corners.items() if rows},
        {
            MESHIO_NAMES.get(name, name): np.concatenate([np.asarray(rows[place]) for place in kept])
            for name, rows in mesh.cell_data.items()
            if kept
        },
        {
            MESHIO_NAMES.get(name, name): np.asarray(rows)
            for name, rows in mesh.point_data.items()
            if name != "gmsh:dim_tags"
        },
    )


def _meshio_kind(name: str) -> str | None:
    if "lagrange" in name.lower():
        return None
    letters = name.rstrip("0123456789").lower()
    return {"tetra": "tetrahedron"}.get(letters, letters if letters in CORNERS else None)


def by_gmsh(path: Path) -> Reading:
    """Gmsh's readers; it wants an ending that it knows."""
    if path.suffix.lower() not in (".msh", ".mesh", ".meshb", ".vtk"):
        raise NotRead("no reader")
    gmsh.initialize([], False, False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("General.AbortOnError", 2)
        gmsh.merge(str(path))
        return _from_gmsh(raw_wedges=path.suffix.lower() == ".vtk")
    finally:
        gmsh.finalize()


def _from_gmsh(raw_wedges: bool) -> Reading:
    """What is open there; VTK's wedges it takes as they come, though its own are the other way round."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    if not len(tags):
        raise NotRead("no nodes")
    order = np.argsort(tags)
    corners: dict[str, list[Array]] = {kind: [] for kind in CORNERS}
    for number, _, nodes in zip(*gmsh.model.mesh.getElements(3), strict=True):
        name, _, _, size, _, _ = gmsh.model.mesh.getElementProperties(number)
        kind = {"Prism": "wedge"}.get(name.split()[0], name.split()[0].lower())
        if kind not in CORNERS:
            continue
        rows = order[np.searchsorted(tags[order], nodes)].reshape(-1, size)[:, : CORNERS[kind]]
        corners[kind].append(rows[:, OTHER_WEDGE] if kind == "wedge" and not raw_wedges else rows)
    return Reading(
        coordinates.reshape(-1, 3), {kind: np.concatenate(rows) for kind, rows in corners.items() if rows}
    )


PROGRAMS: dict[str, Callable[[Path], Reading]] = {
    "hexalab": by_hexalab,
    "VTK": by_vtk,
    "meshio": by_meshio,
    "gmsh": by_gmsh,
}


def read(program: str, path: Path) -> Reading:
    """Read a file, unpacked first where it is gzipped and the program is not ours."""
    if path.suffix.lower() != ".gz" or program == "hexalab":
        return PROGRAMS[program](path)
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder) / path.stem
        plain.write_bytes(gzip.decompress(path.read_bytes()))
        return PROGRAMS[program](plain)
