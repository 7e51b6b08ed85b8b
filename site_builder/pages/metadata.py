"""What machines read in a page: schema.org JSON-LD, Highwire tags, OpenGraph."""

from __future__ import annotations

from typing import Any

from hexalab.formats import FORMATS
from hexalab.quality import METRICS

from ..model.catalogue import Author, Catalogue, MeshEntry, Source
from .words import plural, structure_line, verdict

LICENCES = {
    "CC0-1.0": "https://creativecommons.org/publicdomain/zero/1.0/",
    "CC-BY-4.0": "https://creativecommons.org/licenses/by/4.0/",
    "CC-BY-SA-4.0": "https://creativecommons.org/licenses/by-sa/4.0/",
    "CC-BY-NC-4.0": "https://creativecommons.org/licenses/by-nc/4.0/",
    "CC-BY-NC-SA-4.0": "https://creativecommons.org/licenses/by-nc-sa/4.0/",
    "CC-BY-3.0": "https://creativecommons.org/licenses/by/3.0/",
    "PDDL-1.0": "https://opendatacommons.org/licenses/pddl/1-0/",
    "ODC-By-1.0": "https://opendatacommons.org/licenses/by/1-0/",
    "MIT": "https://spdx.org/licenses/MIT.html",
    "BSD-3-Clause": "https://spdx.org/licenses/BSD-3-Clause.html",
    "Apache-2.0": "https://spdx.org/licenses/Apache-2.0.html",
}
"""Address of each licence's text."""

AUTHORS_NOTE = (
    "The data belong to the authors of the paper; for any use but looking at them, ask the authors."
)

FORMAT_NAMES = {ending: row.name for row in reversed(FORMATS) for ending in row.extensions}

TECHNIQUE = (
    "Metrics of the Verdict library; edges by the cells around them; sheets and base complex traced by vertex "
    "numbers alone; validity certified by Bézier bounds"
)

JsonLd = dict[str, Any]


def format_name(mesh: MeshEntry) -> str:
    """The file's format in words: "Medit ASCII, gzipped"."""
    packed = mesh.format.endswith(".gz")
    return FORMAT_NAMES.get(mesh.format.removesuffix(".gz"), mesh.format) + (", gzipped" if packed else "")


def catalogue_json_ld(catalogue: Catalogue) -> JsonLd:
    """The catalogue as a schema.org DataCatalog."""
    return {
        "@context": "https://schema.org/",
        **_catalogue_reference(catalogue),
        "description": catalogue.description or catalogue.title,
        "publisher": {"@type": "Organization", "name": catalogue.publisher or catalogue.title},
        "dataset": [
            {"@type": "Dataset", "name": source.title, "description": describe_source(source),
             "url": catalogue.address + source.page, "creator": _creators(source)}
            for source in catalogue.sources
        ],
    }  # fmt: skip


def source_json_ld(catalogue: Catalogue, source: Source) -> JsonLd:
    """A source as a schema.org Dataset.

    A paper's DOI and page are what to cite; they name the data themselves only where the data are what is published.
    """
    page = catalogue.address + source.page
    is_data = source.reference["type"] == "dataset"
    return {
        **_dataset(catalogue, source),
        "name": source.title,
        "description": describe_source(source),
        "url": page,
        "identifier": (source.doi_address if is_data else "") or page,
        "variableMeasured": ["Scaled Jacobian", "number of cells", "valence of interior edges"],
        "distribution": [_download(catalogue, mesh) for mesh in source.meshes],
        **({"sameAs": source.web} if source.web and is_data else {}),
    }


def mesh_json_ld(catalogue: Catalogue, mesh: MeshEntry) -> JsonLd:
    """A mesh as a schema.org Dataset, with what was measured."""
    data = {
        **_dataset(catalogue, mesh.source),
        "name": f"{mesh.name}, of: {mesh.source.title}",
        "description": describe_mesh(mesh),
        "url": catalogue.address + mesh.page,
        "identifier": catalogue.address + mesh.page,
        "distribution": [_download(catalogue, mesh)],
        "isPartOf": {"@type": "Dataset", "name": mesh.source.title, "description": describe_source(mesh.source),
                     "url": catalogue.address + mesh.source.page},
    }  # fmt: skip
    measured = _measured(mesh)
    if measured:
        data["variableMeasured"] = measured
    return data


def describe_source(source: Source) -> str:
    """A description of a source, long enough for catalogues that ask for fifty characters."""
    if source.description:
        return source.description
    meshes = plural(len(source.meshes), "hexahedral mesh", "hexahedral meshes")
    return f"{meshes} of the paper “{source.title}” by {_joined(source.authors)} ({source.year})."


def describe_mesh(mesh: MeshEntry) -> str:
    """A description of a mesh from what is known of it."""
    parts = [mesh.description] if mesh.description else []
    if mesh.cells:
        parts.append(f"A mesh of {plural(mesh.cells, 'cell')}.")
    who = f"{_joined(mesh.source.authors)} ({mesh.source.year})"
    parts.append(f"{mesh.name}, one of the meshes of “{mesh.source.title}” by {who}.")
    parts += [text for text in (structure_line(mesh.facts), verdict(mesh.facts)[1]) if text]
    return " ".join(part if part.endswith(".") else part + "." for part in parts)


