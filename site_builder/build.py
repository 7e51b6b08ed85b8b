"""Building the site: repository in, static pages out."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import unquote

from hexalab import HexaLabError

from .citing.exports import bibtex, csl_json, ris
from .kept import prune
from .measuring.making import MakingError, make
from .measuring.measurer import Measurer
from .model.catalogue import Catalogue, Problem
from .model.names import on_this_machine
from .model.problems import disagreements, problem_of
from .output import Output
from .pages import indexes, interface
from .pages.assets import assets
from .pages.bodies import bodies
from .pages.croissant import croissant
from .pages.model_csv import model_csv
from .pages.numbers import Numbers
from .pages.pages import Pages
from .pages.viewer_page import viewer_page
from .pages.words import file_size
from .pictures import Album, png_size, take_missing
from .pictures.collection import Collection
from .pictures.portrait import portrait
from .pictures.thumbnails import Thumbnails
from .plots import kept as plots
from .reading.gallery import read_gallery
from .reading.models import read_models
from .reading.repository import read_repository
from .tables import files as table
from .tables.field import field_of

ROOT = Path(__file__).resolve().parent.parent
STATIC = ROOT / "static"
ADDRESS_VARIABLE = "HEXALAB_SITE_ADDRESS"
"""Environment variable that says where the site will be, if not at the address in catalogue.yaml."""

Progress = Callable[[str, float], None]
"""Called with what is being done, and how much of all is done: 0 to 1."""


class BuildError(Exception):
    """The site can't be built; `problems` say why."""

    def __init__(self, problems: list[Problem]) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems


@dataclass
class BuildReport:
    """What a build has done.

    Parameters
    ----------
    pages, sources, meshes, measured, taken, changed : int
        Numbers of pages, sources and meshes in the site; of meshes measured, pictures taken and files changed in this
        run.
    seconds : float
    weight : int
        Bytes that a first visit brings over the wire, gzipped; 0 without the viewer.
    sizes : dict of str to int
        Bytes by the first part of the address.
    warnings : list of Problem
    notes : list of str
        What the site does without, a line each.
    """

    pages: int = 0
    sources: int = 0
    meshes: int = 0
    measured: int = 0
    taken: int = 0
    changed: int = 0
    seconds: float = 0.0
    weight: int = 0
    sizes: dict[str, int] = field(default_factory=dict)
    warnings: list[Problem] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def summary(self) -> str:
        """A few lines for the terminal."""
        largest = sorted(self.sizes.items(), key=lambda row: -row[1])
        return "\n".join(
            (
                f"{self.pages:,} pages, {self.sources} sources, {self.meshes:,} meshes "
                f"({self.measured} measured, {self.taken} pictures taken), {self.changed:,} files changed, "
                f"{file_size(sum(self.sizes.values()))} in {self.seconds:.1f} s",
                *(f"  {file_size(size):>9}  {name}" for name, size in largest),
                *([f"a first visit: {file_size(self.weight)} gzipped"] if self.weight else []),
                *self.notes,
            )
        )


