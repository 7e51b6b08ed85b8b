"""The structure of a whole mesh: irregular graph, sheets, chords, base complex (SPEC T)."""

from ..mesh import Mesh
from .cell_data import CELL_DATA, with_structure
from .facts import facts_of
from .structure import Structure
from .tables import TABLES, csv_of

__all__ = ["CELL_DATA", "TABLES", "Structure", "csv_of", "facts_of", "structure", "with_structure"]


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
