"""Seeded mutants of small files in every format and encoding."""

from __future__ import annotations

import gzip
import random
import re
import struct
import tempfile
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from hexalab.formats import write_bytes
from hexalab.mesh import Mesh
from tests.core.formats.samples import HEX_22, INP_CELLS, INP_NODES, MESHIO_NAMES, grid, mixed
from tests.core.formats.test_medit import text_of
from tests.core.formats.test_meditb import meshb
from tests.core.formats.test_mfem import mfem
from tests.core.formats.test_openvolumemesh import ovm
from tests.core.formats.test_ucd import ucd

NUMBERS = [
    b"0", b"-1", b"1", b"7", b"2147483647", b"2147483648", b"4294967296", b"-9223372036854775808",
    b"9223372036854775807", b"99999999999999999999999", b"1000000000000", b"nan", b"-inf", b"1e400", b"1.5", b"1e3",
    b"0x10", b"abc", b"", b"1-2", b"--3", b"1d2", b"#", b"*", b"$End", b"<", b"\0", b"\xff\xfe",
]  # fmt: skip
WORDS = (-1, 0, 1, 3, 8, 255, 2**16, 2**31 - 1, 2**31, 2**32 - 1, 2**40, 2**62, 2**63 - 1)


@cache
def seeds() -> tuple[tuple[str, bytes], ...]:
    """Names and bytes of small good files; without VTK and meshio (in a browser's Python) fewer of them."""
    sample = mixed()
    hexahedra = grid(2, 1, 1)
    mesh = Mesh.from_cells(hexahedra.points, hexahedra.rows_of(0))
    mesh.cell_data = {"q": hexahedra.rows_of(0)[:, :2], "wide name": hexahedra.points[:2]}
    out = [("a.mesh", text_of(sample).encode()), ("b.mesh", text_of(grid(2, 1, 1), False).encode())]
    out += [(f"{v}{'lb'[o == '>']}.meshb", meshb(grid(2, 1, 1), v, o)) for v in (1, 2, 3, 4) for o in "<>"]
    out += [(f"a.{format_id}", write_bytes(mesh, format_id)) for format_id in ("mesh", "vtk", "vtu")]
    out += [("a.msh", HEX_22.encode()), ("b.inp", (INP_NODES + INP_CELLS).encode())]
    out.append(("a.ovm", ovm(sample, tail='CProp int "q"\n1 2 3 4 5\n').encode()))
    out += [
        ("a.ucd", ucd(hexahedra, tail="1 1\nq, m\n7 1.5\n8 2\n", counts="0 1 0")),
        ("c.mesh", mfem(sample)),
    ]
    out.append(("a.mesh.gz", gzip.compress(text_of(sample).encode())))
    return tuple(
        out + (files_of_vtk() + files_of_meshio() if find_spec("vtk") and find_spec("meshio") else [])
    )


def files_of_vtk() -> list[tuple[str, bytes]]:
    """Seeds written by VTK."""
    from tests.core.formats.vtk_files import legacy, unstructured_grid, xml

    data = unstructured_grid(mixed())
    out = [(f"{v}{b}.vtk", legacy(data, v, b)) for v in (42, 51) for b in (False, True)]
    path = Path(tempfile.mkdtemp()) / "x.vtu"
    for mode in (
        {"DataMode": "Ascii"},
        {"DataMode": "Binary"},
        {"DataMode": "Appended", "EncodeAppendedData": "Off"},
    ):
        for packing in ("None", "ZLib"):
            options = mode | {"CompressorType": packing}
            out.append((f"{mode['DataMode']}{packing}.vtu", xml(data, path, **options)))
    return out


def files_of_meshio() -> list[tuple[str, bytes]]:
    """Seeds written by meshio."""
    import meshio

    sample = mixed().grouped()
    out = []
    folder = Path(tempfile.mkdtemp())
    blocks = [(MESHIO_NAMES[kind], sample.rows_of(kind)) for kind in range(4)]
    for version, binary in (("gmsh22", False), ("gmsh22", True), ("gmsh", False), ("gmsh", True)):
        content = meshio.Mesh(sample.points, blocks if version == "gmsh22" else blocks[:1])
        meshio.write(folder / "x.msh", content, file_format=version, binary=binary)
        out.append((f"{version}{binary}.msh", (folder / "x.msh").read_bytes()))
    meshio.write(folder / "x.inp", meshio.Mesh(sample.points, blocks[:2]))
    out.append(("a.inp", (folder / "x.inp").read_bytes()))
    return out


def mutant(number: int) -> tuple[str, bytes]:
    """The name and bytes of the mutant with that number; the same on every run."""
    source = random.Random(number)
    name, data = source.choice(seeds())
    zipped = name.endswith(".gz") and source.random() < 0.7
    data = gzip.decompress(data) if zipped else data
    for _ in range(source.choice((1, 1, 1, 2, 3))):
        data = source.choice(MUTATORS)(source, data)
    if source.random() < 0.05:
        name = source.choice(seeds())[0]
    return name, gzip.compress(data) if zipped else data


