"""Several processes of this machine that do jobs; one that dies costs its own job alone."""

from __future__ import annotations

import json
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Generator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, Generic

from .craft import Craft, Job, Outcome

PATIENCE = 3600.0
"""Seconds for one mesh."""

WORKER = ["hexalab.hosts.labour.worker"]
"""The module that a process runs; the craft's own is its argument."""

CORE = str(Path(__file__).resolve().parents[3])


class Hand(Generic[Job, Outcome]):
    """One process, started when it is needed."""

    def __init__(self, craft: Craft[Job, Outcome]) -> None:
        self._craft = craft
        self._process: subprocess.Popen[str] | None = None
        self._ended = False
        self._starting = threading.Lock()

    def do(self, job: Job) -> Outcome:
        """Do a job; another thread may `end` the process at any time."""
        with self._starting:
            if self._ended:
                return self._craft.failed(job, "the work was ended before")
            process = self._process or self._start()
        assert process.stdin and process.stdout
        late = threading.Timer(PATIENCE, process.kill)
        late.start()
        try:
            process.stdin.write(json.dumps(job.as_dict()) + "\n")
            process.stdin.flush()
            line = process.stdout.readline()
        except (OSError, ValueError):  # the process is gone, its streams are closed
            line = ""
        finally:
            overdue = not late.is_alive()
            late.cancel()
        if line:
            outcome: Outcome = json.loads(line)
            return outcome
        self._process = None
        code = process.wait()
        reason = f"no end within {PATIENCE:.0f} s" if overdue else f"the process ended with code {code}"
        return self._craft.failed(job, f"{reason}: the mesh may need more memory than there is")

    def end(self) -> None:
        """End the process for good, whatever it is at."""
        with self._starting:
            self._ended = True
            process, self._process = self._process, None
        if process is None:
            return
        process.terminate()
        try:
            process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        for stream in (process.stdin, process.stdout):
            with suppress(OSError):  # what was not yet written has no reader any more
                if stream:
                    stream.close()

    def _start(self) -> subprocess.Popen[str]:
        apart: dict[str, Any] = {"start_new_session": True}  # Ctrl-C is for who leads
        if os.name == "nt":
            apart = {"creationflags": getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0)}
        paths = [CORE, *filter(None, [os.environ.get("PYTHONPATH")])]
        self._process = subprocess.Popen(
            [sys.executable, "-m", *WORKER, self._craft.module],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8",
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)}, **apart,
        )  # fmt: skip
        return self._process


class Crew(Generic[Job, Outcome]):
    """Does jobs side by side.

    Parameters
    ----------
    craft : Craft
    count : int
        Processes.
    """

    def __init__(self, craft: Craft[Job, Outcome], count: int) -> None:
        self._craft, self._count = craft, count

    def outcomes(self, jobs: Sequence[Job]) -> Generator[Outcome]:
        """Do all jobs; what came of each, as it is done. Closing the iterator ends all processes."""
        waiting: queue.SimpleQueue[Job] = queue.SimpleQueue()
        done: queue.SimpleQueue[Outcome] = queue.SimpleQueue()
        for job in jobs:
            waiting.put(job)
        hands = [Hand(self._craft) for _ in range(min(self._count, len(jobs)))]
        stopped = threading.Event()

        def work(hand: Hand[Job, Outcome]) -> None:
            while not stopped.is_set():
                try:
                    job = waiting.get_nowait()
                except queue.Empty:
                    return
                done.put(hand.do(job))

        threads = [threading.Thread(target=work, args=(hand,), daemon=True) for hand in hands]
        for thread in threads:
            thread.start()
        try:
            for _ in jobs:
                yield done.get()
        finally:
            stopped.set()
            for hand in hands:
                hand.end()
