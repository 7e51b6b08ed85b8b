"""Reading YAML that strangers send."""

from pathlib import Path

import pytest

from site_builder.reading.documents import LARGEST_DOCUMENT, DocumentError, field_name, parse_yaml, read_yaml

FILE = Path("source.yaml")


def test_C1_every_field_knows_its_line():
    document = parse_yaml("a:\n  b:\n    - x\n    - {c: 1,\n       d: 2}\n", FILE)
    assert document.data == {"a": {"b": ["x", {"c": 1, "d": 2}]}}
    assert document.line(("a", "b", 1, "d")) == 5
    assert document.line(("a", "b", 0)) == 3
    assert document.line(("a", "missing", "deep")) == 1
    assert field_name(("meshes", 2, "url")) == "meshes[2].url"


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("a: &x [1]\nb: *x\n", 2, "aliases"),
        ("a: 1\nb: 2\na: 3\n", 3, "twice"),
        ("x: 1\na: b: c\n", 2, "not YAML"),
        ("a: !!python/object/apply:os.system ['true']\n", 1, "not YAML"),
        ("a: " + "[" * 30 + "]" * 30, 1, "levels deep"),
        ("", 1, "nothing in it"),
        ("? [1, 2]\n: x\n", 1, "key must be a word"),
        ("a: \x07\n", 1, "not YAML"),
        ("a: 1\nb: x\0\n", 2, r"U\+0000"),
        ('a: 1\nb: "x\\u202ey"\n', 2, r"U\+202E"),
        ('a: "x\\u2028y"\n', 1, r"U\+2028"),
        ("a:\n\tb: 1\n", 2, "a tab"),
        ("a: 1\n2: b\n", 2, "key must be a word"),
        ("a: 1\n~: b\n", 2, "key must be a word"),
    ],
)
def test_C1_what_cannot_be_read_is_named_with_its_line(text, line, message):
    with pytest.raises(DocumentError, match=message) as caught:
        parse_yaml(text, FILE)
    assert caught.value.line == line
    assert str(caught.value).startswith(f"source.yaml:{line}: ")


def test_C1_an_alias_bomb_is_refused_at_once():
    bomb = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "".join(
        f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join(['*' + chr(97 + i)] * 9)}]\n" for i in range(12)
    )
    with pytest.raises(DocumentError, match="aliases"):
        parse_yaml(bomb, FILE)


def test_C1_a_huge_file_is_refused_unread(tmp_path):
    file = tmp_path / "source.yaml"
    file.write_bytes(b"a: " + b"x" * LARGEST_DOCUMENT)
    with pytest.raises(DocumentError, match="bytes"):
        read_yaml(file)


def test_C1_a_file_that_is_no_text_is_refused(tmp_path):
    file = tmp_path / "source.yaml"
    file.write_bytes(b"\x89PNG\r\n\xff\xfe")
    with pytest.raises(DocumentError, match="UTF-8"):
        read_yaml(file)


def test_C1_plain_scalars_are_what_they_look_like():
    text = "[010, 1:30, 0x10, no, yes, 2025-13-41, .inf, 12, -3, 1.5, true, ~, " + "9" * 5000 + "]"
    assert parse_yaml(text, FILE).data == [
        "010", "1:30", "0x10", "no", "yes", "2025-13-41", ".inf", 12, -3, 1.5, True, None, "9" * 5000,
    ]  # fmt: skip
