"""SPEC R5, R10: decks that include other files, out of their folder or opened together."""

from __future__ import annotations

import gzip
import hashlib
import os
from pathlib import Path

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read, read_bytes
from tests.core.formats.test_abaqus_scopes import CUBE, ELEMENT, nodes, points_of_cells

MAIN = "*HEADING\nthe model\n*INCLUDE, INPUT=mesh.inp\n*STEP\n*END STEP\n"
MESH = nodes() + ELEMENT


def folder(path: Path, **files: str) -> Path:
    """Write files, whose names have `__` for a dot and `___` for a separator, and return the path of `main.inp`."""
    for name, text in files.items():
        file = path / name.replace("___", "/").replace("__", ".")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text.encode())
    return path / "main.inp"


@pytest.mark.parametrize(
    "line",
    [
        "*INCLUDE, INPUT=mesh.inp",
        "*Include,input=mesh.inp",
        '*INCLUDE, INPUT="mesh.inp"',
        "*INCLUDE,\nINPUT=./mesh.inp",
        "*INCLUDE, INPUT=MESH.INP",
        "*INCLUDE, INPUT= mesh.inp \r",
    ],
)
def test_R5_an_included_file_stands_where_it_is_included(tmp_path: Path, line: str) -> None:
    mesh = read(folder(tmp_path, main__inp=MAIN.replace("*INCLUDE, INPUT=mesh.inp", line), mesh__inp=MESH))
    np.testing.assert_array_equal(points_of_cells(mesh), [CUBE])
    assert mesh.name == "main.inp" and mesh.notes == []


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1"])
def test_R5_the_name_of_an_included_file_is_utf_8_or_latin_1(tmp_path: Path, encoding: str) -> None:
    path = folder(tmp_path, größe__inp=MESH, main__inp="")
    path.write_bytes(MAIN.replace("mesh.inp", "größe.inp").encode(encoding))
    assert read(path).cell_count == 1


def test_R5_lines_of_one_keyword_out_of_several_files(tmp_path: Path) -> None:
    rows = nodes().splitlines()
    main = f"{rows[0]}\n{rows[1]}\n*INCLUDE, INPUT=rows/a.txt\n{rows[5]}\n"
    main += "*NODE, INPUT=rows\\b.txt\n*INCLUDE, INPUT=elements\n"
    path = folder(
        tmp_path,
        main__inp=main,
        rows___a__txt="\n".join(rows[2:5]),
        rows___b__txt="\n".join(rows[6:]),
        elements=ELEMENT,
    )
    mesh = read(path)
    np.testing.assert_array_equal(mesh.points, CUBE)
    assert mesh.cell_count == 1


def test_R5_files_in_files_and_parts_in_files(tmp_path: Path) -> None:
    main = "*PART, NAME=a\n*INCLUDE, INPUT=parts/a.inp\n*END PART\n*INCLUDE, INPUT=assembly.inp\n"
    assembly = "*ASSEMBLY, NAME=x\n*INSTANCE, NAME=i, PART=a\n2, 0, 0\n*END INSTANCE\n*END ASSEMBLY\n"
    path = folder(
        tmp_path,
        main__inp=main,
        parts___a__inp="*INCLUDE, INPUT=parts/nodes.inp\n*INCLUDE, INPUT=elements.inp\n",
        parts___nodes__inp="\ufeff" + nodes(),
        parts___elements__inp=ELEMENT,
        assembly__inp=assembly,
    )
    np.testing.assert_array_equal(points_of_cells(read(path)), [CUBE + np.array([2, 0, 0])])


def test_R5_elements_out_of_a_file_of_their_own(tmp_path: Path) -> None:
    path = folder(
        tmp_path,
        main__inp=nodes() + "*ELEMENT, TYPE=C3D8, INPUT=e.dat\n",
        e__dat="7, 1, 2, 3, 4,\n5, 6, 7, 8\n",
    )
    assert read(path).cell_numbers.tolist() == [7]


def test_R5_a_gzipped_deck_and_a_gzipped_include(tmp_path: Path) -> None:
    (tmp_path / "main.inp.gz").write_bytes(gzip.compress(MAIN.encode()))
    (tmp_path / "mesh.inp").write_bytes(gzip.compress(MESH.encode()))
    assert read(tmp_path / "main.inp.gz").cell_count == 1


def test_R5_files_that_were_read_along_are_named_with_their_digests(tmp_path: Path) -> None:
    """As they lie there: gzipped is another file."""
    packed = gzip.compress(ELEMENT.encode(), mtime=0)
    main = MAIN.replace("*STEP", "*INCLUDE, INPUT=more/cells.inp.gz\n*INCLUDE, INPUT=gone.inp\n*STEP")
    path = folder(tmp_path, main__inp=main, mesh__inp=nodes(), unused__inp=MESH)
    (tmp_path / "more").mkdir()
    (tmp_path / "more" / "cells.inp.gz").write_bytes(packed)
    mesh = read(path)
    assert mesh.cell_count == 1
    assert mesh.included == {
        "mesh.inp": hashlib.sha256(nodes().encode()).hexdigest(),
        "more/cells.inp.gz": hashlib.sha256(packed).hexdigest(),
    }
    assert read_bytes(MESH.encode(), "whole.inp").included == {}


