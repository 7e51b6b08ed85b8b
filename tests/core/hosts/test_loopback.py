"""The server of `hexalab view`: who gets in, and what is told. SPEC A5."""

from __future__ import annotations

import http.client
import json
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from hexalab.hosts.loopback import GRACE, Loopback
from hexalab.hosts.offers import file_offers
from hexalab.packing import unpack
from tests.core.hosts.asking import Caller, framed

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

MESH = "a.mesh"

FOREIGN = ("evil.example", "127.0.0.1", "127.0.0.1:1", "localhost.evil.example:{port}", "[::2]:{port}")


@pytest.fixture
def mesh_file(tmp_path: Path, grid: Any) -> Path:
    file = tmp_path / MESH
    file.write_bytes(grid(2, 2, 2))
    return file


@pytest.fixture
def viewer(tmp_path: Path) -> Path:
    folder = tmp_path / "viewer"
    folder.mkdir()
    (folder / "index.html").write_text("<!doctype html><title>the viewer</title>")
    (folder / "viewer.js").write_text("// the script")
    return folder


@pytest.fixture
def grace() -> float:
    """Seconds that a session is kept whose page has gone; those of a test that wants it short are its parameter."""
    return GRACE


@pytest.fixture
def server(mesh_file: Path, viewer: Path, grace: float) -> Iterator[Loopback]:
    with Loopback(file_offers([mesh_file]), viewer=viewer, grace=grace) as running:
        running.start()
        yield running
        running.shutdown()


@pytest.fixture
def caller(server: Loopback) -> Caller:
    return Caller(server)


def test_A5_the_page_and_its_script_are_had_without_a_token(caller: Caller) -> None:
    answer, body = caller.get("/")
    assert (answer.status, answer.getheader("Content-Type")) == (200, "text/html; charset=utf-8")
    assert b"the viewer" in body
    answer, body = caller.get("/viewer.js")
    assert (answer.status, answer.getheader("Content-Type"), body) == (
        200,
        "text/javascript",
        b"// the script",
    )


@pytest.mark.parametrize(
    "path", ["/a.mesh", "/../a.mesh", "/%2e%2e/a.mesh", "//a.mesh", "/ask", "/events", "/hello"]
)
def test_A5_no_file_of_the_machine_is_had_by_its_address(caller: Caller, path: str) -> None:
    answer, body = caller.get(path)
    assert answer.status == 404
    assert b"Vertices" not in body


def test_A5_headers_keep_others_from_framing_embedding_and_keeping_it(caller: Caller) -> None:
    answer, _ = caller.get("/")
    told = {name.lower(): value for name, value in answer.getheaders()}
    assert told["x-frame-options"] == "DENY"
    assert told["content-security-policy"] == "frame-ancestors 'none'"
    assert told["cross-origin-resource-policy"] == "same-origin"
    assert told["x-content-type-options"] == "nosniff"
    assert told["referrer-policy"] == "no-referrer"
    assert told["cache-control"] == "no-store"
    assert not [name for name in told if name.startswith("access-control")], "no other origin is let in"
    assert "python" not in told["server"].lower()


def refused(caller: Caller, status: int, **headers: str | None) -> None:
    """Every way in is closed with these headers, though the token is right."""
    names = {name.replace("_", "-"): value for name, value in headers.items()}
    answer, body = caller.post("/hello", seat="s", headers=names)
    assert (answer.status, answer.getheader("Connection")) == (status, "close")
    assert b"token" not in body or status == 403
    seat = caller.enter()
    for path, sent in (("/ask", framed("open_offered", ["0"])), ("/events", b"")):
        answer, body = caller.post(path, sent, seat=seat, headers=names)
        assert (answer.status, answer.getheader("Connection")) == (status, "close")
        assert len(body) < 200


@pytest.mark.parametrize("host", FOREIGN)
def test_A5_a_foreign_host_gets_nothing(caller: Caller, host: str) -> None:
    refused(caller, 421, Host=host.format(port=caller.port))
    answer, body = caller.get("/", headers={"Host": host.format(port=caller.port)})
    assert (answer.status, b"the viewer" in body) == (421, False)


