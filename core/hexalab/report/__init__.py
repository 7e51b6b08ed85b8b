"""The report of a file: its facts, criteria that decide whether it passes, and how it is written.

>>> facts = collect(hexalab.read("part.inp"), criteria=read_criteria(Path("criteria.json")))    # doctest: +SKIP
>>> facts["verdict"]["passed"]                                                                  # doctest: +SKIP
True
>>> Path("part.html").write_text(written(facts, "html"), "utf-8")                               # doctest: +SKIP
"""

from .criteria import (
    CriteriaError,
    Criterion,
    FindingCriterion,
    InvalidCriterion,
    MetricCriterion,
    checked,
    read_criteria,
)
from .facts import VERSION, About, Found, collect
from .forms import FORMS, Form, form_of, written
from .pictures import Pose, ReportPicture, poses

__all__ = [
    "FORMS",
    "VERSION",
    "About",
    "CriteriaError",
    "Criterion",
    "FindingCriterion",
    "Form",
    "Found",
    "InvalidCriterion",
    "MetricCriterion",
    "Pose",
    "ReportPicture",
    "checked",
    "collect",
    "form_of",
    "poses",
    "read_criteria",
    "written",
]
