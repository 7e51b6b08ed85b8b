"""Plots over the whole catalogue: drawn by Matplotlib, as SVG that a page's style sheet colours; points are links."""
