"""The plots of the catalogue: drawn once, and again if what they show or how they are drawn has changed."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from ..kept import remember
from ..tables.field import Field
from .points import Chosen, points_of
from .svg import page_svg
from .table import PLOTS, Plot

NOT_INSTALLED = "the plots of the catalogue are left out: matplotlib is not installed"


@dataclass(frozen=True)
class Drawn:
    """A plot for a page.

    Parameters
    ----------
    plot : Plot
    name : str
        With which the ids in it begin.
    svg : str
    families : dict of str to int
        Families that have points in it, and how many.
    notes : list of str
        What is not drawn, and why.
    """

    plot: Plot
    name: str
    svg: str
    families: dict[str, int]
    notes: list[str]


def installed() -> bool:
    """Whether the library that draws is here."""
    return find_spec("matplotlib") is not None


def drawn(field: Field, cache: Path, root: str) -> list[Drawn]:
    """All plots of a field that has something to draw.

    Parameters
    ----------
    field : Field
    cache : Path
        Folder of what is remembered between builds.
    root : str
        From the page to the site's root.
    """
    found = []
    for number, plot in enumerate(PLOTS):
        chosen = points_of(plot, field)
        if chosen.points and installed():
            name = f"p{number}"
            svg = _svg(plot, name, chosen, field, cache, root)
            families = dict(Counter(point.family for point in chosen.points))
            found.append(Drawn(plot, name, svg, families, chosen.notes))
    return found


def _svg(plot: Plot, name: str, chosen: Chosen, field: Field, cache: Path, root: str) -> str:
    kept = cache / "plots" / f"{plot.id}-{_key(plot, name, chosen, field, root)}.svg"
    return remember(kept, lambda: _draw(plot, name, chosen, field, root)).read_text("utf-8")


def _draw(plot: Plot, name: str, chosen: Chosen, field: Field, root: str) -> bytes:
    from .drawing import draw

    text = f"{plot.x.label}, from left to right; {plot.y.label}, from bottom to top. {chosen.notes[0]}"
    image = draw(plot, chosen.points, field)
    return page_svg(image, name, plot.title, text, chosen.points, root).encode()


def _key(plot: Plot, name: str, chosen: Chosen, field: Field, root: str) -> str:
    """A hash of what is drawn, and of what draws it."""
    years: Sequence[object] = (
        [(m.source.year, m.facts.sj_min is None) for m in field.meshes] if plot.by_year else ()
    )
    shown = [name, root, chosen.notes, [list(asdict(point).values()) for point in chosen.points], years]
    digest = hashlib.sha256(json.dumps(shown).encode() + version("matplotlib").encode())
    for file in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(file.read_bytes())
    return digest.hexdigest()[:32]
