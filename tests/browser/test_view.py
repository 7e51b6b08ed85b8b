"""`hexalab view`, as a user runs it: the program in a shell of its own, the page in Chromium. SPEC A5."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, Page

import hexalab
from tests.browser import grouped
from tests.browser.conftest import grid
from tests.browser.ui import set_status, status, summary, until
from tests.browser.viewing import ROOT, messages, viewing, visited

pytestmark = pytest.mark.browser


@pytest.fixture
def make(tmp_path: Path) -> Callable[..., Path]:
    """Write a grid to a file of the test's folder."""

    def write(name: str, *sides: int) -> Path:
        hexalab.write(grid(*sides), tmp_path / name)
        return tmp_path / name

    return write


def write_beside(path: Path, mesh: hexalab.Mesh) -> None:
    """As another program does that writes anew: beside, then renamed."""
    new = path.with_name(f"new-{path.name}")
    hexalab.write(mesh, new)
    os.replace(new, path)


def test_A5_files_are_shown_chosen_and_kept_over_a_reload(
    chromium: Browser, make: Callable[..., Path]
) -> None:
    first, second = make("first.mesh", 3, 2, 2), make("second.vtk", 2, 2, 1)
    with viewing(first, second) as program, visited(chromium, program.address) as page:
        assert page.url == program.root, "the token has left the address"
        assert (summary(page)["name"], summary(page)["cells"]) == ("first.mesh", 12)
        assert page.locator("select#offered-mesh option").all_inner_texts() == ["first.mesh", "second.vtk"]
        page.select_option("select#offered-mesh", label="second.vtk")
        until(lambda: summary(page)["cells"] == 4)
        page.reload()
        until(lambda: (summary(page) or {}).get("cells") == 12)
        with visited(chromium, program.address) as other:
            set_status(other, {"filters": {"peel": {"depth": 1}}})
            assert summary(other)["shown"]["cells"] == 0
            assert summary(page)["shown"]["cells"] == 12, "pages have sessions of their own"


def test_R12_groups_and_numbers_of_the_native_core(chromium: Browser, tmp_path: Path) -> None:
    mesh = grouped.deck(tmp_path / "deck.inp")
    with viewing(tmp_path / "deck.inp") as program, visited(chromium, program.address) as page:
        page.evaluate("() => { for (const fold of document.querySelectorAll('details')) fold.open = true; }")
        names = page.locator(".group-table tbody th")
        until(lambda: names.all_text_contents()[:3] == ["STEEL", "RUBBER", "GLASS"])
        until(lambda: "…" not in page.locator(".group-table tbody").inner_text())
        volume = hexalab.quality(mesh, "volume")[grouped.sets(mesh)["STEEL_CELLS"]].sum()
        assert float(page.locator(".group-table td").nth(4).inner_text()) == pytest.approx(volume, abs=6e-4)
        page.get_by_role("checkbox", name="STEEL shown", exact=True).click()
        until(lambda: summary(page)["shown"]["cells"] == 80)
        page.locator("#go-to").fill("1301")
        page.locator("#go-to").press("Enter")
        until(lambda: page.locator(".inspector h2").inner_text() == "Cell 1301")
        row = int((mesh.cell_numbers == 1301).argmax())
        until(lambda: row in status(page)["filters"]["picking"]["shown"])


def test_A5_it_shows_what_the_command_line_says(
    chromium: Browser, make: Callable[..., Path], tmp_path: Path
) -> None:
    settings = tmp_path / "status.json"
    settings.write_text('{"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5}]}}}')
    with (
        viewing(make("a.mesh", 4, 2, 2), "--status", settings) as program,
        visited(chromium, program.address) as page,
    ):
        until(lambda: summary(page)["shown"]["cells"] == 8)
        sha256 = until(lambda: status(page)["mesh"]["sha256"])
        import hashlib

        assert sha256 == hashlib.sha256((tmp_path / "a.mesh").read_bytes()).hexdigest()


