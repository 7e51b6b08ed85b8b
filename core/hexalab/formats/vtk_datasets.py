"""VTK's kinds of data that are no unstructured grid: what to call them, and what to do."""

from __future__ import annotations

from .tokens import quoted

MAKE_GRID = "make it one in ParaView (filter Append Datasets) and save it as .vtu"
OPEN_PARTS = "open the .vtu files that it names, or join them in ParaView (filter Merge Blocks)"
AS_REFERENCE = "as a surface it can be opened as a reference to measure a mesh against"

OTHERS = {
    "polydata": ("surface polygons", AS_REFERENCE),
    "ppolydata": ("an index of the parts of a surface", ""),
    "structured_points": ("an image", MAKE_GRID),
    "imagedata": ("an image", MAKE_GRID),
    "structured_grid": ("a structured grid", MAKE_GRID),
    "structuredgrid": ("a structured grid", MAKE_GRID),
    "rectilinear_grid": ("a rectilinear grid", MAKE_GRID),
    "rectilineargrid": ("a rectilinear grid", MAKE_GRID),
    "hypertreegrid": (
        "a tree of refined boxes",
        "make it a grid in ParaView (filter HyperTreeGrid To Unstructured Grid)",
    ),
    "field": ("a table", ""),
    "table": ("a table", ""),
    "graph": ("a graph", ""),
    "directed_graph": ("a graph", ""),
    "undirected_graph": ("a graph", ""),
    "tree": ("a tree", ""),
    "punstructuredgrid": ("an index of the parts of a mesh", OPEN_PARTS),
    "vtkmultiblockdataset": ("an index of several meshes", OPEN_PARTS),
    "vtkpartitioneddataset": ("an index of several meshes", OPEN_PARTS),
    "vtkpartitioneddatasetcollection": ("an index of several meshes", OPEN_PARTS),
    "collection": ("an index of several meshes", OPEN_PARTS),
}
"""Names in legacy files and in XML files, in lower case: what it is, and what to do about it."""


def refusal(found: str, wanted: str) -> str:
    """The sentence for a file that holds data of a name other than the wanted one."""
    what, remedy = OTHERS.get(found.lower(), ("", ""))
    if not what and found.lower().startswith("p"):
        what, remedy = OTHERS.get(found.lower()[1:], ("", ""))
    of_kind = f" ({what})" if what else ""
    expected = f"expected {wanted}, a mesh of volumetric cells"
    return f"the file holds {quoted(found)}{of_kind}, {expected}" + (f"; {remedy}" if remedy else "")
