"""Reading `repository/_gallery/`: sections of the gallery whose pictures lie there; their meshes lie elsewhere."""

from __future__ import annotations

from typing import Any

from hexalab.png_text import PngError, read_settings
from hexalab.status import DEFAULTS, check

from ..model.catalogue import Catalogue, Problem
from ..model.stills import Still, StillSection
from .documents import Document
from .repository import checked

FOLDER = "_gallery"


def read_gallery(catalogue: Catalogue) -> list[StillSection]:
    """The sections, by the names of their files; what is wrong with them goes to the catalogue's ``problems``."""
    files = sorted((catalogue.root / FOLDER).glob("*.yaml"))
    documents = (checked(file, "gallery", catalogue.problems, catalogue.root) for file in files)
    return [_section(catalogue, document) for document in documents if document]


def _section(catalogue: Catalogue, document: Document) -> StillSection:
    rows = document.data["pictures"]
    stills = [still for number, row in enumerate(rows) if (still := _still(catalogue, document, number, row))]
    return StillSection(document.file.stem, document.data["title"], document.data["text"], tuple(stills))


def _still(catalogue: Catalogue, document: Document, number: int, row: dict[str, Any]) -> Still | None:
    def wrong(field: str, message: str) -> None:
        path = ("pictures", number, field)
        file = f"{FOLDER}/{document.file.name}"
        name = f"pictures[{number}].{field}"
        catalogue.problems.append(Problem("error", file, document.line(path), name, message))

    mesh = next((mesh for mesh in catalogue.meshes if mesh.id == row["mesh"]), None)
    if mesh is None:
        wrong("mesh", f"the catalogue has no mesh {row['mesh']}")
        return None
    picture = document.file.parent / row["file"]
    if picture.is_symlink() or not picture.is_file():
        wrong("file", "no such file beside it")
        return None
    try:
        status, rejections = check(read_settings(picture.read_bytes()))
    except PngError as error:
        wrong("file", str(error))
        return None
    for rejection in rejections:
        wrong(
            "file", f"its settings: {rejection.path}: found {rejection.found}, expected {rejection.expected}"
        )
    settings = {name: part for name, part in status.items() if name not in ("mesh", "version")}
    return Still(picture, mesh, differing(settings, DEFAULTS), row["title"], row["sentence"])


def differing(settings: dict[str, Any], defaults: dict[str, Any]) -> dict[str, Any]:
    """What of some settings is not as the defaults have it."""
    out = {}
    for name, value in settings.items():
        usual = defaults[name]
        part = differing(value, usual) if isinstance(usual, dict) else value
        if part != usual and part != {}:
            out[name] = part
    return out
