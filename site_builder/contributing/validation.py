"""Validating a repository, or one source of it, for a pull request: exact reasons, and a table of measurements."""

from __future__ import annotations

import hashlib
import stat
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from hexalab import HexaLabError

from ..measuring.making import MakingError, make
from ..measuring.measurer import Measurer
from ..model.catalogue import Catalogue, MeshEntry, Problem, Source
from ..model.names import ending
from ..model.problems import disagreements, problem_of
from ..model.published import FACTS_FILE, PICTURES
from ..pages.words import count, file_size, number, structure_word, verdict
from ..reading.models import read_models
from ..reading.repository import LARGEST_FILE, read_repository, read_source

KNOWN_FILES = ("source.yaml", FACTS_FILE, "make.py", "README.md", "LICENSE")
LARGEST_SOURCE = 100_000_000
"""Bytes of all files of one source."""


@dataclass
class ValidationReport:
    """What was found.

    Parameters
    ----------
    problems : list of Problem
        Errors and warnings, in the order of files and lines.
    meshes : list of MeshEntry
        Those that could be read, with their facts.
    """

    problems: list[Problem] = field(default_factory=list)
    meshes: list[MeshEntry] = field(default_factory=list)

    @property
    def ok(self) -> bool:
        """Whether nothing but warnings was found."""
        return not any(problem.severity == "error" for problem in self.problems)

    @property
    def markdown(self) -> str:
        """Problems as a list and measurements as a table, for a pull request's page."""
        errors = [problem for problem in self.problems if problem.severity == "error"]
        warnings = [problem for problem in self.problems if problem.severity != "error"]
        lines = ["## " + _headline(len(errors), len(warnings), len(self.meshes)), ""]
        for title, problems in (("Errors", errors), ("Warnings", warnings)):
            if problems:
                lines += [f"### {title}", ""]
                lines += [
                    f"- `{problem.file}`{_line(problem)} {_code(problem.field)}{_md(problem.message)}"
                    for problem in problems
                ]
                lines.append("")
        if self.meshes:
            lines += _table(self.meshes)
        return "\n".join(lines) + "\n"


def validate(directory: Path, cache: Path | None = None) -> ValidationReport:
    """Check a repository, or a single source's folder, and read every mesh in it.

    Parameters
    ----------
    directory : Path
        A folder of sources, or one with a source.yaml.
    cache : Path, optional
        Where measurements are kept; by default nothing is kept.
    """
    if (directory / "source.yaml").exists():
        catalogue = Catalogue(directory.parent)
        directory = directory.resolve()
        catalogue.root = directory.parent
        source = read_source(directory, catalogue.problems, directory.parent)
        catalogue.sources = [source] if source else []
        catalogue.problems += _doi_taken(source) if source else []
    else:
        catalogue = read_repository(directory)
        if not catalogue.sources and not catalogue.problems:
            catalogue.problems.append(
                Problem("error", str(directory), 0, "", "no folder with a source.yaml in it")
            )
    read_models(catalogue)
    report = ValidationReport(catalogue.problems)
    with tempfile.TemporaryDirectory() as temporary:
        place = cache or Path(temporary)
        for source in catalogue.sources:
            report.problems += _folder_problems(
                source.folder, [*map(listed_path, source.meshes)], catalogue.root
            )
            _measure_all(source.meshes, Measurer(place), place, catalogue.root, report)
            report.problems += _repeated_files(source.meshes)
    report.problems.sort(key=lambda problem: (problem.file, problem.line, problem.field))
    return report


def listed_path(mesh: MeshEntry) -> str:
    """The file in its source's folder that a row stands for: a mesh, or the picture of a remote one."""
    return f"{PICTURES}/{mesh.slug}.webp" if mesh.remote else mesh.path


def _doi_taken(source: Source) -> list[Problem]:
    """What the sources beside it have against a source that is checked alone."""
    root = source.folder.parent
    for folder in sorted(root.iterdir()):
        if folder != source.folder and source.doi and (folder / "source.yaml").is_file():
            other = read_source(folder, [], root)
            if other and other.doi.lower() == source.doi.lower():
                message = f"the DOI {source.doi} is taken by {other.slug}"
                file = f"{source.folder.name}/source.yaml"
                return [Problem("error", file, source.doi_line, "reference.DOI", message)]
    return []


