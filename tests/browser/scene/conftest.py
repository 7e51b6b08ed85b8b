"""A page with the scene in it, in real Chromium with the software GPU."""

from __future__ import annotations

import io
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from hexalab.status import DEFAULTS

image = pytest.importorskip("PIL.Image")

HERE = Path(__file__).parent
ROOT = HERE.parents[2]


class Stage:
    """One scene on one page: starts it, feeds it, takes its picture."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.messages: list[str] = []
        page.on("console", lambda message: self.messages.append(message.text))
        page.on("pageerror", lambda error: self.messages.append(str(error)))

    def start(
        self, width: int = 400, height: int = 300, ratio: float = 1, directions: int | None = None
    ) -> None:
        options = [width, height, ratio, {**DEFAULTS["camera"], "fit": False}, directions]
        self.page.evaluate("([w, h, r, camera, d]) => start(w, h, r, camera, d ?? undefined)", options)

    def call(self, method: str, *arguments: Any) -> Any:
        from .grids import pack

        return self.page.evaluate(
            "([method, values]) => scene[method](...values.map(unpack))",
            [method, [pack(value) for value in arguments]],
        )

    def run(self, script: str) -> Any:
        return self.page.evaluate(script)

    def settle(self) -> None:
        self.page.evaluate("next(4)")

    def picture(self) -> np.ndarray:
        """Return what the canvas shows, (h, w, 3) uint8."""
        data = self.page.locator("canvas").screenshot()
        return np.array(image.open(io.BytesIO(data)).convert("RGB"))


@pytest.fixture(scope="session")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> str:
    esbuild = ROOT / "node_modules" / ".bin" / "esbuild"
    if not esbuild.exists():
        pytest.skip("node_modules is not installed")
    out = tmp_path_factory.mktemp("harness") / "harness.js"
    source = str(HERE / "harness.js")
    subprocess.run(
        [str(esbuild), source, "--bundle", "--format=iife", f"--outfile={out}"],
        check=True,
        capture_output=True,
    )
    return out.read_text()


@pytest.fixture
def stage(chromium: Any, bundle: str) -> Iterator[Stage]:
    page = chromium.new_page(viewport={"width": 1280, "height": 800})
    page.set_content("<!doctype html><style>body{margin:0} canvas{display:block}</style>")
    page.add_script_tag(content=bundle)
    stage = Stage(page)
    stage.start()
    yield stage
    page.close()
    assert stage.messages == []
