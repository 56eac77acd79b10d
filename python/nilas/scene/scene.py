"""A scene: what a run simulates."""

import os
import pathlib
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from typing import Any

from nilas import _core
from nilas.arguments import number, settings_of
from nilas.arguments import path as path_of
from nilas.errors import FileError, InputError
from nilas.scene.element import Element
from nilas.scene.path import read_path
from nilas.values import written

Settings = Mapping[str, Any]


class Scene(Element):
    """A scene of elements that Python makes, or of a file.

    Paths in it are relative to `folder`. Nothing is checked before `check()`, or before a simulation is built, apart
    from names: the same table as for files then checks everything, with the same messages.

    >>> scene = Scene(
    ...     Element("time", step=0.01, end=1),
    ...     Element("body", name="ball", shape="sphere", radius=0.1, mass=1, position=[0, 0, 1]),
    ...     name="falling-ball",
    ... )
    >>> scene.check().end
    1.0
    """

    def __init__(
        self, *children: Element, folder: str | os.PathLike[str] = ".", **attributes: Any
    ) -> None:
        super().__init__("scene", *children, **{"version": 1, **attributes})
        self.folder = pathlib.Path(folder).absolute()

    @classmethod
    def read(cls, file: str | os.PathLike[str]) -> "Scene":
        """Reads a scene file into elements. Comments are lost.

        >>> Scene.read(small_scene)["name"]
        'small'
        """
        path = pathlib.Path(file)
        _core.CheckedScene.read(path)  # its messages name lines and columns
        return cls.parse(path.read_bytes(), folder=path.absolute().parent)

    @classmethod
    def parse(cls, xml: str | bytes, folder: str | os.PathLike[str] = ".") -> "Scene":
        """Makes a scene of XML text.

        >>> Scene.parse('<scene version="1" name="empty"/>')["name"]
        'empty'
        """
        try:
            root = ElementTree.fromstring(xml)
        except ElementTree.ParseError as fault:
            raise InputError(f"The text is no XML: {fault}.") from fault
        if root.tag != "scene":
            raise InputError(f"The root of a scene is <scene>; found <{root.tag}>.")
        scene = cls(folder=folder)
        for name, value in root.attrib.items():
            scene[name] = value
        for child in _element_of(root):
            scene.append(child)
        return scene

    def set(self, settings: Settings) -> "Scene":
        """Sets attributes by the paths of `--set`, and returns the scene.

        An element that is missing is added. Of several with one name, `[2]` picks the second, `[@name='box']` the one
        of that name, and `[+]` adds one.

        >>> scene = Scene(name="s").set({"contact/@tolerance": 1e-8})
        >>> scene.find("contact")["tolerance"]
        '1e-08'
        >>> scene = scene.set({"body[+]/@name": "a"}).set({"body[@name='a']/@mass": 2})
        >>> scene.find("body")["mass"]
        '2'
        """
        for path, value in settings_of(settings).items():
            elements, attribute = read_path(path)
            element: Element = self
            for step in elements:
                element = step.found_in(element)
            element[attribute] = value
        return self

    def check(self, settings: Settings | None = None, scale: float = 1.0) -> _core.CheckedScene:
        """Checks the scene and fills in every default.

        The result has the attributes `name`, `start`, `end` and `step` in s, `xml`, `fingerprint`, `notes` and
        `warnings`. Raises `InputError` with every fault.

        >>> Scene(Element("time", end=2), name="empty").check({"time/@step": 0.5}).step
        0.5
        >>> Scene(Element("time", end=-1), name="empty").check()  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        nilas.errors.InputError: ...empty.xml...<time end>...
        """
        name = self["name"] or "scene"
        return _core.CheckedScene.parse(
            self.xml(), self.folder / f"{name}.xml", _pairs(settings), scale
        )

    def write(self, file: str | os.PathLike[str]) -> pathlib.Path:
        """Writes the scene as a file and returns its path. Relative paths in it must hold for its new folder.

        >>> file = Scene(Element("time", end=2), name="empty").write("empty.xml")
        >>> Scene.read(file).find("time")["end"]
        '2'
        """
        path = pathlib.Path(file)
        try:
            path.write_text(
                '<?xml version="1.0" encoding="UTF-8"?>\n' + self.xml() + "\n", encoding="utf-8"
            )
        except OSError as fault:
            raise FileError(f"{path}: the scene cannot be written: {fault.strerror}.") from fault
        return path


def _element_of(tree: ElementTree.Element) -> Element:
    if (tree.text or "").strip() or any((child.tail or "").strip() for child in tree):
        raise InputError(f"<{tree.tag}> holds text; a scene has elements and attributes alone.")
    element = Element(tree.tag, **{name + "_": value for name, value in tree.attrib.items()})
    for child in tree:
        element.append(_element_of(child))
    return element


def _pairs(settings: Settings | None) -> list[tuple[str, str]]:
    return [(path, written(value)) for path, value in settings_of(settings).items()]


def checked(
    scene: Scene | _core.CheckedScene | str | os.PathLike[str],
    settings: Settings | None = None,
    scale: float = 1.0,
) -> _core.CheckedScene:
    """The checked scene of a Scene or of a file.

    >>> checked(small_scene, {"time/@end": 2}).end
    2.0
    """
    if isinstance(scene, Scene):
        return scene.check(settings, scale)
    if isinstance(scene, _core.CheckedScene):
        if settings or scale != 1.0:
            raise InputError("A scene that is checked already takes no more settings.")
        return scene
    file = path_of("scene", scene, "a nilas.Scene")
    return _core.CheckedScene.read(file, _pairs(settings), number("scale", scale))