def test_A5_the_host_is_what_the_page_has_no_catalogue_and_no_link_of(
    chromium: Browser, make: Callable[..., Path]
) -> None:
    with viewing(make("a.mesh", 2, 1, 1)) as program, visited(chromium, program.address) as page:
        assert page.locator("a.wordmark").count() == 0
        page.get_by_role("button", name="Share").click()
        assert page.get_by_role("textbox", name="Link", exact=True).is_hidden()
        assert page.get_by_role("textbox", name="Settings", exact=True).is_visible()
        page.keyboard.press("Escape")
        page.set_input_files("#file", make("dropped.mesh", 5, 1, 1))
        until(lambda: summary(page)["cells"] == 5)


def test_A5_a_file_that_is_written_anew_is_shown_under_the_same_view(
    chromium: Browser, make: Callable[..., Path]
) -> None:
    file = make("a.mesh", 4, 3, 3)
    with viewing("--watch", file) as program, visited(chromium, program.address) as page:
        kept = {
            "camera": {"fit": False, "direction": [0.0, -1.0, 0.0], "up": [0.0, 0.0, 1.0], "distance": 3.5},
            "filters": {"peel": {"depth": 0}, "picking": {"hidden": [0, 1]}},
            "colour": {"by": "quality", "metric": "scaled_jacobian", "range": [0.2, 1.0]},
            "silhouette": 0.25,
        }
        assert set_status(page, kept) == []
        before = status(page)
        write_beside(file, grid(4, 3, 3, noise=0.2))
        until(lambda: "written anew" in messages(page))
        after = status(page)
        assert after["mesh"]["sha256"] != before["mesh"]["sha256"] or until(
            lambda: status(page)["mesh"]["sha256"]
        )
        for section in ("camera", "filters", "colour", "silhouette"):
            assert after[section] == before[section], section
        assert summary(page)["shown"]["cells"] == 34
        assert page.evaluate("() => window.hexalab.quality('scaled_jacobian')")["min"] < 1

        write_beside(file, grid(3, 3, 3))  # other cells: what was picked would be others
        until(lambda: summary(page)["cells"] == 27)
        until(lambda: summary(page)["shown"] and summary(page)["shown"]["cells"] == 27)
        assert status(page)["filters"]["picking"]["hidden"] == []
        assert status(page)["camera"] == before["camera"]


