"""A process that does jobs: a line of JSON in for each, a line out (`crew.Crew` starts it)."""

from __future__ import annotations

import json
import sys
from importlib import import_module


def main() -> None:
    """Work until there are no more jobs; the craft's module is named on the command line."""
    answers = sys.stdout
    sys.stdout = sys.stderr  # what a library prints is no answer
    craft = import_module(sys.argv[1])
    for line in sys.stdin:
        answers.write(json.dumps(craft.run(json.loads(line))) + "\n")
        answers.flush()
    craft.finish()


if __name__ == "__main__":
    main()
