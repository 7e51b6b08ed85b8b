"""One process for each program: what crashes or hangs there costs that file alone."""

from __future__ import annotations

import multiprocessing
import os
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

Answer = dict[str, Any]
"""Either the facts, or `{"refused": words, "told": whether that is an error meant for the user}`."""


def serve(program: str, channel: Connection) -> None:
    """Answer one path after the other, in the child process; what a library prints goes nowhere."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)
    from hexalab.errors import HexaLabError

    from .facts import measured
    from .programs import read

    while True:
        path = channel.recv()
        try:
            answer = measured(read(program, Path(path)))
        except BaseException as error:  # whatever a program raises is its answer
            words = f"{type(error).__name__}: {error}".replace("\n", " ")[:300]
            answer = {"refused": words, "told": isinstance(error, HexaLabError)}
        channel.send(answer)


class Worker:
    """A program in a process of its own.

    Parameters
    ----------
    program : str
        A key of `programs.PROGRAMS`.
    patience : float
        Seconds after which it is taken for hung.
    """

    def __init__(self, program: str, patience: float) -> None:
        self.program, self.patience = program, patience
        self.start()

    def start(self) -> None:
        """Begin anew."""
        context = multiprocessing.get_context("spawn")
        self.channel, theirs = context.Pipe()
        self.process = context.Process(target=serve, args=(self.program, theirs), daemon=True)
        self.process.start()
        theirs.close()

    def ask(self, path: Path) -> None:
        """Hand it a file."""
        self.channel.send(str(path))

    def answer(self) -> Answer:
        """Wait for what it says; a crash and a hang are answers, and the process begins anew."""
        try:
            if self.channel.poll(self.patience):
                answer: Answer = self.channel.recv()
                return answer
            words = f"no answer within {self.patience:g} s"
        except (EOFError, OSError):
            words = "the process died"
        self.stop()
        self.start()
        return {"refused": words, "told": False}

    def stop(self) -> None:
        """End the process."""
        self.process.kill()
        self.process.join()
