"""What a browser gets: byte code of one Python alone, nothing that it never imports, and a lock file that fits."""

from __future__ import annotations

import gzip
import hashlib
import json
from pathlib import Path

import pytest
from packaging.utils import parse_wheel_filename
from wheel.wheelfile import WheelFile

from site_builder.runtime import RuntimeReport, assemble
from site_builder.runtime.archives import unpacked

MAGIC_3_13 = bytes.fromhex("f30d0d0a")
"""Of CPython 3.13: 3571, little-endian, then CR LF (Include/internal/pycore_magic_number.h)."""


@pytest.fixture(scope="module")
def runtime(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, RuntimeReport]:
    site = tmp_path_factory.mktemp("runtime")
    return site, assemble(site)


@pytest.fixture(scope="module")
def archives(runtime: tuple[Path, RuntimeReport]) -> dict[str, dict[str, bytes]]:
    """`python_stdlib`, `numpy` and `hexalab` to their files."""
    folder = runtime[0] / runtime[1].runtime
    found = {
        path.name.split("-")[0].split(".")[0]: path for path in [*folder.glob("*.whl"), *folder.glob("*.zip")]
    }
    return {name: unpacked(path.read_bytes()) for name, path in found.items()}


def test_modules_are_byte_code_alone(archives: dict[str, dict[str, bytes]]) -> None:
    assert sorted(archives) == ["hexalab", "numpy", "python_stdlib"]
    for name, files in archives.items():
        modules = [data for file, data in files.items() if file.endswith(".pyc")]
        assert len(modules) > 80, name
        assert {data[:4] for data in modules} == {MAGIC_3_13}, name
        assert not [file for file in files if file.endswith((".py", ".pyi", ".h", ".pxd"))], name


@pytest.mark.parametrize(
    ("archive", "there", "gone"),
    [
        ("python_stdlib", "asyncio/base_events", "asyncio/proactor_events"),
        ("python_stdlib", "datetime", "_pydatetime"),
        ("python_stdlib", "http/__init__", "http/server"),
        ("python_stdlib", "encodings/utf_8", "encodings/shift_jis"),
        ("python_stdlib", "encodings/cp437", "encodings/cp1252"),
        ("python_stdlib", "pyodide/__init__", "unittest/__init__"),
        ("numpy", "numpy/linalg/__init__", "numpy/linalg/tests/__init__"),
        ("numpy", "numpy/lib/format", "numpy/random/__init__"),
        ("numpy", "numpy/linalg/_linalg", "numpy/ma/core"),
        ("numpy", "numpy/__init__", "numpy/conftest"),
        ("hexalab", "hexalab/session/__init__", "hexalab/cli/__init__"),
        ("hexalab", "hexalab/formats/vtu", "hexalab/hosts/__init__"),
    ],
)
def test_what_is_left_out_is_left_out(
    archives: dict[str, dict[str, bytes]], archive: str, there: str, gone: str
) -> None:
    assert f"{there}.pyc" in archives[archive]
    assert f"{gone}.pyc" not in archives[archive]


def test_the_lock_file_fits_what_is_served(runtime: tuple[Path, RuntimeReport]) -> None:
    folder = runtime[0] / runtime[1].runtime
    lock = json.loads((folder / "pyodide-lock.json").read_text())
    assert sorted(lock["packages"]) == ["hexalab", "numpy"]
    abi = f"pyodide_{lock['info']['abi_version']}_wasm32"
    for name, package in lock["packages"].items():
        served = folder / package["file_name"]
        assert package["sha256"] == hashlib.sha256(served.read_bytes()).hexdigest()
        named, version, _, tags = parse_wheel_filename(served.name)
        assert (named, str(version)) == (name, package["version"])
        (tag,) = tags
        assert tag.interpreter == "cp313"
        assert tag.platform == (abi if name == "numpy" else "any")
        with WheelFile(served) as wheel:  # compares with RECORD whatever it reads
            for file in wheel.namelist():
                wheel.read(file)


def test_P8_viewer_and_python_weigh_little(runtime: tuple[Path, RuntimeReport]) -> None:
    """Interpreter, numpy, core and scripts, compressed as hosts of static pages send them; the page is 80 kB."""
    site, report = runtime
    served = [*(site / report.runtime).iterdir(), *(site / one for one in report.scripts.values())]
    sizes = {path.name: len(gzip.compress(path.read_bytes(), 6, mtime=0)) for path in served}
    assert sum(sizes.values()) < 7_600_000, sizes
