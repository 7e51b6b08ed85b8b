"""What the catalogue weighs: pages, pictures and facts of all published meshes."""

from __future__ import annotations

from benchmarks.page import SITE

MOST = 60_000_000
"""Bytes that pages, pictures and facts may take; the meshes, the viewer and its Python are not among them."""

FACTS = (
    "index.json",
    "catalogue.json",
    "search.json",
    "croissant.json",
    "numbers/meshes.csv",
    "numbers/meshes.parquet",
)


def test_C8_pages_pictures_and_facts_stay_small(site: str) -> None:
    pages = [*SITE.rglob("*.html")]
    pictures = [*(SITE / "pictures").rglob("*.webp")]
    assert len(pages) > 1_700
    assert len(pictures) >= 861
    assert sum(file.stat().st_size for file in pictures) < 16_000 * len(pictures)
    files = [*pages, *pictures, *(SITE / name for name in FACTS)]
    assert sum(file.stat().st_size for file in files) < MOST


def test_C8_what_is_kept_for_when_there_is_no_network_stays_light(site: str) -> None:
    sources = [*(SITE / "sources").glob("*/index.html")]
    assert len(sources) == 35
    assert sum(file.stat().st_size for file in sources) < 3_000_000
