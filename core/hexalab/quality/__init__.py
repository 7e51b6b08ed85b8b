"""Quality of cells: Verdict's metrics, their ranges and normalisations, statistics, certified validity."""

from .compute import quality, quality_many
from .measures import histogram, statistics
from .metrics import METRICS, Metric
from .validity import Validity, certify

__all__ = ["METRICS", "Metric", "Validity", "certify", "histogram", "quality", "quality_many", "statistics"]