def highwire(source: Source) -> list[tuple[str, str]]:
    """The ``citation_*`` tags that Scholar and Zotero read."""
    item = source.reference
    tags = [("citation_title", source.title)]
    tags += [("citation_author", _inverted(author)) for author in item["author"]]
    parts = item["issued"]["date-parts"][0]
    tags.append(("citation_publication_date", "/".join(f"{part:02d}" for part in parts)))
    for name, key in (
        ("citation_volume", "volume"),
        ("citation_issue", "issue"),
        ("citation_publisher", "publisher"),
    ):
        tags.append((name, str(item.get(key, ""))))
    container = (
        "citation_conference_title" if item["type"] == "paper-conference" else "citation_journal_title"
    )
    tags.append((container, str(item.get("container-title", ""))))
    first, _, last = str(item.get("page", "")).partition("-")
    tags += [("citation_firstpage", first), ("citation_lastpage", last)]
    tags += [
        ("citation_doi", source.doi),
        ("citation_arxiv_id", source.arxiv),
        ("citation_pdf_url", source.pdf),
    ]
    return [(name, content) for name, content in tags if content]


def _dataset(catalogue: Catalogue, source: Source) -> JsonLd:
    rights = (
        {"conditionsOfAccess": AUTHORS_NOTE}
        if source.belongs_to_authors
        else {"license": LICENCES[source.licence]}
    )
    citation = source.doi_address or source.reference.get("URL") or ""
    return {
        "@context": "https://schema.org/",
        "@type": "Dataset",
        "creator": _creators(source),
        "datePublished": "-".join(f"{part:02d}" for part in source.reference["issued"]["date-parts"][0]),
        "keywords": ["hexahedral mesh", "volumetric mesh", "mesh quality", "finite elements"],
        "isAccessibleForFree": True,
        "measurementTechnique": TECHNIQUE,
        "includedInDataCatalog": _catalogue_reference(catalogue),
        **rights,
        **({"citation": citation} if citation and not citation.startswith(catalogue.address) else {}),
    }


def _catalogue_reference(catalogue: Catalogue) -> JsonLd:
    return {"@type": "DataCatalog", "name": catalogue.title, "url": catalogue.address}


def _creators(source: Source) -> list[JsonLd]:
    return [_creator(author) for author in source.reference["author"]]


def _creator(author: Author) -> JsonLd:
    if "literal" in author:
        return {"@type": "Organization", "name": author["literal"]}
    person = {"@type": "Person", "name": f"{author.get('given', '')} {author['family']}".strip()}
    person["familyName"] = author["family"]
    if author.get("given"):
        person["givenName"] = author["given"]
    if author.get("ORCID"):
        person["sameAs"] = f"https://orcid.org/{author['ORCID']}"
    return person


def _download(catalogue: Catalogue, mesh: MeshEntry) -> JsonLd:
    download = {
        "@type": "DataDownload",
        "name": mesh.name,
        "contentUrl": mesh.remote or catalogue.address + mesh.file_address,
        "encodingFormat": format_name(mesh),
    }
    if mesh.facts.bytes is not None:
        download["contentSize"] = f"{mesh.facts.bytes} B"
    if mesh.sha256:
        download["sha256"] = mesh.sha256
    return download


def _measured(mesh: MeshEntry) -> list[JsonLd | str]:
    """The figures by which meshes are searched for; metrics whose statistics `index.json` has, by name alone."""
    facts = mesh.facts
    values: list[tuple[str, Any]] = [
        ("number of cells", mesh.cells),
        ("number of vertices", facts.vertices),
        ("number of irregular interior edges", facts.irregular_edges),
        ("number of arcs and loops of irregular interior edges", facts.arcs),
        ("number of sheets", facts.sheets),
        ("number of blocks of the base complex", facts.blocks),
        ("number of invalid cells", facts.invalid_cells),
    ]
    measured: list[JsonLd | str] = [
        _property(name, value=value) for name, value in values if value is not None
    ]
    if facts.sj_min is not None:
        measured.append(
            _property("Scaled Jacobian", minValue=facts.sj_min, maxValue=facts.sj_max, value=facts.sj_mean)
        )
    others = (metric for metric in facts.quality or () if metric != "scaled_jacobian")
    return [*measured, *(METRICS[metric].name for metric in others)]


def _property(name: str, **values: Any) -> JsonLd:
    return {"@type": "PropertyValue", "name": name, **values}


def _inverted(author: Author) -> str:
    return author.get("literal") or ", ".join(
        part for part in (author["family"], author.get("given", "")) if part
    )


def _joined(names: list[str]) -> str:
    if len(names) > 3:
        return f"{names[0]} and others"
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]
