"""Scenes as objects of Python: elements with the names, defaults and checks of the scene file."""

from nilas.scene.element import Element
from nilas.scene.scene import Scene

__all__ = ["Element", "Scene"]
