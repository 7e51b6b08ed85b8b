"""SPEC R5: parts, instances and systems of coordinates in Abaqus decks."""

from __future__ import annotations

import numpy as np
import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes
from tests.core.formats.samples import signed_volumes

CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float)


def nodes(points=CUBE, first: int = 1, keyword: str = "*Node") -> str:
    rows = (f"{first + n}, {x!r}, {y!r}, {z!r}" for n, (x, y, z) in enumerate(np.asarray(points).tolist()))
    return "\n".join([keyword, *rows, ""])


ELEMENT = "*Element, type=C3D8\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
PART = f"*Part, name=Box\n{nodes()}{ELEMENT}*End Part\n"


def instance(name: str, place: str = "", inside: str = "", part: str = "Box") -> str:
    return f"*Instance, name={name}, part={part}\n{place}{inside}*End Instance\n"


def assembly(*instances: str) -> bytes:
    return f"*Heading\n{PART}*Assembly, name=A\n{''.join(instances)}*End Assembly\n".encode()


def points_of_cells(mesh) -> np.ndarray:
    return mesh.points[mesh.cells]


def test_R5_a_part_appears_at_each_place_of_its_instances() -> None:
    mesh = read_bytes(
        assembly(instance("one"), instance("two", "5., 0., -2.\n"), instance("three", "0,,7\n")), "x.inp"
    )
    expected = np.stack([CUBE, CUBE + np.array([5, 0, -2]), CUBE + np.array([0, 0, 7])])
    np.testing.assert_array_equal(points_of_cells(mesh), expected)
    assert mesh.vertex_numbers.tolist() == [1, 2, 3, 4, 5, 6, 7, 8] * 3
    assert mesh.cell_numbers.tolist() == [1, 1, 1]
    assert mesh.notes == []


def test_R5_an_instance_is_turned_after_it_is_moved() -> None:
    """A quarter turn about the axis through (1, 0, 0) along z, after a move by (2, 0, 0)."""
    place = "2., 0., 0.\n1., 0., 0., 1., 0., 3., 90.\n"
    mesh = read_bytes(assembly(instance("one", place)), "x.inp")
    x, y, z = (CUBE + np.array([2, 0, 0])).T
    expected = np.stack([1 - y, x - 1, z], axis=1)
    np.testing.assert_allclose(points_of_cells(mesh)[0], expected, atol=1e-15)


@pytest.mark.parametrize("seed", range(5))
def test_R5_rotations_about_any_axis(seed: int) -> None:
    """Against the exponential of the axis' cross product matrix, summed as a series."""
    source = np.random.default_rng(seed)
    a, b, shift, angle = (
        source.normal(size=3),
        source.normal(size=3),
        source.normal(size=3),
        source.uniform(-360, 360),
    )
    text = (
        ", ".join(map(repr, shift.tolist()))
        + "\n"
        + ", ".join(map(repr, [*a.tolist(), *b.tolist(), angle]))
        + "\n"
    )
    mesh = read_bytes(assembly(instance("one", text)), "x.inp")
    x, y, z = (b - a) / np.linalg.norm(b - a) * np.radians(angle)
    generator = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn, term = np.eye(3), np.eye(3)
    for order in range(1, 80):
        term = term @ generator / order
        turn += term
    np.testing.assert_allclose(points_of_cells(mesh)[0], (CUBE + shift - a) @ turn.T + a, atol=1e-11)
    np.testing.assert_allclose(signed_volumes(mesh), 1)


def test_R5_a_part_without_instance_is_left_out_and_said() -> None:
    other = f"*PART, NAME=Tool\n{nodes(CUBE + 9)}{ELEMENT}*END PART\n*Part, name=Empty\n*End Part\n"
    text = assembly(instance("one")).replace(b"*Assembly", other.encode() + b"*Assembly")
    mesh = read_bytes(text, "x.inp")
    np.testing.assert_array_equal(points_of_cells(mesh), [CUBE])
    assert mesh.notes == ["Part Tool is left out with its cell: it is not instanced."]


def test_R5_an_instance_may_add_to_its_part() -> None:
    own = nodes(CUBE[4:] + np.array([0, 0, 1]), 9) + "*Element, type=C3D8\n2, 5,6,7,8, 9,10,11,12\n"
    mesh = read_bytes(assembly(instance("one", "0, 0, 10\n", own), instance("two")), "x.inp")
    np.testing.assert_array_equal(
        points_of_cells(mesh), [CUBE + np.array([0, 0, 10]), CUBE + np.array([0, 0, 11]), CUBE]
    )
    assert mesh.vertex_count == 20
    assert mesh.cell_numbers.tolist() == [1, 2, 1]


