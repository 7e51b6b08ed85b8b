"""Settings of a view as a verb's `--status` takes them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..errors import HexaLabError
from ..png_text import SIGNATURE, read_settings

HELP = "settings, whole or in part; or a picture that carries them; the original HexaLab's, too"


def read_status(path: Path) -> dict[str, Any]:
    """Read settings from a JSON file or out of a picture.

    Raises
    ------
    HexaLabError
        The file holds none.
    OSError
        It can't be read.
    """
    data = path.read_bytes()
    try:
        document = read_settings(data) if data.startswith(SIGNATURE) else json.loads(data)
    except HexaLabError as error:
        raise HexaLabError(f"{path}: {error}") from None
    except (ValueError, RecursionError) as error:
        raise HexaLabError(f"{path}: the settings are not JSON: {error}") from None
    if not isinstance(document, dict):
        raise HexaLabError(f"{path}: found no settings, expected a JSON object")
    return document
