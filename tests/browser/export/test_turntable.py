"""The turntable (SPEC A8); truth: what a box looks like from its sides, and the browser's own player."""

from __future__ import annotations

import base64
import io
import zipfile

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page

from .asking import take

pytestmark = pytest.mark.browser


def test_A8_a_turntable_goes_round_once_and_comes_back(viewer: Page) -> None:
    before = viewer.evaluate("() => window.hexalab.getStatus()")
    turn = {"frames": 4, "width": 200, "height": 150}
    archive = zipfile.ZipFile(io.BytesIO(take(viewer, "turntable", turn)))
    assert archive.namelist() == [f"brick-{number:03}.png" for number in range(4)]
    frames = [
        np.asarray(Image.open(io.BytesIO(archive.read(name))).convert("RGB")).astype(int)
        for name in archive.namelist()
    ]
    assert {frame.shape for frame in frames} == {(150, 200, 3)}
    for frame in frames:
        drawn = (frame != 255).any(axis=2)
        assert drawn.any() and not (
            drawn[0].any() or drawn[-1].any() or drawn[:, 0].any() or drawn[:, -1].any()
        )
    # A box is its own mirror image half a turn on, but for its light; a quarter on, it is another.
    quarter, half = (np.abs(frames[0] - frames[place]).mean() for place in (1, 2))
    assert quarter > 5 * max(half, 0.1)
    assert viewer.evaluate("() => window.hexalab.getStatus()") == before


@pytest.mark.parametrize("form", ["webm", "mp4"])
def test_A8_a_turntable_as_a_video_plays(viewer: Page, chromium: Browser, form: str) -> None:
    turn = {"frames": 8, "seconds": 2, "width": 160, "height": 120, "format": form}
    data = base64.b64encode(take(viewer, "turntable", turn)).decode()
    page = chromium.new_page()
    told = page.evaluate(
        """async ([data, type]) => {
          const video = document.createElement("video");
          video.src = `data:${type};base64,${data}`;
          await new Promise((resolve, reject) => {
            video.onloadeddata = resolve;
            video.onerror = () => reject(new Error(video.error.message));
          });
          return { seconds: video.duration, width: video.videoWidth, height: video.videoHeight };
        }""",
        [data, f"video/{form}"],
    )
    page.close()
    assert (told["width"], told["height"]) == (160, 120)
    assert told["seconds"] == pytest.approx(2, abs=0.3)
