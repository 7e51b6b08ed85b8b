"""Which file a question has opened is told by its hash, whatever lies on the easel by then (SPEC A5, B3)."""

from __future__ import annotations

import hashlib
import sys
import threading
from typing import Any

import pytest

from hexalab.hosts.easels import Easel, SurfaceEasel
from hexalab.hosts.frames import Question
from hexalab.hosts.offers import BytesOffer, SurfaceBytesOffer
from hexalab.hosts.seat import Seat

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

FIRST, SECOND = BytesOffer("a.mesh", b"one"), BytesOffer("b.mesh", b"two")


def told(seat: Seat, question: Question, meanwhile: object) -> str:
    """What is told of a question, if something else is put on the easel before it is hashed."""
    found: list[str] = []
    done = threading.Event()

    def tell(number: int, sha256: str) -> None:
        assert number == question.id
        found.append(sha256)
        done.set()

    identify = seat.identifier(question)
    seat.answer(question)
    seat._offers["easel"].offer = meanwhile  # type: ignore[attr-defined]
    identify(tell)
    assert done.wait(10)
    return found[0]


@pytest.mark.parametrize("meanwhile", [None, SECOND])
def test_B3_what_was_on_the_easel_is_hashed_though_it_was_taken_down(meanwhile: object) -> None:
    easel = Easel()
    easel.offer = FIRST
    question = Question(3, "open_offered", '["easel"]', [])
    assert told(Seat({"easel": easel}), question, meanwhile) == hashlib.sha256(b"one").hexdigest()


@pytest.mark.parametrize("text", ['["easel"]', '["none"]', "[]", "nonsense"])
def test_B3_nothing_is_told_of_what_is_not_there(text: str) -> None:
    assert told(Seat({"easel": Easel()}), Question(3, "open_offered", text, []), None) == ""


OFF = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


def test_B3_a_mesh_is_compared_with_what_is_on_the_other_easels(grid: Any) -> None:
    easel, other, surface = Easel(), Easel(), SurfaceEasel()
    seat = Seat({"0": easel, "1": other, "2": surface})

    def asked(method: str, text: str) -> bytes:
        packed, _ = seat.answer(Question(1, method, text, []))
        return packed.head

    with easel.holding(BytesOffer("a.mesh", grid(2, 1, 1))):
        assert b'"cells":2' in asked("open_offered", '["0"]')
        for name, there in (("1", other), ("2", surface)):
            assert b"nothing is on the easel" in asked("compare_with_offered", f'["{name}"]')
            assert there.name == ""
        with other.holding(BytesOffer("b.mesh", grid(3, 1, 1))):
            assert b"12 vertices and 16" in asked("compare_with_offered", '["1"]')
        with surface.holding(SurfaceBytesOffer("c.off", OFF)):
            assert b'"c.off"' in asked("compare_with_offered", '["2"]')
            assert surface.name == "c.off" and surface.size() == len(OFF)
