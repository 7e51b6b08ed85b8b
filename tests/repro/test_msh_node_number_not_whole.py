"""A node number that is not finite or not whole was cast to an integer (found by a mutant)."""

from __future__ import annotations

import warnings

import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes

CORNERS = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1"
MSH = (
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n{nodes}\n$EndNodes\n"
    "$Elements\n1\n1 5 0 1 2 3 4 5 6 7 8\n$EndElements\n"
)


@pytest.mark.parametrize("number", ["nan", "inf", "1e300", "1.5"])
def test_R10_a_node_number_that_is_no_whole_number(number: str) -> None:
    rows = [f"{i + 1} {row}" for i, row in enumerate(CORNERS.split("\n"))]
    rows[3] = number + rows[3][1:]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(MeshReadError, match="not whole"):
            read_bytes(MSH.format(nodes="\n".join(rows)).encode(), "x.msh")
        inp = "*NODE\n" + "\n".join(row.replace(" ", ",") for row in rows) + "\n*ELEMENT,TYPE=C3D4\n1,1,2,3,5"
        with pytest.raises(MeshReadError, match="not whole"):
            read_bytes(inp.encode(), "x.inp")
