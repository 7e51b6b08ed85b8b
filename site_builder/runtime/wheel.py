"""The core as a wheel: pure Python, the same bytes for the same sources."""

from __future__ import annotations

from pathlib import Path

from .archives import packed

LEFT_OUT = ("cli", "hosts", "__pycache__")
"""Folders of the core that a browser has no use for."""


def core_wheel(package: Path, version: str) -> tuple[str, bytes]:
    """Make the wheel of the package `hexalab`.

    Parameters
    ----------
    package : Path
        The folder core/hexalab.
    version : str
        The distribution's version.

    Returns
    -------
    name : str
        File name of the wheel.
    data : bytes
        Its content.
    """
    info = f"hexalab-{version}.dist-info"
    files = {
        f"hexalab/{path.relative_to(package).as_posix()}": path.read_bytes()
        for path in sorted(package.rglob("*"))
        if path.suffix in (".py", ".json") and not set(path.relative_to(package).parts) & set(LEFT_OUT)
    }
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: hexalab\nVersion: {version}\nLicense: MIT\nRequires-Dist: numpy\n"
    ).encode()
    files[f"{info}/WHEEL"] = (
        b"Wheel-Version: 1.0\nGenerator: hexalab\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    )
    return f"hexalab-{version}-py3-none-any.whl", packed(files)
