"""The service worker: a script, and before it the list of files that make the site work without a network."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

SCRIPT = "static/service_worker.js"
HASHED = re.compile(r"^runtime-[0-9a-f]+/|^viewer/.*-[0-9A-Z]{8}\.js$|^styles/|^scripts/")
"""Addresses that carry their content's hash: what lies there never changes."""


def service_worker(root: Path, site: Path, addresses: Iterable[str]) -> str:
    """The worker's text.

    Parameters
    ----------
    root : Path
        The checkout, with node_modules.
    site : Path
        The built site.
    addresses : iterable of str
        Files that are kept on the first visit, relative to the site's root.

    Raises
    ------
    RuntimeError
        If bundling fails.
    """
    entries = [_entry(site, address) for address in sorted(set(addresses))]
    return f"globalThis.precache = {json.dumps(entries, separators=(',', ':'))};\n{_bundled(root)}"


def _entry(site: Path, address: str) -> dict[str, str | None]:
    digest = hashlib.sha256((site / address).read_bytes()).digest()
    entry: dict[str, str | None] = {
        "url": address,
        "revision": None if HASHED.search(address) else digest.hex()[:16],
    }
    if HASHED.search(address):
        entry["integrity"] = f"sha256-{base64.b64encode(digest).decode()}"
    return entry


def _bundled(root: Path) -> str:
    command = [
        str(root / "node_modules" / ".bin" / "esbuild"), str(root / SCRIPT),
        "--bundle", "--format=iife", "--target=es2022", "--minify", "--legal-comments=eof",
        '--define:process.env.NODE_ENV="production"', "--log-level=warning",
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, cwd=root)
    if done.returncode:
        raise RuntimeError(f"bundling the service worker failed:\n{done.stderr.strip()}")
    return done.stdout
