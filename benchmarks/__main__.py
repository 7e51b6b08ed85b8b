"""`make bench`: every figure of the specification that a machine can print, in a few minutes.

python -m benchmarks [native] [groups] [structure] [distance] [comparison] [archives] [start] [browser] [view] [memory]
                     [lighting]
"""

from __future__ import annotations

import os
import platform
import sys
from pathlib import Path

from . import (
    archives,
    browser,
    comparison,
    distance,
    groups,
    lighting,
    memory,
    native,
    start,
    structure,
    view,
)

PARTS = {
    "native": native.run,
    "groups": groups.run,
    "structure": structure.run,
    "distance": distance.run,
    "comparison": comparison.run,
    "archives": archives.run,
    "start": start.run,
    "browser": browser.run,
    "view": view.run,
    "memory": memory.run,
    "lighting": lighting.run,
}
FOLDER = Path("build/bench")


def main(names: list[str]) -> int:
    """Run the parts named, or all of them."""
    unknown = set(names) - set(PARTS)
    if unknown:
        print(
            f"benchmarks: no part {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}", file=sys.stderr
        )
        return 2
    load = os.getloadavg()
    print(
        f"{platform.machine()}, {os.cpu_count()} cores, Python {platform.python_version()}, load {load[0]:.1f}"
    )
    for name in names or PARTS:
        PARTS[name](FOLDER)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
