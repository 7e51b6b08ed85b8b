"""The structure of a whole mesh: irregular graph, sheets, chords, base complex (SPEC T)."""

from .cell_data import CELL_DATA, with_structure
from .facts import facts_of
from .structure import Structure, structure
from .tables import TABLES, csv_of

__all__ = ["CELL_DATA", "TABLES", "Structure", "csv_of", "facts_of", "structure", "with_structure"]
