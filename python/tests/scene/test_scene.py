"""Scenes of Python objects."""

import pathlib

import nilas
import numpy as np
import pytest
from nilas.scene import Element, Scene
from nilas.scene.table import table

SCENES = pathlib.Path(__file__).parents[3] / "apps" / "scenes"


@pytest.mark.parametrize("file", sorted(SCENES.glob("*.xml")), ids=lambda file: file.stem)
def test_shipped_scenes_survive_the_round_trip(file):
    there = nilas.Scene.read(file)
    assert there.check().fingerprint == nilas._core.CheckedScene.read(file).fingerprint


def test_values_are_written_as_numbers_and_words():
    element = Element("body", name="a", position=np.array([1, 2.5, 0]), mass=np.float64(3), fixed=np.bool_(True))
    assert element["position"] == "1.0 2.5 0.0"
    assert element["fixed"] == "true"


def test_faults_name_the_nearest_word():
    with pytest.raises(nilas.InputError, match="did you mean tolerance"):
        Element("contact", tolernce=1)
    with pytest.raises(nilas.InputError, match="did you mean <time>"):
        Element("tme")
    with pytest.raises(nilas.InputError, match="one <time> only"):
        Scene(Element("time"), Element("time"))
    with pytest.raises(nilas.InputError, match="step"):
        Scene(Element("time", step=-1)).check()
    with pytest.raises(nilas.InputError, match="holds text"):
        Scene.parse("<scene version='1'><time>soon</time></scene>")
    two = Scene(Element("body", name="a"), Element("body", name="b"))
    with pytest.raises(nilas.InputError, match="say which"):
        two.set({"body/@mass": 1})
    assert two.set({"body[2]/@mass": 3}).children[1]["mass"] == "3"
    with pytest.raises(nilas.InputError, match="no path"):
        Scene().set({"contact/tolerance": 1})
    with pytest.raises(nilas.InputError, match="no XML"):
        Scene.parse("<scene")


def test_every_element_of_the_table_can_be_made():
    for name, entry in table().items():
        element = Element(name)
        assert element.tag == name
        for child in entry.children:
            element.append(Element(child))


def test_numpy_values_are_values():
    assert Element("body", fixed=np.array(True))["fixed"] == "true"
    with pytest.raises(nilas.InputError, match="no value"):
        Element("body", name=b"a")


def test_the_version_of_a_text_is_kept():
    assert Scene.parse('<scene version="7"/>')["version"] == "7"


def test_a_scene_is_written_and_read(tmp_path):
    scene = Scene(Element("time", step=0.02, end=3), name="written")
    assert nilas.Scene.read(scene.write(tmp_path / "written.xml")).xml() == scene.xml()
