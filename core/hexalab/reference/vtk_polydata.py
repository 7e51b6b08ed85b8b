"""Legacy `.vtk` with DATASET POLYDATA: POINTS, POLYGONS and TRIANGLE_STRIPS, in both forms, ASCII and binary.

Points, lines and what is known of points and cells are left out, the first two with a note.
"""

from __future__ import annotations

from ..formats.file import File
from ..formats.tokens import NUMBER, quoted
from ..formats.vtk_attributes import SECTIONS
from ..formats.vtk_datasets import refusal
from ..formats.vtk_legacy import CellRows
from ..formats.vtk_legacy import Reader as LegacyReader
from .polygons import Polygons, surface_of
from .strips import cut_strips
from .surface import TriangleSurface

FACES = ("polygons", "triangle_strips")

LEFT_OUT = {"vertices": "points", "lines": "lines"}
"""Sections of cells that are no faces, and what to call them."""

AFTER_IT = ("point_data", "cell_data")


def read(file: File) -> TriangleSurface:
    """Read the bytes of a `.vtk` file of polygons; raises MeshReadError."""
    return Reader(file).surface()


class Reader(LegacyReader):
    """One pass over the file up to its attributes."""

    def __init__(self, file: File) -> None:
        super().__init__(file)
        self.found: dict[str, CellRows] = {}

    def dataset(self) -> None:
        """Read the kind of data set; any but POLYDATA is an error that says what was found."""
        word = self.text.word().decode("latin-1")
        if word.lower() != "polydata":
            raise self.text.error(refusal(word, "POLYDATA"))

    def surface(self) -> TriangleSurface:
        """Read section after section.

        Raises
        ------
        MeshReadError
            A section is cut short or there twice, or there are no faces.
        """
        text = self.text
        while word := text.word():
            start = text.position - len(word)
            keyword = word.decode("latin-1").lower()
            if keyword in AFTER_IT:
                break
            if keyword == "dataset":
                self.dataset()
            elif keyword == "points":
                self.points()
            elif keyword in FACES or keyword in LEFT_OUT:
                if keyword in self.found:
                    raise text.error(f"a second section {keyword.upper()}, expected one", start)
                self.found[keyword] = self.rows(keyword.upper())
            elif keyword in SECTIONS:
                self.attributes.section(keyword)
            elif not self.found or NUMBER.fullmatch(word):
                raise text.error(
                    f"{quoted(word)} stands where a section was expected, such as POINTS or POLYGONS", start
                )
            else:
                line = text.file.line_number(start)
                self.out.note(f"Reading stopped at line {line}, which is not of the format: {quoted(word)}.")
                break
        return self.together()

    def together(self) -> TriangleSurface:
        """The surface of all polygons and strips."""
        text, out = self.text, self.out
        if out.coordinates is None:
            raise text.error("the file ends before its section POINTS")
        for keyword, name in LEFT_OUT.items():
            if keyword in self.found:
                out.leave_out(name, len(self.found[keyword][2]))
        if out.left_out:
            out.note(f"Left out, as they are no faces: {out.counts_left_out()}.")
        parts = []
        if "polygons" in self.found:
            parts.append(Polygons(*self.found["polygons"]))
        if "triangle_strips" in self.found:
            parts.append(cut_strips(*self.found["triangle_strips"]))
        return surface_of(text.file, "polydata", out.coordinates, parts, out.notes)