def _measure_all(
    meshes: list[MeshEntry], measurer: Measurer, cache: Path, root: Path, report: ValidationReport
) -> None:
    for mesh in meshes:
        if mesh.kind == "url":
            continue
        try:
            if mesh.kind == "made":
                mesh.local = make(mesh, root, cache)
            if mesh.local is None or not mesh.local.is_file() or mesh.local.stat().st_size > LARGEST_FILE * 4:
                continue
            mesh.facts = measurer.facts(mesh.local)
        except (HexaLabError, MakingError) as error:
            report.problems.append(problem_of(mesh, str(error)))
            continue
        report.problems += disagreements(mesh)
        report.meshes.append(mesh)


def _folder_problems(folder: Path, listed: list[str], root: Path) -> list[Problem]:
    """What lies in a source's folder and shouldn't."""
    problems = []
    total = 0
    for file in sorted(folder.rglob("*")):
        path = file.relative_to(folder).as_posix()
        shown = file.relative_to(root).as_posix()
        if "__pycache__" in file.parts:
            continue
        if file.is_symlink():
            problems.append(Problem("error", shown, 0, "", "a symbolic link; only plain files are taken"))
        elif not file.is_file():
            if not file.is_dir():
                problems.append(Problem("error", shown, 0, "", "not a plain file"))
        else:
            total += file.stat().st_size
            if file.stat().st_mode & stat.S_IXUSR:
                problems.append(
                    Problem("error", shown, 0, "", "is executable; take that right away (chmod -x)")
                )
            if path not in listed and path not in KNOWN_FILES:
                what = (
                    "a mesh that source.yaml doesn't list" if ending(path) else "not a file that belongs here"
                )
                severity = "error" if not ending(path) else "warning"
                problems.append(Problem(severity, shown, 0, "", what))
    if total > LARGEST_SOURCE:
        message = f"{file_size(total)} in all, but at most {file_size(LARGEST_SOURCE)} may lie in a source"
        problems.append(Problem("error", folder.relative_to(root).as_posix(), 0, "", message))
    return problems


def _repeated_files(meshes: list[MeshEntry]) -> list[Problem]:
    """Two rows whose files are the same, byte by byte."""
    first: dict[str, MeshEntry] = {}
    problems = []
    for mesh in meshes:
        if mesh.local and mesh.local.is_file():
            other = first.setdefault(hashlib.sha256(mesh.local.read_bytes()).hexdigest(), mesh)
            if other is not mesh:
                problems.append(problem_of(mesh, f"the same file as {other.path!r}"))
    return problems


def _headline(errors: int, warnings: int, meshes: int) -> str:
    read = f"{meshes:,} {'mesh' if meshes == 1 else 'meshes'} read"
    if errors:
        return f"Refused: {errors} {'error' if errors == 1 else 'errors'}; {read}"
    noted = f", {warnings} {'warning' if warnings == 1 else 'warnings'}" if warnings else ""
    return f"Accepted: {read}{noted}"


def _table(meshes: list[MeshEntry]) -> list[str]:
    rows = ["### Measurements", ""]
    rows.append(
        "| mesh | cells | vertices | min SJ | mean SJ | irregular edges | sheets | blocks | class | validity | size |"
    )
    rows.append("|---|--:|--:|--:|--:|--:|--:|--:|---|---|--:|")
    for mesh in meshes:
        facts = mesh.facts
        cells = [
            _md(mesh.id), count(facts.cells), count(facts.vertices), number(facts.sj_min), number(facts.sj_mean),
            count(facts.irregular_edges), count(facts.sheets), count(facts.blocks), structure_word(facts),
            verdict(facts)[1], file_size(facts.bytes),
        ]  # fmt: skip
        rows.append("| " + " | ".join(cells) + " |")
    findings = [(mesh, finding) for mesh in meshes for finding in mesh.facts.findings or []]
    if findings:
        rows += ["", "### Diagnosis", ""]
        rows += [f"- {_md(mesh.id)}: {_md(finding['message'])}" for mesh, finding in findings]
    return rows


def _line(problem: Problem) -> str:
    return f" line {problem.line}:" if problem.line else ":"


def _code(text: str) -> str:
    return f"`{text.replace('`', '')}`: " if text else ""


def _md(text: str) -> str:
    """Text that Markdown shows as it is, on one line."""
    plain = " ".join(text.split())
    return "".join("\\" + letter if letter in "\\`*_{}[]<>|#@" else letter for letter in plain)
