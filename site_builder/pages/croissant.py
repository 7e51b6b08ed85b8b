"""The table of meshes as machines find and load it: Croissant, and schema.org's form of the same."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

from ..model.catalogue import Catalogue, Issued
from ..tables.columns import COLUMNS, Column
from ..tables.files import CSV, PARQUET
from .metadata import LICENCES, JsonLd

CONFORMS_TO = "http://mlcommons.org/croissant/1.1"
"""Of the format's specification, MLCommons."""

TABLE_VERSION = "1.0.0"
"""Of the columns: its first number is raised when one changes its meaning or goes."""

LICENCE = LICENCES["CC0-1.0"]
"""Of the table: facts that were measured here."""

RIGHTS = (
    "The numbers are measurements of this catalogue, free for every use (CC0). The meshes that they speak of belong "
    "to their authors: the column licence says what may be done with each."
)

FORMATS = {CSV: "text/csv", PARQUET: "application/vnd.apache.parquet"}

TYPES = {
    "text": "sc:Text",
    "address": "sc:URL",
    "whole": "sc:Integer",
    "number": "sc:Float",
    "truth": "sc:Boolean",
}
"""Types of the format by the kind of a column."""

RECORDS = "meshes"

TERMS = (
    "annotation", "arrayShape", "citeAs", "column", "containedIn", "equivalentProperty", "excludes", "extract",
    "field", "fileProperty", "fileObject", "fileSet", "format", "includes", "isArray", "isLiveDataset", "jsonPath",
    "key", "md5", "parentField", "path", "recordSet", "references", "regex", "repeated", "replace", "readLines",
    "samplingRate", "sdVersion", "separator", "source", "subField", "transform", "unArchive", "value",
)  # fmt: skip
"""Words of the format that stand for themselves."""

CONTEXT: JsonLd = {
    "@language": "en",
    "@vocab": "https://schema.org/",
    "sc": "https://schema.org/",
    "cr": "http://mlcommons.org/croissant/",
    "rai": "http://mlcommons.org/croissant/RAI/",
    "dct": "http://purl.org/dc/terms/",
    "conformsTo": "dct:conformsTo",
    **{term: f"cr:{term}" for term in TERMS},
    "data": {"@id": "cr:data", "@type": "@json"},
    "examples": {"@id": "cr:examples", "@type": "@json"},
    "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "name": {"@container": "@language"},
    "description": {"@container": "@language"},
}
"""As the specification's first appendix has it."""


def croissant(catalogue: Catalogue, files: Mapping[str, bytes]) -> JsonLd:
    """The table with all its columns.

    Parameters
    ----------
    catalogue : Catalogue
    files : mapping of str to bytes
        The table's files by their addresses below the site's root.
    """
    return {
        "@context": CONTEXT,
        "@type": "sc:Dataset",
        "conformsTo": CONFORMS_TO,
        **_dataset(catalogue),
        "citeAs": _bibtex(catalogue),
        "distribution": [
            {"@type": "cr:FileObject", "@id": _name(address), **_file(catalogue, address, data)}
            for address, data in files.items()
        ],
        "recordSet": [
            {
                "@type": "cr:RecordSet",
                "@id": RECORDS,
                "name": RECORDS,
                "description": "A record for each mesh of the catalogue, measured or not.",
                "key": {"@id": f"{RECORDS}/id"},
                "field": [_field(column) for column in COLUMNS],
            }
        ],
    }


def table_json_ld(catalogue: Catalogue, files: Mapping[str, bytes]) -> JsonLd:
    """The table as a schema.org Dataset."""
    return {
        "@context": "https://schema.org/",
        "@type": "Dataset",
        **_dataset(catalogue),
        "identifier": _page(catalogue),
        "includedInDataCatalog": {"@type": "DataCatalog", "name": catalogue.title, "url": catalogue.address},
        "distribution": [
            {"@type": "DataDownload", **_file(catalogue, address, data)} for address, data in files.items()
        ],
    }


def _dataset(catalogue: Catalogue) -> JsonLd:
    maker = {
        "@type": "Organization",
        "name": catalogue.publisher or catalogue.title,
        "url": catalogue.address,
    }
    return {
        "name": f"{catalogue.title}: the numbers of its meshes",
        "description": (
            "Hexahedral meshes as they were published, a row each: where they come from, size, quality by every "
            f"metric, validity, irregular edges, sheets, blocks, and what is wrong with them. {RIGHTS}"
        ),
        "url": _page(catalogue),
        "license": LICENCE,
        "creator": maker,
        "publisher": maker,
        "datePublished": max(
            (_issued(source.reference["issued"]) for source in catalogue.sources), default=""
        ),
        "version": TABLE_VERSION,
        "inLanguage": "en",
        "isAccessibleForFree": True,
        "keywords": ["hexahedral mesh", "mesh quality", "scaled Jacobian", "base complex", "finite elements"],
        "citation": [source.doi_address for source in catalogue.sources if source.doi],
    }


def _issued(issued: Issued) -> str:
    """A date in ISO 8601; the year's first day stands for the year."""
    year, month, day = (*issued["date-parts"][0], 1, 1)[:3]
    return f"{year:04d}-{month:02d}-{day:02d}"


def _page(catalogue: Catalogue) -> str:
    return f"{catalogue.address}numbers/"


def _name(address: str) -> str:
    return address.rsplit("/", 1)[-1]


def _file(catalogue: Catalogue, address: str, data: bytes) -> JsonLd:
    return {
        "name": _name(address),
        "contentUrl": catalogue.address + address,
        "contentSize": f"{len(data)} B",
        "encodingFormat": FORMATS[address],
        "sha256": hashlib.sha256(data).hexdigest(),
    }


def _field(column: Column) -> JsonLd:
    unit = f" Unit: {column.unit}." if column.unit else ""
    return {
        "@type": "cr:Field",
        "@id": f"{RECORDS}/{column.name}",
        "name": column.name,
        "description": column.meaning + unit,
        "dataType": TYPES[column.kind],
        "source": {"fileObject": {"@id": _name(CSV)}, "extract": {"column": column.name}},
    }


def _bibtex(catalogue: Catalogue) -> str:
    who, year = catalogue.publisher or catalogue.title, max((s.year for s in catalogue.sources), default="")
    return (
        f"@misc{{hexalab-numbers, title = {{{catalogue.title}: the numbers of its meshes}}, "
        f"author = {{{{{who}}}}}, year = {{{year}}}, url = {{{_page(catalogue)}}}}}"
    )
