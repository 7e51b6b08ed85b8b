"""`hexalab report`: what is known of a file, to be attached to it; criteria decide whether it passes."""

from __future__ import annotations

import base64
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from ..errors import HexaLabError
from ..hosts.offers import FileOffer, stamp_of
from ..report import FORMS, About, ReportPicture, collect, form_of, read_criteria, written
from ..report.told import check_rows
from . import FINDING
from .units import add_unit

NO_PICTURES = "Pictures are left out"


def configure(parser: ArgumentParser) -> None:
    """Declare the verb's arguments."""
    parser.add_argument("file", type=Path, metavar="FILE", help="a mesh file; may be gzipped")
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        action="append",
        required=True,
        metavar="REPORT",
        help="where it goes, the ending says in which form: "
        + ", ".join(f".{row.id} ({row.name})" for row in FORMS)
        + "; may be repeated",
    )
    parser.add_argument(
        "--criteria",
        type=Path,
        metavar="FILE",
        help="what the mesh has to hold, .json or .yaml: exit with 1 if it misses one",
    )
    parser.add_argument(
        "--strict",
        action="store_true",
        help="exit with 1, too, for an invalid cell or an error of the diagnosis",
    )
    parser.add_argument(
        "--no-pictures", action="store_true", help="leave the pictures out, which need a browser"
    )
    add_unit(parser)
    parser.set_defaults(run=run)


def run(arguments: Namespace) -> int:
    """Write the report; what was missed, and what it lacks, goes to stderr."""
    forms = [form_of(str(out)) for out in arguments.out]
    criteria = read_criteria(arguments.criteria) if arguments.criteria else []
    stamp = stamp_of(arguments.file)
    offer = FileOffer(arguments.file, arguments.file.name)
    mesh = offer.mesh()
    about = About(offer.name, offer.size(), offer.sha256(), arguments.unit)
    facts = collect(mesh, about, criteria, strict=arguments.strict)
    taken: list[dict[str, Any]] = []
    problem = ""
    if any(form.pictured for form in forms) and not arguments.no_pictures:
        taken, problem = pictures(offer, arguments.unit)
    if stamp_of(arguments.file) != stamp:
        raise HexaLabError(f"{arguments.file}: the file was changed while it was read")
    if problem:
        print(f"hexalab: {NO_PICTURES}: {problem}", file=sys.stderr)
    for out, form in zip(arguments.out, forms, strict=True):
        note = [f"{NO_PICTURES}: {problem}."] if problem and form.pictured else []
        write(out, form.id, {**facts, "notes": [*facts["notes"], *note]}, taken)
    return judged(arguments, facts)


def pictures(offer: FileOffer, unit: str) -> tuple[list[dict[str, Any]], str]:
    """Have the viewer take the pictures; where it can't, none, and why."""
    try:
        exporting = import_module("hexalab.hosts.exporting")
        with exporting.Renderer() as renderer:
            return exporting.report_pictures(renderer, offer, unit), ""
    except ModuleNotFoundError as error:
        package = (error.name or "").split(".")[0]
        return [], f"the package {package} is not installed (pip install 'hexalab[render]')"
    except HexaLabError as error:
        return [], " ".join(str(error).split())


def write(out: Path, form: str, facts: dict[str, Any], taken: Sequence[dict[str, Any]]) -> None:
    """Write one form: pictures are within a page, and beside a text."""
    if form == "html":
        addresses = [f"data:image/png;base64,{base64.b64encode(one['data']).decode()}" for one in taken]
    elif form_of(form).pictured:
        addresses = [f"{out.stem}-{place}.png" for place in range(1, len(taken) + 1)]
        for address, one in zip(addresses, taken, strict=True):
            out.with_name(address).write_bytes(one["data"])
    else:
        addresses, taken = [], []
    placed = [
        ReportPicture(one["title"], one["alt"], address)
        for one, address in zip(taken, addresses, strict=True)
    ]
    out.write_text(written(facts, form, placed), "utf-8", newline="\n")
    word = "passed" if facts["verdict"]["passed"] else "failed"
    print(f"{out}: {word}, {out.stat().st_size:,} bytes")


def judged(arguments: Namespace, facts: dict[str, Any]) -> int:
    """Say what was missed; returns the exit code. Without criteria a report is no judgement."""
    if not arguments.criteria and not arguments.strict:
        return 0
    for check, (_, asked, found, where) in zip(facts["verdict"]["checks"], check_rows(facts), strict=True):
        if check["state"] == "missed":
            print(f"hexalab: {arguments.file}: missed: {asked}: {found} {where}".rstrip(), file=sys.stderr)
    return 0 if facts["verdict"]["passed"] else FINDING
