"""A real JupyterLab for the tests: a server of its own, homes of its own, notebooks run in real Chromium."""

from __future__ import annotations

import json
import os
import secrets
import signal
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Page

from .ui import until

ROOT = Path(__file__).parents[2]
RUN_ALL = """async () => {
    const app = window.jupyterapp;
    await app.commands.execute("notebook:run-all-cells");
}"""
READY = """() => {
    const app = window.jupyterapp;
    const panel = app?.shell.currentWidget;
    const session = panel?.sessionContext;
    return session?.session?.kernel?.connectionStatus === "connected" && session.session.kernel.status === "idle";
}"""


def notebook(*cells: str) -> dict[str, Any]:
    """A notebook of code cells."""
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return {
        "cells": [
            {"cell_type": "code", "id": f"cell-{number}", "metadata": {}, "execution_count": None, "outputs": [],
             "source": cell}
            for number, cell in enumerate(cells)
        ],
        "metadata": {"kernelspec": kernel},
        "nbformat": 4,
        "nbformat_minor": 5,
    }  # fmt: skip


class Lab:
    """A running JupyterLab and the folder that it shows."""

    def __init__(self, folder: Path, address: str, token: str) -> None:
        self.folder, self.address, self._token = folder, address, token
        self._context: BrowserContext | None = None

    @contextmanager
    def opened(self, chromium: Browser, name: str, *cells: str) -> Iterator[Page]:
        """A page with a notebook of these cells, all run; the pages share a cache of JupyterLab's scripts."""
        (self.folder / name).write_text(json.dumps(notebook(*cells)))
        self._context = self._context or chromium.new_context(
            viewport={"width": 1280, "height": 2400}, color_scheme="null"
        )
        page = self._context.new_page()
        page.goto(f"{self.address}lab/tree/{name}?token={self._token}&reset")
        until(lambda: page.evaluate("() => window.jupyterapp !== undefined"), 60)
        until(lambda: page.evaluate(READY), 60)
        page.evaluate(RUN_ALL)
        try:
            yield page
        finally:
            page.close()

    def close(self) -> None:
        """Close what the pages shared."""
        if self._context:
            self._context.close()

    def saved(self, page: Page, name: str) -> dict[str, Any]:
        """The notebook as it is saved."""
        page.evaluate("() => window.jupyterapp.commands.execute('docmanager:save')")
        found: dict[str, Any] = json.loads((self.folder / name).read_text())
        return found


@contextmanager
def jupyterlab(folder: Path) -> Iterator[Lab]:
    """A JupyterLab for the time of a `with` block."""
    homes = {
        "HOME": folder / "home", "JUPYTER_CONFIG_DIR": folder / "config", "JUPYTER_DATA_DIR": folder / "data",
        "JUPYTER_RUNTIME_DIR": folder / "runtime", "IPYTHONDIR": folder / "ipython",
    }  # fmt: skip
    for place in (*homes.values(), folder / "notebooks"):
        place.mkdir(parents=True, exist_ok=True)
    token = secrets.token_hex(16)
    options = [
        f"--IdentityProvider.token={token}", "--no-browser", "--ServerApp.port=0", "--ServerApp.ip=127.0.0.1",
        f"--ServerApp.root_dir={folder / 'notebooks'}", "--ServerApp.allow_root=True",
        "--LabApp.expose_app_in_browser=True", "--LabApp.news_url=",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    ]  # fmt: skip
    with (folder / "log").open("w") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *options], stdout=log, stderr=log, start_new_session=True,
            env={**os.environ, "PYTHONPATH": str(ROOT / "core"), **{name: str(place) for name, place in homes.items()}},
        )  # fmt: skip
    try:
        until(lambda: list((folder / "runtime").glob("jpserver-*.json")), 60)
        (file,) = (folder / "runtime").glob("jpserver-*.json")
        address = until(lambda: file.read_text() and json.loads(file.read_text())["url"], 20)
        until(lambda: answers(f"{address}api/status?token={token}"), 20)
        running = Lab(folder / "notebooks", address, token)
        yield running
        running.close()
    finally:
        end(process)


@contextmanager
def marimo(app: Path) -> Iterator[str]:
    """A marimo application for the time of a `with` block; its address."""
    command = [sys.executable, "-m", "marimo", "run", app.name, "--headless", "--host", "127.0.0.1", "--port"]
    with free_port() as port:
        command.append(str(port))
    process = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True, cwd=app.parent,
        env={**os.environ, "PYTHONPATH": str(ROOT / "core"), "HOME": str(app.parent)},
    )  # fmt: skip
    address = f"http://127.0.0.1:{port}/"
    try:
        until(lambda: answers(address), 60)
        yield address
    finally:
        end(process)


@contextmanager
def free_port() -> Iterator[int]:
    """A port that nobody has."""
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        yield one.getsockname()[1]


def answers(address: str) -> bool:
    """Whether somebody answers there."""
    try:
        return bool(urllib.request.urlopen(address, timeout=5).status == 200)
    except OSError:
        return False


def end(process: subprocess.Popen[bytes]) -> None:
    """End a process and all that it has started."""
    os.killpg(process.pid, signal.SIGTERM)
    try:
        process.wait(timeout=20)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
