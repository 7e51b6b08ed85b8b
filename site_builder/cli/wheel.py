"""Build what is published: the wheel and the sdist, with the built viewer in both.

python -m site_builder.cli.wheel [dist]
"""

import sys
from pathlib import Path

from ..build import ROOT
from ..runtime.wheel import distribution

OUT = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "dist"

for kind in ("wheel", "sdist"):
    file = distribution(ROOT, OUT, kind)
    print(f"{file}: {file.stat().st_size / 1000:.0f} kB")
