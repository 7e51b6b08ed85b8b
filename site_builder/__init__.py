"""The site builder: YAML and meshes in, static pages out.

>>> from pathlib import Path
>>> report = build(Path("repository"), Path("build/site"))      # doctest: +SKIP
>>> serve(Path("build/site"), 8000)                              # doctest: +SKIP
"""

from .bibtex import BibtexError
from .build import BuildError, BuildReport, build
from .scaffold import ScaffoldError, new_source
from .serving import serve
from .validation import ValidationReport, validate

__all__ = [
    "BibtexError",
    "BuildError",
    "BuildReport",
    "ScaffoldError",
    "ValidationReport",
    "build",
    "new_source",
    "serve",
    "validate",
]
