"""Which family of methods a mesh comes from, and which model it shows, as the model tells them."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec

from ..model.catalogue import MeshEntry

METHODS = "site_builder.model.methods"
NOT_TOLD = "not told"


def method_of(mesh: MeshEntry) -> str:
    """The id of the family of methods that made a mesh; "" if nobody has told it."""
    return str(getattr(mesh, "method", ""))


def model_of(mesh: MeshEntry) -> str:
    """The model that a mesh shows; "" if nobody has told it."""
    return str(getattr(mesh, "model", ""))


def family_names() -> dict[str, str]:
    """What each family of methods is called, by its id, in the order in which they are told; "" is the last."""
    table = import_module(METHODS).METHODS if find_spec(METHODS) else {}
    return {str(name): str(row.name) for name, row in table.items()} | {"": NOT_TOLD}
