"""Meshes made at build time, and what the core says of each mesh."""
