"""Work in jobs: one after the other, side by side in processes of this machine, or on a Dask cluster (SPEC B3, C8)."""

from .craft import Craft, Task

__all__ = ["Craft", "Task"]
