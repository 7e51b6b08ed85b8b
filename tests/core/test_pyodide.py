"""The core's own tests once more, on the Python and numpy that browsers get."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.skipif(sys.platform == "emscripten", reason="is itself what starts them")
def test_A1_the_core_passes_its_tests_inside_pyodide() -> None:
    if shutil.which("node") is None or not (ROOT / "node_modules" / "pyodide").is_dir():
        pytest.skip("needs Node and pyodide, which are not installed")
    site_packages = Path(np.__file__).parents[1]
    command = ["node", "tests/core_in_pyodide.mjs", str(site_packages), "-x", "tests/core"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, encoding="utf-8", timeout=900)
    passed = re.search(r"(\d+) passed", done.stdout)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]
    assert passed
    assert int(passed[1]) > 50
