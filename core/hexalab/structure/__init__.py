"""The structure of a whole mesh: irregular graph, sheets, chords, base complex (SPEC T)."""

from .cell_data import CELL_DATA, with_structure
from .facts import facts_of
from .structure import Structure, structure
from .tables import TABLES, table_rows

__all__ = ["CELL_DATA", "TABLES", "Structure", "facts_of", "structure", "table_rows", "with_structure"]