def build(
    repository: Path,
    out: Path,
    strict: bool = False,
    progress: Progress | None = None,
    *,
    runtime: bool = True,
    pictures: bool = True,
    cache: Path | None = None,
) -> BuildReport:
    """Build the site.

    Parameters
    ----------
    repository : Path
        Folder of sources.
    out : Path
        Folder of the site; made if it isn't there.
    strict : bool
        Whether a warning stops the build.
    progress : callable, optional
        Told what is being done and how far it is.
    runtime : bool
        Whether to put the viewer and its Python into the site; without it, the catalogue's pages alone.
    pictures : bool
        Whether to take the pictures that are missing; those taken before are shown in any case.
    cache : Path, optional
        Folder of what is remembered between builds; `cache` beside `out` by default.

    Raises
    ------
    BuildError
        Something in the repository is wrong.
    """
    began, since = time.perf_counter(), time.time()
    tell = progress or (lambda what, part: None)
    cache = cache or out.parent / "cache"
    tell("reading the repository", 0.0)
    catalogue = read_repository(repository)
    sections = read_gallery(catalogue)
    read_models(catalogue)
    catalogue.address = os.environ.get(ADDRESS_VARIABLE) or catalogue.address or "http://localhost:8000/"
    _address_collections(catalogue)
    measurer = Measurer(cache)
    output = Output(out)
    previews = _add_meshes(catalogue, measurer, output, cache, tell)
    warnings = [problem for problem in catalogue.problems if problem.severity != "error"]
    if catalogue.errors or (strict and warnings):
        raise BuildError(catalogue.problems)
    _add_static(output)
    collected = {mesh.picture_address for mesh in catalogue.meshes if mesh.picture}
    output.write("catalogue.json", indexes.catalogue_json(catalogue, previews, collected))
    thumbnails = Thumbnails(cache)
    collection = Collection(catalogue, sections)
    album = Album(cache)
    taken, trouble, weight = 0, "", 0
    if runtime:
        tell("the viewer and its Python", 0.35)
        weight = _add_viewer(output, cache)
    if runtime and pictures:
        shots = [*map(thumbnails.shot, thumbnails.wanted(catalogue)), *collection.figures.values()]
        taken, trouble = take_missing(shots, out, album, lambda what, part: tell(what, 0.4 + 0.5 * part))
    shown = _add_pictures(catalogue, output, thumbnails)
    figures = _add_figures(collection, output, album)
    numbers = _add_numbers(catalogue, output, shown, cache)
    pages = Pages(
        catalogue, shown, collection, figures, numbers=numbers, installable=runtime, memory=cache / "pages"
    )
    addresses = []
    for number, (page, html) in enumerate(pages.all()):
        output.write(f"{page}index.html", html)
        addresses.append(page)
        if number % 50 == 0:
            tell(f"page {page or 'index.html'}", 0.9 + 0.1 * number / (len(catalogue.meshes) + 40))
    for body in bodies(catalogue).values():
        output.write(body.model.table, model_csv(body, catalogue.address))
    listed = [page for page in addresses if not page.startswith(("offline/", "embed/"))]
    _add_indexes(catalogue, output, listed, shown)
    if runtime:
        _add_manifest(catalogue, output, collection, figures, cache)
        _add_service_worker(catalogue, output)
    output.clean()
    prune(cache, since)
    tell("done", 1.0)
    return BuildReport(
        pages=len(addresses),
        sources=len(catalogue.sources),
        meshes=len(catalogue.meshes),
        measured=measurer.measured,
        taken=taken,
        changed=output.changed,
        seconds=time.perf_counter() - began,
        weight=weight,
        sizes=_sizes(out),
        warnings=warnings,
        notes=[
            *([trouble] if trouble else []),
            *(part.NOT_INSTALLED for part in (interface, table, plots) if not part.installed()),
        ],
    )


def _address_collections(catalogue: Catalogue) -> None:
    """A collection that is published nowhere else is cited by its page here, once the site has a lasting address."""
    for source in catalogue.sources:
        if source.own and not on_this_machine(catalogue.address):
            source.reference.setdefault("URL", catalogue.address + source.page)


def _add_meshes(
    catalogue: Catalogue, measurer: Measurer, output: Output, cache: Path, tell: Progress
) -> set[str]:
    """Make, measure and copy the meshes that lie here; give the addresses of their previews."""
    previews: set[str] = set()
    here = [mesh for mesh in catalogue.meshes if mesh.kind != "url"]
    for number, mesh in enumerate(here):
        tell(f"mesh {mesh.id}", 0.02 + 0.3 * number / len(here))
        try:
            if mesh.kind == "made":
                mesh.local = make(mesh, catalogue.root, cache)
            if mesh.local is None or not mesh.local.is_file():
                continue
            mesh.facts = measurer.facts(mesh.local)
            preview = measurer.preview(mesh.local, mesh.facts, portrait(mesh.facts))
        except (HexaLabError, MakingError) as error:
            catalogue.problems.append(problem_of(mesh, str(error)))
            continue
        catalogue.problems.extend(disagreements(mesh))
        output.copy(unquote(mesh.file_address), mesh.local)
        output.write(mesh.preview_address, preview)
        previews.add(mesh.preview_address)
    return previews


def _add_pictures(catalogue: Catalogue, output: Output, thumbnails: Thumbnails) -> set[str]:
    pictures = set()
    for mesh in catalogue.meshes:
        picture = mesh.picture if mesh.remote else thumbnails.thumbnail(mesh)
        if picture:
            output.copy(mesh.picture_address, picture)
            pictures.add(mesh.picture_address)
    return pictures


def _add_figures(collection: Collection, output: Output, album: Album) -> dict[str, tuple[int, int]]:
    """Copy the pictures of gallery and guide; give their widths and heights by their addresses."""
    figures = {}
    for address, shot in collection.figures.items():
        picture = album.picture(shot)
        if picture:
            output.copy(address, picture)
            figures[address] = png_size(picture)
    for address, picture in collection.stills.items():
        output.copy(address, picture)
        figures[address] = png_size(picture)
    return figures


