"""Measuring meshes with the core, once: facts are kept by the file's SHA-256 and the core that measured them."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np

import hexalab
from hexalab.arrays import Floats
from hexalab.diagnosis import turn_round
from hexalab.formats import read_bytes
from hexalab.quality import histogram, quality
from hexalab.quality.validity import certify
from hexalab.session import Session
from hexalab.session.opened import Opened
from hexalab.status.views import View
from hexalab.structure import Structure, facts_of
from hexalab.summary import summarise

from ..kept import is_kept, keep, remember
from ..model.facts import Binned, Facts, Looked, Validity

BINS = 60
"""Bins of the Scaled Jacobian's histogram."""


class Measurer:
    """Gives the facts and the preview of mesh files, and remembers both.

    Parameters
    ----------
    cache : Path
        Folder of what is remembered.
    """

    def __init__(self, cache: Path) -> None:
        self._cache = cache
        self._version = core_version()
        self.measured = 0

    def facts(self, file: Path) -> Facts:
        """Measure a mesh file, or remember it.

        Raises
        ------
        hexalab.MeshReadError
            The file isn't a mesh that can be read.
        """
        data = file.read_bytes()
        kept = self._kept(hashlib.sha256(data).hexdigest()[:32], "facts.json")
        if is_kept(kept):
            return Facts.from_dict(json.loads(kept.read_text("utf-8")))
        facts = measure(data, file.name)
        keep(kept, json.dumps(facts.to_dict(), allow_nan=False).encode())
        self.measured += 1
        return facts

    def preview(self, file: Path, facts: Facts, status: dict[str, Any]) -> bytes:
        """What the viewer draws of a mesh before Python has started, under a partial status."""
        shown = hashlib.sha256(json.dumps(status, sort_keys=True).encode()).hexdigest()[:8]
        kept = self._kept(f"{str(facts.sha256)[:32]}-{shown}", "preview")
        return remember(kept, lambda: _preview(file, status)).read_bytes()

    def _kept(self, key: str, what: str) -> Path:
        return self._cache / what.split(".")[0] / f"{key}-{self._version}.{what}"


def _preview(file: Path, status: dict[str, Any]) -> bytes:
    session = Session()
    session.open(file.name, file.read_bytes())
    return session.preview(status)


OWN = frozenset(("file", "features"))
"""Facts of a summary that the catalogue does not tell as they are."""


def measure(data: bytes, name: str, up: str = "") -> Facts:
    """The facts of a mesh file's bytes; the axis that points up is guessed where none is given."""
    mesh = turn_round(read_bytes(data, name))
    opened = Opened(mesh)
    summary = summarise(mesh)
    jacobian = quality(mesh, "scaled_jacobian")
    finite = jacobian[np.isfinite(jacobian)]
    jacobians = summary["quality"]["scaled_jacobian"]
    return Facts(
        bytes=len(data),
        sha256=hashlib.sha256(data).hexdigest(),
        sj_min=jacobians["min"],
        sj_mean=jacobians["mean"],
        sj_max=jacobians["max"],
        sj_not_positive=int(np.count_nonzero(finite <= 0)),
        sj_not_finite=jacobians["not_finite"],
        extent=opened.mesh.extent.tolist(),
        view=looked(opened.view(up)),
        validity=_validity(mesh),
        histogram=_histogram(finite),
        notes=list(mesh.notes),
        structure=facts_of(Structure(mesh)),
        features={name: row for name, row in summary["features"].items() if row["count"]},
        **{key: _valences(key, value) for key, value in summary.items() if key not in OWN},
    )


def looked(view: View) -> Looked:
    """A view as facts keep it."""
    return {"direction": [*view.direction], "up": [*view.up], "facing": [*view.facing]}


def _valences(key: str, value: Any) -> Any:
    return {int(v): n for v, n in value.items()} if key.endswith("_edge_valence") else value


def _validity(mesh: hexalab.Mesh) -> Validity:
    counts = certify(mesh).counts
    return {"invalid": counts["invalid"], "valid": counts["valid"], "undecided": counts["undecided"]}


def _histogram(values: Floats) -> Binned | None:
    if not len(values):
        return None
    low = 0.0 if values.min() >= 0 else -1.0
    _, counts = histogram(values, low, 1.0, BINS)
    return {"low": low, "high": 1.0, "counts": [int(count) for count in counts]}


def core_version() -> str:
    """A hash of the core's source: facts that another core measured are measured again."""
    root = Path(hexalab.__file__).parent
    digest = hashlib.sha256(np.__version__.encode())
    for file in sorted(root.rglob("*.py")):
        if not {"cli", "hosts"} & set(file.relative_to(root).parts):
            digest.update(file.relative_to(root).as_posix().encode() + b"\0" + file.read_bytes())
    digest.update(Path(__file__).read_bytes())
    return digest.hexdigest()[:16]
