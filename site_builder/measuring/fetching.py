"""Fetching remote files as a polite guest: few at a time, resumed where it broke off, patient with a busy server."""

from __future__ import annotations

import hashlib
import json
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

import urllib3

from hexalab import HexaLabError, __version__

from ..model.names import on_this_machine

LARGEST = 2_000_000_000
"""Bytes of a file that is still fetched."""

TRIES, GROWTH, LONGEST = 6, 1.0, 120.0
"""How often a server is asked, seconds of the first pause (each is twice the one before), seconds of the longest."""

BUSY = (408, 425, 429, 500, 502, 503, 504)
"""Answers after which it is worth to ask again; a server that says when is believed."""

PAUSE = 0.25
"""Seconds between two requests to the same server."""

PATIENCE = 60.0
"""Seconds without a byte after which a connection is given up."""

WHO = {"User-Agent": f"hexalab/{__version__}", "Accept-Encoding": "identity"}

SHARE = 2**20


class FetchError(HexaLabError):
    """A file can't be had."""


@dataclass(frozen=True)
class Fetched:
    """What a server gave.

    Parameters
    ----------
    file : Path or None
        None if the file is still the one whose ETag was sent.
    etag : str
        By which the server knows it, "" if it told none.
    """

    file: Path | None
    etag: str


class Fetcher:
    """Fetches files into a folder; what was fetched before is not fetched again.

    Parameters
    ----------
    folder : Path
    largest : int
        Bytes of a file that is still fetched.
    growth : float
        Seconds of the first pause.
    """

    def __init__(self, folder: Path, largest: int = LARGEST, growth: float = GROWTH) -> None:
        self._folder, self._largest, self._growth = folder, largest, growth
        self._pool = urllib3.PoolManager(
            timeout=urllib3.Timeout(connect=PATIENCE, read=PATIENCE),
            retries=False,
        )
        self._stopped = threading.Event()
        self._turns = threading.Lock()
        self._asked: dict[str, float] = {}

    def fetch(self, address: str, etag: str = "") -> Fetched:
        """Fetch a file, unless it is still the one that the server called `etag`.

        Raises
        ------
        FetchError
            There is no such file, it is too large, or the server can't be reached.
        """
        if not address.startswith("https://") and not on_this_machine(address):
            raise FetchError(f"{address}: expected an address that begins with https://")
        place = self._place(address)
        if place.is_file():
            return Fetched(place, _note(place).get("etag", ""))
        for number in range(1, TRIES + 1):
            try:
                return self._try(address, place, etag)
            except _BusyError as busy:
                if number == TRIES:
                    raise FetchError(f"{address}: {busy}, {TRIES} times") from None
                self._pause(min(max(self._growth * 2 ** (number - 1), busy.wait), LONGEST))
        raise AssertionError("unreachable")

    def forget(self, address: str) -> None:
        """Have a file fetched again next time."""
        self._place(address).unlink(missing_ok=True)

    def stop(self) -> None:
        """Leave off, whatever is under way: it goes on from there next time."""
        self._stopped.set()

    def _place(self, address: str) -> Path:
        name = unquote(urlsplit(address).path).rsplit("/", 1)[-1] or "mesh"
        return self._folder / hashlib.sha256(address.encode()).hexdigest()[:32] / name

    def _try(self, address: str, place: Path, etag: str) -> Fetched:
        half = place.with_name(f"{place.name}.half")
        known = half.stat().st_size if half.is_file() else 0
        version = _note(half).get("etag", "")
        headers = WHO | ({"If-None-Match": etag} if etag else {})
        if known and version and not version.startswith("W/"):  # of another version the rest would not fit
            headers |= {"Range": f"bytes={known}-", "If-Range": version}
        self._wait_for_turn(urlsplit(address).hostname or "")
        try:
            answer: Any = self._pool.request(
                "GET", address, headers=headers, preload_content=False, redirect=5
            )
        except urllib3.exceptions.HTTPError as error:
            raise _BusyError(f"no answer ({_reason(error)})") from None
        try:
            if answer.status == 304:
                return Fetched(None, etag)
            self._refuse(address, answer)
            return self._store(address, answer, place, half)
        except urllib3.exceptions.HTTPError as error:
            raise _BusyError(f"the connection broke ({_reason(error)})") from None
        finally:
            answer.release_conn()

    def _refuse(self, address: str, answer: Any) -> None:
        """Say why an answer brings no file, if it brings none."""
        came_from = answer.geturl() or address
        if came_from.startswith("http:") and not on_this_machine(came_from):
            raise FetchError(f"{address} leads to {came_from}, which is not https")
        if answer.status in BUSY:
            asked = answer.headers.get("Retry-After", "")
            raise _BusyError(f"the server answered {answer.status}", float(asked) if asked.isdigit() else 0.0)
        if answer.status not in (200, 206):
            raise FetchError(f"{address}: the server answered {answer.status}")
        length = answer.headers.get("Content-Length", "")
        if length.isdigit() and int(length) > self._largest:
            raise FetchError(f"{address}: {int(length):,} bytes, but at most {self._largest:,} are fetched")

    def _store(self, address: str, answer: Any, place: Path, half: Path) -> Fetched:
        etag = answer.headers.get("ETag", "")
        half.parent.mkdir(parents=True, exist_ok=True)
        _write_note(half, etag)
        with half.open("ab" if answer.status == 206 else "wb") as out:
            began, length = out.tell(), answer.headers.get("Content-Length", "")
            while share := answer.read1(SHARE):  # what has come is written down before more is waited for
                self._pause(0.0)
                out.write(share)
                if out.tell() > self._largest:
                    half.unlink()
                    raise FetchError(f"{address}: more than {self._largest:,} bytes")
            if length.isdigit() and out.tell() - began != int(length):
                raise _BusyError("the connection broke")
        half.replace(place)
        _write_note(place, etag)
        return Fetched(place, etag)

    def _wait_for_turn(self, host: str) -> None:
        """Requests to a server keep a distance, whoever makes them."""
        with self._turns:
            now = time.monotonic()
            turn = max(now, self._asked.get(host, now - PAUSE) + PAUSE)
            self._asked[host] = turn
        self._pause(turn - now)

    def _pause(self, seconds: float) -> None:
        if self._stopped.wait(max(0.0, seconds)):
            raise FetchError("stopped")


class _BusyError(Exception):
    """It may be worth to ask again, after so many seconds at least."""

    def __init__(self, message: str, wait: float = 0.0) -> None:
        super().__init__(message)
        self.wait = wait


def _reason(error: Exception) -> str:
    return str(error).split(": ", 1)[-1] or type(error).__name__


def _note(file: Path) -> dict[str, str]:
    """What was written down of a file: the version that the server told."""
    try:
        note: dict[str, str] = json.loads(file.with_name(f"{file.name}.note").read_text("utf-8"))
        return note
    except (OSError, ValueError):
        return {}


def _write_note(file: Path, etag: str) -> None:
    file.with_name(f"{file.name}.note").write_text(json.dumps({"etag": etag}), "utf-8")
