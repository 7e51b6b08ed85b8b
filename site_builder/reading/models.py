"""Reading `repository/models.yaml`: which bodies several sources mesh; each mesh learns whose it is."""

from __future__ import annotations

from ..model.catalogue import Catalogue, Problem
from ..model.models import Model, joined, model_of
from ..model.problems import problem_of
from .documents import Document
from .repository import checked

MODELS_FILE = "models.yaml"


def read_models(catalogue: Catalogue) -> None:
    """Put the models into the catalogue, and the id of its model into each mesh; what is wrong goes to ``problems``.

    A mesh's model is what its row says, else what its file's name says.
    """
    file = catalogue.root / MODELS_FILE
    document = checked(file, "models", catalogue.problems, catalogue.root) if file.is_file() else None
    names = _add_models(catalogue, document) if document else {}
    known = {model.id for model in catalogue.models}
    for mesh in catalogue.meshes:
        if mesh.own_model is None:
            mesh.model = "" if mesh.source.own else model_of(mesh.path, names)
        elif mesh.own_model in known or not mesh.own_model:
            mesh.model = mesh.own_model
        else:
            message = f"{MODELS_FILE} has no model {mesh.own_model!r}"
            catalogue.problems.append(problem_of(mesh, message, "model"))


def _add_models(catalogue: Catalogue, document: Document) -> dict[str, str]:
    """The models of a document; gives their names, in one spelling, to their ids."""
    owners: dict[str, str] = {}
    for id, row in document.data.items():
        model = Model(id, row["title"], row.get("origin", ""), tuple(row.get("names", (id,))))
        catalogue.models.append(model)
        for name in map(joined, model.names):
            owner = owners.setdefault(name, id)
            if owner != id:
                message = f"the name {name!r} is that of {owner!r} already"
                line = document.line((id,))
                catalogue.problems.append(Problem("error", MODELS_FILE, line, f"{id}.names", message))
    return owners
