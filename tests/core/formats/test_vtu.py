"""SPEC R4: `.vtu` in every encoding that VTK writes, and the traps of the format."""

from __future__ import annotations

import base64
import itertools
import re
import struct
import sys
import zlib
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes, write_bytes
from tests.core.formats.samples import HEXAHEDRON, Sample, check, check_data, grid, mixed, signed_volumes
from tests.core.formats.vtk_files import insert, unstructured_grid, xml
from tests.tools import tool

meshio, vtk = tool("meshio"), tool("vtk")

CASES = Path(__file__).parent / "cases"
LZMA = ("LZMA",) if find_spec("_lzma") else ()
"""Python in a browser has none."""

MODES = [
    {"DataMode": "Ascii"},
    {"DataMode": "Binary"},
    {"DataMode": "Appended", "EncodeAppendedData": "On"},
    {"DataMode": "Appended", "EncodeAppendedData": "Off"},
]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("make", [mixed, lambda: grid(12, 13, 14), lambda: grid(1, 1, 1)])
def test_R4_files_of_vtk(tmp_path: Path, mode: dict[str, str], make) -> None:
    sample = make()
    data = unstructured_grid(sample)
    variants = itertools.product(
        ("None", "ZLib", "LZMA"), ("UInt32", "UInt64"), ("LittleEndian", "BigEndian")
    )
    for compressor, header, order in variants:
        options = mode | {"CompressorType": compressor, "HeaderType": header, "ByteOrder": order}
        content = xml(data, tmp_path / "x.vtu", **options)
        assert f'compressor="vtk{compressor}'.encode() in content or compressor == "None"
        mesh = read_bytes(content, "x.vtu")
        check(mesh, sample, 1e-15)
        assert set(mesh.cell_data) == set(sample.cell_data)
        if mode["DataMode"] != "Ascii":
            check_data(mesh, sample)


def test_R4_small_blocks(tmp_path: Path) -> None:
    writer = vtk.vtkXMLUnstructuredGridWriter()
    sample = grid(6, 7, 5)
    writer.SetInputData(unstructured_grid(sample))
    writer.SetBlockSize(256)
    writer.SetFileName(str(tmp_path / "x.vtu"))
    for mode in range(3):
        writer.SetDataMode(mode)
        writer.Write()
        check(read(tmp_path / "x.vtu"), sample, 1e-15)


def test_R4_lz4_is_refused_by_name_with_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(MeshReadError, match=r"vtkLZ4DataCompressor.*ZLib or none \(in ParaView"):
        read(CASES / "vtu-lz4.vtu")
    content = xml(unstructured_grid(mixed()), tmp_path / "x.vtu", CompressorType="LZ4", DataMode="Ascii")
    check(read_bytes(content, "x.vtu"), mixed(), 1e-15)


def test_R4_lzma_is_refused_by_name_where_python_has_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "lzma", None)
    with pytest.raises(MeshReadError, match=r"vtkLZMADataCompressor.*no LZMA.*ZLib or none.*command line"):
        read(CASES / "vtu-lzma.vtu")
    content = xml(unstructured_grid(mixed()), tmp_path / "x.vtu", CompressorType="LZMA", DataMode="Ascii")
    check(read_bytes(content, "x.vtu"), mixed(), 1e-15)


@pytest.mark.parametrize(("binary", "compression"), [(False, None), (True, None), (True, "zlib")])
def test_R4_files_of_meshio(tmp_path: Path, binary: bool, compression: str | None) -> None:
    sample = grid(3, 4, 5)
    mesh = meshio.Mesh(
        sample.points, [("hexahedron", sample.rows_of(HEXAHEDRON))], cell_data={"q": [np.arange(60.0)]}
    )
    meshio.write(tmp_path / "x.vtu", mesh, binary=binary, compression=compression)
    found = read(tmp_path / "x.vtu")
    check(found, sample, 1e-10)
    assert found.cell_data["q"].tolist() == list(range(60))


def test_R4_voxels_and_surfaces(tmp_path: Path) -> None:
    image = vtk.vtkImageData()
    image.SetDimensions(4, 3, 2)
    append = vtk.vtkAppendFilter()
    append.AddInputData(image)
    append.Update()
    data = append.GetOutput()
    insert(data, 9, [0, 1, 5, 4])
    mesh = read_bytes(xml(data, tmp_path / "x.vtu"), "x.vtu")
    np.testing.assert_allclose(signed_volumes(mesh), 1)
    assert mesh.cell_count == 6 and mesh.notes == []
    assert mesh.features[0].corners.T.tolist() == [[0, 1, 5, 4]]


