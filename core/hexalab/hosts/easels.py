"""What holds one mesh, or one surface, after the other, for a page that is shown many."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Generic, TypeVar

from ..errors import HexaLabError
from ..mesh import Mesh
from ..reference import TriangleSurface
from .offers import AnyOffer, Offer, SurfaceOffer

Held = TypeVar("Held", bound=AnyOffer)


class Stand(Generic[Held]):
    """Holds one offer after the other."""

    def __init__(self) -> None:
        self.offer: Held | None = None

    @contextmanager
    def holding(self, offer: Held) -> Iterator[None]:
        """Hold an offer for the time of a `with` block."""
        self.offer = offer
        try:
            yield
        finally:
            self.offer = None

    @property
    def name(self) -> str:
        """That of what is on it; "" while nothing is."""
        return self.offer.name if self.offer else ""

    def hasher(self) -> Callable[[], str]:
        """That of what is on it now, whatever is there when it is called."""
        return self.offer.hasher() if self.offer else str

    def size(self) -> int | None:
        """That of what is on it."""
        return self._present.size()

    @property
    def _present(self) -> Held:
        if self.offer is None:
            raise HexaLabError("nothing is on the easel")
        return self.offer


class Easel(Stand[Offer]):
    """For meshes."""

    def mesh(self) -> Mesh:
        """The mesh that is on it."""
        return self._present.mesh()


class SurfaceEasel(Stand[SurfaceOffer]):
    """For reference surfaces."""

    def surface(self) -> TriangleSurface:
        """The surface that is on it."""
        return self._present.surface()
