"""Quality of cells: Verdict's metrics, their ranges and normalisations, statistics, certified validity."""

from .compute import quality, quality_many
from .measures import histogram, statistics
from .metrics import METRICS, Metric

__all__ = ["METRICS", "Metric", "histogram", "quality", "quality_many", "statistics"]
