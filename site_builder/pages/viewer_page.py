"""The viewer's page, as each host shows it: the site, a server on one's own machine, a frame in a notebook."""

from __future__ import annotations

from typing import Literal

from markupsafe import Markup

from .environment import environment
from .viewer_tables import viewer_tables

Host = Literal["site", "server", "frame"]

ANYWHERE = "https: http://localhost:* http://127.0.0.1:*"
"""Where a mesh may be fetched from that the user gives the address of."""

POLICIES: dict[Host, str] = {
    "site": (
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; "
        f"connect-src 'self' {ANYWHERE} blob:; manifest-src 'self'; worker-src 'self' blob:; "
    ),
    "server": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
        f"connect-src 'self' {ANYWHERE} blob:; worker-src blob:; "
    ),
    "frame": (
        "default-src 'none'; script-src blob:; style-src 'unsafe-inline'; img-src data: blob:; "
        "connect-src data: blob:; worker-src blob:; "
    ),
}
"""Content-Security-Policy of the page, by its host; what all have in common is in `COMMON`."""

COMMON = "object-src 'none'; base-uri 'none'; form-action 'none'"
TRUSTED = "; require-trusted-types-for 'script'; trusted-types hexalab"
"""A frame's script is put in from outside, where the viewer's policy for scripts is not known."""


def viewer_page(
    host: Host,
    *,
    root: str = "",
    style: str = "",
    style_text: str = "",
    icon: str = "",
    start: str = "",
    script: str = "",
    imports: tuple[str, ...] = (),
    worker: str = "",
    runtime: str = "",
) -> str:
    """The page's HTML.

    Parameters
    ----------
    host : "site", "server" or "frame"
        Who shows it; a frame's script is put in by whoever makes the frame.
    root : str
        Address of the catalogue; "" where there is none.
    style, style_text : str
        Address of the style sheet, or the sheet itself.
    icon : str
        Address of the icon.
    start, script : str
        Addresses of the scripts: what is begun before the page is built, and all the rest.
    imports : tuple of str
        Addresses of what the scripts import before they run.
    worker, runtime : str
        Addresses of the core's worker and of the interpreter's folder, where the page has them.
    """
    if "</style" in style_text:
        raise ValueError("a style sheet that ends its own element can't be put into a page")
    return (
        environment()
        .get_template("viewer.html.jinja")
        .render(
            host=host,
            policy=Markup(POLICIES[host] + COMMON + ("" if host == "frame" else TRUSTED)),
            root=root,
            style=style,
            style_text=Markup(style_text),
            favicon=icon,
            start=start,
            script=script,
            imports=imports,
            worker=worker,
            runtime=runtime,
            tables=viewer_tables(),
        )
    )
