"""Collecting: which meshes are due, where their files come from, and what is written of each as soon as it is done."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

from ..measuring.fetching import Fetcher, FetchError
from ..measuring.mirror import Mirror
from ..model.catalogue import MeshEntry, Source
from ..model.facts import Facts
from ..model.published import FACTS_FILE, PICTURES, VERSION, Collected, write_published
from ..pictures.portrait import portrait
from .jobs import CollectJob, Outcome, job_of
from .work import shown

SIDE_BY_SIDE = 3
"""Files that are fetched at a time."""

Tell = Callable[[str, float], None]
"""Called with what is being done, and how much of all is done: 0 to 1."""

Do = Callable[[Sequence[CollectJob]], Generator[Outcome]]
"""Does jobs, and gives what came of each as it is done."""


@dataclass
class Report:
    """What came of collecting, meshes by their ids.

    Parameters
    ----------
    before, collected, unchanged : list of str
        Done before and not looked at again; measured now; looked at again and found to be the same.
    changed : dict of str to (str, str)
        The SHA-256 before and now.
    absent : list of str
        Not in the mirror.
    failed : dict of str to str
        Why.
    """

    before: list[str] = field(default_factory=list)
    collected: list[str] = field(default_factory=list)
    unchanged: list[str] = field(default_factory=list)
    changed: dict[str, tuple[str, str]] = field(default_factory=dict)
    absent: list[str] = field(default_factory=list)
    failed: dict[str, str] = field(default_factory=dict)

    @property
    def summary(self) -> str:
        """One line for the terminal."""
        counts = (
            (len(self.collected), "collected"),
            (len(self.unchanged), "unchanged"),
            (len(self.before), "done before"),
            (len(self.changed), "changed"),
            (len(self.absent), "not in the mirror"),
            (len(self.failed), "failed"),
        )
        return ", ".join(f"{count:,} {word}" for count, word in counts if count) or "no remote mesh"


class Collector:
    """Collects the remote meshes of sources.

    Parameters
    ----------
    sources : iterable of Source
        As `read_repository` gives them.
    files : Mirror or Fetcher
        Where their files come from.
    only : sequence of str
        Ids of meshes that are meant alone in their sources; of a source none of whose meshes is named, all are.
    check : bool
        Whether what was collected before is looked at again, to see whether it has changed.
    again : bool
        Whether it is measured and portrayed again in any case.
    """

    def __init__(
        self,
        sources: Iterable[Source],
        files: Mirror | Fetcher,
        only: Sequence[str] = (),
        *,
        check: bool = False,
        again: bool = False,
    ) -> None:
        self.report = Report()
        self._files = files
        self._again = again
        self._etags: dict[str, str] = {}
        self._remote = {mesh.id: mesh for source in sources for mesh in meant(source, only) if mesh.remote}
        self._due = [mesh for mesh in self._remote.values() if again or check or not is_done(mesh)]
        self.report.before = [id for id in self._remote if id not in {mesh.id for mesh in self._due}]

    def run(self, do: Do, tell: Tell) -> Report:
        """Collect what is due; a mesh that fails is reported, and the rest goes on.

        Parameters
        ----------
        do : callable
        tell : callable
        """
        jobs = list(self._at_hand(tell))
        with closing(do(jobs)) as outcomes:
            for number, outcome in enumerate(outcomes, 1):
                self._take(outcome)
                tell(outcome["id"], 0.3 + 0.7 * number / len(jobs))
        return self.report

    def _at_hand(self, tell: Tell) -> Generator[CollectJob]:
        """The jobs of the meshes that are due and whose files can be had, unless these are what was measured before."""
        with ThreadPoolExecutor(SIDE_BY_SIDE) as threads:
            try:
                found = threads.map(self._obtain, self._due)
                for number, (mesh, file) in enumerate(zip(self._due, found, strict=True), 1):
                    if file and not (not self._again and is_done(mesh) and self._is_the_same(mesh, file)):
                        yield job_of(mesh, str(file.resolve()))
                    tell(f"fetching, {number} of {len(self._due)}", 0.3 * number / len(self._due))
            except BaseException:
                if isinstance(self._files, Fetcher):
                    self._files.stop()
                threads.shutdown(cancel_futures=True)
                raise

    def _obtain(self, mesh: MeshEntry) -> Path | None:
        """The file of a mesh; None, and a line in the report, if it can't be had or its server says it's the same."""
        if isinstance(self._files, Mirror):
            copy = self._files.find(mesh.remote)
            if copy is None:
                self.report.absent.append(mesh.id)
            return copy
        kept = mesh.collected if is_done(mesh) and not self._again else None
        try:
            fetched = self._files.fetch(mesh.remote, kept.etag if kept else "")
        except FetchError as error:
            self.report.failed[mesh.id] = str(error)
            return None
        self._etags[mesh.id] = fetched.etag
        if fetched.file is None:
            self.report.unchanged.append(mesh.id)
        return fetched.file

    def _is_the_same(self, mesh: MeshEntry, file: Path) -> bool:
        """Whether a file is the one that was measured before; by what its server calls it, it is known from now on."""
        with file.open("rb") as stream:
            if hashlib.file_digest(stream, "sha256").hexdigest() != mesh.facts.sha256:
                return False
        etag = self._etags.get(mesh.id, "")
        if etag and mesh.collected:
            mesh.collected.etag = etag
            write_source(mesh.source)
        self._forget(mesh)
        self.report.unchanged.append(mesh.id)
        return True

    def _forget(self, mesh: MeshEntry) -> None:
        if isinstance(self._files, Fetcher):
            self._files.forget(mesh.remote)

    def _take(self, outcome: Outcome) -> None:
        """Write down what came of a mesh: its picture first, so that facts never speak of one that isn't there."""
        mesh = self._remote[outcome["id"]]
        if outcome["problem"]:
            self.report.failed[mesh.id] = outcome["problem"]
            return
        facts = Facts.from_dict(outcome["facts"])
        before = mesh.facts.sha256
        place = mesh.source.folder / PICTURES / f"{mesh.slug}.webp"
        place.parent.mkdir(exist_ok=True)
        half = place.with_suffix(".half")
        half.write_bytes(base64.b64decode(outcome["picture"]))
        half.replace(place)
        mesh.facts, mesh.picture = facts, place
        mesh.collected = Collected(facts, self._etags.get(mesh.id, ""), outcome["shows"])
        write_source(mesh.source)
        self._forget(mesh)
        if before and before != facts.sha256:
            self.report.changed[mesh.id] = (before, facts.sha256 or "")
        else:
            self.report.collected.append(mesh.id)


def meant(source: Source, only: Sequence[str]) -> list[MeshEntry]:
    """The meshes of a source that are named, or all if none is."""
    return [mesh for mesh in source.meshes if mesh.id in only] or source.meshes


def is_done(mesh: MeshEntry) -> bool:
    """Whether a mesh is measured as it would be now, and its picture shows what it would show now."""
    kept = mesh.collected
    if kept is None or kept.version != VERSION or mesh.picture is None or not kept.facts.view:
        return False
    if mesh.up and not points_up(kept.facts, mesh.up):
        return False
    return kept.picture == shown(kept.facts.sha256 or "", portrait(kept.facts))


def points_up(facts: Facts, axis: str) -> bool:
    """Whether a mesh is looked at with an axis pointing up."""
    sign, at = (-1.0, "xyz".index(axis[1:])) if axis.startswith("-") else (1.0, "xyz".index(axis))
    return facts.view is not None and facts.view["up"][at] == sign


def write_source(source: Source) -> None:
    """Write down what is known of a source's remote meshes, in the order of its source.yaml."""
    known = {mesh.key: mesh.collected for mesh in source.meshes if mesh.collected}
    write_published(source.folder / FACTS_FILE, known)
