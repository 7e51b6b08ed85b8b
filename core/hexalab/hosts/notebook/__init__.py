"""The viewer in a notebook: a widget before the kernel's own core (SPEC A6)."""
