"""Pictures of the catalogue's own meshes, made at build by the site's own viewer and kept by what they show."""

from .album import Album, png_size
from .shot import Shot
from .studio import Studio, take_missing

__all__ = ["Album", "Shot", "Studio", "png_size", "take_missing"]
