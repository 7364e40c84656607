"""The version of the package, which is that of the whole project."""

from ._native import __version__

__all__ = ["__version__"]
