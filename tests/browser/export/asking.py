"""Asks the viewer for files, and reads them with VTK."""

from __future__ import annotations

import base64
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

from hexalab import cli

HALF = {"filters": {"planes": {"items": [{"enabled": True, "normal": [1, 0, 0], "offset": 0.5}]}}}
OPEN = {"filters": {"planes": {"items": [{"enabled": True, "normal": [-1, 0, 0], "offset": 0.5}]}}}
"""The other half: what the slice exposes looks at the eye."""
PLAIN = {"lighting": {"mode": "none"}}

TAKE = """async ([method, args]) => {
  const made = await window.hexalab[method](...args);
  const blob = made.file ?? made;
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return { data: btoa(text), notes: made.notes ?? [], type: blob.type };
}"""


def take(page: Page, method: str, *args: Any) -> bytes:
    """What a method of the page makes, as bytes."""
    return base64.b64decode(page.evaluate(TAKE, [method, list(args)])["data"])


def put(page: Page, *statuses: dict[str, Any]) -> None:
    for status in statuses:
        assert page.evaluate("(status) => window.hexalab.setStatus(status)", status) == []


def run(words: list[str]) -> int:
    """The command line in a thread of its own: Playwright runs once in each, and here the tests' browser does."""
    with ThreadPoolExecutor(1) as thread:
        return thread.submit(cli.main, words).result()


def polygons(path: Path) -> Any:
    """What VTK reads of a file of polygons."""
    vtk = pytest.importorskip("vtkmodules.vtkIOPLY" if path.suffix == ".ply" else "vtkmodules.vtkIOGeometry")
    reader = getattr(
        vtk, {".ply": "vtkPLYReader", ".obj": "vtkOBJReader", ".stl": "vtkSTLReader"}[path.suffix]
    )()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def measured(found: Any) -> tuple[float, float]:
    """Area of polygons and the volume that they enclose, by VTK."""
    from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

    triangles = vtkTriangleFilter()
    triangles.SetInputData(found)
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea(), mass.GetVolume()
