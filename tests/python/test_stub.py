"""The type stub has every public name and option, and no other."""
import ast
import inspect
import pathlib

import glare
from glare import _making

TREE = ast.parse((pathlib.Path(glare.__file__).with_suffix(".pyi")).read_text())
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef)}


def members(name):
    body = CLASSES[name].body
    return {node.name for node in body if isinstance(node, ast.FunctionDef)} | {
        node.target.id for node in body if isinstance(node, ast.AnnAssign)}


def public(thing):
    return {name for name in dir(thing) if not name.startswith("_")}


def parameters(function):
    arguments = function.args
    return [a.arg for a in arguments.posonlyargs + arguments.args + arguments.kwonlyargs]


def test_names():
    declared = {node.target.id for node in TREE.body if isinstance(node, ast.AnnAssign)}
    stub = {name for name in set(CLASSES) | set(FUNCTIONS) | declared if not name.startswith("_")}
    assert stub | {"__version__"} == set(glare.__all__)
    listed = next(ast.literal_eval(node.value) for node in TREE.body if isinstance(node, ast.Assign)
                  and node.targets[0].id == "__all__")
    assert listed == glare.__all__
    assert (pathlib.Path(glare.__file__).parent / "py.typed").exists()


def test_members_of_classes():
    assert members("Template") == public(glare.Template)
    assert members("Filter") - {"__init__"} == public(glare.Filter)
    for name in ("Lamp", "Spectrum", "Observer", "RadialProfile", "Aperture"):
        assert members(name) == set(getattr(glare, name)._fields), name


def test_parameters():
    for name, function in FUNCTIONS.items():
        if name == "read_template":
            continue  # Built in, without a signature.
        expected = [p.name for p in inspect.signature(getattr(glare, name)).parameters.values()
                    if p.kind is not p.VAR_KEYWORD]
        assert parameters(function) == expected, name
    for node in CLASSES["Filter"].body:
        if node.name in ("__init__", "apply"):
            expected = list(inspect.signature(getattr(glare.Filter, node.name)).parameters)
            assert parameters(node) == expected, node.name


def test_options():
    template = members("_EyeOptions") | members("_TemplateOptions")
    assert template == set(_making._TEMPLATE_KEYWORDS)
    assert members("_EyeOptions") | members("_EyePictureOptions") == set(_making._EYE_KEYWORDS)
