"""The table of meshes as files: CSV for everybody, Parquet with types, units and meanings in it."""

from __future__ import annotations

import csv
import hashlib
import io
from collections.abc import Iterable, Sequence
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from ..kept import remember
from ..model.catalogue import MeshEntry
from .columns import COLUMNS
from .values import Row, Value

CSV, PARQUET = "numbers/meshes.csv", "numbers/meshes.parquet"
"""Addresses below the site's root."""

NOT_INSTALLED = "the table of meshes is left out as Parquet: pyarrow is not installed"

HERE = Path(__file__).parent

TRUTHS = {True: "true", False: "false"}

Table = list[list[Value]]
"""A row for each mesh, in the order of `COLUMNS`."""


def installed() -> bool:
    """Whether the library that writes Parquet is here."""
    return find_spec("pyarrow") is not None


def table_of(meshes: Iterable[MeshEntry], root: str, pictures: set[str]) -> Table:
    """The table of some meshes.

    Parameters
    ----------
    meshes : iterable of MeshEntry
    root : str
        Address of the site, ending in a slash.
    pictures : set of str
        Addresses of the pictures that the site has.
    """
    rows = (Row(mesh, root, mesh.picture_address in pictures) for mesh in meshes)
    return [[column.value(row) for column in COLUMNS] for row in rows]


def files_of(table: Table, cache: Path) -> dict[str, bytes]:
    """The table's files, by their addresses: Parquet is kept by the hash of what it is made of."""
    text = as_csv(table)
    if not installed():
        return {CSV: text}
    made_by = [version("pyarrow").encode(), *(file.read_bytes() for file in sorted(HERE.glob("*.py")))]
    kept = cache / "tables" / f"{hashlib.sha256(b''.join([text, *made_by])).hexdigest()[:32]}.parquet"
    return {CSV: text, PARQUET: remember(kept, lambda: as_parquet(table)).read_bytes()}


def as_csv(table: Table) -> bytes:
    """The table with a header, UTF-8, empty where nothing is known; numbers in full."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([column.name for column in COLUMNS])
    writer.writerows([TRUTHS[cell] if isinstance(cell, bool) else cell for cell in row] for row in table)
    return text.getvalue().encode()


def as_parquet(table: Table) -> bytes:
    """The table as Parquet; unit and meaning of each column are in its metadata. The same bytes for the same table."""
    import pyarrow as arrow
    from pyarrow import parquet

    types = {
        "text": arrow.string(),
        "address": arrow.string(),
        "whole": arrow.int64(),
        "number": arrow.float64(),
        "truth": arrow.bool_(),
    }
    fields = [
        arrow.field(
            column.name, types[column.kind], metadata={"unit": column.unit, "meaning": column.meaning}
        )
        for column in COLUMNS
    ]
    columns = [arrow.array(_column(table, at), field.type) for at, field in enumerate(fields)]
    stream = io.BytesIO()
    whole = arrow.Table.from_arrays(columns, schema=arrow.schema(fields))
    parquet.write_table(whole, stream, compression="zstd")
    return stream.getvalue()


def _column(table: Table, at: int) -> Sequence[Value]:
    return [row[at] for row in table]
