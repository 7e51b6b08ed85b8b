"""The interpreter's files: checked against the hashes that their makers published, then made smaller and faster.

Pyodide comes from npm. The numpy wheel made for it is in no registry by itself: an npm package carries it, and its
SHA-256 must equal the one in Pyodide's own lock file. Where the carrier is missing, Pyodide's distribution address
serves the same file. Both archives are then compiled to byte code without the parts that a viewer never imports.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
import tempfile
import urllib.request
from pathlib import Path

from pyodide_lock import PyodideLockSpec
from pyodide_lock.spec import InfoSpec, PackageSpec

PYODIDE_VERSION = "0.29.0"
DISTRIBUTION = f"https://cdn.jsdelivr.net/pyodide/v{PYODIDE_VERSION}/full/"
PLAIN_FILES = ("pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm")

NUMPY_LEFT_OUT = (
    r"\.(pyi|pxd|pyx|h|a|c|build|in|ini|typed|src)$",
    r"^numpy/(f2py|random|testing|doc|core|compat|_pyinstaller|polynomial|distutils|fft)/",
    r"/tests/",
    r"(^|/)conftest\.py$",
    r"^numpy/_core/_(simd|multiarray_tests|umath_tests|operand_flag_tests|rational_tests|struct_ufunc_tests)",
)
STDLIB_LEFT_OUT = (
    r"^(idlelib|lib2to3|ensurepip|turtledemo|tkinter|curses|sqlite3|dbm|wsgiref|xmlrpc|venv|pydoc_data|unittest)/",
    r"^(test|distutils|multiprocessing|_pyrepl|ctypes/macholib|xml/sax|xml/dom)/",
    r"^(asyncio/windows|concurrent/futures/process)",
    r"^(turtle|doctest|pdb|imaplib|smtplib|ftplib|poplib|nntplib|telnetlib|mailbox|pickletools|optparse)\.py$",
    r"^(cProfile|profile|pstats|trace|tracemalloc|webbrowser|antigravity|this|imghdr|sndhdr|sunau|aifc)\.py$",
    r"^(chunk|wave|tabnanny|pyclbr|pydoc|cgi|cgitb|mailcap|nturl2path|plistlib|netrc|statistics|socketserver)\.py$",
    r"^encodings/(cp(?!437)|mac_|iso|big5|euc|gb|hz|johab|koi|kz|ptcp|shift|tis|hp_|palmos|uu_|quopri|bz2|rot_)",
)


def copy_interpreter(node_modules: Path, out: Path, core_wheel: tuple[str, bytes]) -> None:
    """Write interpreter, compiled standard library, numpy, the core and their lock file to `out`.

    Raises
    ------
    RuntimeError
        If a file is missing or its hash isn't the published one.
    """
    pyodide = node_modules / "pyodide"
    version = json.loads((pyodide / "package.json").read_text())["version"]
    if version != PYODIDE_VERSION:
        raise RuntimeError(f"pyodide {version} is installed, {PYODIDE_VERSION} is expected: run `npm ci`")
    lock = json.loads((pyodide / "pyodide-lock.json").read_text())
    numpy = lock["packages"]["numpy"]
    out.mkdir(parents=True, exist_ok=True)
    for name in PLAIN_FILES:
        shutil.copyfile(pyodide / name, out / name)
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "numpy.whl").write_bytes(official_wheel(node_modules, numpy))
        (work / "core.whl").write_bytes(core_wheel[1])
        plan = [
            {
                "source": str(pyodide / "python_stdlib.zip"),
                "target": str(out / "python_stdlib.zip"),
                "leave_out": STDLIB_LEFT_OUT,
            },
            {
                "source": str(work / "numpy.whl"),
                "target": str(out / numpy["file_name"]),
                "leave_out": NUMPY_LEFT_OUT,
                "optimize": 1,  # numpy reads its own docstrings while it is imported
            },
            {"source": str(work / "core.whl"), "target": str(out / core_wheel[0])},
        ]
        (work / "plan.json").write_text(json.dumps(plan))
        script = Path(__file__).with_name("compile_python.mjs")
        done = subprocess.run(
            ["node", str(script), str(pyodide), str(work / "plan.json")], capture_output=True, text=True
        )
        if done.returncode:
            raise RuntimeError(f"compiling Python under Pyodide failed:\n{done.stderr.strip()[-1500:]}")
    _write_lock(out, lock["info"], numpy, core_wheel[0])


def official_wheel(node_modules: Path, package: dict[str, str]) -> bytes:
    """The wheel that Pyodide's lock file names, from its carrier or from Pyodide's distribution; hash checked."""
    carrier = node_modules / "@galaxyproject" / "vintent" / "static" / "pyodide" / package["file_name"]
    if carrier.is_file():
        data, origin = carrier.read_bytes(), str(carrier.relative_to(node_modules))
    else:
        origin = DISTRIBUTION + package["file_name"]
        with urllib.request.urlopen(origin, timeout=120) as response:
            data = response.read()
    found = hashlib.sha256(data).hexdigest()
    if found != package["sha256"]:
        raise RuntimeError(f"{origin}: SHA-256 is {found}, pyodide-lock.json says {package['sha256']}")
    return data


def _write_lock(out: Path, info: dict[str, str], numpy: dict[str, str], core_name: str) -> None:
    """The site's own lock file: numpy and the core, with the hashes of the files that are served."""

    def entry(name: str, version: str, file_name: str, depends: list[str]) -> PackageSpec:
        digest = hashlib.sha256((out / file_name).read_bytes()).hexdigest()
        return PackageSpec(
            name=name, version=version, file_name=file_name, install_dir="site", sha256=digest,
            package_type="package", imports=[name], depends=depends,
        )  # fmt: skip

    spec = PyodideLockSpec(
        info=InfoSpec(**info),
        packages={
            "numpy": entry("numpy", numpy["version"], numpy["file_name"], []),
            "hexalab": entry("hexalab", core_name.split("-")[1], core_name, ["numpy"]),
        },
    )
    spec.to_json(out / "pyodide-lock.json")
