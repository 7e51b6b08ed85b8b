"""The columns of the table of meshes: one table of names, units and meanings for files, page and metadata."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from hexalab.quality import METRICS, Metric
from hexalab.summary import STATISTICS

from . import values
from .families import method_of, model_of
from .values import Row, Value


@dataclass(frozen=True)
class Column:
    """A column of the table.

    Parameters
    ----------
    name : str
    kind : "text", "address", "whole", "number" or "truth"
    unit : str
        "" for what has none; "length" is the unit of the mesh's file.
    meaning : str
    value : callable
        Gives what stands in a row.
    """

    name: str
    kind: str
    unit: str
    meaning: str
    value: Callable[[Row], Value]


PLAIN = (
    Column("id", "text", "", "The mesh in this catalogue: source/mesh.", lambda row: row.mesh.id),
    Column("source", "text", "", "The source: a paper, or a collection.", values.of_source("slug")),
    Column("name", "text", "", "What the source calls the mesh.", lambda row: row.mesh.name),
    Column("title", "text", "", "Title of the source.", values.of_source("title")),
    Column("authors", "text", "",
        "Authors of the source, with semicolons between.", lambda row: "; ".join(row.mesh.source.authors)),
    Column("year", "whole", "year", "When the source was published.", values.of_source("year")),
    Column("doi", "text", "", "DOI of the source.", values.of_source("doi")),
    Column("own", "truth", "",
        "Whether the mesh is of this catalogue's making, and in no paper.", lambda row: row.mesh.source.own),
    Column("method", "text", "",
        "Family of the method that made it.", lambda row: method_of(row.mesh) or None),
    Column("model", "text", "",
        "The model that it shows: meshes of one model by several methods have the same.",
        lambda row: model_of(row.mesh) or None),
    Column("same_as", "text", "",
        "Id of another row that is this mesh in another file format: leave such rows out when you count.",
        values.same_as),
    Column("licence", "text", "",
        "SPDX id of the mesh's licence; authors: it belongs to them, for any use but looking at it ask them.",
        values.of_source("licence")),
    Column("page", "address", "", "The mesh's page in this catalogue.", lambda row: row.root + row.mesh.page),
    Column("picture", "address", "",
        "A picture of it.", lambda row: row.root + row.mesh.picture_address if row.pictured else None),
    Column("address", "address", "", "Its file.", values.address),
    Column("sha256", "text", "", "SHA-256 of the file, in hexadecimal.", lambda row: row.mesh.sha256),
    Column("bytes", "whole", "bytes", "Size of the file.", values.fact("bytes")),
    Column("format", "text", "", "Ending of the file's name.", lambda row: row.mesh.format),
    Column("measured", "truth", "",
        "Whether this catalogue has measured it; where not, what follows is empty.",
        lambda row: row.mesh.facts.quality is not None),
    Column("cells", "whole", "",
        "Number of cells; where nobody has measured, as the source says.", lambda row: row.mesh.cells),
    Column("hexahedra", "whole", "", "Hexahedra among them.", values.kind("hexahedron")),
    Column("wedges", "whole", "", "Wedges among them.", values.kind("wedge")),
    Column("pyramids", "whole", "", "Pyramids among them.", values.kind("pyramid")),
    Column("tetrahedra", "whole", "", "Tetrahedra among them.", values.kind("tetrahedron")),
    Column("cells_repeating_a_vertex", "whole", "",
        "Hexahedra with one vertex at several corners.", values.fact("cells_repeating_a_vertex")),
    Column("vertices", "whole", "", "Number of vertices.", values.fact("vertices")),
    Column("unreferenced_vertices", "whole", "",
        "Vertices that no cell uses.", values.fact("unreferenced_vertices")),
    Column("faces", "whole", "", "Number of faces.", values.fact("faces")),
    Column("boundary_faces", "whole", "", "Faces of one cell alone.", values.fact("boundary_faces")),
    Column("nonmanifold_faces", "whole", "",
        "Faces of more than two cells.", values.fact("nonmanifold_faces")),
    Column("edges", "whole", "", "Number of edges.", values.fact("edges")),
    Column("interior_edges", "whole", "",
        "Edges that are not on the boundary.", values.fact("interior_edges")),
    Column("components", "whole", "", "Parts that hang together by faces.", values.fact("components")),
    Column("depth", "whole", "faces",
        "Largest number of faces to cross from a cell to the boundary.", values.depth),
    Column("extent_x", "number", "length", "Extent along x.", values.extent(0)),
    Column("extent_y", "number", "length", "Extent along y.", values.extent(1)),
    Column("extent_z", "number", "length", "Extent along z.", values.extent(2)),
    Column("irregular_edges", "whole", "",
        "Interior edges with other than four cells around them.", values.fact("irregular_edges")),
    Column("irregular_edge_share", "number", "",
        "Their part of the interior edges, 0 to 1.", values.irregular_edge_share),
    Column("irregular_vertex_share", "number", "",
        "Part of the interior vertices that is irregular, 0 to 1.", values.traced("irregular_vertex_share")),
    Column("arcs", "whole", "", "Chains of irregular interior edges: arcs and loops.", values.fact("arcs")),
    Column("nodes", "whole", "", "Vertices in which arcs end.", values.traced("irregular", "nodes")),
    Column("sheets", "whole", "",
        "Layers of cells: all that is reached by going to the opposite edge in a face.",
        values.fact("sheets")),
    Column("self_intersecting_sheets", "whole", "",
        "Sheets that cross a cell more than once.", values.fact("self_intersecting_sheets")),
    Column("chords", "whole", "",
        "Columns of cells: all that is reached by going to the opposite face in a cell.", values.traced("chords",
        "count")),
    Column("blocks", "whole", "",
        "Blocks of the base complex, whose walls begin at every irregular edge.", values.fact("blocks")),
    Column("interior_blocks", "whole", "",
        "Blocks where walls begin at irregular edges inside alone.", values.traced("interior_base_complex",
        "blocks")),
    Column("class", "text", "",
        "regular or polycube, where no interior edge is irregular.", values.traced("class")),
    Column("cells_valid", "whole", "",
        "Cells whose Jacobian is certified positive throughout.", values.validity("valid")),
    Column("cells_invalid", "whole", "",
        "Cells whose Jacobian is certified not to be.", values.validity("invalid")),
    Column("cells_undecided", "whole", "",
        "Cells of which neither could be certified.", values.validity("undecided")),
    Column("cells_sj_not_positive", "whole", "",
        "Cells whose Scaled Jacobian is 0 or less.", values.fact("sj_not_positive")),
    Column("cells_sj_not_finite", "whole", "",
        "Cells that have no Scaled Jacobian.", values.fact("sj_not_finite")),
    Column("findings", "text", "",
        "What the diagnosis found, by its ids, with spaces between.", values.findings),
)  # fmt: skip
"""What is no statistic of a metric."""

LENGTHS = {0: "", 1: "length", 3: "length³"}
"""Unit of a metric by the power of a length that it is."""

SQUARES = {"": "", "length": "length²", "length³": "length⁶", "degrees": "degrees²"}
"""Unit of a metric's variance by the metric's unit."""

MEANINGS = {
    "min": "smallest value",
    "max": "largest value",
    "mean": "mean over the cells",
    "median": "median",
    "variance": "variance, of the population",
    "not_finite": "cells without a finite value",
    "outside_acceptable": "cells outside the acceptable range",
}
"""What each statistic is; the columns of a metric end in these names."""

COUNTED = ("not_finite", "outside_acceptable")
"""Statistics that are numbers of cells."""


def unit_of(metric: Metric) -> str:
    """The unit of a metric's values."""
    return "degrees" if metric.variant == "degrees" else LENGTHS[metric.length_power]


def _statistic(metric: Metric, statistic: str) -> Column:
    def value(row: Row) -> Value:
        found: dict[str, Any] = {**(row.mesh.facts.quality or {}).get(metric.id, {})}
        result: Value = found.get(statistic)
        return result

    counted, unit = statistic in COUNTED, unit_of(metric)
    return Column(
        f"{metric.id}_{statistic}",
        "whole" if counted else "number",
        "" if counted else SQUARES[unit] if statistic == "variance" else unit,
        f"{metric.name}: {MEANINGS[statistic]}.",
        value,
    )


COLUMNS = PLAIN + tuple(_statistic(metric, name) for metric in METRICS.values() for name in STATISTICS)
"""All columns, in their order."""
