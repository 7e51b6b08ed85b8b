"""Converts settings of the original HexaLab into ours (SPEC S4).

Its documents have neither a version nor the mesh's identity; the camera's offset is in the mesh's own unit,
and qualities are normalised to 0 to 1 over the mesh that was open. For those two the open mesh is needed.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeGuard

from .check import Rejection, check, quoted

SECTIONS = ("app", "camera", "rendering", "materials", "filters")
FILTERS = ("Plane", "Peeling", "Quality", "Pick")

LIGHTING = {"AO": "object_space_ao", "SSAO": "screen_space_ao", "Direct": "direct", "none": "none"}
SEPARATION = {
    "DynamicLines": "darkness_coded_edges",
    "Lines": "lines",
    "Cracked": "fissure",
    "Smooth": "rounded",
}
MAPS = {"Parula": "parula", "Jet": "jet", "RedBlue": "red_blue"}
GAP_OF_CRACK = 0.6
RADIUS_OF_ROUNDING = 0.3
FIELD_OF_VIEW = 30
LARGEST = 1e100
"""Numbers beyond it are none of a document that was written by a program."""


@dataclass(frozen=True)
class OpenMesh:
    """What conversion must know of the mesh that is open.

    Parameters
    ----------
    centre, diagonal : (float, float, float), float
        Of the frame that we draw by: of the extent over the vertices that cells use.
    whole_centre, whole_diagonal : (float, float, float), float
        Of the extent as the original took it: over all vertices.
    native : callable (metric id, normalised value) -> float
        Inverse of the metric's normalisation over this mesh.
    """

    centre: tuple[float, float, float]
    diagonal: float
    whole_centre: tuple[float, float, float]
    whole_diagonal: float
    native: Callable[[str, float], float]


def is_original(document: Any) -> bool:
    """Whether a parsed document is one of the original HexaLab's."""
    if not isinstance(document, dict) or "version" in document:
        return False
    if any(isinstance(document.get(name), dict) for name in ("app", "rendering", "materials")):
        return True
    camera, filters = document.get("camera"), document.get("filters")
    return (isinstance(camera, dict) and "offset" in camera) or (
        isinstance(filters, dict) and any(name in filters for name in FILTERS)
    )


def from_original(
    document: dict[str, Any], mesh: OpenMesh | None = None
) -> tuple[dict[str, Any], list[Rejection]]:
    """Convert a document of the original HexaLab.

    Parameters
    ----------
    document : dict
        As parsed from its JSON; any section or key may be missing.
    mesh : OpenMesh, optional
        The mesh that it is to be applied to. Without it a shifted camera and a quality threshold, which are
        relative to the mesh, are left out and named.

    Returns
    -------
    partial : dict
        The same settings as a part of our document, checked.
    rejections : list of Rejection
        What could not be converted; paths are those of the original's document, or of ours for wrong values.
    """
    rejections: list[Rejection] = []
    parts = {name: _section(document, name, rejections) for name in SECTIONS}
    look = {**parts["rendering"], **parts["materials"]}
    partial = {
        "camera": _camera(parts["camera"], mesh, rejections),
        "filters": _filters(parts["filters"], look, mesh, rejections),
        "separation": _separation(look, rejections),
        "colour": _colour(look, rejections),
        "silhouette": _silhouette(look),
        "irregular": _taken(look, singularity_mode="mode"),
        "lighting": _words(look, rejections, lighting=("mode", LIGHTING)),
        "background": look.get("background"),
    }
    partial = {name: part for name, part in partial.items() if part is not None and part != {}}
    clean, wrong = check(partial)
    return clean, rejections + wrong


def _camera(camera: dict[str, Any], mesh: OpenMesh | None, rejections: list[Rejection]) -> dict[str, Any]:
    ours: dict[str, Any] = {}
    for name in ("direction", "up"):
        if name in camera:
            ours[name] = _vector(camera[name])
    scale = mesh.whole_diagonal / mesh.diagonal if mesh else 1.0
    if "distance" in camera:
        distance = camera["distance"]
        ours["distance"] = distance * scale if _is_number(distance) else distance
    if ours or "offset" in camera:
        ours.update(projection="perspective", field_of_view=FIELD_OF_VIEW)
    offset = _vector(camera["offset"]) if "offset" in camera else None
    if isinstance(offset, list) and len(offset) == 3 and all(map(_is_number, offset)):
        if mesh:
            places = zip(offset, mesh.whole_centre, mesh.centre, strict=True)
            ours["target"] = [(shift + whole - own) / mesh.diagonal for shift, whole, own in places]
        elif not any(offset):
            ours["target"] = [0, 0, 0]
        else:
            rejections.append(_needs_mesh("camera.offset", camera["offset"]))
    elif "offset" in camera:
        ours["target"] = camera["offset"]
    return ours


def _filters(
    filters: dict[str, Any], look: dict[str, Any], mesh: OpenMesh | None, rejections: list[Rejection]
) -> dict[str, Any]:
    parts = {name: _section(filters, name, rejections, "filters.") for name in FILTERS if name in filters}
    ours: dict[str, Any] = {}
    if plane := parts.get("Plane"):
        ours["planes"] = {**_taken(plane, enabled="enabled"), "rule": "any_corner", **_plane_item(plane)}
    if peeling := parts.get("Peeling"):
        ours["peel"] = _taken(peeling, enabled="enabled", depth="depth")
    if "erode_dilate_level" in look:
        ours["regularisation"] = {"enabled": True, "strength": look["erode_dilate_level"]}
    if quality := parts.get("Quality"):
        ours["quality"] = _taken(quality, enabled="enabled")
        items = _quality_items(quality, look, mesh, rejections)
        if items is not None:
            ours["quality"]["items"] = items
    if pick := parts.get("Pick"):
        ours["picking"] = _picking(pick)
    return ours


