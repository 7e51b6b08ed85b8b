"""The site builder: YAML and meshes in, static pages out.

>>> from pathlib import Path
>>> report = build(Path("repository"), Path("build/site"))      # doctest: +SKIP
"""

from .build import BuildError, BuildReport, build
from .citing.bibtex import BibtexError
from .contributing.scaffold import ScaffoldError, new_source
from .contributing.validation import ValidationReport, validate

__all__ = [
    "BibtexError",
    "BuildError",
    "BuildReport",
    "ScaffoldError",
    "ValidationReport",
    "build",
    "new_source",
    "validate",
]
