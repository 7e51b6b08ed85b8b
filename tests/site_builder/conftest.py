"""A whole tiny repository, built once for all tests that look at pages."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

from site_builder import BuildReport, build

DEMO = Path(__file__).parent / "demo"


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The demo, built without the viewer."""
    out = tmp_path_factory.mktemp("demo") / "site"
    build(DEMO, out, strict=True, runtime=False)
    return out


@pytest.fixture
def demo(tmp_path: Path) -> Path:
    """A copy of the demo's repository that a test may change."""
    shutil.copytree(DEMO, tmp_path / "repository", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path / "repository"


@pytest.fixture
def rebuild(demo: Path) -> Callable[[], BuildReport]:
    """Builds the copy beside it."""
    return lambda: build(demo, demo.parent / "site", runtime=False)


@pytest.fixture
def edit() -> Callable[[Path, Callable[[dict], None]], None]:
    """Changes a YAML file through a function."""

    def change(file: Path, function: Callable[[dict], None]) -> None:
        data = yaml.safe_load(file.read_text("utf-8"))
        function(data)
        file.write_text(yaml.safe_dump(data, allow_unicode=True, sort_keys=False), "utf-8")

    return change
