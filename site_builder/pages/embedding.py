"""What the guide's page on embedding is filled with."""

from __future__ import annotations

from pathlib import Path
from typing import Any

EXAMPLE = Path(__file__).resolve().parents[2] / "static" / "catalogue" / "embedding_example.js"
"""The script that the page shows, and runs."""

HALF = {"filters": {"planes": {"items": [{"normal": [1, 0, 0], "offset": 0.5}]}}}
QUESTIONS = (
    ("Cut it in half", ["setStatus", HALF]),
    ("Colour it", ["setStatus", {"colour": {"by": "quality", "metric": "scaled_jacobian"}}]),
    ("Ask for its Scaled Jacobian", ["quality", "scaled_jacobian"]),
    ("Put it back", ["reset"]),
)
"""What the page's buttons ask the viewer: method and arguments."""


def embedding_values() -> dict[str, Any]:
    """Values of the template."""
    return {
        "heading": "Embedding",
        "description": "A mesh to turn in a page of yours, a script that drives it, and a badge for a README.",
        "questions": QUESTIONS,
        "code": EXAMPLE.read_text("utf-8").replace("export ", "").strip(),
        "frames": " frame-src 'self';",
    }
