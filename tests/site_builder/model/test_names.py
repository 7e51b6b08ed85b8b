"""Slugs, DOIs, mesh names."""

import pytest

from site_builder.model.names import doi_address, ending, mesh_name, normal_doi, slug


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("double torus/Double_Torus (2)", "double-torus-double-torus-2"),
        ("Núñez", "nunez"),
        ("3002.hh.sat", "3002-hh-sat"),
        ("ℓ1", "l1"),
        ("<script>", "script"),
        ("---", ""),
    ],
)
def test_C1_slugs_are_plain(text, expected):
    assert slug(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        "10.1111/cgf.13617", "https://doi.org/10.1111/cgf.13617", "http://dx.doi.org/10.1111/cgf.13617",
        "doi:10.1111/cgf.13617", " DOI: 10.1111/cgf.13617 ", "https://doi.org/10.1111%2Fcgf.13617",
    ],
)  # fmt: skip
def test_C1_dois_are_normalised(text):
    assert normal_doi(text) == "10.1111/cgf.13617"


@pytest.mark.parametrize("text", ["", "11.1111/x", "https://example.org/10", "10.1/x", "10.1111/"])
def test_C1_what_is_no_doi_is_none(text):
    assert normal_doi(text) == ""


def test_C1_a_doi_in_an_address_is_escaped():
    assert doi_address("10.1000/a<b>#c") == "https://doi.org/10.1000/a%3Cb%3E%23c"


@pytest.mark.parametrize(
    ("path", "name", "kind"),
    [
        ("bone.vtk", "bone", ".vtk"),
        ("hex_mesh/bunny/bunny_1.mesh", "hex_mesh / bunny / bunny_1", ".mesh"),
        ("grid.MESH.GZ", "grid", ".mesh.gz"),
        ("a.meshb", "a", ".meshb"),
        ("readme.txt", "readme.txt", ""),
    ],
)
def test_C1_meshes_are_called_by_their_paths(path, name, kind):
    assert mesh_name(path) == name
    assert ending(path) == kind
