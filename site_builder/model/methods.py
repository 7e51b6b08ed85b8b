"""Families of methods that make hexahedral meshes: by one of them a source says how its meshes came about."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Method:
    """A family of methods.

    Parameters
    ----------
    name : str
        As it stands in tables and lists.
    sentence : str
        What its methods do.
    """

    name: str
    sentence: str


METHODS = {
    "polycube": Method(
        "polycube",
        "The body is mapped onto one of axis-aligned boxes, a grid is put there and mapped back.",
    ),
    "field-aligned": Method(
        "field-aligned",
        "A field of frames says how cells are to lie, and a map that follows it is cut along whole numbers.",
    ),
    "octree": Method(
        "octree or grid",
        "A grid, finer where it has to be, fills the body and is fitted to its surface.",
    ),
    "sweeping": Method(
        "sweeping",
        "Quadrilaterals of one side are swept through the body, or through its parts, to the other side.",
    ),
    "blocks": Method(
        "block decomposition",
        "The body is cut into simple blocks, along loops on its surface or around its skeleton, and each is filled.",
    ),
    "dual-sheets": Method(
        "dual sheets",
        "The sheets of the mesh, its layers of cells, are laid through the body one by one.",
    ),
    "hex-dominant": Method(
        "hex-dominant",
        "Most cells are hexahedra; where none fits, there are prisms, pyramids, tetrahedra or collapsed cells.",
    ),
    "interactive": Method(
        "interactive",
        "A person puts boxes together, and the program keeps the mesh sound.",
    ),
    "simplification": Method(
        "simplification",
        "A mesh is taken as it is, and its structure is made simpler by collapsing sheets and chords.",
    ),
    "untangling": Method(
        "untangling",
        "A mesh is taken as it is, and its vertices are moved until its cells are valid and well shaped.",
    ),
}
"""Each by its id, as `method` of source.yaml names it."""
