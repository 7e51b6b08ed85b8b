"""Collecting remote meshes: each fetched, measured, portrayed, and written down beside its source (C8)."""

from .collector import Collector, Report

__all__ = ["Collector", "Report"]