def test_A5_two_hosts_get_nothing(caller: Caller) -> None:
    name = f"127.0.0.1:{caller.port}"
    answer, body = caller.get("/", headers={"Host": [name, name]})
    assert (answer.status, b"the viewer" in body) == (421, False)


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost", "LOCALHOST", "[::1]"])
def test_A5_the_names_of_the_loopback_are_let_in(caller: Caller, name: str) -> None:
    host = f"{name}:{caller.port}"
    assert caller.get("/", headers={"Host": host})[0].status == 200
    assert (
        caller.post("/hello", seat="s", headers={"Host": host, "Origin": f"http://{host}"})[0].status == 200
    )


@pytest.mark.parametrize(
    "origin",
    [
        "https://evil.example",
        "null",
        "http://127.0.0.1",
        "https://127.0.0.1:{port}",
        "http://localhost:{port}",
    ],
)
def test_A5_a_page_of_another_origin_gets_nothing(caller: Caller, origin: str) -> None:
    refused(caller, 403, Host=f"127.0.0.1:{caller.port}", Origin=origin.format(port=caller.port))


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_A5_what_a_browser_says_comes_from_another_site_gets_nothing(caller: Caller, site: str) -> None:
    refused(caller, 403, Sec_Fetch_Site=site)
    assert caller.get("/viewer.js", headers={"Sec-Fetch-Site": site})[0].status == 403
    linked = {"Sec-Fetch-Site": site, "Sec-Fetch-Mode": "navigate", "Sec-Fetch-Dest": "document"}
    assert caller.get("/", headers=linked)[0].status == 200, (
        "a link may lead to the page, which holds nothing"
    )
    assert caller.get("/", headers={**linked, "Sec-Fetch-Dest": "iframe"})[0].status == 403


@pytest.mark.parametrize("token", [None, "", "wrong", "é"])
def test_A5_a_wrong_token_gets_nothing(caller: Caller, token: str | None) -> None:
    refused(caller, 403, X_HexaLab_Token=token)


def test_A5_two_tokens_get_nothing(caller: Caller) -> None:
    answer, _ = caller.post("/hello", seat="s", headers={"X-HexaLab-Token": [caller.token, caller.token]})
    assert answer.status == 403


def test_A5_a_ticket_counts_once_and_gives_the_token(server: Loopback, caller: Caller) -> None:
    ticket = server.once.split("#token=")[1]
    assert ticket != server.token
    answer, body = caller.post("/hello", seat="s", headers={"X-HexaLab-Token": ticket})
    assert (answer.status, json.loads(body)["token"]) == (200, server.token)
    assert caller.post("/hello", seat="s", headers={"X-HexaLab-Token": ticket})[0].status == 403


def test_A5_nothing_is_granted_to_a_preflight(caller: Caller) -> None:
    answer, _ = caller.ask(
        "OPTIONS", "/ask", headers={"Origin": "https://evil.example", "Access-Control-Request-Method": "POST"}
    )
    assert answer.status >= 400
    assert not [name for name, _ in answer.getheaders() if name.lower().startswith("access-control")]


def test_A5_a_mesh_is_opened_and_drawn(caller: Caller) -> None:
    seat = caller.enter()
    answer, body = caller.post("/ask", framed("open_offered", ["0"]), seat=seat)
    assert (answer.status, float(answer.getheader("X-HexaLab-Milliseconds") or "nan") > 0) == (200, True)
    assert unpack(body)["result"]["cells"] == 8
    _, body = caller.post("/ask", framed("update", []), seat=seat)
    assert unpack(body)["result"]["shown_faces"] == 24


def test_A5_pages_have_sessions_of_their_own(caller: Caller, grid: Any) -> None:
    first, second = caller.enter(), caller.enter()
    caller.post("/ask", framed("open", ["b.mesh", {"$bytes": 0}], [grid(1, 1, 1)]), seat=first)
    _, body = caller.post("/ask", framed("update", []), seat=second)
    assert "no mesh is open" in unpack(body)["error"]["message"]
    _, body = caller.post("/ask", framed("update", []), seat=first)
    assert unpack(body)["result"]["shown_cells"] == 1


@pytest.mark.parametrize(
    ("body", "status"),
    [
        (b"", 400),
        (b"\0\0", 400),
        (b"\xff\xff\xff\xff{}", 400),
        (b"\2\0\0\0{}", 400),
        (framed("update", [], sizes=[7]), 400),
    ],
)
def test_A5_a_question_that_is_none_is_refused(caller: Caller, body: bytes, status: int) -> None:
    assert caller.post("/ask", body, seat=caller.enter())[0].status == status


