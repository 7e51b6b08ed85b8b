"""Puts interpreter, core and viewer into the site, and remembers them by the hash of what they are made from."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from .bundle import Bundle, bundle
from .interpreter import copy_interpreter
from .wheel import core_wheel, distribution

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class RuntimeReport:
    """What the pages need to know of the runtime.

    Attributes
    ----------
    scripts : dict of str to str
        "start", "main" and "worker" to their files' addresses, relative to the site's root.
    imports : list of str
        Addresses of what these scripts import before they run.
    runtime : str
        Address of the interpreter's folder, relative to the site's root, ending in a slash.
    """

    scripts: dict[str, str]
    imports: list[str]
    runtime: str


def assemble(out: Path, cache: Path | None = None) -> RuntimeReport:
    """Write `runtime-HASH/` and the viewer's bundles to the site in `out`.

    Parameters
    ----------
    out : Path
        The site's root.
    cache : Path, optional
        Folder that keeps what was made, by the hash of its sources; `build/cache` of the checkout by default.

    Raises
    ------
    RuntimeError
        If an interpreter file isn't the published one, or a tool fails.
    """
    cache = cache or ROOT / "build" / "cache"
    wheel = core_wheel(distribution(ROOT, cache / "distribution", cache=cache))
    modules = ROOT / "node_modules"
    pins = ROOT / "requirements-pyodide.txt"
    made_by = [*Path(__file__).parent.glob("*.*"), modules / "pyodide" / "package.json", pins]
    key = _hash([wheel[1], *_contents(made_by)])
    interpreter = cache / f"runtime-{key}"
    if not (interpreter / "pyodide-lock.json").is_file():
        _forget(cache, "runtime-*")
        copy_interpreter(modules, ROOT / "build" / "pyodide-build", interpreter, wheel)
    runtime = f"runtime-{key}"
    _forget(out, "runtime-*", keep=runtime)
    _copy_tree(interpreter, out / runtime)

    folders = (ROOT / "static" / name for name in ("viewer", "offline"))
    scripts = [path for folder in folders for path in folder.rglob("*") if path.is_file()]
    lock = ROOT / "package-lock.json"
    bundle_key = _hash(_contents([*scripts, lock, Path(__file__).with_name("bundle.py")]))
    bundles = cache / f"viewer-{bundle_key}"
    index = bundles / "index.json"
    if not index.is_file():
        _forget(cache, "viewer-*")
        bundles.mkdir(parents=True)
        index.write_text(json.dumps(bundle(ROOT, bundles)))
    entries: dict[str, Bundle] = json.loads(index.read_text())
    bundled = {path.name for path in bundles.iterdir()} - {"index.json"}
    for old in (out / "viewer").glob("*-*.js*"):
        if old.name not in bundled:
            old.unlink()
    _copy_tree(bundles, out / "viewer", leave_out=frozenset({"index.json"}))
    return RuntimeReport(
        {name: f"viewer/{one['script']}" for name, one in entries.items()},
        sorted({f"viewer/{script}" for one in entries.values() for script in one["imports"]}),
        f"{runtime}/",
    )


def _contents(paths: Iterable[Path]) -> list[bytes]:
    return [path.name.encode() + b"\0" + path.read_bytes() for path in sorted(paths)]


def _hash(parts: Iterable[bytes]) -> str:
    digest = hashlib.sha256()
    for part in parts:
        digest.update(hashlib.sha256(part).digest())
    return digest.hexdigest()[:16]


def _forget(folder: Path, pattern: str, keep: str = "") -> None:
    for old in folder.glob(pattern):
        if old.name != keep:
            shutil.rmtree(old)


def _copy_tree(source: Path, target: Path, leave_out: frozenset[str] = frozenset()) -> None:
    target.mkdir(parents=True, exist_ok=True)
    for path in sorted(source.iterdir()):
        if path.name in leave_out:
            continue
        copy = target / path.name
        if not copy.is_file() or copy.stat().st_size != path.stat().st_size:
            shutil.copyfile(path, copy)
