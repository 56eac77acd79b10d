"""The stub names what the compiled part has, and nothing else."""

import ast
import pathlib

from nilas import _core

STUB = ast.parse((pathlib.Path(__file__).parents[2] / "nilas" / "_core.pyi").read_text())


def test_classes_and_members_agree():
    stub = {node.name: node for node in STUB.body if isinstance(node, ast.ClassDef)}
    real = {name: value for name, value in vars(_core).items() if isinstance(value, type)}
    assert set(stub) == set(real)
    for name, node in stub.items():
        members = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        public = {member for member in vars(real[name]) if not member.startswith("_")}
        assert members - {"__init__"} == public, name


def test_functions_agree():
    stub = {node.name for node in STUB.body if isinstance(node, ast.FunctionDef)}
    real = {name for name, value in vars(_core).items() if callable(value) and not isinstance(value, type)}
    assert stub == real
