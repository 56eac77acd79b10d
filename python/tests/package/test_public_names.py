"""Every public name has a docstring with an example, and the examples of the compiled part are run."""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
from collections.abc import Iterator
from pathlib import Path

import nilas
import nilas.study
import numpy as np
import pytest
from nilas import _core

PACKAGE = Path(nilas.__file__).parent
# Of studies the command and the few names of nilas.study are public; the rest serves them.
INNER = PACKAGE / "study"
COMPILED = [_core.Problem, _core.Solution, _core.CheckedScene, _core.Step, _core.VesselStep, _core.BodyStates]
COMPILED += [_core.Snapshot]


def examples(text: str | None) -> str:
    """The code of the examples in a docstring."""
    return "".join(one.source for one in doctest.DocTestParser().get_examples(text or ""))


def public(members: dict[str, object]) -> dict[str, object]:
    return {name: value for name, value in members.items() if not name.startswith("_")}


def nodes_without_example(body: list[ast.stmt], place: str, around: str) -> Iterator[str]:
    """Public functions and classes. A property may be shown by the example of its class, in ``around``."""
    for node in body:
        if not isinstance(node, (ast.FunctionDef, ast.ClassDef)) or node.name.startswith("_"):
            continue
        code = examples(ast.get_docstring(node))
        decorators = [ast.unparse(one) for one in node.decorator_list]
        is_shown = "property" in decorators and f".{node.name}" in around
        if not code and not is_shown and "overload" not in decorators:
            yield f"{place}.{node.name}"
        if isinstance(node, ast.ClassDef):
            yield from nodes_without_example(node.body, f"{place}.{node.name}", code)


def test_every_public_name_of_the_modules_has_an_example() -> None:
    missing: list[str] = []
    for file in sorted(PACKAGE.rglob("*.py")):
        if INNER not in file.parents:
            missing += nodes_without_example(ast.parse(file.read_text()).body, file.stem, "")
    assert not missing


def test_every_name_that_is_exported_has_an_example() -> None:
    exported = {f"nilas.{name}": getattr(nilas, name) for name in nilas.__all__}
    exported |= {f"nilas.study.{name}": getattr(nilas.study, name) for name in nilas.study.__all__}
    assert len(exported) > 30
    assert not [name for name, value in exported.items() if not examples(inspect.getdoc(value))]


def test_every_member_of_the_compiled_classes_has_an_example() -> None:
    """A method has its own, and a number or an array is shown by that of its class or of the member."""
    missing = []
    for kind in COMPILED:
        shown = examples(kind.__doc__)
        for name, member in public(vars(kind)).items():
            own = examples(getattr(kind, name).__doc__)
            if not own and (not isinstance(member, property) or f".{name}" not in shown):
                missing.append(f"{kind.__name__}.{name}")
        assert shown, kind.__name__
    assert not missing


def compiled_docs() -> dict[str, str]:
    docs = {}
    for kind in COMPILED:
        docs[kind.__name__] = kind.__doc__ or ""
        for name in public(vars(kind)):
            docs[f"{kind.__name__}.{name}"] = getattr(kind, name).__doc__ or ""
    return {name: text for name, text in docs.items() if examples(text)}


@pytest.mark.parametrize("name", compiled_docs())
def test_the_example_of_a_compiled_name_runs(
    name: str, small_scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names = {**public(vars(_core)), "nilas": nilas, "np": np, "small_scene": small_scene}
    test = doctest.DocTestParser().get_doctest(compiled_docs()[name], names, name, None, None)
    told: list[str] = []
    result = doctest.DocTestRunner().run(test, out=told.append)
    assert result.attempted > 0 and result.failed == 0, "".join(told)


def test_names_of_the_package_are_those_of_its_annotations() -> None:
    """What a reader of types sees in nilas/__init__.py is what can be imported."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    block = next(node for node in tree.body if isinstance(node, ast.If))
    typed = {f"{node.module}:{one.name}" for node in block.body if isinstance(node, ast.ImportFrom) for one in node.names}
    assert typed == {f"{home}:{name}" for name, home in nilas._HOMES.items()}
    for name, home in nilas._HOMES.items():
        assert getattr(nilas, name) is getattr(importlib.import_module(home), name)
