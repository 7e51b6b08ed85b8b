"""The repository as the builder knows it: sources, their meshes, and what is wrong with them."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import NotRequired, TypedDict
from urllib.parse import quote

from .facts import Facts
from .models import Model
from .names import doi_address, ending
from .published import Collected


class Author(TypedDict, total=False):
    """A name in CSL-JSON: `family` and perhaps `given`, or `literal` for a group or a single name."""

    family: str
    given: str
    literal: str
    ORCID: str


Issued = TypedDict("Issued", {"date-parts": list[list[int]]})
"""A date in CSL-JSON: one list of year, perhaps month, perhaps day."""

Reference = TypedDict(
    "Reference",
    {
        "id": str,
        "type": str,
        "title": str,
        "author": list[Author],
        "issued": Issued,
        "container-title": NotRequired[str],
        "collection-title": NotRequired[str],
        "event-title": NotRequired[str],
        "publisher": NotRequired[str],
        "volume": NotRequired[str],
        "issue": NotRequired[str],
        "page": NotRequired[str],
        "number": NotRequired[str],
        "version": NotRequired[str],
        "abstract": NotRequired[str],
        "DOI": NotRequired[str],
        "URL": NotRequired[str],
    },
)
"""What to cite, as an item of CSL-JSON; `id` is the source's slug."""


@dataclass(frozen=True)
class Problem:
    """Something wrong in the repository, and where: an ``error`` stops a build, a ``warning`` a strict one."""

    severity: str
    file: str
    line: int
    field: str
    message: str

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        what = f"{self.field}: {self.message}" if self.field else self.message
        return f"{place}: {what}"


@dataclass(eq=False)
class MeshEntry:
    """One mesh of a source.

    Parameters
    ----------
    kind : "file" | "url" | "made"
        In the source's folder, elsewhere on the web, or made at build time.
    path : str
        As source.yaml names it, without percent-encoding: the file's path in its source.
    key : str
        As source.yaml names it, letter for letter.
    remote : str
        Absolute address of a remote file, "" for others.
    local : Path or None
        The file on this disk, once it is there.
    up : str
        The axis that points up, as "y" or "-z"; "" to have it guessed.
    same_as : str
        Slug of another of the source's meshes that this file holds too, in another format; "" for none.
    method : str
        Id of the family of methods that made it (`methods.METHODS`), "" if it is not said.
    domain : str
        What it fills, if not the body of its model (`domains.DOMAINS`).
    model, own_model : str, str or None
        Id of the body that it is a mesh of, "" for none; and what its row says of that, None for nothing.
    collected, picture : Collected or None, Path or None
        Of a remote mesh, what was measured of it before, and the picture that was taken.
    line, lines : int, dict of str to int
        Where source.yaml has its row, and each field of it.
    """

    source: Source
    slug: str
    name: str
    kind: str
    path: str
    key: str
    description: str = ""
    remote: str = ""
    local: Path | None = None
    declared_sha256: str | None = None
    declared_cells: int | None = None
    facts: Facts = field(default_factory=Facts)
    up: str = ""
    same_as: str = ""
    method: str = ""
    domain: str = ""
    model: str = ""
    own_model: str | None = None
    collected: Collected | None = None
    picture: Path | None = None
    line: int = 0
    lines: dict[str, int] = field(default_factory=dict)

    @property
    def id(self) -> str:
        """``source-slug/mesh-slug``: how the viewer's address names the mesh."""
        return f"{self.source.slug}/{self.slug}"

    @property
    def page(self) -> str:
        """Address of the mesh's page below the site's root."""
        return f"sources/{self.id}/"

    @property
    def file_address(self) -> str:
        """Address of the mesh file: absolute if remote, else below the site's root."""
        return self.remote or quote(f"meshes/{self.source.slug}/{self.path}")

    @property
    def preview_address(self) -> str:
        """Address of the preview below the site's root."""
        return f"meshes/{self.id}.preview"

    @property
    def picture_address(self) -> str:
        """Address of the thumbnail below the site's root: smaller and packed tighter for what lies elsewhere."""
        return f"pictures/{self.id}.{'webp' if self.remote else 'png'}"

    @property
    def file_name(self) -> str:
        """The last part of the file's path."""
        return self.path.rsplit("/", 1)[-1]

    @property
    def format(self) -> str:
        """The format's name by the file's ending."""
        return ending(self.path)

    @property
    def cells(self) -> int | None:
        """Number of cells, as measured or else as declared."""
        return self.facts.cells if self.facts.cells is not None else self.declared_cells

    @property
    def sha256(self) -> str | None:
        """Of the file, as measured or else as declared."""
        return self.facts.sha256 or self.declared_sha256


