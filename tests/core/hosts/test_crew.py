"""Processes that do a batch's jobs can be ended at any time, without a word of theirs (SPEC B3)."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import suppress

import pytest

from hexalab.hosts.batching import Job, Look
from hexalab.hosts.batching.records import Outcome, failed
from hexalab.hosts.labour import Craft, crew

pytestmark = pytest.mark.skipif(sys.platform == "emscripten", reason="hosts run natively")

DEAF = ["timeit", "-n", "1", "-r", "1", "__import__('time').sleep(600)"]
"""A module of Python's own, with arguments, that reads nothing."""

CRAFT: Craft[Job, Outcome] = Craft("hexalab.hosts.batching.work", failed)
JOB = Job("folder", "box.mesh", "box", (), "", Look({}), "out")


@pytest.fixture(autouse=True)
def broken_pipes_are_errors() -> Iterator[None]:
    """As Python has it from the start; gmsh, which other tests load, lets the system end the process instead."""
    if os.name == "nt":
        yield
        return
    before = signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    yield
    signal.signal(signal.SIGPIPE, before)


class Handed(subprocess.Popen[str]):
    """Is handed one more job at the moment of its end."""

    def terminate(self) -> None:
        assert self.stdin
        self.kill()
        self.wait()
        with suppress(BrokenPipeError):
            self.stdin.write("{}\n")
            self.stdin.flush()


def test_B3_a_process_is_ended_while_it_is_handed_a_job(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crew, "WORKER", DEAF)
    monkeypatch.setattr(crew.subprocess, "Popen", Handed)
    hand = crew.Hand(CRAFT)
    outcomes: list[Outcome] = []
    thread = threading.Thread(target=lambda: outcomes.append(hand.do(JOB)), daemon=True)
    thread.start()
    time.sleep(0.5)
    assert thread.is_alive()
    hand.end()
    thread.join(20)
    assert "the process ended with code" in outcomes[0]["measured"]["problem"]


def test_B3_no_process_is_started_after_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    def start(*_: object, **__: object) -> None:
        raise AssertionError("a process was started")

    hand = crew.Hand(CRAFT)
    hand.end()
    monkeypatch.setattr(crew.subprocess, "Popen", start)
    assert "ended before" in hand.do(JOB)["measured"]["problem"]
