"""Remote files are fetched as a polite guest would, and found in mirrors by their addresses (SPEC C8)."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from site_builder.measuring import fetching
from site_builder.measuring.fetching import Fetcher, FetchError
from site_builder.measuring.mirror import Mirror

DATA = bytes(range(256)) * 40


@dataclass
class Host:
    """What a server does, and what it was asked.

    `answers`: statuses of the next answers, 200 afterwards; `breaks`: bytes after which the next answers break off.
    """

    address: str = ""
    etag: str = '"one"'
    answers: list[int] = field(default_factory=list)
    breaks: list[int] = field(default_factory=list)
    asked: list[dict[str, str]] = field(default_factory=list)
    moments: list[float] = field(default_factory=list)
    headers: dict[str, str] = field(default_factory=dict)


@contextmanager
def serving(host: Host) -> Iterator[Host]:
    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            host.asked.append({name.lower(): value for name, value in self.headers.items()})
            host.moments.append(time.monotonic())
            status = host.answers.pop(0) if host.answers else 200
            if self.headers.get("If-None-Match") == host.etag:
                status = 304
            data = DATA
            if status == 200 and self.headers.get("Range") and self.headers.get("If-Range") == host.etag:
                status, data = 206, DATA[int(self.headers["Range"][6:-1]) :]
            self.send_response(status)
            self.send_header("ETag", host.etag)
            for name, value in host.headers.items():
                self.send_header(name, value)
            if status not in (200, 206):
                self.send_header("Content-Length", "0")
                self.end_headers()
                return
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            cut = host.breaks.pop(0) if host.breaks else len(data)
            self.wfile.write(data[:cut])
            self.close_connection = True

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    host.address = f"http://127.0.0.1:{server.server_port}/a%20folder/box.mesh"
    try:
        yield host
    finally:
        server.shutdown()
        server.server_close()


@pytest.fixture
def host() -> Iterator[Host]:
    with serving(Host()) as running:
        yield running


@pytest.fixture
def fetcher(tmp_path: Path) -> Fetcher:
    return Fetcher(tmp_path, growth=0.001)


def test_C8_a_file_is_fetched_once(host: Host, fetcher: Fetcher) -> None:
    first = fetcher.fetch(host.address)
    assert first.file and first.file.name == "box.mesh" and first.file.read_bytes() == DATA
    assert first.etag == '"one"' and fetcher.fetch(host.address) == first
    assert len(host.asked) == 1 and host.asked[0]["user-agent"].startswith("hexalab/")
    fetcher.forget(host.address)
    assert fetcher.fetch(host.address) == first and len(host.asked) == 2


def test_C8_a_file_that_has_not_changed_is_not_sent_again(host: Host, fetcher: Fetcher) -> None:
    assert fetcher.fetch(host.address, '"one"').file is None
    assert fetcher.fetch(host.address, '"older"').file is not None


def test_C8_what_broke_off_goes_on_from_there(host: Host, fetcher: Fetcher) -> None:
    host.breaks = [1000, 2000]
    fetched = fetcher.fetch(host.address)
    assert fetched.file and fetched.file.read_bytes() == DATA
    assert [asked.get("range") for asked in host.asked] == [None, "bytes=1000-", "bytes=3000-"]


def test_C8_of_another_version_nothing_is_kept(host: Host, fetcher: Fetcher) -> None:
    host.answers, host.breaks = [200, 404], [1000]
    with pytest.raises(FetchError, match="404"):
        fetcher.fetch(host.address)
    host.etag = '"two"'
    fetched = fetcher.fetch(host.address)
    assert fetched.file and fetched.file.read_bytes() == DATA and fetched.etag == '"two"'


def test_C8_a_weak_tag_does_not_join_two_halves(host: Host, fetcher: Fetcher) -> None:
    host.etag, host.breaks = 'W/"one"', [1000]
    fetched = fetcher.fetch(host.address)
    assert fetched.file and fetched.file.read_bytes() == DATA
    assert all("range" not in asked for asked in host.asked)


@pytest.mark.parametrize("status", [429, 503])
def test_C8_a_busy_server_is_asked_again_later(host: Host, tmp_path: Path, status: int) -> None:
    host.answers = [status, status, status]
    waited: list[float] = []
    fetcher = Fetcher(tmp_path, growth=1.0)
    fetcher._pause = waited.append  # type: ignore[method-assign]
    assert fetcher.fetch(host.address).file
    pauses = [seconds for seconds in waited if seconds >= 1]
    assert pauses == [1, 2, 4] and len(host.asked) == 4


def test_C8_a_server_that_says_when_is_believed(host: Host, tmp_path: Path) -> None:
    host.answers, host.headers = [503], {"Retry-After": "7"}
    waited: list[float] = []
    fetcher = Fetcher(tmp_path)
    fetcher._pause = waited.append  # type: ignore[method-assign]
    fetcher.fetch(host.address)
    assert max(waited) == 7


def test_C8_a_server_that_stays_busy_is_given_up(host: Host, fetcher: Fetcher) -> None:
    host.answers = [503] * 20
    with pytest.raises(FetchError, match=r"box\.mesh: the server answered 503, 6 times"):
        fetcher.fetch(host.address)
    assert len(host.asked) == 6


def test_C8_what_is_not_there_is_asked_for_once(host: Host, fetcher: Fetcher) -> None:
    host.answers = [404]
    with pytest.raises(FetchError, match="the server answered 404"):
        fetcher.fetch(host.address)
    assert len(host.asked) == 1


def test_C8_what_is_too_large_is_refused(host: Host, tmp_path: Path) -> None:
    fetcher = Fetcher(tmp_path, largest=len(DATA) - 1)
    with pytest.raises(FetchError, match=r"10,240 bytes, but at most 10,239 are fetched"):
        fetcher.fetch(host.address)
    assert not list(tmp_path.rglob("box.mesh*"))


def test_C8_a_server_that_is_not_there_is_named(fetcher: Fetcher) -> None:
    with pytest.raises(FetchError, match=r"http://127\.0\.0\.1:9/box\.mesh: no answer"):
        fetcher.fetch("http://127.0.0.1:9/box.mesh")


@pytest.mark.parametrize("address", ["http://example.org/a.mesh", "ftp://example.org/a.mesh", "a.mesh"])
def test_C8_nothing_but_https_is_fetched(fetcher: Fetcher, address: str) -> None:
    with pytest.raises(FetchError, match="expected an address that begins with https"):
        fetcher.fetch(address)


def test_C8_a_way_that_leaves_https_is_not_gone(host: Host, fetcher: Fetcher) -> None:
    host.answers, host.headers = [302], {"Location": "http://127.0.0.2.example:9/box.mesh"}
    with pytest.raises(FetchError):
        fetcher.fetch(host.address)


def test_C8_requests_to_a_server_keep_a_distance(
    host: Host, fetcher: Fetcher, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fetching, "PAUSE", 0.2)
    threads = [
        threading.Thread(target=fetcher.fetch, args=(f"{host.address}?{number}",)) for number in range(3)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    moments = sorted(host.moments)
    assert len(moments) == 3 and moments[2] - moments[0] >= 0.35


def test_C8_a_fetcher_that_is_stopped_leaves_off(host: Host, tmp_path: Path) -> None:
    host.answers = [503] * 20
    fetcher = Fetcher(tmp_path, growth=60.0)
    threading.Timer(0.3, fetcher.stop).start()
    with pytest.raises(FetchError, match="stopped"):
        fetcher.fetch(host.address)


def test_C8_a_mirror_is_searched_by_the_end_of_an_address(tmp_path: Path) -> None:
    for path in ("org/data/deep/a b.mesh", "deep/a b.mesh", "c.mesh"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(path)
    mirror = Mirror(tmp_path)
    found = mirror.find("https://host.example/org/data/deep/a%20b.mesh")
    assert found == tmp_path / "org/data/deep/a b.mesh"  # the copy whose path agrees with most of the address
    assert mirror.find("https://host.example/other/deep/a%20b.mesh?raw=1") == tmp_path / "deep/a b.mesh"
    assert mirror.find("https://host.example/org/data/c.mesh") is None  # a name alone says too little
    assert mirror.find("https://host.example/deep/../deep/a%20b.mesh") is None