def test_A5_a_file_that_breaks_or_vanishes_leaves_the_mesh_and_is_watched_on(
    chromium: Browser, make: Callable[..., Path]
) -> None:
    file = make("a.mesh", 4, 3, 3)
    whole = file.read_bytes()
    with viewing("--watch", file) as program, visited(chromium, program.address) as page:
        file.write_bytes(whole[: len(whole) // 2])
        until(lambda: "still shown" in messages(page))
        assert "a.mesh" in messages(page)
        assert (summary(page)["cells"], summary(page)["shown"]["cells"]) == (36, 36)
        set_status(page, {"filters": {"peel": {"depth": 1}}})
        assert summary(page)["shown"]["cells"] == 2, "the mesh from before answers"
        file.unlink()
        until(lambda: "not there any more" in messages(page))
        hexalab.write(grid(5, 3, 3), file)
        until(lambda: summary(page)["cells"] == 45)
        until(lambda: summary(page)["shown"] and summary(page)["shown"]["cells"] == 3)
        until(lambda: "not there any more" not in messages(page))


def comparison(page: Page) -> dict[str, Any]:
    told: dict[str, Any] = page.evaluate("() => window.hexalab.comparison()") or {}
    return told


def test_A5_two_files_beside_each_other_are_watched(
    chromium: Browser, make: Callable[..., Path], tmp_path: Path
) -> None:
    before, after = make("before.mesh", 4, 3, 3), tmp_path / "after.vtk"
    hexalab.write(grid(4, 3, 3, noise=0.2), after)
    with (
        viewing("--compare", "--watch", before, after) as program,
        visited(chromium, program.address) as page,
    ):
        until(lambda: comparison(page).get("name") == "after.vtk")
        assert comparison(page)["same_cells"] is True
        assert page.evaluate("() => window.hexalab.changes('scaled_jacobian')")["worse"] == 36
        write_beside(after, grid(3, 3, 3))
        until(lambda: comparison(page).get("same_cells") is False)
        assert summary(page)["cells"] == 36, "the first mesh stays"
        assert page.locator("#second-canvas").is_visible()
        write_beside(before, grid(3, 3, 3, noise=0.2))
        until(lambda: comparison(page).get("same_cells") is True)
        assert page.evaluate("() => window.hexalab.changes('scaled_jacobian')")["better"] == 27


def test_A5_a_file_of_faces_alone_is_the_surface_that_a_mesh_is_compared_with(
    chromium: Browser, make: Callable[..., Path], tmp_path: Path
) -> None:
    mesh, surface = make("cube.mesh", 2, 2, 2), tmp_path / "square.mesh"
    square = (
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 {0} 0\n2 0 {0} 0\n2 2 {0} 0\n0 2 {0} 0\n"
        "Quadrilaterals\n1\n1 2 3 4 0\nEnd\n"
    )
    surface.write_text(square.format(2))
    with (
        viewing("--compare", "--watch", mesh, surface) as program,
        visited(chromium, program.address) as page,
    ):
        until(lambda: (comparison(page).get("surface") or {}).get("triangles") == 2)
        apart = page.evaluate("() => window.hexalab.distances()")
        assert apart["a_to_b"]["max"] == pytest.approx(2)
        new = tmp_path / "new.mesh"
        new.write_text(square.format(5))
        os.replace(new, surface)
        until(lambda: page.evaluate("() => window.hexalab.distances()")["a_to_b"]["max"] == pytest.approx(5))


def test_A5_the_page_says_that_the_program_has_ended(chromium: Browser, make: Callable[..., Path]) -> None:
    with viewing(make("a.mesh", 2, 2, 2)) as program:
        with visited(chromium, program.address, ends=True) as page:
            program.process.send_signal(signal.SIGINT)
            until(lambda: "has ended" in messages(page))
            assert (
                page.evaluate("async () => (await window.hexalab.screenshot({ width: 64, height: 64 })).size")
                > 100
            )
        assert program.process.wait(timeout=20) == 0


def test_A5_a_program_that_was_killed_is_missed(chromium: Browser, make: Callable[..., Path]) -> None:
    with viewing(make("a.mesh", 2, 2, 2)) as program, visited(chromium, program.address, ends=True) as page:
        program.process.kill()
        program.process.wait()
        until(lambda: "start `hexalab view` again" in messages(page) or "has ended" in messages(page))


def test_A5_a_page_without_the_token_says_what_to_do(chromium: Browser, make: Callable[..., Path]) -> None:
    with viewing(make("a.mesh", 2, 2, 2)) as program:
        page = chromium.new_page()
        for address in (program.root, f"{program.root}#token=wrong"):
            page.goto("about:blank")
            page.goto(address)
            until(lambda: "open the address that it printed" in messages(page))
            assert page.evaluate("() => window.hexalab.summary()") is None
        page.close()


class Foreign(BaseHTTPRequestHandler):
    """A page of another site."""

    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.end_headers()
        self.wfile.write(b"<!doctype html><title>another site</title>")

    def log_message(self, *_: object) -> None:
        """Stay quiet."""


TRY = """async ([root, token]) => {
  const headers = { "X-HexaLab-Token": token, "X-HexaLab-Seat": "stolen" };
  const tried = {};
  const attempt = async (name, act) => {
    try { tried[name] = await act(); } catch (error) { tried[name] = error.name; }
  };
  await attempt("hello", async () => (await fetch(root + "hello", { method: "POST", headers })).text());
  await attempt("plain", async () => (await fetch(root + "hello", { method: "POST", mode: "no-cors" })).type);
  await attempt("page", async () => (await fetch(root)).text());
  await attempt("script", () => new Promise((resolve) => {
    const script = document.createElement("script");
    script.type = "module";
    script.src = root + "viewer.js";
    script.onload = () => resolve("loaded");
    script.onerror = () => resolve("blocked");
    document.head.append(script);
  }));
  await attempt("frame", () => new Promise((resolve) => {
    const frame = document.createElement("iframe");
    frame.src = root;
    frame.onload = () => resolve("loaded");
    document.body.append(frame);
  }));
  return tried;
}"""


def test_A5_a_page_of_another_site_gets_nothing_though_it_knew_the_token(
    chromium: Browser, make: Callable[..., Path]
) -> None:
    with viewing(make("a.mesh", 2, 2, 2)) as program, ThreadingHTTPServer(("127.0.0.1", 0), Foreign) as other:
        threading.Thread(target=other.serve_forever, daemon=True).start()
        page = chromium.new_page()
        answers: list[int] = []
        page.on(
            "response", lambda answer: answers.append(answer.status) if program.root in answer.url else None
        )
        page.goto(f"http://127.0.0.1:{other.server_address[1]}/")
        token = program.address.split("token=")[1]
        tried = page.evaluate(TRY, [program.root, token])
        assert tried["hello"] == "TypeError", tried
        assert tried["plain"] in ("opaque", "TypeError"), tried
        assert (tried["page"], tried["script"]) == ("TypeError", "blocked"), tried
        assert not [status for status in answers if status == 200], answers
        assert page.frames[-1].evaluate("() => document.querySelector('canvas')") is None
        page.close()
        other.shutdown()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["missing.mesh"], "missing.mesh: no such file or directory"),
        (["."], "found a folder, expected a mesh file"),
        (["--host", "0.0.0.0", "x.mesh"], "SSH tunnel"),
        (["--port", "70000", "x.mesh"], "expected a port"),
        ([], "FILE"),
    ],
)
def test_A5_what_can_not_be_is_said_in_a_line(tmp_path: Path, words: list[str], said: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "hexalab", "view", *words],
        capture_output=True, text=True, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT / "core")},
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (2, "")
    assert said in done.stderr and len(done.stderr.splitlines()) == 1


