"""Which file a question has opened is told by its hash, whatever lies on the easel by then (SPEC A5, B3)."""

from __future__ import annotations

import hashlib
import sys
import threading

import pytest

from hexalab.hosts.frames import Question
from hexalab.hosts.offers import BytesOffer, Easel
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
