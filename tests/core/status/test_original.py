"""Documents of the original HexaLab (SPEC S4): real ones out of its pictures, and the rules one by one."""

from __future__ import annotations

import math
from typing import Any

import pytest

from hexalab import status
from hexalab.png_text import read_settings
from tests.published import picture

MESH = status.OpenMesh(
    centre=(1.0, 2.0, 3.0),
    diagonal=4.0,
    whole_centre=(1.0, 2.0, 5.0),
    whole_diagonal=8.0,
    native=lambda metric, normal: normal if metric == "scaled_jacobian" else 10 - 9 * normal,
)


def converted(document: dict[str, Any], mesh: status.OpenMesh | None = MESH) -> dict[str, Any]:
    partial, rejections = status.read(document, mesh)
    assert not rejections
    return partial


@pytest.mark.parametrize(
    ("name", "mode", "by", "irregular", "offset"),
    [
        ("original-1.png", "darkness_coded_edges", "sides", 1, 0.5),
        ("original-3.png", "rounded", "quality", 1, 0.4),
        ("original-4.png", "fissure", "sides", 5, 0.5),
        ("original-5.png", "darkness_coded_edges", "quality", 3, 0.5),
    ],
)
def test_S4_real_pictures_of_the_original(
    name: str, mode: str, by: str, irregular: int, offset: float
) -> None:
    document = read_settings(picture(name).read_bytes())
    assert status.is_original(document)
    partial = converted(document)
    assert partial["separation"]["mode"] == mode
    assert partial["separation"]["gap"] == 0.15
    assert partial["separation"]["radius"] == 0.075
    assert partial["separation"]["line_opacity"] == 0.15
    assert partial["colour"]["by"] == by
    assert partial["irregular"]["mode"] == irregular
    assert partial["silhouette"] == 1
    assert partial["lighting"]["mode"] == "object_space_ao"
    assert partial["camera"]["target"] == [0, 0, 0.5]
    assert partial["camera"]["distance"] == pytest.approx(3.2)
    assert partial["camera"]["field_of_view"] == 30
    planes = partial["filters"]["planes"]
    assert planes["rule"] == "any_corner"
    assert planes["items"][0]["normal"] == [1, 0, 0]
    assert planes["items"][0]["offset"] == pytest.approx(offset, abs=1e-7)
    assert partial["filters"]["quality"]["items"] == []
    assert status.check(status.merge(status.DEFAULTS, partial))[1] == []


def test_S4_a_part_of_a_document_is_enough() -> None:
    assert converted({"rendering": {"lighting": "SSAO"}}) == {"lighting": {"mode": "screen_space_ao"}}
    assert converted({"filters": {"Peeling": {"depth": 3}}}) == {"filters": {"peel": {"depth": 3}}}
    assert converted({"app": {}}) == {}


def test_S4_our_documents_are_not_taken_for_the_originals() -> None:
    assert not status.is_original(status.DEFAULTS)
    assert not status.is_original({"camera": {"distance": 2}, "filters": {"peel": {"depth": 1}}})
    assert status.is_original({"filters": {"Pick": {"filtered_hexas": [3]}}})


@pytest.mark.parametrize(
    ("theirs", "ours"),
    [
        ("ScaledJacobian", "scaled_jacobian"),
        ("MaxEdgeRatio", "max_edge_ratio"),
        ("Relative Size Squared", "relative_size_squared"),
        ("ShapeAndSize", "shape_and_size"),
        ("Volume", "volume"),
    ],
)
def test_S4_metrics_by_the_originals_names(theirs: str, ours: str) -> None:
    assert converted({"rendering": {"quality_measure": theirs}}) == {"colour": {"metric": ours}}


def test_S4_camera_shifts_with_the_extents_centre_and_scale() -> None:
    camera = {"offset": {"x": 4, "y": 0, "z": -2}, "distance": 1.5, "direction": {"x": 0, "y": 0, "z": -1}}
    ours = converted({"camera": camera})["camera"]
    eye = [t * MESH.diagonal + c for t, c in zip(ours["target"], MESH.centre, strict=True)]
    assert eye == [5, 2, 3]
    assert ours["distance"] * MESH.diagonal == 1.5 * MESH.whole_diagonal


