"""The frame of a page of one file: viewer, style and policy inside; a mesh comes in when one is saved."""

from __future__ import annotations

import base64
import gzip
import hashlib

from markupsafe import Markup

from .environment import environment


def sheet_page(program: str, boot: str, style: str) -> str:
    """The frame's HTML; title, name, reference, poster and sheet are left as ``@@title@@`` and so on.

    Nothing is loaded, and nothing runs but the two scripts, which the policy knows by their hashes.

    Parameters
    ----------
    program : str
        The viewer's script. It stands there compressed.
    boot : str
        The script that inflates it and puts it in.
    style : str
        The style sheet.

    Raises
    ------
    ValueError
        A text would end its own element.
    """
    for text, end in ((boot, "</script"), (boot, "<!--"), (style, "</style")):
        if end in text.lower():
            raise ValueError(f"a text with {end} in it can't be put into a page")
    policy = (
        f"default-src 'none'; script-src {_hash(boot)} {_hash(program)}; style-src {_hash(style)}; "
        "img-src data: blob:; base-uri 'none'; form-action 'none'"
    )
    packed = base64.b64encode(gzip.compress(program.encode(), mtime=0)).decode()
    template = environment().get_template("sheet.html.jinja")
    return template.render(policy=Markup(policy), program=packed, boot=Markup(boot), style=Markup(style))


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
