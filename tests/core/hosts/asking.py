"""Asking the loopback's server as a page does, and as one that should not get in."""

from __future__ import annotations

import http.client
import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from hexalab.hosts.loopback import SEAT, Loopback

Headers = Mapping[str, str | Sequence[str] | None]


def framed(
    method: str,
    arguments: list[Any],
    blocks: Sequence[bytes] = (),
    number: int = 1,
    sizes: list[int] | None = None,
) -> bytes:
    """A question's body."""
    sizes = [len(block) for block in blocks] if sizes is None else sizes
    head = json.dumps(
        {"id": number, "method": method, "text": json.dumps(arguments), "sizes": sizes}
    ).encode()
    return struct.pack("<I", len(head)) + head + b"".join(blocks)


class Caller:
    """Sends requests to a server, each over a connection of its own."""

    def __init__(self, server: Loopback) -> None:
        self.port, self.token = server.port, server.token
        self._seats = 0

    def ask(
        self, verb: str, path: str, body: bytes = b"", headers: Headers | None = None
    ) -> tuple[http.client.HTTPResponse, bytes]:
        """One request; a header of None is left out, one of several values is sent as often."""
        connection, answer = self._sent(verb, path, body, headers or {})
        data = answer.read()
        connection.close()
        return answer, data

    def get(self, path: str, headers: Headers | None = None) -> tuple[http.client.HTTPResponse, bytes]:
        return self.ask("GET", path, headers=headers)

    def post(
        self, path: str, body: bytes = b"", *, seat: str, headers: Headers | None = None
    ) -> tuple[http.client.HTTPResponse, bytes]:
        return self.ask("POST", path, body, {"X-HexaLab-Token": self.token, SEAT: seat, **(headers or {})})

    def enter(self) -> str:
        """A page of its own; gives its seat."""
        self._seats += 1
        seat = f"seat-{self._seats}"
        answer, _ = self.post("/hello", seat=seat)
        assert answer.status == 200
        return seat

    @contextmanager
    def listening(self, seat: str) -> Iterator[Iterator[bytes]]:
        """The lines that a page is told."""
        headers = {"X-HexaLab-Token": self.token, SEAT: seat}
        connection, answer = self._sent("POST", "/events", b"", headers)
        assert answer.status == 200
        yield iter(answer)
        answer.close()
        connection.close()

    def _sent(
        self, verb: str, path: str, body: bytes, headers: Headers
    ) -> tuple[http.client.HTTPConnection, http.client.HTTPResponse]:
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        connection.putrequest(verb, path, skip_host=True, skip_accept_encoding=True)
        given = {"Host": f"127.0.0.1:{self.port}", "Content-Length": str(len(body)), **headers}
        for name, value in given.items():
            for one in [value] if isinstance(value, str) else value or ():
                connection.putheader(name, one.encode("utf-8"))
        connection.endheaders(body)
        return connection, connection.getresponse()