def test_A5_a_question_without_a_length_is_refused(caller: Caller) -> None:
    answer, _ = caller.post(
        "/ask", b"x", seat=caller.enter(), headers={"Transfer-Encoding": "chunked", "Content-Length": None}
    )
    assert answer.status == 411


@pytest.mark.parametrize("grace", [0.2])
def test_A5_a_session_goes_when_its_page_has_gone(caller: Caller) -> None:
    seat = caller.enter()
    assert caller.post("/ask", framed("check", [{}]), seat=seat)[0].status == 200
    deadline = time.monotonic() + 20
    while caller.post("/ask", framed("check", [{}]), seat=seat)[0].status != 410:
        assert time.monotonic() < deadline, "nobody listens for it"
        time.sleep(0.05)


def test_A5_a_session_that_was_left_may_go_sooner_than_one_that_is_waited_for(
    mesh_file: Path, viewer: Path
) -> None:
    with Loopback(file_offers([mesh_file]), viewer=viewer, parting=0.1) as server:
        server.start()
        caller = Caller(server)
        left, waited = caller.enter(), caller.enter()
        with caller.listening(left):
            pass
        deadline = time.monotonic() + 20
        while caller.post("/ask", framed("check", [{}]), seat=left)[0].status != 410:
            assert time.monotonic() < deadline, "its page has gone"
            time.sleep(0.05)
        assert caller.post("/ask", framed("check", [{}]), seat=waited)[0].status == 200
        server.shutdown()


@pytest.mark.parametrize("grace", [0.2])
def test_A5_who_listens_is_told_and_keeps_the_session(server: Loopback, caller: Caller) -> None:
    seat = caller.enter()
    with caller.listening(seat) as lines:
        time.sleep(0.5)  # longer than the grace
        assert caller.post("/ask", framed("check", [{}]), seat=seat)[0].status == 200
        server.tell_of("0", there=True)
        assert json.loads(next(lines)) == {"changed": "0"}
        server.tell_of("0", there=False)
        assert json.loads(next(lines)) == {"gone": "0"}


def test_A5_a_file_is_identified_after_it_was_opened(caller: Caller, mesh_file: Path, grid: Any) -> None:
    from hashlib import sha256

    seat = caller.enter()
    with caller.listening(seat) as lines:
        caller.post("/ask", framed("open_offered", ["0"], number=5), seat=seat)
        told = json.loads(next(lines))["identified"]
        assert told == {"question": 5, "sha256": sha256(mesh_file.read_bytes()).hexdigest()}
        caller.post("/ask", framed("open", ["b", {"$bytes": 0}], [grid(1, 1, 1)], number=6), seat=seat)
        assert json.loads(next(lines))["identified"] == {
            "question": 6,
            "sha256": sha256(grid(1, 1, 1)).hexdigest(),
        }


def test_A5_what_was_told_before_the_page_listens_is_not_lost(server: Loopback, caller: Caller) -> None:
    seat = caller.enter()
    server.tell_of("0", there=True)
    server.tell_of("0", there=False)
    with caller.listening(seat) as lines:
        assert [json.loads(next(lines)) for _ in range(2)] == [{"changed": "0"}, {"gone": "0"}]
        server.tell_of("0", there=True)
        assert json.loads(next(lines)) == {"changed": "0"}


def test_A5_pages_are_told_that_the_server_ends(mesh_file: Path, viewer: Path) -> None:
    with Loopback(file_offers([mesh_file]), viewer=viewer) as server:
        server.start()
        caller = Caller(server)
        with caller.listening(caller.enter()) as lines:
            server.shutdown()
            server.server_close()
            assert json.loads(next(lines)) == {"stopped": True}
    with pytest.raises(OSError):
        http.client.HTTPConnection("127.0.0.1", server.port, timeout=5).connect()


def test_A5_it_listens_on_the_loopback_alone(server: Loopback) -> None:
    assert server.socket.getsockname()[0] == "127.0.0.1"
    assert server.address.startswith(f"http://127.0.0.1:{server.port}/#token=")
