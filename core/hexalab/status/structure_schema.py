"""The part of the settings document's schema about the structure of the whole mesh."""

from __future__ import annotations

from .words_of_schema import NUMBERS, ON, UNIT, choice, core, section

COMPLEX = choice("whole", "interior")

STRUCTURE_FILTER = section(
    "By what was traced: cells in any of these blocks, sheets and chords. Without any it hides nothing.",
    enabled=ON,
    keep=choice("inside", "outside", description="Cells in any of them, or in none"),
    complex={**COMPLEX, "description": "Which base complex the blocks are of"},
    blocks={**NUMBERS, "description": "By number, from 0"},
    sheets={**NUMBERS, "description": "By number, from 0"},
    chords={**NUMBERS, "description": "By number, from 0"},
)

STRUCTURE = section(
    "The structure of the whole mesh: what of it is looked at. What isn't is as faint as what is seen through.",
    kind=core(choice("none", "arcs", "sheets", "chords", "blocks")),
    chosen=core({**NUMBERS, "description": "Things of that kind by number, from 0; empty: all alike"}),
    form=core(
        choice(
            "cells",
            "surfaces",
            description="Sheets, chords and blocks as their cells; or as the surfaces and curves through the middles "
            "of the cells, and as the walls between blocks",
        )
    ),
    complex=core(
        {
            **COMPLEX,
            "description": "What all irregular edges enforce, or those inside alone; blocks are numbered in it",
        }
    ),
    boundary=core(
        {"type": "boolean", "default": False, "description": "Arcs of the boundary's irregular edges, too"}
    ),
    curves=core(
        {"type": "boolean", "default": False, "description": "Edges and vertices of the base complex"}
    ),
    explode=core(
        {
            **UNIT,
            "default": 0,
            "description": "How far blocks are drawn apart: 1, twice as far from the middle as they are",
        }
    ),
)
