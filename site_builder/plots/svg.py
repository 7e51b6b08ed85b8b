"""From the SVG that Matplotlib writes to one for a page: few bytes, classes instead of styles, points that link.

What was drawn carries a name that begins with `MARKED`; the rest of it is the class. Everything else is left out.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import escape
from itertools import groupby
from xml.etree import ElementTree

from .families import Look, look_of
from .points import Point

MARKED, POINTS = "c-", "points"
NAMESPACE = "{http://www.w3.org/2000/svg}"

Element = ElementTree.Element


def page_svg(drawn: str, name: str, title: str, text: str, points: Sequence[Point], root: str) -> str:
    """The plot for a page.

    To whoever hears the page it is a picture with a description. Its points are neither read out nor steps of the
    keyboard: there are thousands on a page, and the catalogue's search leads to the same meshes.

    Parameters
    ----------
    drawn : str
        What Matplotlib has written (`drawing.draw`).
    name : str
        With which ids begin; no other SVG of the page has it.
    title, text : str
        What it is, and what its axes are.
    points : sequence of Point
        In the order in which they were drawn.
    root : str
        From the page to the site's root.
    """
    tree = ElementTree.fromstring(drawn)
    parts: dict[str, list[Element]] = {}
    for kind, element in _marked(tree):
        parts.setdefault(kind, []).append(element)
    places = [(_short(use.get("x", "")), _short(use.get("y", ""))) for use in parts.pop(POINTS)]
    shapes = [
        f'<g class="{kind}">{"".join(map(_shape, _joined(elements)))}</g>' for kind, elements in parts.items()
    ]
    heads = f'<title id="{name}-title">{escape(title)}</title><desc id="{name}-text">{escape(text)}</desc>'
    return (
        f'<svg class="plot" viewBox="{tree.get("viewBox")}">'
        f'<g role="img" aria-labelledby="{name}-title" aria-describedby="{name}-text">{heads}\n'
        f"{''.join(shapes)}</g>\n"
        f'<g aria-hidden="true">{"".join(_families(name, points, places, root))}</g></svg>'
    )


def marker(name: str, look: Look) -> str:
    """The id of the outline of a family's points in a plot."""
    return f"{name}-{look.number}"


def _marked(element: Element, kind: str = "") -> Iterator[tuple[str, Element]]:
    """What was drawn under a name, with its class."""
    name = element.get("id", "")
    kind = name.removeprefix(MARKED) if name.startswith(MARKED) else kind
    tag = element.tag.removeprefix(NAMESPACE)
    if tag == "defs":
        return
    if kind and tag in ("path", "text", "use"):
        yield kind, element
    for inner in element:
        yield from _marked(inner, kind)


def _joined(elements: Sequence[Element]) -> Iterator[Element]:
    """Elements, their paths made one."""
    paths = [element for element in elements if element.tag == f"{NAMESPACE}path"]
    if paths:
        yield Element(paths[0].tag, {"d": "".join(_path(path.get("d", "")) for path in paths)})
    yield from (element for element in elements if element.tag != f"{NAMESPACE}path")


def _shape(element: Element) -> str:
    if element.tag == f"{NAMESPACE}path":
        return f'<path d="{element.get("d")}"/>'
    anchor = re.search(r"text-anchor: (\w+)", element.get("style", ""))
    where = f' text-anchor="{anchor[1]}"' if anchor else ""
    x, y = _short(element.get("x", "")), _short(element.get("y", ""))
    return f'<text{where} x="{x}" y="{y}">{escape(element.text or "")}</text>'


def _path(steps: str) -> str:
    """A path in few letters."""
    short = re.sub(r"-?\d+(\.\d+)?", lambda number: _short(number[0]), steps)
    return re.sub(r"\s*([A-Za-z])\s*", r"\1", short).strip()


def _short(number: str) -> str:
    """A coordinate with one decimal."""
    return f"{round(float(number), 1):g}"


def _families(
    name: str, points: Sequence[Point], places: Sequence[tuple[str, str]], root: str
) -> Iterator[str]:
    """The points of each family, linked, after its outline."""
    if len(points) != len(places):
        raise RuntimeError(f"{name}: {len(places)} points were drawn, expected {len(points)}")
    whole = zip(points, places, strict=True)
    for family, group in groupby(whole, key=lambda pair: pair[0].family):
        look = look_of(family)
        shape = marker(name, look)
        links = "\n".join(
            f'<a href="{root}{point.page}" tabindex="-1"><title>{escape(point.title)}</title>'
            f'<use href="#{shape}" x="{x}" y="{y}"/></a>'
            for point, (x, y) in group
        )
        yield (
            f'<defs><path id="{shape}" d="{look.outline}"/></defs>\n'
            f'<g class="points {look.tone} family-{look.number}">{links}</g>\n'
        )
