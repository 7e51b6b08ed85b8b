"""Pictures and measurements of many meshes, one after the other, side by side, or on a cluster (SPEC B2, B3).

What is made of one mesh the page makes (`static/viewer/batch/batch.js`), as when it is given an archive: both agree.
"""

from .jobs import Job, Look, jobs_in
from .results import Results

__all__ = ["Job", "Look", "Results", "jobs_in"]
