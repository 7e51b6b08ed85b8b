"""Pictures of the catalogue's own meshes, made at build by the site's own viewer and kept by what they show."""

from .album import Album
from .shot import Shot
from .studio import Studio, take_missing

__all__ = ["Album", "Shot", "Studio", "take_missing"]