def test_R5_files_opened_together_are_one_deck() -> None:
    mesh = read_bytes(MAIN.encode(), "main.inp", {"mesh.inp": MESH.encode(), "other.txt": b"?"})
    np.testing.assert_array_equal(points_of_cells(mesh), [CUBE])
    for name in ("sub/mesh.inp", "..\\sub\\Mesh.inp", "/home/me/mesh.inp"):
        text = MAIN.replace("=mesh.inp", f"={name}").encode()
        assert read_bytes(text, "main.inp", {"mesh.inp": MESH.encode()}).cell_count == 1


def test_R5_names_of_files_opened_together_may_be_paths() -> None:
    """As of a folder that is dropped: names are meant from the deck's folder on."""
    files = {"a/mesh.inp": MESH.encode(), "b/mesh.inp": b"", "mesh.inp": b""}
    assert read_bytes(MAIN.encode(), "a/main.inp", files).cell_count == 1
    files = {"a/m/x.inp": b"*INCLUDE, INPUT=y.inp\n", "a/m/y.inp": MESH.encode(), "b/y.inp": b""}
    assert read_bytes(MAIN.replace("=mesh", "=m/x").encode(), "a/main.inp", files).cell_count == 1


def test_R10_of_two_files_of_one_name_none_is_guessed() -> None:
    text = MAIN.replace("=mesh.inp", "=sub/mesh.inp").encode()
    with pytest.raises(MeshReadError, match=r"it includes sub/mesh\.inp"):
        read_bytes(text, "main.inp", {"a/mesh.inp": MESH.encode(), "b/mesh.inp": MESH.encode()})
    assert read_bytes(text, "main.inp", {"a/mesh.inp": b"", "sub/mesh.inp": MESH.encode()}).cell_count == 1


@pytest.mark.parametrize(
    "name", ["../mesh.inp", "sub/../../mesh.inp", "{absolute}", "link.inp", "linked/mesh.inp"]
)
def test_R10_nothing_outside_of_the_deck_s_folder_is_read(tmp_path: Path, name: str) -> None:
    folder(tmp_path, mesh__inp=MESH)
    inside = tmp_path / "inside"
    inside.mkdir()
    os.symlink(tmp_path / "mesh.inp", inside / "link.inp")
    os.symlink(tmp_path, inside / "linked")
    name = name.format(absolute=tmp_path / "mesh.inp")
    path = folder(inside, main__inp=MAIN.replace("=mesh.inp", f"={name}"))
    with pytest.raises(MeshReadError, match="which was not found in its folder; open the files together"):
        read(path)


def test_R5_what_is_not_there_is_noted_or_asked_for() -> None:
    mesh = read_bytes((MESH + "*INCLUDE, INPUT=steel.mat\n*NODE, INPUT=more.txt\n").encode(), "x.inp")
    assert mesh.cell_count == 1
    assert mesh.notes == [
        "Not all of the deck is here: it includes steel.mat, more.txt, which were not found in its folder; "
        "open the files together."
    ]
    with pytest.raises(
        MeshReadError, match=r"refers to node 5, which is missing: it includes top\.inp, which was not"
    ):
        read_bytes((nodes(CUBE[:4]) + "*INCLUDE, INPUT=top.inp\n" + ELEMENT).encode(), "x.inp")


def test_R10_errors_of_an_included_file_name_it_and_its_line(tmp_path: Path) -> None:
    path = folder(tmp_path, main__inp=MAIN, mesh__inp=MESH.replace("3, 1.0, 1.0, 0.0", "3, 1.0, one, 0.0"))
    with pytest.raises(MeshReadError, match=r"^mesh\.inp, line 4: ‘one’ stands where a number was expected"):
        read(path)
    path = folder(tmp_path, main__inp=MAIN, mesh__inp=MESH.replace("7, 8\n", "7, 9\n"))
    with pytest.raises(MeshReadError, match=r"^mesh\.inp, line 11: element 1 refers to node 9"):
        read(path)


def test_R10_files_that_include_themselves(tmp_path: Path) -> None:
    path = folder(tmp_path, main__inp="*INCLUDE, INPUT=main.inp\n")
    with pytest.raises(MeshReadError, match=r"main\.inp, line 1: main\.inp is included by itself"):
        read(path)
    path = folder(tmp_path, main__inp=MAIN, mesh__inp="*HEADING\n*INCLUDE, INPUT=MAIN.inp\n")
    with pytest.raises(MeshReadError, match=r"mesh\.inp, line 2: main\.inp is included by itself"):
        read(path)


def test_R10_files_that_include_each_other_over_and_over() -> None:
    files = {f"{n}.inp": f"*INCLUDE, INPUT={n + 1}.inp\n".encode() * 2 for n in range(18)}
    with pytest.raises(MeshReadError, match="too many files include others"):
        read_bytes(b"*INCLUDE, INPUT=0.inp\n", "x.inp", files)
    deep = {f"{n}.inp": f"*INCLUDE, INPUT={n + 1}.inp\n".encode() for n in range(100)}
    with pytest.raises(MeshReadError, match="too many files include others"):
        read_bytes(b"*INCLUDE, INPUT=0.inp\n", "x.inp", deep)
