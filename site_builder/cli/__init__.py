"""The verbs that need the repository's clone, one module per verb; `hexalab.cli` finds them here."""
