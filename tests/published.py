"""Published meshes that tests read where they lie beside the repository; they belong to their authors.

The folder has the files and `expected.json`: facts about each by its name, from dictionaries and VTK's Verdict. What
is held on them is held on the repository's own meshes, too (`own.py`): the suite's strength does not hang on them.
"""

from __future__ import annotations

import json
import os
from functools import cache
from pathlib import Path
from typing import Any

import pytest

SHARED = Path(__file__).resolve().parents[2] / "shared"
MESHES = Path(os.environ.get("HEXALAB_MESHES", SHARED / "meshes"))
PICTURES = Path(os.environ.get("HEXALAB_PICTURES", SHARED / "reference" / "pictures"))

CELLS = {
    "2012-all-hex-meshing--impeller-impeller.vtk": 11_174,
    "2012-all-hex-meshing--rod-rod.vtk": 5_488,
    "2014-l1-based-construction--fertility-hex.vtk": 17_910,
    "2014-l1-based-construction--gargoyle-hex.mesh": 25_669,
    "2015-practical-hex-mesh--armadillo-stresstest-in.mesh": 29_935,
    "2015-practical-hex-mesh--armadillo-stresstest-out.mesh": 29_935,
    "2016-all-hex-meshing--nut-hex.mesh": 12_636,
    "2016-efficient-volumetric-polycube--Fertility-hex-small.mesh": 4_292,
    "2016-polycube-simplification-for--block-model-out.mesh": 17_896,
    "2016-skeleton-driven-adaptive--dino.mesh": 8_992,
    "2016-structured-volume-decomposition--hex-mesh-cat-cat-3.mesh": 27_776,
    "2019-dual-sheet-meshing--rockarm.vtk": 1_858,
    "2019-feature-preserving-octree--CompletePart-16.hh.sat.vtk": 28_439,
    "2019-selective-padding-for--Bearing.mesh": 8_062,
    "2019-singularity-structure-simplification--buste-buste-input.mesh": 19_075,
    "2019-symmetric-moving-frames--hex-fanpart.vtk": 2_460,
    "2019-symmetric-moving-frames--hex-joint.vtk": 7_746,
    "2019-symmetric-moving-frames--hex-sphere.vtk": 4_032,
    "2020-cut-enhanced-polycube--fig10-DEMO09-1.hh.sat-ours.vtk": 8_222,
    "2020-loopycuts-practical-feature--hand.mesh": 1_300,
    "2021-at-most-hexa--cylinder-n-slivers.mesh": 1_746,
    "2021-at-most-hexa--fandisk-slivers.mesh": 10_007,
    "2021-at-most-hexa--twistcube-m-slivers.mesh": 5_737,
    "2021-generalized-adaptive-refinement--oni-input-tri.mesh": 21_866,
}
"""Number of cells by the name of the file."""


@cache
def facts() -> dict[str, Any]:
    """Facts about each mesh by its name; the test is left out where they are not here."""
    if not (MESHES / "expected.json").is_file():
        pytest.skip("needs published meshes, which are not here (HEXALAB_MESHES)")
    return dict(json.loads((MESHES / "expected.json").read_text("utf-8")))


def file_of(name: str) -> Path:
    """A published mesh; the test is left out where it is not here."""
    if not (MESHES / name).is_file():
        pytest.skip("needs published meshes, which are not here (HEXALAB_MESHES)")
    return MESHES / name


def picture(name: str) -> Path:
    """A picture that the original HexaLab saved; the test is left out where it is not here."""
    if not (PICTURES / name).is_file():
        pytest.skip("needs pictures of the original, which are not here (HEXALAB_PICTURES)")
    return PICTURES / name
