"""Makes a failing scene small: removes elements and attributes and simplifies numbers while it fails alike."""
import copy
import re
import time
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Callable, Iterator

from case import Case
from generate.scene import RandomScene
from judges import JUDGES
from program import Program

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
SECONDS_OF_A_SMALL_SCENE = 10.0
# Of these judges the sentence says which of several failures it is; the others have one each.
BY_SENTENCE = ("ends", "check")


def kind_of(judge: str, sentence: str) -> str:
    """What a failure has in common with that of a smaller scene: its sentence without numbers and places."""
    if judge not in BY_SENTENCE:
        return judge
    words = re.sub(r"\S*/\S*", "", sentence.split("\n")[0])
    return judge + ": " + NUMBER.sub("#", re.sub(r"'[^']*'", "''", words))[:160]


def _simpler(text: str) -> Iterator[str]:
    """Simpler forms of an attribute of numbers."""
    words = text.split()
    if not words or not all(NUMBER.fullmatch(word) for word in words):
        return
    seen = {text}
    whole = all(re.fullmatch(r"[-+]?\d+", word) for word in words)
    for digits in ("0", "1g", "2g", "3g"):
        def simple(word: str, digits: str = digits) -> str:
            return "0" if digits == "0" else word if whole else f"{float(word):.{digits}}"
        candidate = " ".join(simple(word) for word in words)
        if candidate not in seen:
            seen.add(candidate)
            yield candidate
    for k, word in enumerate(words):
        if len(words) > 1 and float(word) != 0:
            yield " ".join([*words[:k], "0", *words[k + 1:]])


class Shrinker:
    """Shrinks scenes within a number of seconds of wall time each."""

    def __init__(self, program: Program, folder: Path, seconds: float) -> None:
        # A smaller scene that takes long is no help to anybody.
        self._program = program.hurried(SECONDS_OF_A_SMALL_SCENE)
        self._folder = folder
        self._seconds = seconds

    def shrink(self, scene: RandomScene, judge: str, sentence: str) -> RandomScene:
        """The smallest scene found that fails in the same way."""
        kind, end = kind_of(judge, sentence), time.monotonic() + self._seconds
        def fails(xml: ET.Element) -> bool:
            if time.monotonic() > end:
                return False
            verdict = self._verdict(RandomScene(xml, scene.files), judge)
            return bool(verdict) and kind_of(judge, verdict) == kind
        xml, size = copy.deepcopy(scene.xml), 0
        while size != len(ET.tostring(xml)) and time.monotonic() < end:
            size = len(ET.tostring(xml))
            for one_pass in (self._fewer_steps, self._fewer_elements, self._fewer_attributes, self._simpler_numbers):
                xml = one_pass(xml, fails)
        text = ET.tostring(xml, encoding="unicode")
        # Files of a hull folder are named by the folder alone.
        named = {name: content for name, content in scene.files.items() if name.split("/")[0] in text}
        return RandomScene(xml, named)

    def _verdict(self, scene: RandomScene, judge: str) -> str:
        try:
            return JUDGES[judge](Case(self._program, scene, self._folder)) or ""
        except (ET.ParseError, KeyError, ValueError, OSError, AssertionError):
            return ""  # the smaller scene cannot be judged: it is no smaller form of this failure

    @staticmethod
    def _fewer_steps(xml: ET.Element, fails: Callable[[ET.Element], bool]) -> ET.Element:
        time_element = xml.find("time")
        if time_element is None:
            return xml
        start, step = float(time_element.get("start", "0")), float(time_element.get("step", "0.01"))
        if start:
            smaller = copy.deepcopy(xml)
            moved = smaller.find("time")
            assert moved is not None
            del moved.attrib["start"]
            moved.set("end", f"{float(moved.get('end', '0')) - start:.10g}")
            if fails(smaller):
                return Shrinker._fewer_steps(smaller, fails)
        steps = (float(time_element.get("end", "0")) - start) / step
        for count in (1, 2, 3, 4, 6, 8, 12, 16):
            if count >= steps - 0.5:
                break
            smaller = copy.deepcopy(xml)
            smaller.find("time").set("end", f"{start + count * step:.10g}")  # type: ignore[union-attr]
            if fails(smaller):
                return smaller
        return xml

    @staticmethod
    def _fewer_elements(xml: ET.Element, fails: Callable[[ET.Element], bool]) -> ET.Element:
        place = 0
        while True:
            found = [(parent, child) for parent in xml.iter() for child in parent]
            # The largest first; the time stays, since steps are counted by it.
            order = sorted(range(len(found)), key=lambda k: -len(list(found[k][1].iter())))
            order = [k for k in order if found[k][1].tag not in ("time", "output")]
            if place >= len(order):
                return xml
            smaller = copy.deepcopy(xml)
            parent, child = [(p, c) for p in smaller.iter() for c in p][order[place]]
            parent.remove(child)
            if fails(smaller):
                xml = smaller
            else:
                place += 1

    @staticmethod
    def _fewer_attributes(xml: ET.Element, fails: Callable[[ET.Element], bool]) -> ET.Element:
        for place, element in enumerate(list(xml.iter())):
            for name in list(element.attrib):
                if (element.tag, name) in (("scene", "version"),
                                           ("output", "trajectory_every")) or element.tag == "time":
                    continue
                smaller = copy.deepcopy(xml)
                del list(smaller.iter())[place].attrib[name]
                if fails(smaller):
                    xml = smaller
        return xml

    @staticmethod
    def _simpler_numbers(xml: ET.Element, fails: Callable[[ET.Element], bool]) -> ET.Element:
        for place, element in enumerate(list(xml.iter())):
            for name in list(element.attrib):
                if element.tag in ("scene", "time", "output"):
                    continue
                for value in _simpler(list(xml.iter())[place].attrib[name]):
                    smaller = copy.deepcopy(xml)
                    list(smaller.iter())[place].set(name, value)
                    if fails(smaller):
                        xml = smaller
                        break
        return xml
