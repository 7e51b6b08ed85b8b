"""The viewer's JavaScript, bundled by esbuild under names that carry their content's hash."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import TypedDict

ENTRIES = {
    "start": "static/viewer/start.js",
    "main": "static/viewer/main.js",
    "worker": "static/viewer/core/worker.js",
}


COMMAND = (
    "--bundle", "--format=esm", "--target=es2022", "--minify", "--legal-comments=eof", "--external:html2canvas",
    "--external:dompurify", "--external:canvg", "--loader:.glsl=text", "--loader:.svg=text", "--log-level=warning",
)  # fmt: skip
"""Options of esbuild. What is external, jsPDF would load for HTML and for SVG by another way than ours: it is never
asked for."""


class Bundle(TypedDict):
    """A script as the page links it, and the scripts that come with it before it runs; names of files."""

    script: str
    imports: list[str]


def bundle(root: Path, out: Path) -> dict[str, Bundle]:
    """Bundle the viewer into `out`.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.
    out : Path
        Folder for the bundles.

    Returns
    -------
    dict of str to Bundle
        By the name of the entry.
    """
    meta = out / "meta.json"
    command = [
        str(root / "node_modules" / ".bin" / "esbuild"),
        *(f"{name}={root / path}" for name, path in ENTRIES.items()),
        *COMMAND, "--sourcemap=linked", "--splitting", "--chunk-names=[name]-[hash]", f"--outdir={out}",
        "--entry-names=[name]-[hash]", f"--metafile={meta}",
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, cwd=root)
    if done.returncode:
        raise RuntimeError(f"bundling the viewer failed:\n{done.stderr.strip()}")
    outputs = json.loads(meta.read_text())["outputs"]
    meta.unlink()
    names = {path: name for name, path in ENTRIES.items()}
    return {
        names[entry["entryPoint"]]: {
            "script": Path(path).name,
            "imports": [
                Path(one["path"]).name for one in entry["imports"] if one["kind"] == "import-statement"
            ],
        }
        for path, entry in outputs.items()
        if entry.get("entryPoint") in names
    }


def bundled(root: Path, entry: str) -> str:
    """One script with all that it imports.

    Raises
    ------
    RuntimeError
        If bundling fails.
    """
    command = [str(root / "node_modules" / ".bin" / "esbuild"), str(root / entry), *COMMAND]
    done = subprocess.run(command, capture_output=True, text=True, cwd=root)
    if done.returncode:
        raise RuntimeError(f"bundling the viewer failed:\n{done.stderr.strip()}")
    return done.stdout
