"""A Dask scheduler and its workers, for the tests of batches."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from .ui import until
from .viewing import ROOT

ENVIRONMENT = {**os.environ, "PYTHONPATH": str(ROOT / "core")}


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[tuple[Path, list[subprocess.Popen[bytes]]]]:
    """A scheduler and its workers, as a user starts them; gives the scheduler's file and the workers."""
    file = folder / "scheduler.json"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "env": ENVIRONMENT, "cwd": folder}
    dask = [sys.executable, "-m", "dask"]
    found = ["--scheduler-file", str(file), "--no-dashboard"]
    place = ["--host", "127.0.0.1", "--port", "0"]
    alone = ["--nthreads", "1", "--memory-limit", "0", "--death-timeout", "20"]

    def start(*words: str) -> subprocess.Popen[bytes]:
        return subprocess.Popen([*dask, *words, *found], start_new_session=True, **quiet)  # type: ignore[call-overload]

    started = [start("scheduler", *place)]
    until(file.is_file, 60)
    started += [start("worker", *alone) for _ in range(workers)]
    try:
        yield file, started[1:]
    finally:
        for process in reversed(started):
            os.killpg(process.pid, signal.SIGTERM)
        for process in started:
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
