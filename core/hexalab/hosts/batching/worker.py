"""A process that does jobs: a line of JSON in for each, a line out (`crew.Crew` starts it)."""

from __future__ import annotations

import json
import sys

from .work import BENCH, run


def main() -> None:
    """Work until there are no more jobs."""
    answers = sys.stdout
    sys.stdout = sys.stderr  # what a library prints is no answer
    for line in sys.stdin:
        answers.write(json.dumps(run(json.loads(line))) + "\n")
        answers.flush()
    BENCH.clear()


if __name__ == "__main__":
    main()
