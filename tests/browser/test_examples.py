"""The example notebook, as a reader runs it: every cell, in JupyterLab (SPEC A6)."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from .lab import jupyterlab
from .test_notebook import asked, run, view
from .ui import until

pytest.importorskip("anywidget")
pytest.importorskip("jupyterlab")
pytestmark = pytest.mark.browser
NOTEBOOK = Path(__file__).parents[2] / "docs" / "examples" / "notebook.ipynb"


def test_A6_the_example_notebook_runs(chromium: Browser, tmp_path: Path) -> None:
    document = json.loads(NOTEBOOK.read_text())
    codes = ["".join(cell["source"]) for cell in document["cells"] if cell["cell_type"] == "code"]
    assert all(not cell["outputs"] for cell in document["cells"] if cell["cell_type"] == "code"), "kept bare"
    with jupyterlab(tmp_path) as lab, lab.opened(chromium, "example.ipynb", *codes) as page:
        frame = view(page)
        assert asked(frame, "summary()")["cells"] == 8 * 6 * 4
        until(lambda: asked(frame, "summary()")["shown"]["cells"] == 8 * 6 * 2)
        worst = run(page, "print(worst)")
        until(lambda: worst in frame.locator(".inspector").inner_text())
        outputs = [cell["outputs"] for cell in lab.saved(page, "example.ipynb")["cells"]]
        assert not [one for cell in outputs for one in cell if one["output_type"] == "error"], outputs