@pytest.mark.parametrize(
    ("quality", "metric", "item"),
    [
        ({"min": 0, "max": 0.3}, "ScaledJacobian", ("inside", None, 0.3)),
        ({"min": 0.2, "max": 1, "op": "inside"}, "ScaledJacobian", ("inside", 0.2, None)),
        ({"min": 0.2, "max": 0.5, "op": "outside"}, "ScaledJacobian", ("outside", 0.2, 0.5)),
        ({"min": 0, "max": 1, "op": "outside"}, "ScaledJacobian", ("outside", 0, 1)),
        ({"min": 0, "max": 0.5}, "EdgeRatio", ("inside", 5.5, None)),
        ({"min": 0.5, "max": 1}, "EdgeRatio", ("inside", None, 5.5)),
    ],
)
def test_S4_normalised_thresholds_become_native_values(
    quality: dict[str, Any], metric: str, item: tuple[str, float | None, float | None]
) -> None:
    document = {"rendering": {"quality_measure": metric}, "filters": {"Quality": quality}}
    (found,) = converted(document)["filters"]["quality"]["items"]
    assert (found["keep"], found["minimum"], found["maximum"]) == item
    assert found["quantity"] == status.original.metric_id(metric)


def test_S4_without_a_mesh_what_depends_on_it_is_named() -> None:
    document = {
        "camera": {"offset": {"x": 1, "y": 0, "z": 0}, "distance": 2},
        "filters": {"Quality": {"min": 0, "max": 0.5}, "Peeling": {"depth": 1}},
    }
    partial, rejections = status.read(document)
    assert [rejection.path for rejection in rejections] == ["camera.offset", "filters.Quality"]
    assert partial["camera"]["distance"] == 2
    assert partial["filters"] == {"peel": {"depth": 1}, "quality": {}}


def test_S4_isolated_cells() -> None:
    picked = converted({"filters": {"Pick": {"filtered_hexas": [-1], "filled_hexas": [7, 10]}}})
    assert picked["filters"]["picking"] == {
        "enabled": True,
        "isolated": True,
        "hidden": [],
        "shown": [7, 10],
    }


@pytest.mark.parametrize("slider", [0, 0.1, 0.5, 0.7, 1])
def test_S4_silhouette_slider(slider: float) -> None:
    flat, shaded = (2 * slider, 0) if slider < 0.5 else (2 - 2 * slider, 2 * slider - 1)
    materials = {"silhouette_opacity": flat, "filtered_surface_opacity": shaded}
    assert math.isclose(converted({"materials": materials})["silhouette"], slider)


def test_S4_wrong_values_are_named_and_the_rest_applies() -> None:
    document = {
        "rendering": {"lighting": "disco", "geometry_mode": 4, "crack_size": "x", "color_map": "Jet"},
        "camera": 3,
        "filters": {"Plane": {"normal": {"x": 0, "y": 0, "z": 0}, "offset": 7}, "Quality": {"min": "a"}},
    }
    partial, rejections = status.read(document, MESH)
    assert {rejection.path for rejection in rejections} == {
        "lighting",
        "geometry_mode",
        "separation.gap",
        "camera",
        "filters.Quality",
        "filters.planes.items[0].normal",
    }
    assert partial["colour"] == {"map": "jet"}


@pytest.mark.parametrize(
    "odd", [10**400, -(10**400), 1e400, math.nan, [], [1, 2], [1, 2, 3, 4], {}, {"x": 10**400}]
)
def test_S4_odd_numbers_and_vectors_are_named(odd: Any) -> None:
    for section, key in (
        ("camera", "offset"),
        ("camera", "distance"),
        ("rendering", "crack_size"),
        ("rendering", "rounding_radius"),
    ):
        partial, rejections = status.read({section: {key: odd, "singularity_mode": 2}}, MESH)
        assert rejections
        assert partial.get("irregular", {"mode": 2}) == {"mode": 2}
    for filters in ({"Quality": {"min": odd, "max": 1}}, {"Plane": {"offset": odd}}):
        status.read({"filters": filters, "materials": {"filtered_surface_opacity": odd}}, MESH)
