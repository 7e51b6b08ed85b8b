"""Who is let in by a server on the loopback: this machine's own page, with its token; no page of another site.

A page of another site can make a browser send requests to this machine, and by rebinding its own name to 127.0.0.1 it
can read what comes back. The name that the browser believes it talks to stands in Host, the page that asks in Origin,
and neither can be set by a page.
"""

from __future__ import annotations

import hmac
from collections.abc import Iterable
from email.message import Message
from http import HTTPStatus
from typing import NamedTuple

TOKEN = "X-HexaLab-Token"
"""The header with the token. A page of another site that sets it has to ask first, and is never answered."""

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")


class Refusal(NamedTuple):
    """Why a request is not answered."""

    status: HTTPStatus
    reason: str


def refusal(headers: Message, names: Iterable[str], navigating: bool = False) -> Refusal | None:
    """Say why a request is not let in; None if it is.

    Parameters
    ----------
    headers : Message
        The request's.
    names : iterable of str
        What Host may be: names with their port.
    navigating : bool
        Whether it asks for the page itself, which a link of another site may lead to: it holds nothing private.
    """
    hosts = headers.get_all("Host", [])
    if len(hosts) != 1 or hosts[0].lower() not in set(names):
        return Refusal(
            HTTPStatus.MISDIRECTED_REQUEST, "this server goes by the names of this machine's loopback alone"
        )
    origin = headers.get("Origin")
    if origin is not None and origin.lower() != f"http://{hosts[0].lower()}":
        return Refusal(HTTPStatus.FORBIDDEN, "this server answers its own page alone")
    site = headers.get("Sec-Fetch-Site", "none")
    opened = (
        navigating
        and headers.get("Sec-Fetch-Mode") == "navigate"
        and headers.get("Sec-Fetch-Dest") == "document"
    )
    if site not in ("same-origin", "none") and not opened:
        return Refusal(HTTPStatus.FORBIDDEN, "this server answers its own page alone")
    return None


def token_of(headers: Message) -> str:
    """The token that a request bears; "" if it bears none, or several."""
    found = headers.get_all(TOKEN, [])
    return found[0] if len(found) == 1 else ""


def same(given: str, token: str) -> bool:
    """Whether two tokens are the same; how long that takes tells nothing of them."""
    return hmac.compare_digest(given.encode(), token.encode())