def test_A5_a_port_that_is_taken_is_said(make: Callable[..., Path]) -> None:
    file = make("a.mesh", 1, 1, 1)
    with viewing(file) as program:
        port = program.root.rstrip("/").split(":")[-1]
        done = subprocess.run(
            [sys.executable, "-m", "hexalab", "view", "--no-browser", "--port", port, str(file)],
            capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(ROOT / "core")},
        )  # fmt: skip
        assert done.returncode == 2 and f"port {port} can't be used" in done.stderr


def test_A5_over_ssh_the_tunnel_is_told(make: Callable[..., Path]) -> None:
    with viewing(
        make("a.mesh", 1, 1, 1), environment={"SSH_CONNECTION": "10.0.0.1 5 10.0.0.2 22"}
    ) as program:
        port = program.root.rstrip("/").split(":")[-1]
        assert re.search(rf"ssh -N -L {port}:127\.0\.0\.1:{port} \S+@\S+", program.printed)


def test_A5_a_browser_is_started_with_a_ticket_not_the_token(
    make: Callable[..., Path], tmp_path: Path
) -> None:
    browser = tmp_path / "browser.sh"
    browser.write_text(f'#!/bin/sh\necho "$1" > {tmp_path}/opened\n')
    browser.chmod(0o755)
    process = subprocess.Popen(
        [sys.executable, "-m", "hexalab", "view", str(make("a.mesh", 1, 1, 1))],
        stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT / "core"), "BROWSER": str(browser), "DISPLAY": ""},
    )  # fmt: skip
    assert process.stdout
    address = process.stdout.readline().split()[-1]
    opened = until(lambda: (tmp_path / "opened").is_file() and (tmp_path / "opened").read_text().strip())
    assert opened.split("#")[0] == address.split("#")[0] and opened != address
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=20) == 0
    process.stdout.close()
