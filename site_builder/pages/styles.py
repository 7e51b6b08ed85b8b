"""The style sheets: a part lies with its component in `static/styles/`, a page links one file."""

from __future__ import annotations

from pathlib import Path

from hexalab.errors import HexaLabError

STYLES = Path(__file__).resolve().parents[2] / "static" / "styles"

SHEETS = {
    "catalogue": (
        "tokens", "base",
        "catalogue/page", "catalogue/text", "catalogue/title", "catalogue/button",
        "catalogue/front", "catalogue/search", "catalogue/chips", "catalogue/filters",
        "catalogue/cards", "catalogue/mark", "catalogue/range", "catalogue/table", "catalogue/sources",
        "catalogue/models",
        "catalogue/mesh", "catalogue/structure", "catalogue/histogram", "catalogue/citation", "catalogue/about",
        "catalogue/shots", "catalogue/plots", "catalogue/numbers",
        "catalogue/offline", "catalogue/guide", "catalogue/terms", "catalogue/interface",
        "catalogue/print",
    ),
    "viewer": (
        "tokens", "base",
        "viewer/page/page", "viewer/page/bar", "viewer/page/view", "viewer/page/compare", "viewer/page/empty_state",
        "viewer/page/portrait", "viewer/page/embedded", "viewer/page/progress_bar", "viewer/page/status_line",
        "viewer/page/message_list", "viewer/page/panel",
        "viewer/widgets/section", "viewer/widgets/row", "viewer/widgets/folding", "viewer/widgets/checkbox",
        "viewer/widgets/fields", "viewer/widgets/slider", "viewer/widgets/button", "viewer/widgets/link",
        "viewer/widgets/icon", "viewer/widgets/swatch", "viewer/widgets/table",
        "viewer/widgets/data_table", "viewer/widgets/pair_matrix",
        "viewer/panels/mesh", "viewer/panels/catalogue", "viewer/panels/findings", "viewer/panels/structure",
        "viewer/panels/histogram", "viewer/panels/quality", "viewer/panels/arrows", "viewer/panels/groups",
        "viewer/panels/inspector", "viewer/panels/compare",
        "viewer/dialogs/dialog", "viewer/dialogs/save", "viewer/dialogs/figure", "viewer/dialogs/status_editor",
        "viewer/dialogs/help",
    ),
    "embed": ("tokens", "base", "embed/embed"),
    "standalone": ("tokens", "base", "standalone/sheet"),
}  # fmt: skip
"""The parts of each sheet, in their order: of two rules that weigh the same, the later holds."""

INLINE = ("standalone",)
"""Sheets that no page links: they stand inside."""


def style_sheets(folder: Path = STYLES, sheets: dict[str, tuple[str, ...]] = SHEETS) -> dict[str, str]:
    """Put the parts together.

    Parameters
    ----------
    folder : Path
        Where the parts lie.
    sheets : dict of str to tuple of str
        Name of each sheet to its parts: paths below the folder, without ``.css``.

    Returns
    -------
    dict of str to str
        Name of each sheet to its text.

    Raises
    ------
    HexaLabError
        If a part is in no sheet, or isn't there.
    """
    named = {part for parts in sheets.values() for part in parts}
    there = {file.relative_to(folder).with_suffix("").as_posix() for file in folder.rglob("*.css")}
    if there - named:
        raise HexaLabError(f"{folder}: no sheet of {__name__} has {_files(there - named)}")
    if named - there:
        raise HexaLabError(f"{folder}: there is no {_files(named - there)}, which a sheet of {__name__} has")
    return {
        name: "\n".join((folder / f"{part}.css").read_text("utf-8") for part in parts)
        for name, parts in sheets.items()
    }


def _files(parts: set[str]) -> str:
    return ", ".join(f"{part}.css" for part in sorted(parts))
