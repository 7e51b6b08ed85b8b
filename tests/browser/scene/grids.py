"""Drawable buffers of box grids, made without the core: independent inputs for the scene's tests."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import NDArray

FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
STEPS = ((0, 0, -1), (0, 0, 1), (0, -1, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0))
CORNERS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])


def grid_surface(shown: NDArray[np.bool_], mode: str = "lines") -> dict[str, Any]:
    """Return the surface of the shown cells of an (nx, ny, nz) box grid, as section 3 of the buffers lays it out."""
    shape = np.array(shown.shape)
    diagonal = float(np.linalg.norm(shape))
    cells = np.argwhere(shown)
    padded = np.pad(shown, 1)
    positions, normals, owners, inside, faces = [], [], [], [], []
    for local, (face, step) in enumerate(zip(FACES, STEPS, strict=True)):
        beside = cells + step
        open_face = ~padded[tuple((beside + 1).T)]
        mine = cells[open_face]
        ids = np.ravel_multi_index(mine.T, shown.shape)
        within = np.all((beside[open_face] >= 0) & (beside[open_face] < shape), axis=1)
        positions.append((mine[:, None] + CORNERS[list(face)] - shape / 2) / diagonal)
        normals.append(np.broadcast_to(np.array([*step, 0]) * 32767, (len(mine), 4, 4)))
        owners.append(np.repeat(ids, 4))
        inside.append(np.repeat(within * 255, 4))
        faces.append(ids * 8 + local)
    corners = np.concatenate(positions)
    edges, beside = quad_edges(corners)
    return {
        "mode": mode,
        "positions": corners.astype(np.float32).ravel(),
        "normals": np.concatenate(normals).astype(np.int16).ravel(),
        "cells": np.concatenate(owners).astype(np.uint32),
        "inside": np.concatenate(inside).astype(np.uint8),
        "quads": None,
        "faces": np.concatenate(faces).astype(np.uint32),
        "edges": edges.astype(np.float32).ravel(),
        "edge_cells": np.zeros(0, np.uint8),
        "edge_faces": beside.astype(np.uint32).ravel(),
    }


def quad_edges(corners: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return the distinct edges (E, 2, 3) of quads (Q, 4, 3), and the first and the last quad at each, (E, 2)."""
    pairs = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 3)
    keys = np.round(pairs * 1e6).astype(np.int64)
    swap = np.array([tuple(a) > tuple(b) for a, b in keys])
    keys[swap] = keys[swap][:, ::-1]
    _, first, which = np.unique(keys.reshape(-1, 6), axis=0, return_index=True, return_inverse=True)
    last = np.zeros(len(first), np.intp)
    last[which.reshape(-1)] = np.arange(len(pairs))
    return pairs[first], np.stack([first, last], axis=1) // 4


KINDS = {"float32": "f32", "int16": "i16", "uint32": "u32", "uint8": "u8"}


def pack(value: Any) -> Any:
    """Return the value with arrays as base64, for the harness's `unpack`."""
    if isinstance(value, np.ndarray):
        value = np.ascontiguousarray(value)
        return {"type": KINDS[value.dtype.name], "base64": base64.b64encode(value.tobytes()).decode()}
    if isinstance(value, dict):
        return {key: pack(inner) for key, inner in value.items()}
    return value
