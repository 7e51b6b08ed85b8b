"""What the browser runs: the interpreter, the core as a wheel, the bundled viewer; all from the site's own folder."""

from .assemble import RuntimeReport, assemble

__all__ = ["RuntimeReport", "assemble"]
