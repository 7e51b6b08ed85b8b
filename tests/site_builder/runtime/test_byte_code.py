"""pyodide-build's byte-compiler, run inside Pyodide under Node: what it makes is what that Python itself would make."""

from __future__ import annotations

import _imp
import base64
import io
import json
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import pytest

from site_builder.runtime.archives import packed, unpacked
from site_builder.runtime.byte_code import Archive, byte_code

ROOT = Path(__file__).resolve().parents[3]
PYODIDE = ROOT / "node_modules" / "pyodide"
TOOLS = ROOT / "build" / "pyodide-build"

SOURCES = {
    "shape/__init__.py": b'"""A package."""\nfrom .area import area\n',
    "shape/area.py": b'def area(a, b=2):\n    """Of a rectangle."""\n    assert a > 0, "thin"\n    return a * b\n',
    "shape/notes.txt": b"kept as it is",
}
INFO = {"shape-1.0.dist-info/WHEEL": b"Wheel-Version: 1.0\nTag: py3-none-any\n"}

TRUTH = """
import { loadPyodide } from "PYODIDE";
const pyodide = await loadPyodide({ indexURL: "FOLDER" });
pyodide.globals.set("given", process.argv[1]);
console.log(pyodide.runPython(`
import base64, importlib.util, json, marshal
def told(row):
    made = marshal.loads(base64.b64decode(row["byte_code"])[16:])
    own = [compile(row["source"], row["name"], "exec", dont_inherit=True, optimize=level) for level in (0, 1, 2)]
    return {"levels": [level for level in (0, 1, 2) if own[level] == made], "file": made.co_filename}
json.dumps({"magic": importlib.util.MAGIC_NUMBER.hex(), "modules": [told(row) for row in json.loads(given)]})
`));
"""
"""Asks Pyodide for its magic number, and at which level of optimisation its own `compile` makes this very code."""


@pytest.fixture(scope="module")
def compiled() -> dict[int, tuple[str, dict[str, bytes]]]:
    """Level of optimisation to name and files of an archive: at 1 a wheel, at 2 a zip archive."""
    wheel = Archive("shape-1.0-py3-none-any.whl", packed(SOURCES | INFO), optimize=1)
    archive = Archive("shapes.zip", packed(SOURCES), (r"\.txt$",))
    one, two = byte_code([wheel, archive], PYODIDE, TOOLS)
    return {1: (one[0], unpacked(one[1])), 2: (two[0], unpacked(two[1]))}


@pytest.fixture(scope="module")
def truth(compiled: dict[int, tuple[str, dict[str, bytes]]]) -> dict[str, Any]:
    rows = [
        {
            "name": name,
            "source": SOURCES[name].decode(),
            "byte_code": base64.b64encode(files[name + "c"]).decode(),
        }
        for _, files in compiled.values()
        for name in ("shape/__init__.py", "shape/area.py")
    ]
    script = TRUTH.replace("PYODIDE", (PYODIDE / "pyodide.mjs").as_uri()).replace("FOLDER", str(PYODIDE))
    done = subprocess.run(
        ["node", "--input-type=module", "--eval", script, json.dumps(rows)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return dict(json.loads(done.stdout))


def test_the_code_is_what_that_python_compiles_at_this_level(truth: dict[str, Any]) -> None:
    """`__init__.py` has a docstring and no assertion, so without docstrings removed 0 and 1 are the same to it."""
    assert [module["levels"] for module in truth["modules"]] == [[0, 1], [1], [2], [2]]
    assert [module["file"] for module in truth["modules"]] == ["shape/__init__.py", "shape/area.py"] * 2


def test_every_module_is_byte_code_of_this_pyodide(
    compiled: dict[int, tuple[str, dict[str, bytes]]], truth: dict[str, Any]
) -> None:
    for _, files in compiled.values():
        assert not [name for name in files if name.endswith(".py")]
        modules = [name for name in files if name.endswith(".pyc")]
        assert sorted(modules) == ["shape/__init__.pyc", "shape/area.pyc"]
        assert {files[name][:4].hex() for name in modules} == {truth["magic"]}


def test_a_module_carries_its_sources_hash_and_no_time(
    compiled: dict[int, tuple[str, dict[str, bytes]]],
) -> None:
    """PEP 552: flags 3, then eight bytes of SipHash, keyed by the magic number."""
    for _, files in compiled.values():
        for name in ("shape/__init__.py", "shape/area.py"):
            header = files[name + "c"][:16]
            key = int.from_bytes(header[:4], "little")
            assert header[4:] == (3).to_bytes(4, "little") + _imp.source_hash(key, SOURCES[name])


def test_other_files_stay_but_what_is_left_out_is_left_out(
    compiled: dict[int, tuple[str, dict[str, bytes]]],
) -> None:
    assert compiled[1][1]["shape/notes.txt"] == SOURCES["shape/notes.txt"]
    assert "shape/notes.txt" not in compiled[2][1]


def test_a_wheel_is_named_for_the_python_of_its_byte_code(
    compiled: dict[int, tuple[str, dict[str, bytes]]],
) -> None:
    lock = json.loads((PYODIDE / "pyodide-lock.json").read_text())
    major, minor, _ = lock["info"]["python"].split(".")
    assert compiled[1][0] == f"shape-1.0-cp{major}{minor}-none-any.whl"
    assert compiled[2][0] == "shapes.zip"


def test_an_archive_that_comes_back_uncompiled_is_an_error() -> None:
    with pytest.raises(RuntimeError, match=r"did not compile shape\.whl"):
        byte_code([Archive("shape.whl", packed(SOURCES))], PYODIDE, TOOLS)


def test_a_module_that_is_not_python_is_an_error() -> None:
    with pytest.raises(RuntimeError, match=r"wrong\.py"):
        byte_code([Archive("wrong.zip", packed({"wrong.py": b"def\n"}))], PYODIDE, TOOLS)


def test_missing_tools_are_named(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match="pyodide-build"):
        byte_code([Archive("shapes.zip", packed(SOURCES))], PYODIDE, tmp_path)


def test_its_wheels_are_the_ones_pinned() -> None:
    """By hash as pip has checked; and what both files pin is pinned alike."""
    lines = (ROOT / "requirements-pyodide.txt").read_text().splitlines()
    pinned = dict(line.split(" ")[0].split("==") for line in lines if line and not line.startswith("#"))
    assert all("--hash=sha256:" in line for line in lines if line and not line.startswith("#"))
    found = {
        path.name.split("-")[0].replace("_", "-"): path.name.split("-")[1] for path in TOOLS.glob("*.whl")
    }
    assert found == pinned
    with zipfile.ZipFile(io.BytesIO(next(TOOLS.glob("pyodide_build-*")).read_bytes())) as wheel:
        assert "pyodide_build/_py_compile.py" in wheel.namelist()
    ours = dict(
        line.split("==") for line in (ROOT / "requirements.txt").read_text().splitlines() if "==" in line
    )
    assert {name: ours[name] for name in pinned if name in ours} == {
        name: version for name, version in pinned.items() if name in ours
    }