def _plane_item(plane: dict[str, Any]) -> dict[str, Any]:
    if "normal" not in plane and "offset" not in plane:
        return {}
    offset = plane.get("offset", 0)
    item = {"normal": _vector(plane.get("normal", {"x": 1, "y": 0, "z": 0})), "offset": offset}
    if _is_number(offset):
        item["offset"] = min(max(offset, 0), 1)  # its number box let any offset through
    return {"items": [{"enabled": True, **item}]}


def _quality_items(
    quality: dict[str, Any], look: dict[str, Any], mesh: OpenMesh | None, rejections: list[Rejection]
) -> list[dict[str, Any]] | None:
    low, high = quality.get("min", 0), quality.get("max", 1)
    keep = quality.get("op", "inside")
    if not (_is_number(low) and _is_number(high)):
        rejections.append(
            Rejection("filters.Quality", quoted({"min": low, "max": high}), "numbers from 0 to 1")
        )
        return None
    if keep == "inside" and low <= 0 and high >= 1:
        return []
    if mesh is None:
        rejections.append(_needs_mesh("filters.Quality", {"min": low, "max": high}))
        return None
    metric = metric_id(str(look.get("quality_measure", "ScaledJacobian")))
    ends: list[float | None] = [mesh.native(metric, float(low)), mesh.native(metric, float(high))]
    if keep == "inside":  # beyond the ends of the normalised range nothing is hidden
        ends = [None if low <= 0 else ends[0], None if high >= 1 else ends[1]]
    if mesh.native(metric, 0.0) > mesh.native(metric, 1.0):  # the best is the lowest
        ends.reverse()
    return [{"quantity": metric, "keep": keep, "minimum": ends[0], "maximum": ends[1]}]


def _picking(pick: dict[str, Any]) -> dict[str, Any]:
    hidden, filled = pick.get("filtered_hexas", []), pick.get("filled_hexas", [])
    isolated = isinstance(hidden, list) and -1 in hidden
    return {"enabled": True, "isolated": isolated, "hidden": [] if isolated else hidden, "shown": filled}


def _separation(look: dict[str, Any], rejections: list[Rejection]) -> dict[str, Any]:
    ours = _words(look, rejections, geometry_mode=("mode", SEPARATION))
    ours.update(_taken(look, visible_wireframe_opacity="line_opacity"))
    for theirs, name, factor in (
        ("crack_size", "gap", GAP_OF_CRACK),
        ("rounding_radius", "radius", RADIUS_OF_ROUNDING),
    ):
        if theirs in look:
            size = look[theirs]
            ours[name] = round(size * factor, 12) if _is_number(size) else size
    return ours


def _colour(look: dict[str, Any], rejections: list[Rejection]) -> dict[str, Any]:
    mapped = look.get("is_quality_color_mapping_enabled", look.get("apply_color_map"))
    ours = {} if mapped is None else {"by": "quality" if mapped else "sides"}
    ours.update(_words(look, rejections, color_map=("map", MAPS)))
    ours.update(
        _taken(
            look,
            visible_surface_default_outside_color="outside",
            visible_surface_default_inside_color="inside",
        )
    )
    if "quality_measure" in look:
        ours["metric"] = metric_id(str(look["quality_measure"]))
    return ours


def _silhouette(look: dict[str, Any]) -> Any:
    shaded, flat = look.get("filtered_surface_opacity"), look.get("silhouette_opacity")
    if _is_number(shaded) and shaded > 0:
        return (1 + shaded) / 2
    return flat / 2 if _is_number(flat) else None


def metric_id(name: str) -> str:
    """Turn the original's name of a metric (ScaledJacobian, "Relative Size Squared") into its id."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name.replace(" ", "")).lower()


def _taken(part: dict[str, Any], **names: str) -> dict[str, Any]:
    return {ours: part[theirs] for theirs, ours in names.items() if theirs in part}


def _words(
    part: dict[str, Any], rejections: list[Rejection], **names: tuple[str, dict[str, str]]
) -> dict[str, Any]:
    found = {}
    for theirs, (ours, words) in names.items():
        word = part.get(theirs)
        if isinstance(word, str) and word in words:
            found[ours] = words[word]
        elif theirs in part:
            rejections.append(Rejection(theirs, quoted(word), "one of " + ", ".join(words)))
    return found


def _section(
    document: dict[str, Any], name: str, rejections: list[Rejection], before: str = ""
) -> dict[str, Any]:
    part = document.get(name, {})
    if isinstance(part, dict):
        return part
    rejections.append(Rejection(before + name, quoted(part), "an object of settings"))
    return {}


def _vector(value: Any) -> Any:
    return [value.get(axis) for axis in "xyz"] if isinstance(value, dict) else value


def _is_number(value: Any) -> TypeGuard[float]:
    """Whether it is a number that can be calculated with: JSON bounds neither floats nor integers."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST


def _needs_mesh(path: str, found: Any) -> Rejection:
    return Rejection(path, quoted(found), "an open mesh, to whose size and quality it is relative")
