"""Remake the README's picture: build the site, take the guide's picture of the whole window.

python -m site_builder.cli.readme_picture [build/site]
"""

import shutil
import sys
from pathlib import Path

from ..build import ROOT, build

SITE = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build" / "site"
PICTURE = ROOT / "docs" / "viewer.png"

report = build(ROOT / "repository", SITE)
if report.notes:
    raise SystemExit("\n".join(report.notes))
PICTURE.parent.mkdir(exist_ok=True)
shutil.copyfile(SITE / "guide" / "window.png", PICTURE)
print(f"{PICTURE}: {PICTURE.stat().st_size / 1000:.0f} kB")