def test_R5_names_of_parts_ignore_letter_case_and_quotes() -> None:
    text = assembly(instance("one", part='"BOX"')).replace(b"End Instance", b"EndInstance")
    assert read_bytes(text, "x.inp").cell_count == 1


def test_R5_an_instance_of_a_part_that_is_not_there() -> None:
    mesh = read_bytes(assembly(instance("one"), instance("two", part="Lost")), "x.inp")
    assert mesh.cell_count == 1
    assert mesh.notes == ["Instance two is left out: part Lost is not in the file."]
    with pytest.raises(MeshReadError, match="no part that is instanced has nodes"):
        read_bytes(assembly(instance("two", part="Lost")), "x.inp")


def test_R5_what_is_left_out_is_counted_where_it_appears() -> None:
    shell = "*Element, type=U4\n2, 1, 2, 3, 4\n3, 5, 6, 7, 8\n"
    text = assembly(instance("one"), instance("two", "2, 0, 0\n")).replace(
        b"*End Part", shell.encode() + b"*End Part"
    )
    assert "elements of type U4 (4)" in read_bytes(text, "x.inp").notes[0]


def test_R10_an_instance_without_a_place() -> None:
    with pytest.raises(MeshReadError, match=r"x.inp, line \d+: instance one has no place"):
        read_bytes(assembly(instance("one", "1., 0., 0.\n1., 1., 1., 1., 1., 1., 30.\n")), "x.inp")
    with pytest.raises(MeshReadError, match="instance one has no place"):
        read_bytes(assembly(instance("one", "1., here, 0.\n")), "x.inp")


def test_R10_a_missing_node_is_told_with_its_part_s_line() -> None:
    text = assembly(instance("one")).replace(b"1, 1, 2, 3, 4, 5, 6, 7, 8", b"\n1, 1, 2, 3, 4, 5, 6, 7, 88")
    with pytest.raises(
        MeshReadError, match=r"x\.inp, line 14: element 1 refers to node 88, which is missing"
    ):
        read_bytes(text, "x.inp")


def test_R5_systems_of_coordinates() -> None:
    """Nodes 1 to 4 by cylindrical, 5 to 8 by spherical coordinates: angles in degrees, the last from the equator."""
    x, y, z = CUBE.T
    radius, around = np.hypot(x, y), np.degrees(np.arctan2(y, x))
    above = np.degrees(np.arctan2(z, radius))
    cylindrical = np.stack([radius, around, z], axis=1)
    spherical = np.stack([np.sqrt(x * x + y * y + z * z), around, above], axis=1)
    text = nodes(cylindrical[:4], 1, "*NODE, SYSTEM=C") + nodes(spherical[4:], 5, "*Node, system=Spherical")
    mesh = read_bytes((text + ELEMENT).encode(), "x.inp")
    np.testing.assert_allclose(points_of_cells(mesh)[0], CUBE, atol=1e-15)
    with pytest.raises(MeshReadError, match="SYSTEM=Q is unknown, expected R, C or S"):
        read_bytes((text.replace("=C\n", "=Q\n") + ELEMENT).encode(), "x.inp")


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("", lambda x, y, z: (x, y, z)),
        ("1, 2, 3\n", lambda x, y, z: (x + 1, y + 2, z + 3)),
        ("1, 2, 3,\n", lambda x, y, z: (x + 1, y + 2, z + 3)),
        ("1, 2, 3, 1, 9, 55\n", lambda x, y, z: (1 - y, 2 + x, 3 + z)),  # the first axis along y
        ("0, 0, 0, 0, 5, 0\n0, 0, 2\n", lambda x, y, z: (z, x, y)),  # second axis along z
    ],
)
def test_R5_nodes_in_a_system_of_their_own(lines: str, expected) -> None:
    mesh = read_bytes(f"*SYSTEM\n{lines}{nodes()}{ELEMENT}".encode(), "x.inp")
    np.testing.assert_allclose(mesh.points, np.stack(expected(*CUBE.T), axis=1), atol=1e-15)
    assert mesh.notes == []


def test_R5_a_system_ends_with_the_next_or_with_its_part() -> None:
    text = f"*SYSTEM\n1, 0, 0\n{nodes(CUBE[:4])}*SYSTEM\n{nodes(CUBE[4:], 5)}{ELEMENT}"
    mesh = read_bytes(text.encode(), "x.inp")
    np.testing.assert_array_equal(mesh.points, np.concatenate([CUBE[:4] + np.array([1, 0, 0]), CUBE[4:]]))
    text = f"*PART, NAME=a\n*SYSTEM\n1, 0, 0\n{nodes()}{ELEMENT}*END PART\n*PART, NAME=b\n{nodes()}{ELEMENT}*END PART\n"
    np.testing.assert_array_equal(
        points_of_cells(read_bytes(text.encode(), "x.inp")), [CUBE + np.array([1, 0, 0]), CUBE]
    )