def test_R4_arrays_in_any_order_and_unknown_elements(tmp_path: Path) -> None:
    content = xml(unstructured_grid(mixed()), tmp_path / "x.vtu", DataMode="Ascii").decode()
    points = re.search(r"<Points>.*</Points>", content, re.S)[0]
    cells = re.search(r"<Cells>(.*)</Cells>", content, re.S)
    arrays = re.findall(r"<DataArray.*?</DataArray>", cells[1], re.S)
    turned = content.replace(points, "").replace(cells[1], "\n".join(reversed(arrays)))
    turned = turned.replace("</Cells>", "</Cells><!-- <Points> -->" + points + "<Unknown a='1'/>")
    turned = turned.replace("<VTKFile", "<?xml version='1.0'?>\n<!-- a > b -->\n<VTKFile", 1)
    check(read_bytes(turned.encode(), "x.vtu"), mixed(), 1e-15)


def piece(points: str, cells: str, count: int, size: int) -> str:
    def array(name: str, kind: str, text: str, width: int = 1) -> str:
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" format="ascii">{text}</DataArray>'

    ids = array("connectivity", "Int64", cells) + array("offsets", "Int32", str(size))
    return (
        f'<Piece NumberOfPoints="{count}" NumberOfCells="1"><Points>{array("", "Float32", points, 3)}</Points>'
        f"<Cells>{ids}{array('types', 'UInt8', '12' if size == 8 else '10')}</Cells>"
        f"<CellData>{array('q', 'Float64', str(size))}</CellData></Piece>"
    )


def file(*pieces: str) -> bytes:
    inside = "".join(pieces)
    return (
        f'<VTKFile type="UnstructuredGrid"><UnstructuredGrid>{inside}</UnstructuredGrid></VTKFile>'.encode()
    )


CUBE = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1"
EMPTY = '<Piece NumberOfPoints="0" NumberOfCells="0"></Piece>'


def test_R4_several_pieces_are_joined() -> None:
    corner = "5 0 0 6 0 0 5 1 0 5 0 1"
    data = file(EMPTY, piece(corner, "0 1 2 3", 4, 4), piece(CUBE, "0 1 2 3 4 5 6 7", 8, 8))
    mesh = read_bytes(data, "x.vtu")
    assert mesh.vertex_count == 12 and mesh.kind_counts == {"tetrahedron": 1, "hexahedron": 1}
    assert mesh.cells[1].tolist() == list(range(4, 12))
    assert mesh.cell_data["q"].tolist() == [4, 8]
    np.testing.assert_allclose(signed_volumes(mesh), [1 / 6, 1])


def test_R4_entities_in_names() -> None:
    data = file(piece(CUBE, "0 1 2 3 4 5 6 7", 8, 8)).replace(
        b'Name="q"', b'Name="a &amp; b &lt; &#99; &#x64;"'
    )
    assert list(read_bytes(data, "x.vtu").cell_data) == ["a & b < c d"]


def test_R4_what_is_written_is_what_vtk_reads(tmp_path: Path) -> None:
    data = file(piece(CUBE, "0 1 2 3 4 5 6 7", 8, 8))
    (tmp_path / "x.vtu").write_bytes(write_bytes(read_bytes(data, "x.vtu"), "vtu"))
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / "x.vtu"))
    reader.Update()
    assert reader.GetOutput().GetCell(0).GetCellType() == 12
    assert reader.GetOutput().GetCellData().GetArray("q").GetValue(0) == 8


GOOD = file(piece(CUBE, "0 1 2 3 4 5 6 7", 8, 8))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (b'type="UnstructuredGrid"', b'type="PolyData"', ["‘PolyData’", "expected UnstructuredGrid"]),
        (b'type="UnstructuredGrid"', b'type="StructuredGrid"', ["a structured grid", "Append Datasets"]),
        (b'type="UnstructuredGrid"', b'type="PUnstructuredGrid"', ["index of the parts", "open the .vtu files"]),
        (b'type="UnstructuredGrid"', b'type="vtkMultiBlockDataSet"', ["index of several", "open the .vtu files"]),
        (b'type="UnstructuredGrid"', b'type="PImageData"', ["an image", "Append Datasets"]),
        (b"<VTKFile", b"<XYZFile", ["VTKFile"]),
        (b"</VTKFile>", b"", ["inside ‘VTKFile’", "cut short"]),
        (b"</Cells>", b"", ["‘Piece’", "‘Cells’"]),
        (b'NumberOfPoints="8"', b'NumberOfPoints="9"', ["24 numbers, expected 27"]),
        (b'NumberOfPoints="8"', b'NumberOfPoints="-8"', ["NumberOfPoints", "‘-8’"]),
        (b'NumberOfPoints="8"', b'NumberOfPoints="99999999999999999999"', ["NumberOfPoints"]),
        (b'NumberOfCells="1"', b'NumberOfCells="1000000000"', ["1 offsets", "1000000000 cells"]),
        (b"0 1 2 3 4 5 6 7", b"0 1 2 3 4 5 6 8", ["vertex 8", "0 to 7"]),
        (b"0 1 2 3 4 5 6 7", b"0 1 2 3 4 5 6 -1", ["vertex -1"]),
        (b"0 1 2 3 4 5 6 7", b"0 1 2 3 4 5 6", ["offset 1 is 8", "7 values"]),
        (b"0 1 2 3 4 5 6 7", b"0 1 2 3 4 5 six 7", ["‘six’", "connectivity"]),
        (b">12<", b">5<", ["12"]),
        (b'Name="offsets"', b'Name="ofsets"', ["DataArray offsets"]),
        (b'type="Int64"', b'type="Float64"', ["float64", "expected integers"]),
        (b'type="Int64"', b'type="Int65"', ["‘Int65’"]),
        (b'format="ascii"', b'format="hex"', ["‘hex’", "ascii, binary or appended"]),
        (b'format="ascii"', b'format="appended" offset="0"', ["has none"]),
        (b'format="ascii"', b'format="binary"', ["the points should be"]),
        (b"0 0 0 1 0 0", b"0 0 nan 1 0 0", ["z coordinate of vertex 1"]),
    ],
)  # fmt: skip
def test_R10_bad_vtu_files(old: bytes, new: bytes, words: list[str]) -> None:
    assert old in GOOD
    if words == ["12"]:
        assert read_bytes(GOOD.replace(old, new, 1), "x.vtu").notes
        return
    with pytest.raises(MeshReadError) as caught:
        read_bytes(GOOD.replace(old, new, 1), "bad.vtu")
    for word in ["bad.vtu, line 1", *words]:
        assert word in str(caught.value)


