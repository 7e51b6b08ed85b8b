"""The site builder: YAML and meshes in, static pages out.

>>> from pathlib import Path
>>> report = build(Path("repository"), Path("build/site"))      # doctest: +SKIP
>>> serve(Path("build/site"), 8000)                              # doctest: +SKIP
"""

from .build import BuildError, BuildReport, build
from .serving import serve

__all__ = ["BuildError", "BuildReport", "build", "serve"]
