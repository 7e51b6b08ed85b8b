"""A report as JUnit XML, which build servers read: a test case for each check and each error of the diagnosis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from . import told
from .escaping import escape, quoted
from .judging import MISSED, UNMEASURED
from .pictures import ReportPicture

Facts = dict[str, Any]


def junit_of(facts: Facts, _pictures: Sequence[ReportPicture] = ()) -> str:
    """Write a report as JUnit XML.

    An error of the diagnosis that nothing asked for is skipped, not failed, so that the file says what the exit code
    says.
    """
    cases = [
        _case(check["kind"], check["title"], _outcome(check, where))
        for check, (*_, where) in zip(facts["verdict"]["checks"], told.check_rows(facts), strict=True)
    ]
    asked = {check["of"] for check in facts["verdict"]["checks"] if check["kind"] == "finding"}
    for finding, (_, message, where) in zip(facts["findings"], told.finding_rows(facts), strict=True):
        if finding["severity"] == "error" and finding["id"] not in asked:
            words = quoted(f"{message} No criterion asks for it. {where}".rstrip())
            cases.append(_case("finding", f"Finding {finding['id']}", f"<skipped message={words}/>"))
    counts = (
        f'tests="{len(cases)}" failures="{sum("<failure" in case for case in cases)}" errors="0" '
        f'skipped="{sum("<skipped" in case for case in cases)}" time="0"'
    )
    name = quoted(facts["file"]["name"] or "mesh")
    rows = {
        **dict(told.file_rows(facts)),
        **{f"version of {what}": of for what, of in facts["made_by"].items()},
    }
    properties = "".join(
        f"<property name={quoted(what)} value={quoted(value)}/>\n" for what, value in rows.items()
    )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<testsuites name="hexalab report" {counts}>\n<testsuite name={name} {counts}>\n'
        f"<properties>\n{properties}</properties>\n{''.join(cases)}</testsuite>\n</testsuites>\n"
    )


def _case(kind: str, title: str, outcome: str) -> str:
    return f'<testcase classname="hexalab.{kind}" name={quoted(title)} time="0">{outcome}</testcase>\n'


def _outcome(check: Facts, where: str) -> str:
    words = f"{check['found']} {where}".rstrip()
    if check["state"] == MISSED:
        return f'<failure type="{check["kind"]}" message={quoted(words)}>{escape(words)}</failure>'
    return f"<skipped message={quoted(words)}/>" if check["state"] == UNMEASURED else ""