def packed(header: tuple[int, ...], blocks: bytes) -> bytes:
    return base64.b64encode(struct.pack(f"<{len(header)}I", *header)) + base64.b64encode(blocks)


RAW = np.fromstring(CUBE, sep=" ", dtype="<f4").tobytes()
SMALL = zlib.compress(RAW)


@pytest.mark.parametrize(
    ("header", "blocks", "words"),
    [
        ((1, 96, 0, len(SMALL)), SMALL, None),
        ((1, 96, 96, len(SMALL)), SMALL, None),
        ((2, 48, 0, len(zlib.compress(RAW[:48])), 99), zlib.compress(RAW[:48]), ["block 2", "99 bytes"]),
        ((1, 100, 0, len(SMALL)), SMALL, ["block 1", "96 bytes", "100"]),
        ((1, 50, 0, len(SMALL)), SMALL, ["block 1", "more", "50"]),
        ((1, 96, 0, len(SMALL) + 5), SMALL, ["data end"]),
        ((1, 96, 0, 4), SMALL, ["block 1", "holds"]),
        ((2**31, 96, 0, len(SMALL)), SMALL, ["2147483648 compressed blocks"]),
        ((3, 2**31 - 1, 0, 1, 1, 1), SMALL, ["refused"]),
        ((1, 2**32 - 1, 0, len(SMALL)), SMALL, ["refused"]),
        ((1, 96, 0, len(SMALL)), b"\0" * len(SMALL), ["block 1", "damaged"]),
        ((0,), b"", ["0 numbers"]),
    ],
)  # fmt: skip
def test_R10_block_sizes_that_lie(header: tuple[int, ...], blocks: bytes, words: list[str] | None) -> None:
    data = GOOD.replace(b'"UnstructuredGrid"', b'"UnstructuredGrid" compressor="vtkZLibDataCompressor"', 1)
    old = b'NumberOfComponents="3" format="ascii">' + CUBE.encode()
    assert old in data
    data = data.replace(old, b'NumberOfComponents="3" format="binary">' + packed(header, blocks))
    if words is None:
        assert read_bytes(data, "x.vtu").cell_count == 1
        return
    with pytest.raises(MeshReadError) as caught:
        read_bytes(data, "bad.vtu")
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize("apart", [True, False])
@pytest.mark.parametrize("header", ["I", "Q"])
def test_R4_base64_header_alone_or_with_the_data(apart: bool, header: str) -> None:
    head = struct.pack("<" + header, len(RAW))
    text = base64.b64encode(head) + base64.b64encode(RAW) if apart else base64.b64encode(head + RAW)
    text = b"\n  " + text[:10] + b"\n" + text[10:] + b"\n"
    old = b'NumberOfComponents="3" format="ascii">' + CUBE.encode()
    data = GOOD.replace(old, b'NumberOfComponents="3" format="binary">' + text)
    kind = b"UInt32" if header == "I" else b"UInt64"
    data = data.replace(b'"UnstructuredGrid"', b'"UnstructuredGrid" header_type="' + kind + b'"', 1)
    mesh = read_bytes(data, "x.vtu")
    assert isinstance(mesh.points, np.ndarray)
    unit = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float)
    check(mesh, Sample(unit, [(HEXAHEDRON, list(range(8)))]))