def truncate(source: random.Random, data: bytes) -> bytes:
    return data[: source.randrange(len(data) + 1)]


def truncate_at_token(source: random.Random, data: bytes) -> bytes:
    ends = [match.end() for match in re.finditer(rb"\S+", data)]
    return data[: source.choice(ends)] if ends else data


def change_number(source: random.Random, data: bytes) -> bytes:
    found = list(re.finditer(rb"-?\d[\d.e+-]*", data))
    if not found:
        return data
    match = source.choice(found[:12] if source.random() < 0.3 else found)
    if source.random() < 0.3 and match[0].isdigit() and len(match[0]) < 9:
        new = str(int(match[0]) + source.choice((-2, -1, 1, 2, 1000))).encode()
    else:
        new = source.choice(NUMBERS)
    return data[: match.start()] + new + data[match.end() :]


def change_word(source: random.Random, data: bytes) -> bytes:
    found = list(re.finditer(rb"[A-Za-z_]{3,}", data))
    if not found:
        return data
    match, other = source.choice(found), source.choice(found)
    new = source.choice((other[0], match[0].upper(), match[0][:-1], b"", match[0] * 50, b"bit", b"string"))
    return data[: match.start()] + new + data[match.end() :]


def flip_bytes(source: random.Random, data: bytes) -> bytes:
    out = bytearray(data)
    for _ in range(source.choice((1, 2, 8)) if out else 0):
        out[source.randrange(len(out))] = source.choice((0, 10, 32, 48, 255, source.randrange(256)))
    return bytes(out)


def overwrite_word(source: random.Random, data: bytes) -> bytes:
    code, size = source.choice((("i", 4), ("q", 8)))
    if len(data) < size:
        return data
    start = source.randrange(min(len(data) - size + 1, source.choice((64, 10**9))))
    value = source.choice(WORDS) if size == 8 else (source.choice(WORDS) + 2**31) % 2**32 - 2**31
    return data[:start] + struct.pack(source.choice("<>") + code, value) + data[start + size :]


def delete(source: random.Random, data: bytes) -> bytes:
    a, b = sorted(source.randrange(len(data) + 1) for _ in range(2))
    return data[:a] + data[min(b, a + source.choice((1, 4, 100, 10**9))) :]


def duplicate(source: random.Random, data: bytes) -> bytes:
    a, b = sorted(source.randrange(len(data) + 1) for _ in range(2))
    return data[:b] + data[a:b] + data[b:]


def duplicate_lines(source: random.Random, data: bytes) -> bytes:
    lines = data.split(b"\n")
    a = source.randrange(len(lines))
    b = min(len(lines), a + source.choice((1, 3, 20)))
    at = source.randrange(len(lines) + 1)
    return b"\n".join([*lines[:at], *lines[a:b], *lines[at:]])


def swap_lines(source: random.Random, data: bytes) -> bytes:
    lines = data.split(b"\n")
    a, b = source.randrange(len(lines)), source.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    return b"\n".join(lines)


def splice(source: random.Random, data: bytes) -> bytes:
    other = source.choice(seeds())[1]
    return data[: source.randrange(len(data) + 1)] + other[source.randrange(len(other)) :]


def swap_byte_order(source: random.Random, data: bytes) -> bytes:
    start = source.randrange(len(data) + 1)
    size = source.choice((4, 8))
    end = start + (len(data) - start) // size * size
    turned = b"".join(data[i : i + size][::-1] for i in range(start, end, size))
    return data[:start] + turned + data[end:]


def respell(source: random.Random, data: bytes) -> bytes:
    return source.choice(RESPELLINGS)(data)


RESPELLINGS: tuple[Callable[[bytes], bytes], ...] = (
    lambda d: d.replace(b"\n", b"\r\n"),
    lambda d: d.replace(b"\n", b"\r"),
    lambda d: d.replace(b"\n", b" "),
    lambda d: d.replace(b" ", b"\n"),
    lambda d: b"\xef\xbb\xbf" + d,
    lambda d: b"\n" * 50 + d,
    lambda d: d + d,
    lambda d: d + b"\0" * 20,
    lambda d: d.upper(),
    lambda d: d.lower(),
    lambda d: d.replace(b".", b","),
    lambda d: d.decode("latin-1").encode("utf-16"),
    lambda d: b"#" * 3000 + d,
    lambda d: d.replace(b" ", b""),
)

MUTATORS = (
    truncate, truncate_at_token, change_number, change_number, change_number, change_number, change_word, flip_bytes,
    overwrite_word, overwrite_word, delete, duplicate, duplicate_lines, swap_lines, splice, swap_byte_order, respell,
)  # fmt: skip
