"""Documents in JSON, or in YAML where pyyaml is installed; a key that stands twice is an error in both."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from typing import Any

from ..errors import HexaLabError

YAML = (".yaml", ".yml")

EXPONENT = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)[eE][-+]?[0-9]+")
"""Numbers that YAML 1.1 takes for words: 1e-3."""


def parsed(path: Path) -> Any:
    """Parse a file by its ending.

    Raises
    ------
    HexaLabError
        It is not what its ending says, or it is YAML and pyyaml is not installed.
    OSError
        It can't be read.
    """
    try:
        text = path.read_text("utf-8-sig")
    except UnicodeDecodeError as error:
        raise HexaLabError(f"{path}: byte {error.start} is not UTF-8") from None
    read, kind = (_yaml, "YAML") if path.suffix.lower() in YAML else (_json, "JSON")
    try:
        return read(text)
    except ModuleNotFoundError:
        raise HexaLabError(
            f"{path}: YAML needs the package pyyaml: pip install 'hexalab[report]'; JSON needs none"
        ) from None
    except (ValueError, RecursionError) as error:
        raise HexaLabError(f"{path}: the criteria are not {kind}: {error}") from None


def _json(text: str) -> Any:
    return json.loads(text, object_pairs_hook=_once)


def _once(pairs: Iterable[tuple[Any, Any]]) -> dict[Any, Any]:
    """A dict; raises ValueError where a key stands twice."""
    found: dict[Any, Any] = {}
    for key, value in pairs:
        if key in found:
            raise ValueError(f"the key {key!r} stands twice in one entry")
        found[key] = value
    return found


def _yaml(text: str) -> Any:
    yaml = import_module("yaml")

    class Loader(yaml.SafeLoader):  # type: ignore[misc, name-defined]
        """As YAML 1.2 reads numbers, and with each key once."""

        def construct_mapping(self, node: Any, deep: bool = False) -> Any:
            _once((self.construct_object(key, deep=True), None) for key, _ in node.value)
            return super().construct_mapping(node, deep)

    Loader.add_implicit_resolver("tag:yaml.org,2002:float", EXPONENT, list("-+.0123456789"))
    try:
        return yaml.load(text, Loader)
    except yaml.YAMLError as error:
        raise ValueError(" ".join(str(error).split())) from None
