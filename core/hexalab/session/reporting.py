"""The report of an open mesh, and the poses of its pictures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from ..report import About, Found, ReportPicture, checked, collect, form_of, poses, written
from ..status.views import View
from .opened import Opened


def report_of(
    opened: Opened,
    form: str,
    about: Mapping[str, Any],
    pictures: Sequence[Mapping[str, str]],
    criteria: Any,
    strict: bool,
) -> dict[str, Any]:
    """Write the report of an open mesh.

    Parameters
    ----------
    opened : Opened
    form : str
        Id of a row of `hexalab.report.FORMS`.
    about : mapping
        What is known of the file, some of the fields of `hexalab.report.About`.
    pictures : sequence of mapping
        Each with the fields of `hexalab.report.ReportPicture`.
    criteria : object
        As `hexalab.report.checked` takes them; None for none.
    strict : bool
        Whether the diagnosis counts beside them.

    Returns
    -------
    dict
        `text`, `ending` (of the file, without the dot), `passed`.

    Raises
    ------
    HexaLabError
        There is no such form, or a criterion is none, or names a group that the mesh has not got.
    """
    row = form_of(form)
    asked = [] if criteria is None else checked(criteria)
    found = Found(opened.findings, opened.validity, opened.groups.every, opened.known_values)
    told = About(**{**about, "notes": tuple(about.get("notes", ()))})
    facts = collect(opened.mesh, told, asked, strict=strict, found=found)
    taken = [ReportPicture(**one) for one in pictures]
    return {"text": written(facts, row.id, taken), "ending": row.id, "passed": facts["verdict"]["passed"]}


def poses_of(opened: Opened, unit: str) -> list[dict[str, Any]]:
    """The pictures that a report asks for: `title`, `alt`, `status` of each; see `hexalab.report.poses`."""
    view = View(**{name: tuple(vector) for name, vector in opened.placed["view"].items()})
    quality, volume = opened.values("scaled_jacobian"), opened.values("volume")
    found = poses(opened.mesh, opened.drawn_mesh.frame, view, quality, volume, unit)
    return [asdict(pose) for pose in found]
