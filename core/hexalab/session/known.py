"""What a settings document may name only of an open mesh: metrics, attributes, cells."""

from __future__ import annotations

from typing import Any

from .. import status as documents
from ..comparison import DISPLACEMENT
from ..comparison import QUANTITIES as COMPARED
from ..quality import METRICS
from ..status import Rejection
from ..structure.quantities import QUANTITIES
from .opened import Opened

Partial = dict[str, Any]


def read(document: Any, opened: Opened | None) -> dict[str, Any]:
    """Read any settings document, parsed or its text, as far as it applies to the open mesh; see `Session.check`."""
    if isinstance(document, str):
        document = documents.parse(document)
    form = "original" if documents.is_original(document) else "hexalab"
    original = opened.for_original() if opened and form == "original" else None
    partial, rejections = documents.read(document, original)
    identity = {"mesh": partial["mesh"]} if "mesh" in partial else {}
    partial, unknown = checked(partial, opened)
    told = [rejection.as_dict() for rejection in rejections + unknown]
    return {"partial": {**partial, **identity}, "rejections": told, "form": form}


def checked(partial: Partial, opened: Opened | None) -> tuple[Partial, list[Rejection]]:
    """Leave out of a clean part of a settings document what the open mesh has not got.

    Parameters
    ----------
    partial : dict
        Checked against the schema; it is not changed.
    opened : Opened or None
        Without a mesh only the metrics are known, and nothing is said of attributes and cells.

    Returns
    -------
    partial : dict
    rejections : list of Rejection
    """
    rejections: list[Rejection] = []
    out = {name: part for name, part in partial.items() if name != "mesh"}
    if "colour" in out:
        out["colour"] = _colour(dict(out["colour"]), opened, rejections)
    if "arrows" in out:
        out["arrows"] = _arrows(dict(out["arrows"]), opened, rejections)
    if "marks" in out:
        out["marks"] = _marks(dict(out["marks"]), opened, rejections)
    if "filters" in out:
        out["filters"] = dict(out["filters"])
        for name, check in (("quality", _bands), ("groups", _groups), ("picking", _cells)):
            if name in out["filters"]:
                out["filters"][name] = check(dict(out["filters"][name]), opened, rejections)
    return out, rejections


def _colour(colour: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    metric, attribute = colour.get("metric"), colour.get("attribute")
    if metric is not None and metric not in METRICS:
        rejections.append(_unknown("colour.metric", metric, METRICS))
        del colour["metric"]
        if colour.get("by") == "quality":
            del colour["by"]
    if attribute and opened and not _is_known(attribute, opened):
        rejections.append(_unknown("colour.attribute", attribute, opened.attributes))
        del colour["attribute"]
        if colour.get("by") == "attribute":
            del colour["by"]
    grouping = colour.get("grouping")
    if grouping and opened and grouping not in opened.groups.groupings:
        rejections.append(_unknown("colour.grouping", grouping, opened.groups.groupings))
        del colour["grouping"]
        if colour.get("by") == "group":
            del colour["by"]
    return colour


def _is_known(quantity: str, opened: Opened) -> bool:
    """Whether there is a quantity of that id, or will be when the mesh is compared with something."""
    return quantity in QUANTITIES or quantity in COMPARED or quantity in opened.attributes


def _groups(groups: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    for name in ("hidden", "shown"):
        ids = groups.get(name)
        if not ids or not opened:
            continue
        kept = [id for id in ids if id in opened.groups.of_cells]
        for id in ids:
            if id not in opened.groups.of_cells:
                rejections.append(_unknown(f"filters.groups.{name}", id, opened.groups.of_cells))
        groups[name] = kept
    return groups


def _marks(marks: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    if not opened:
        return marks
    known = {"hidden": opened.marks.ids(), "nodes": set(opened.groups.of_vertices)}
    for name, ids in known.items():
        asked = marks.get(name)
        if asked:
            marks[name] = [id for id in asked if id in ids]
            rejections += [_unknown(f"marks.{name}", id, sorted(ids)) for id in asked if id not in ids]
    origin = marks.get("interfaces")
    if origin and origin not in opened.groups.groupings:
        rejections.append(_unknown("marks.interfaces", origin, opened.groups.groupings))
        del marks["interfaces"]
    return marks


def _arrows(arrows: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    attribute = arrows.get("attribute")
    if attribute and opened and attribute != DISPLACEMENT and attribute not in opened.vectors:
        rejections.append(
            _unknown("arrows.attribute", attribute, opened.vectors, "attributes of three components")
        )
        del arrows["attribute"]
    return arrows


def _bands(quality: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    kept = []
    for place, band in enumerate(quality.get("items", ())):
        quantity = band["quantity"]
        if quantity in METRICS or not opened or _is_known(quantity, opened):
            kept.append(band)
        else:
            known = [*METRICS, *opened.attributes]
            rejections.append(_unknown(f"filters.quality.items[{place}].quantity", quantity, known))
    return {**quality, "items": kept} if "items" in quality else quality


def _cells(picking: Partial, opened: Opened | None, rejections: list[Rejection]) -> Partial:
    if not opened:
        return picking
    count = opened.mesh.cell_count
    for name in ("hidden", "shown"):
        cells = picking.get(name)
        if cells and max(cells) >= count:
            beyond = [cell for cell in cells if cell >= count]
            words = f"cell numbers below {count}, for this mesh has {count} cells"
            rejections.append(
                Rejection(f"filters.picking.{name}", f"{len(beyond)} cells from {min(beyond)} up", words)
            )
            picking[name] = [cell for cell in cells if cell < count]
    return picking


def _unknown(path: str, found: str, known: Any, what: str = "") -> Rejection:
    """A name that is not known; `what` says what the known ones are, where their names don't."""
    names = ", ".join(known)
    some = f"one of the {what}: {names}" if what else f"one of {names}"
    none = f"nothing: the mesh has {f'no {what}' if what else 'none'}"
    return Rejection(path, f'"{found}"', some if names else none)
