"""What the browser runs: the interpreter, the core as a wheel, the bundled viewer; all from the site's own folder."""

from .assemble import RuntimeReport, assemble
from .icons import icon
from .service_worker import service_worker
from .sheet import SHEET, sheet
from .weight import MOST, first_visit, gzipped

__all__ = [
    "MOST",
    "SHEET",
    "RuntimeReport",
    "assemble",
    "first_visit",
    "gzipped",
    "icon",
    "service_worker",
    "sheet",
]
