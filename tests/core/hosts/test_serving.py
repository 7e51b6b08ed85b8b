"""The local server: right types, fresh files, this machine only."""

import socket
import struct
import sys
import threading
import urllib.error
import urllib.request

import pytest

from hexalab.hosts.serving import make_server, serve

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")


@pytest.fixture
def served(tmp_path):
    site = tmp_path / "site"
    (site / "folder").mkdir(parents=True)
    for name in (
        "index.html",
        "a.js",
        "b.mjs",
        "c.wasm",
        "d.json",
        "e.svg",
        "f.whl",
        "g.mesh",
        "h.css",
        "i.webmanifest",
        "j.webp",
        "k.csv",
    ):
        (site / name).write_text(name)
    (tmp_path / "secret").write_text("secret")
    with make_server(site) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


def get(server, path, **headers):
    request = urllib.request.Request(server.address + path, headers=headers)
    return urllib.request.urlopen(request, timeout=10)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("", "text/html; charset=utf-8"),
        ("a.js", "text/javascript"),
        ("b.mjs", "text/javascript"),
        ("c.wasm", "application/wasm"),
        ("d.json", "application/json"),
        ("e.svg", "image/svg+xml"),
        ("f.whl", "application/octet-stream"),
        ("g.mesh", "application/octet-stream"),
        ("h.css", "text/css"),
        ("i.webmanifest", "application/manifest+json"),
        ("j.webp", "image/webp"),
        ("k.csv", "text/csv; charset=utf-8"),
    ],
)
def test_O1_types_are_right_on_every_machine(served, name, kind):
    with get(served, name) as answer:
        assert answer.headers["Content-Type"] == kind
        assert answer.headers["Cache-Control"] == "no-cache"


def test_O1_an_unchanged_file_is_not_sent_again(served):
    with get(served, "a.js") as answer:
        date = answer.headers["Last-Modified"]
    with pytest.raises(urllib.error.HTTPError) as caught:
        get(served, "a.js", **{"If-Modified-Since": date})
    assert caught.value.code == 304


@pytest.mark.parametrize("path", ["folder/", "nothing.html", "../secret", "%2e%2e/secret"])
def test_O1_nothing_else_is_shown(served, path):
    with pytest.raises(urllib.error.HTTPError) as caught:
        get(served, path)
    assert caught.value.code == 404


def test_O1_only_this_machine_is_answered(served):
    assert served.server_address[0] == "127.0.0.1"


def test_O1_a_folder_without_a_site_is_named(tmp_path):
    with pytest.raises(FileNotFoundError, match="build it first"):
        serve(tmp_path, 0)


def test_O1_a_page_that_leaves_is_no_error_to_print(served, capfd):
    place = served.server_address
    for request in (b"", b"GET / HTTP/1.1\r\n", b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"):
        with socket.create_connection(place) as left:
            left.setsockopt(
                socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0)
            )  # a reset, no goodbye
            left.sendall(request)
    with get(served, "") as answer:
        assert answer.status == 200
    try:
        raise ConnectionResetError
    except ConnectionResetError:
        served.handle_error(None, place)
    assert capfd.readouterr().err == ""
    try:
        raise ValueError("a fault of ours")
    except ValueError:
        served.handle_error(None, place)
    assert "a fault of ours" in capfd.readouterr().err