def _add_numbers(catalogue: Catalogue, output: Output, pictures: set[str], cache: Path) -> Numbers:
    """The table of all meshes and what describes it; give what the page about them shows."""
    rows = table.table_of(catalogue.meshes, catalogue.address, pictures)
    files = table.files_of(rows, cache)
    for address, content in files.items():
        output.write(address, content)
    output.write("croissant.json", indexes.dump(croissant(catalogue, files)))
    published = field_of(catalogue.meshes)
    return Numbers(published, files, plots.drawn(published, cache, "../"))


def _add_static(output: Output) -> None:
    """Styles, scripts of the pages, icon."""
    for address, content in assets().files.items():
        output.write(address, content)
    for name in ("icon.svg", "badge.svg"):
        output.copy(name, STATIC / name)


def _add_indexes(catalogue: Catalogue, output: Output, pages: list[str], pictures: set[str]) -> None:
    output.write("index.json", indexes.index_json(catalogue, pictures))
    output.write("search.json", indexes.search_json(catalogue, pictures))
    output.write("datasets/index.json", indexes.original_index(catalogue))
    output.write("sitemap.xml", indexes.sitemap(catalogue, pages))
    output.write("robots.txt", f"User-agent: *\nAllow: /\nSitemap: {catalogue.address}sitemap.xml\n")
    for name, writer in (("bib", bibtex), ("ris", ris), ("csl.json", csl_json)):
        output.write(f"catalogue.{name}", writer(source.reference for source in catalogue.sources))
        for source in catalogue.sources:
            output.write(f"{source.page}{source.slug}.{name}", writer([source.reference]))


def _add_viewer(output: Output, cache: Path) -> int:
    """Put the viewer into the site; give the bytes that a first visit brings over the wire."""
    try:
        from .runtime import MOST, SHEET, assemble, first_visit, gzipped, sheet

        report = assemble(output.root)
        output.write(f"viewer/{SHEET}", sheet(ROOT))
    except (ImportError, RuntimeError, OSError) as error:
        message = f"the viewer can't be put together: {error}; `make build` installs what it needs"
        raise BuildError([Problem("error", "site_builder/runtime", 0, "", message)]) from error
    html = viewer_page(
        "site",
        root="../",
        start="../" + report.scripts["start"],
        script="../" + report.scripts["main"],
        imports=tuple("../" + script for script in report.imports),
        worker="../" + report.scripts["worker"],
        runtime="../" + report.runtime,
        style="../" + assets().styles["viewer"],
        icon="../icon.svg",
    )
    output.write("viewer/index.html", html)
    scripts = [*report.scripts.values(), *report.imports]
    files = first_visit(output.root, assets().styles["viewer"], scripts, report.runtime)
    weight = gzipped(files, cache)
    if weight > MOST:
        message = f"a first visit weighs {file_size(weight)} gzipped, {file_size(MOST)} are allowed"
        raise BuildError([Problem("error", "site_builder/runtime", 0, "", message)])
    return weight


def _add_manifest(
    catalogue: Catalogue,
    output: Output,
    collection: Collection,
    figures: dict[str, tuple[int, int]],
    cache: Path,
) -> None:
    """What makes the site an application that can be installed."""
    from .pages.manifest import APPLE_ICON, ICONS, PAPER, manifest
    from .runtime import icon

    drawing = (STATIC / "icon.svg").read_text("utf-8")
    for address, (side, purpose) in ICONS.items():
        output.write(address, icon(drawing, side, PAPER if purpose == "maskable" else "", cache))
    address, side = APPLE_ICON
    output.write(address, icon(drawing, side, PAPER, cache))
    output.write("manifest.webmanifest", manifest(catalogue, collection.screens, figures))


def _add_service_worker(catalogue: Catalogue, output: Output) -> None:
    """What makes the site work without a network: the viewer, and the catalogue's pages but those of its meshes."""
    from .runtime import service_worker

    shell = {"index.html", "viewer/index.html", "offline/missing/index.html", "catalogue.json", "search.json"}
    shell |= {"icon.svg", "about/index.html", "offline/index.html", "manifest.webmanifest", *assets().files}
    shell |= {f"{source.page}index.html" for source in catalogue.sources}
    for folder in ("viewer", "runtime-*"):
        files = (file for top in output.root.glob(folder) for file in top.glob("*") if file.suffix != ".map")
        shell |= {file.relative_to(output.root).as_posix() for file in files}
    output.write("service_worker.js", service_worker(ROOT, output.root, shell))


def _sizes(out: Path) -> dict[str, int]:
    sizes: dict[str, int] = {}
    for file in out.rglob("*"):
        if file.is_file():
            parts = file.relative_to(out).parts
            name = parts[0] + "/" if len(parts) > 1 else "at the root"
            sizes[name] = sizes.get(name, 0) + file.stat().st_size
    return sizes
