"""The macro API says what there is, with FreeCAD and without it."""

import ast
import inspect
import pydoc
from importlib.util import find_spec

import pytest

from freecad_ortho import api
from solver.errors import OrthoError
from tests.conftest import ROOT


def tree(name):
    return ast.parse((ROOT / "freecad_ortho" / name).read_text(encoding="utf-8"))


def listed(module):
    """The names in ``__all__``."""
    (names,) = (
        item.value
        for item in module.body
        if isinstance(item, ast.Assign) and item.targets[0].id == "__all__"
    )
    return ast.literal_eval(names)


DOCUMENTS = listed(tree("documents/__init__.py"))


without_freecad = pytest.mark.skipif(find_spec("FreeCAD") is not None, reason="has FreeCAD")


def test_all_names_stand_in_the_source_where_editors_look():
    assert listed(tree("api.py")) == api.__all__
    assert set(DOCUMENTS) < set(api.__all__) <= set(dir(api))
    imported = {
        alias.name
        for item in ast.walk(tree("api.py"))
        if isinstance(item, ast.ImportFrom) and item.module == "freecad_ortho.documents"
        for alias in item.names
    }
    assert imported == set(DOCUMENTS)
    with pytest.raises(AttributeError, match="has no attribute 'add_towers'"):
        _ = api.add_towers


@without_freecad
@pytest.mark.parametrize("name", DOCUMENTS)
def test_without_freecad_every_function_has_its_help_and_says_what_it_needs(name):
    function = getattr(api, name)
    arguments, _, docstring = inspect.getdoc(function).partition("\n\n")
    assert arguments.startswith(f"{name}(") and docstring.strip()
    with pytest.raises(OrthoError, match=f"^{name}: works on documents of FreeCAD") as said:
        function("anything", at=all)
    assert "\n" not in str(said.value)


@without_freecad
def test_help_of_the_module_shows_them_all():
    shown = pydoc.plain(pydoc.render_doc(api))
    for name in api.__all__:
        assert f"{name}(" in shown or f"class {name}" in shown, name
    assert "section: str='plate'" in shown
