"""Zip archives and wheels whose bytes depend on their content alone: no time stamps, names in order."""

from __future__ import annotations

import base64
import hashlib
import io
import re
import zipfile
from collections.abc import Iterable, Mapping

EPOCH = (1980, 1, 1, 0, 0, 0)
"""The date of every entry: the earliest that a zip archive can hold."""

LEVEL = 9
"""How hard deflate tries: archives are made once and downloaded by every visitor."""


def unpacked(data: bytes, leave_out: Iterable[str] = ()) -> dict[str, bytes]:
    """The files of an archive.

    Parameters
    ----------
    data : bytes
        A zip archive or a wheel.
    leave_out : iterable of str
        Regular expressions; a file in whose name (path from the archive's root, with slashes) one of them is
        found is not wanted.

    Returns
    -------
    dict of str to bytes
        Name to content, without folders.

    Raises
    ------
    zipfile.BadZipFile
        If it is no archive, or a file's checksum is wrong.
    """
    unwanted = [re.compile(pattern) for pattern in leave_out]
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return {
            name: archive.read(name)
            for name in archive.namelist()
            if not name.endswith("/") and not any(pattern.search(name) for pattern in unwanted)
        }


def packed(files: Mapping[str, bytes], level: int = LEVEL) -> bytes:
    """An archive of these files, in the order of their names; a wheel's RECORD is written anew.

    Parameters
    ----------
    files : mapping of str to bytes
        Name to content. Files below `NAME.dist-info/` make it a wheel.
    level : int
        Of deflate, 0 to 9; 0 stores.

    Returns
    -------
    bytes
        The same for the same files and the same zlib.
    """
    files = dict(sorted(files.items()))
    infos = {name.split("/")[0] for name in files if name.split("/")[0].endswith(".dist-info")}
    for info in infos:
        record = f"{info}/RECORD"
        files.pop(record, None)
        lines = [f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in files.items()]
        files[record] = "".join([*lines, f"{record},,\n"]).encode()
    out = io.BytesIO()
    method = zipfile.ZIP_DEFLATED if level else zipfile.ZIP_STORED
    with zipfile.ZipFile(out, "w", method) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name, EPOCH), data, method, level)
    return out.getvalue()


def _digest(data: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
