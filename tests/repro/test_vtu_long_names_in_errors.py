"""Names from the file stood in errors at full length and over several lines (found by a mutant)."""

from __future__ import annotations

import pytest

from hexalab.errors import MeshReadError
from hexalab.formats import read_bytes


@pytest.mark.parametrize("name", ["DataArray" * 500, "Data\tArray"])
def test_R10_names_in_errors_are_short_and_on_one_line(name: str) -> None:
    data = f'<VTKFile type="UnstructuredGrid\n{name}"><{name.split()[0]}></VTKFile>'.encode()
    with pytest.raises(MeshReadError) as caught:
        read_bytes(data, "x.vtu")
    assert len(str(caught.value)) < 200 and "\n" not in str(caught.value)
