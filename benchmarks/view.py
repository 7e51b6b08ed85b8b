"""`hexalab view` on large binary files: from the command to the picture, slices, and the program's memory."""

from __future__ import annotations

import re
import signal
import statistics
import subprocess
import sys
from pathlib import Path
from time import perf_counter, sleep

from playwright.sync_api import Browser, Page

from hexalab.hosts.browser import browser

from .browser import SLICE
from .clock import table
from .grids import LARGE, SIZES, grid_file
from .page import WINDOW

MESHES = ("1M", *LARGE)
GOALS = {"1M": 1000, "4M": 4000, "10M": 10_000}
"""Milliseconds within which a mesh is to open."""

assert set(MESHES) <= {*SIZES, *LARGE}

HEAD = (
    "mesh",
    "file [MB]",
    "goal",
    "command to picture",
    "to page",
    "read",
    "topology",
    "first picture of the page",
)


def run(folder: Path) -> None:
    """Print the tables of `hexalab view`."""
    opened, sliced = [], []
    with browser() as chromium:
        for name in MESHES:
            file = grid_file(name, ".vtk", folder)
            times, slices, peak = _view(chromium, file)
            opened.append([name, file.stat().st_size / 1e6, GOALS[name], *times])
            sliced.append([name, *slices, peak / 1e6])
    table("view: binary .vtk, the browser runs already [ms]", list(HEAD), opened)
    table(
        "view: 41 slices [ms], and the most memory that the program held [GB]",
        ["mesh", "core, median", "core, worst", "to picture, median", "worst", "GB"],
        sliced,
    )


def _view(chromium: Browser, file: Path) -> tuple[list[float], list[float], float]:
    page = chromium.new_page(viewport=WINDOW)
    began = perf_counter()
    command = [sys.executable, "-m", "hexalab", "view", "--no-browser", str(file)]
    program = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        assert program.stdout
        address = re.search(r"http\S+", program.stdout.readline())
        assert address
        printed = perf_counter()
        page.goto(address[0])
        while not page.evaluate("() => window.hexalab?.timings().first_picture"):
            sleep(0.02)
        done = perf_counter()
        timings = page.evaluate("() => window.hexalab.timings()")
        steps = [timings["read"], timings["topology"], timings["first_picture"]]
        whole = [1000 * (done - began), 1000 * (printed - began), *steps]
        page.evaluate("() => window.hexalab.setStatus({ lighting: { mode: 'direct' } })")
        return whole, _slices(page), _peak(program.pid)
    finally:
        program.send_signal(signal.SIGINT)
        program.wait()
        page.close()


def _slices(page: Page) -> list[float]:
    times = [page.evaluate(SLICE, 0.3 + 0.01 * step) for step in range(41)]
    picture, core = zip(*times, strict=True)
    return [statistics.median(core), max(core), statistics.median(picture), max(picture)]


def _peak(process: int) -> float:
    """The most memory that a process has held, in kB; NaN where the system does not tell."""
    status = Path(f"/proc/{process}/status")
    found = re.search(r"VmHWM:\s+(\d+)", status.read_text()) if status.is_file() else None
    return float(found[1]) if found else float("nan")
