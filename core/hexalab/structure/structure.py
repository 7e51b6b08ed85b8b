"""The structure of a whole mesh, part by part, each at its first use."""

from __future__ import annotations

from functools import cached_property

from ..arrays import Ids
from ..mesh import Mesh
from .base_classes import base_chords, base_sheets
from .base_complex import BaseComplex, Skeleton, interior_complex, skeleton, whole_complex
from .chords import Chords, find_chords
from .distance import irregular_distance
from .frame import Frame
from .graph import Graph, interior_graph, whole_graph
from .sheets import Sheets, find_sheets


class Structure:
    """Irregular graph, sheets, chords and base complex of a mesh, by vertex numbers alone.

    It is traced through hexahedra that have eight vertices. At other cells, and at faces of more than two
    cells, it ends as at the boundary; `frame.skipped` says so.

    Parameters
    ----------
    mesh : Mesh

    Examples
    --------
    >>> structure = hexalab.structure(hexalab.read("bunny.mesh"))                    # doctest: +SKIP
    >>> structure.sheets.count, structure.base_complex.count                  # doctest: +SKIP
    (95, 1063)
    """

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh

    @cached_property
    def frame(self) -> Frame:
        """The cells it is traced in, with their faces and edges."""
        return Frame.of(self.mesh)

    @cached_property
    def graph(self) -> Graph:
        """The graph of the interior irregular edges."""
        return interior_graph(self.frame)

    @cached_property
    def whole_graph(self) -> Graph:
        """The graph of all irregular edges, those of the boundary among them."""
        return whole_graph(self.frame)

    @cached_property
    def sheets(self) -> Sheets:
        """All sheets."""
        return find_sheets(self.frame)

    @cached_property
    def chords(self) -> Chords:
        """All chords."""
        return find_chords(self.frame)

    @cached_property
    def base_complex(self) -> BaseComplex:
        """The base complex that all irregular edges enforce."""
        return whole_complex(self.frame)

    @cached_property
    def interior_base_complex(self) -> BaseComplex:
        """The base complex that the interior irregular edges alone enforce; its blocks need not be boxes."""
        return interior_complex(self.frame)

    @cached_property
    def skeleton(self) -> Skeleton:
        """Vertices, edges and faces of the base complex."""
        return skeleton(self.frame, self.base_complex.complex_faces)

    @cached_property
    def interior_skeleton(self) -> Skeleton:
        """Vertices, edges and faces of the interior base complex."""
        return skeleton(self.frame, self.interior_base_complex.complex_faces)

    @cached_property
    def base_sheets(self) -> tuple[Ids, int]:
        """(S,) int32: the base sheet of each sheet; how many there are."""
        return base_sheets(self.frame, self.base_complex.complex_faces, self.sheets)

    @cached_property
    def base_chords(self) -> tuple[Ids, int]:
        """(K,) int32: the base chord of each chord; how many there are."""
        return base_chords(self.frame, self.base_complex.complex_faces, self.chords)

    @property
    def sheet_of_cells(self) -> Ids:
        """(3, C) int32: the sheet that crosses each cell in each of its three directions; -1 in cells left out."""
        return self.frame.in_mesh(self.sheets.of_cells, self.mesh.cell_count)

    @property
    def chord_of_cells(self) -> Ids:
        """(3, C) int32: the chord that passes each cell in each of its three directions; -1 in cells left out."""
        return self.frame.in_mesh(self.chords.of_cells, self.mesh.cell_count)

    @property
    def block_of_cells(self) -> Ids:
        """(C,) int32: the block of each cell; -1 for cells left out."""
        return self.frame.in_mesh(self.base_complex.of_cells, self.mesh.cell_count)

    @cached_property
    def irregular_distance(self) -> Ids:
        """(N,) int32: faces on the way from each cell of the frame to the nearest one at an interior irregular edge."""
        return irregular_distance(self.frame)

    @property
    def irregular_distance_of_cells(self) -> Ids:
        """(C,) int32: the same for the mesh's cells; -1 where there is no way, and in cells left out."""
        return self.frame.in_mesh(self.irregular_distance, self.mesh.cell_count)

    @property
    def arcs(self) -> list[Ids]:
        """The vertices of each arc of `graph` in order."""
        return self.graph.chains[: self.graph.arcs]

    @property
    def loops(self) -> list[Ids]:
        """The vertices of each loop of `graph` in order, the first one again at the end."""
        return self.graph.chains[self.graph.arcs :]


def structure(mesh: Mesh) -> Structure:
    """Trace the structure of a mesh; each part is found when it is first asked for.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    Structure
        With the arrays `sheet_of_cells`, `chord_of_cells`, `block_of_cells`, and the lists `arcs` and `loops`.
    """
    return Structure(mesh)