@dataclass(eq=False)
class Source:
    """A paper or a collection, with its meshes.

    Parameters
    ----------
    reference : Reference
        With `id`, `title`, `author` and `issued` at least.
    method : str
        Id of the family of methods that made its meshes (`methods.METHODS`), "" if it is not said.
    index_path : str
        Its folder in the original HexaLab's index, "" if it has none.
    """

    slug: str
    folder: Path
    reference: Reference
    licence: str
    method: str = ""
    licence_note: str = ""
    description: str = ""
    arxiv: str = ""
    pdf: str = ""
    web: str = ""
    index_path: str = ""
    contributors: list[str] = field(default_factory=list)
    doi_line: int = 0
    meshes: list[MeshEntry] = field(default_factory=list)

    @property
    def page(self) -> str:
        """Address of the source's page below the site's root."""
        return f"sources/{self.slug}/"

    @property
    def title(self) -> str:
        """The paper's title."""
        return str(self.reference["title"])

    @property
    def year(self) -> int:
        """Of publication."""
        return int(self.reference["issued"]["date-parts"][0][0])

    @property
    def doi(self) -> str:
        """The DOI, bare; "" if there is none."""
        return str(self.reference.get("DOI", ""))

    @property
    def doi_address(self) -> str:
        """Where the DOI resolves; "" if there is none."""
        return doi_address(self.doi) if self.doi else ""

    @property
    def authors(self) -> list[str]:
        """Names as they are read: given name first."""
        return [display_name(author) for author in self.reference["author"]]

    @property
    def short(self) -> str:
        """Who and when: "Livesu et al. 2013"; a collection by a group is called by its title."""
        authors = self.reference["author"]
        if "literal" in authors[0]:
            return self.title.split(":")[0]
        return f"{self.short_authors} {self.year}"

    @property
    def short_authors(self) -> str:
        """Who: "Livesu et al."; the name of a group."""
        names = [author.get("family") or author["literal"] for author in self.reference["author"]]
        return f"{names[0]} et al." if len(names) > 2 else " and ".join(names)

    @property
    def label(self) -> str:
        """Who, when and what: "Livesu et al. 2013: PolyCut"."""
        return self.title if self.title.startswith(self.short) else f"{self.short}: {self.title}"

    @property
    def venue(self) -> str:
        """Where it appeared: "Computer Graphics Forum 30(5), 1407-1416"."""
        item = self.reference
        text = str(item.get("container-title") or item.get("publisher") or "")
        volume, issue, page = (str(item.get(key, "")) for key in ("volume", "issue", "page"))
        if volume:
            text += f" {volume}" + (f"({issue})" if issue else "")
        if page:
            text += f", {page.replace('-', '–')}"
        elif volume and item.get("number"):
            text += f", article {item['number']}"
        return text

    @property
    def own(self) -> bool:
        """Whether it is a collection that is published nowhere else: what a paper or a DOI stands for is not."""
        return self.reference["type"] == "dataset" and not self.doi and not self.arxiv

    @property
    def listed(self) -> list[MeshEntry]:
        """Its meshes without those that are another one in another format."""
        return [mesh for mesh in self.meshes if not mesh.same_as]

    @property
    def elsewhere(self) -> bool:
        """Whether no mesh of it lies in the repository."""
        return all(mesh.kind == "url" for mesh in self.meshes)

    @property
    def belongs_to_authors(self) -> bool:
        """Whether nothing but reading is granted."""
        return self.licence == "authors"


@dataclass(eq=False)
class Catalogue:
    """All sources, what the catalogue says of itself, and the problems found while reading.

    Parameters
    ----------
    first, last : list of str
        Slugs of sources that are listed before and after all others, which go by year.
    hero : list of str
        Pictures of the gallery's folder that the front page opens with.
    """

    root: Path
    title: str = "HexaLab"
    description: str = ""
    address: str = ""
    publisher: str = ""
    first: list[str] = field(default_factory=list)
    last: list[str] = field(default_factory=list)
    hero: list[str] = field(default_factory=list)
    sources: list[Source] = field(default_factory=list)
    models: list[Model] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)

    @property
    def meshes(self) -> list[MeshEntry]:
        """Of all sources, in order."""
        return [mesh for source in self.sources for mesh in source.meshes]

    @property
    def listed(self) -> list[MeshEntry]:
        """Of all sources, without those that are another one in another format."""
        return [mesh for mesh in self.meshes if not mesh.same_as]

    @property
    def errors(self) -> list[Problem]:
        """Problems that stop a build."""
        return [problem for problem in self.problems if problem.severity == "error"]


def display_name(author: Author) -> str:
    """A CSL name as it is read: given name first."""
    return author.get("literal") or " ".join(
        part for part in (author.get("given"), author.get("family")) if part
    )
