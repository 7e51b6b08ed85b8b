"""The pages: templates filled with what the catalogue knows. Everything from YAML is escaped by Jinja."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from markupsafe import Markup

from ..citing.citations import STYLES, citation, plain
from ..citing.exports import bibtex
from ..model.catalogue import Catalogue, MeshEntry, Source
from ..model.methods import METHODS
from ..model.models import Model
from ..model.names import on_this_machine
from ..pictures.collection import Collection
from ..tables.field import field_of
from . import interface, metadata, words
from .assets import assets
from .bodies import bodies
from .compact import compact
from .embedding import embedding_values
from .environment import environment
from .front import front_values
from .indexes import INDEX_VERSION
from .keeping import connections, weight
from .memory import Memory
from .mesh_page import mesh_values
from .model_pages import model_values, models_values
from .numbers import Numbers, numbers_values
from .picture_pages import gallery_values, guide_values
from .source_page import source_values
from .structure_guide import structure_guide_values


class Pages:
    """Renders every page of the catalogue.

    Parameters
    ----------
    catalogue : Catalogue
    pictures : set of str
        Addresses of the thumbnails that the site has.
    collection : Collection
        What gallery and guide show.
    figures : dict of str to (int, int)
        Widths and heights of those of its pictures that the site has, by address.
    numbers : Numbers
        Table and plots of all meshes.
    installable : bool
        Whether the site has the viewer, and can be installed as an application.
    memory : Path, optional
        Folder of pages that were made before.
    """

    def __init__(
        self,
        catalogue: Catalogue,
        pictures: set[str],
        collection: Collection | None = None,
        figures: dict[str, tuple[int, int]] | None = None,
        *,
        numbers: Numbers | None = None,
        installable: bool = False,
        memory: Path | None = None,
    ) -> None:
        self._catalogue = catalogue
        self._memory = Memory(catalogue, pictures, memory, str(installable))
        self._pictures = pictures
        self._collection = collection or Collection(catalogue)
        self._bodies = bodies(catalogue)
        self._numbers = numbers or Numbers(field_of(catalogue.meshes))
        self._citations: dict[str, dict[str, Markup]] = {}
        self._environment = environment()
        self._environment.filters.update(
            count=words.count,
            number=words.number,
            file_size=words.file_size,
            percent=words.whole_percent,
            breakable=words.breakable,
        )
        self._environment.globals.update(
            catalogue=catalogue,
            bodies=self._bodies,
            methods=METHODS,
            pictures=pictures,
            plural=words.plural,
            published=not on_this_machine(catalogue.address),
            picture=lambda mesh: mesh.picture_address in pictures,
            size=lambda figure: (figures or {}).get(figure.address),
            short_verdict=words.short_verdict,
            verdict=words.verdict,
            structure_line=words.structure_line,
            kinds=words.kinds,
            citations=self.citations,
            bibtex=lambda source: bibtex([source.reference]),
            licence_address=lambda licence: metadata.LICENCES[licence],
            format_name=metadata.format_name,
            og_picture=next(
                (m.picture_address for m in catalogue.meshes if m.picture_address in pictures), ""
            ),
            json_ld=None,
            interface=interface.installed(),
            assets=assets(),
            installable=installable,
            connect="",
            frames="",
            weight=weight,
        )

    def all(self) -> Iterator[tuple[str, str]]:
        """Every page: its folder below the site's root, ending in a slash or empty, and its HTML."""
        yield "", self.front()
        yield "gallery/", self.gallery()
        yield "guide/", self.guide()
        yield "guide/structure/", self.structure()
        yield "guide/embedding/", self.embedding()
        yield "embed/", self.embed()
        yield "numbers/", self.numbers()
        yield "about/", self.about()
        yield "offline/", self.offline()
        yield "offline/missing/", self.missing()
        memory = self._memory
        if interface.installed():
            yield from memory.pages(memory.interface, lambda: [("python/", self.interface())])
        yield from memory.pages(memory.bodies, self._of_bodies)
        for source in self._catalogue.sources:
            yield from memory.pages(memory.of(source), partial(self._of_source, source))

    def _of_bodies(self) -> Iterator[tuple[str, str]]:
        if self._bodies:
            yield "models/", self._render("models", "models/", **models_values(list(self._bodies.values())))
        for body in self._bodies.values():
            yield body.model.page, self.model(body.model)

    def _of_source(self, source: Source) -> Iterator[tuple[str, str]]:
        yield source.page, self.source(source)
        for mesh in source.meshes:
            yield mesh.page, self.mesh(mesh)

    def front(self) -> str:
        """The front page, with the first cards and all sources."""
        values = front_values(self._catalogue, self._collection, self._pictures)
        return self._render("front", "", **values, json_ld=metadata.catalogue_json_ld(self._catalogue))

    def about(self) -> str:
        """What the numbers mean, whose data they are, what there is for programs."""
        return self._render(
            "about",
            "about/",
            heading=f"About {self._catalogue.title}",
            description=self._catalogue.description or self._catalogue.title,
            index_version=INDEX_VERSION,
        )

    def numbers(self) -> str:
        """All meshes at once: plots, figures, and the table of which they are made."""
        return self._render("numbers", "numbers/", **numbers_values(self._catalogue, self._numbers))

    def offline(self) -> str:
        """What the browser keeps, and how to free it."""
        return self._render(
            "offline",
            "offline/",
            heading="Offline",
            description="What this browser keeps of HexaLab, so that it works without a network.",
        )

    def missing(self) -> str:
        """What stands for a page that this browser has not kept, when there is no network."""
        return self._render(
            "missing",
            "offline/missing/",
            heading="This page is not kept here",
            description="Without a network, pages that were visited can be seen.",
        )

    def gallery(self) -> str:
        """Every mode and light side by side."""
        return self._render("gallery", "gallery/", **gallery_values(self._collection))

    def guide(self) -> str:
        """What each tool does, with a picture."""
        return self._render("guide", "guide/", **guide_values(self._collection))

    def structure(self) -> str:
        """What the words of the global structure mean, each with a picture."""
        values = structure_guide_values(self._catalogue, self._collection)
        return self._render("structure_guide", "guide/structure/", **values)

    def embedding(self) -> str:
        """How a mesh is shown in another page, with examples that run."""
        local = [mesh for mesh in self._catalogue.meshes if not mesh.remote]
        pictured = [mesh for mesh in local if mesh.picture_address in self._pictures]
        example = next(iter(pictured or local), None)
        return self._render("embedding", "guide/embedding/", example=example, **embedding_values())

    def embed(self) -> str:
        """The poster that stands in a frame until its mesh is asked for."""
        return self._render(
            "embed", "embed/", heading="A mesh in HexaLab", description="A hexahedral mesh to look into."
        )

    def interface(self) -> str:
        """Every public name of the Python package."""
        return self._render("interface", "python/", **interface.interface_values())

    def model(self, model: Model) -> str:
        """A body's page: its meshes side by side."""
        return self._render("model", model.page, **model_values(self._bodies[model.id], self._pictures))

    def source(self, source: Source) -> str:
        """A source's page."""
        return self._render(
            "source",
            source.page,
            source=source,
            heading=source.title,
            description=metadata.describe_source(source),
            highwire=metadata.highwire(source),
            json_ld=metadata.source_json_ld(self._catalogue, source),
            **source_values(source, self._pictures),
        )

    def mesh(self, mesh: MeshEntry) -> str:
        """A mesh's page."""
        return self._render(
            "mesh",
            mesh.page,
            mesh=mesh,
            source=mesh.source,
            heading=f"{mesh.name} · {mesh.source.title}",
            description=metadata.describe_mesh(mesh),
            highwire=metadata.highwire(mesh.source),
            connect=connections([mesh]),
            cite_mesh=self._cite_mesh(mesh),
            json_ld=metadata.mesh_json_ld(self._catalogue, mesh),
            **mesh_values(mesh),
        )

    def citations(self, source: Source) -> dict[str, Markup]:
        """The source's reference in each style."""
        if source.slug not in self._citations:
            self._citations[source.slug] = {style: citation(source.reference, style) for style in STYLES}
        return self._citations[source.slug]

    def _cite_mesh(self, mesh: MeshEntry) -> str:
        text = plain(self.citations(mesh.source)["APA"])
        text += "" if text.endswith(".") or "://" in text.split()[-1] else "."
        digest = f", SHA-256 {mesh.sha256[:16]}…" if mesh.sha256 else ""
        return f"Mesh “{mesh.name}” ({mesh.file_name}{digest}) of: {text}"

    def _render(self, template: str, page: str, **values: Any) -> str:
        root = "../" * page.count("/")
        picture = self._picture_of(values)
        if picture:
            values["og_picture"] = picture
        return compact(
            self._environment.get_template(f"{template}.html.jinja").render(root=root, page=page, **values)
        )

    def _picture_of(self, values: dict[str, Any]) -> str:
        """The picture that stands for a page: its mesh's, or that of its source's first mesh that has one."""
        meshes = (
            [values["mesh"]] if "mesh" in values else values["source"].meshes if "source" in values else []
        )
        found = (mesh.picture_address for mesh in meshes if mesh.picture_address in self._pictures)
        return next(found, "")
