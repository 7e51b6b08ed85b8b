"""What a batch leaves: a folder or an archive with pictures, histograms, and the table of all measurements."""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Sequence
from pathlib import Path

from .jobs import Job
from .records import KEPT, Outcome

EPOCH = (1980, 1, 1, 0, 0, 0)


class Results:
    """Collects outcomes.

    Parameters
    ----------
    target : Path
        A folder, or an archive if it ends in .zip, beside which a folder has what is done so far.
    """

    def __init__(self, target: Path) -> None:
        self.target = target
        self.zipped = target.suffix.lower() == ".zip"
        self.folder = target.with_name(f"{target.name}.partial") if self.zipped else target

    def begin(self, resume: bool) -> None:
        """Make the folder; forget what was done before, unless that is gone on with."""
        if not resume and (self.zipped or (self.folder / KEPT).is_dir()):
            shutil.rmtree(self.folder if self.zipped else self.folder / KEPT, ignore_errors=True)
        self.folder.mkdir(parents=True, exist_ok=True)

    def write_tables(self, jobs: Sequence[Job], outcomes: dict[str, Outcome]) -> None:
        """Write measurements.csv and measurements.json of what is done, in the order of the jobs."""
        done = [outcomes[job.stem] for job in jobs if job.stem in outcomes]
        table = to_csv([outcome["line"] for outcome in done])
        (self.folder / "measurements.csv").write_bytes(table.encode())
        document = {"meshes": [outcome["measured"] for outcome in done]}
        text = json.dumps(document, indent=1, ensure_ascii=False) + "\n"
        (self.folder / "measurements.json").write_bytes(text.encode())

    def finish(self) -> None:
        """Of an archive: put all into it, and remove the folder."""
        if not self.zipped:
            return
        half = self.target.with_name(f"{self.target.name}.half")
        with zipfile.ZipFile(half, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in sorted(self.folder.rglob("*")):
                name = path.relative_to(self.folder).as_posix()
                if path.is_file() and not name.startswith(f"{KEPT}/"):
                    archive.writestr(zipfile.ZipInfo(name, EPOCH), path.read_bytes(), zipfile.ZIP_DEFLATED)
        half.replace(self.target)
        shutil.rmtree(self.folder)


def to_csv(rows: Sequence[dict[str, str]]) -> str:
    """A table (RFC 4180) with all columns that any row has, in the order in which they are met."""
    columns = list(dict.fromkeys(column for row in rows for column in row))
    lines = [columns, *([row.get(column, "") for column in columns] for row in rows)]
    return "".join(",".join(map(_cell, line)) + "\r\n" for line in lines)


def _cell(text: str) -> str:
    return '"' + text.replace('"', '""') + '"' if any(mark in text for mark in ',"\r\n') else text
