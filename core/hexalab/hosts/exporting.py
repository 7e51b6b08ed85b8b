"""Files that the viewer makes of a mesh besides pictures: its surface, a page of its own, a turntable."""

from __future__ import annotations

import base64
from dataclasses import dataclass, field
from typing import Any, Literal

from .headless import Rejection
from .offers import Offer
from .page_scripts import BASE64
from .rendering import Renderer

EXPORT = f"""async ({{ method, args }}) => {{
  try {{
    const made = await window.hexalab[method](...args);
    const file = made.file ?? made;
    return {{ data: ({BASE64})(new Uint8Array(await file.arrayBuffer())), notes: made.notes ?? [] }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""

REPORT_PICTURES = f"""async () => {{
  try {{
    const taken = await window.hexalab.reportPictures();
    const made = taken.map(async ({{ title, alt, picture }}) => ({{
      title, alt, data: ({BASE64})(new Uint8Array(await picture.arrayBuffer())),
    }}));
    return {{ taken: await Promise.all(made) }};
  }} catch (error) {{
    return {{ failed: error.message ?? String(error) }};
  }}
}}"""

Made = Literal["surface", "page", "turntable"]
"""What can be made: methods of `window.hexalab`."""


@dataclass(frozen=True)
class Export:
    """A file and what was told of it.

    Parameters
    ----------
    data : bytes
    notes : list of str
        What the format has no place for.
    rejections : list of Rejection
        What of the status could not be applied.
    """

    data: bytes
    notes: list[str] = field(default_factory=list)
    rejections: list[Rejection] = field(default_factory=list)


def export(
    renderer: Renderer, mesh: Offer, made: Made, arguments: list[Any], status: dict[str, Any] | None = None
) -> Export:
    """Make a file of a mesh.

    Parameters
    ----------
    renderer : Renderer
        Started.
    mesh : Offer
    made : str
    arguments : list
        Of the method, as JSON has them.
    status : dict, optional
        Whole or partial, ours or the original's; it is laid over the defaults.

    Raises
    ------
    RenderError
        The mesh can't be read, nothing of it is shown, the browser can't make such a file, or gave up.
    """
    with renderer.shown(mesh, status) as shown:
        answer = renderer.answer(EXPORT, {"method": made, "args": arguments}, mesh.name)
    return Export(base64.b64decode(answer["data"]), answer["notes"], shown["rejections"])


def report_pictures(renderer: Renderer, mesh: Offer, unit: str = "none") -> list[dict[str, Any]]:
    """Take the pictures of a mesh's report.

    Parameters
    ----------
    renderer : Renderer
        Started.
    mesh : Offer
    unit : str
        Of length, one of `hexalab.status.LENGTH_UNITS`.

    Returns
    -------
    list of dict
        `title`, `alt`, `data` (a PNG) of each.

    Raises
    ------
    RenderError
        The mesh can't be read, or the browser gave up.
    """
    light = {"lighting": {"mode": "none"}}  # the pictures have their own; until then none is waited for
    with renderer.shown(mesh, {"unit": unit, **light}):
        taken = renderer.answer(REPORT_PICTURES, {}, mesh.name)["taken"]
    return [{**one, "data": base64.b64decode(one["data"])} for one in taken]
