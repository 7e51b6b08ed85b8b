from pathlib import Path

import pytest

from site_builder.model.catalogue import MeshEntry, Source
from site_builder.model.facts import Facts
from site_builder.pages.keeping import connections, weight


def mesh(size: int | None, remote: str = "") -> MeshEntry:
    source = Source("any", Path(), {}, "authors")
    return MeshEntry(source, "a", "A", "url", "a.mesh", "a.mesh", remote=remote, facts=Facts(bytes=size))


@pytest.mark.parametrize(
    ("sizes", "words"),
    [
        ([1_100_000], "1.1 MB"),
        ([None], "size not known"),
        ([1000, 500], "2 meshes, 1.5 kB"),
        ([1000, None, None], "3 meshes, 1.0 kB and 2 of unknown size"),
        ([None, None], "2 meshes, size not known"),
    ],
)
def test_O1_what_keeping_will_take_is_said(sizes, words):
    assert weight([mesh(size) for size in sizes]) == words


def test_O3_a_page_reaches_no_further_than_its_meshes():
    assert connections([mesh(1)]) == ""
    assert connections([mesh(1, "https://a.org/x.mesh"), mesh(1, "https://b.org/y.mesh")]) == " https:"
    assert connections([mesh(1, "http://localhost:8001/x.mesh")]) == " http://localhost:8001"
