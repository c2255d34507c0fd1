"""The macro API says what there is, with FreeCAD and without it."""

import ast
import inspect
import pydoc
from importlib.util import find_spec
from typing import get_args, get_type_hints

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho import option_keywords as option_keywords_written
from freecad_ortho.calls import listing_keywords
from freecad_ortho.fabrication.systems import SYSTEMS
from freecad_ortho.keywords import NetSettings
from freecad_ortho.sources import GROUPS, SOURCES
from scripts import option_keywords
from solver.errors import InputError, OrthoError
from solver.nets.options import OPTIONS
from solver.optimise import Settings
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
    assert function.__doc__ and pydoc.plain(pydoc.render_doc(function)).count(f"{name}(") == 1
    assert inspect.signature(function).parameters.keys() != {"arguments", "settings"}
    with pytest.raises(OrthoError, match=f"^{name}: works on documents of FreeCAD") as said:
        function("anything", at=all)
    assert "\n" not in str(said.value)


@without_freecad
def test_help_of_the_module_shows_them_all():
    shown = pydoc.plain(pydoc.render_doc(api))
    for name in api.__all__:
        assert f"{name}(" in shown or f"class {name}" in shown, name
    assert "section: str = 'plate'" in shown and "semi_axes: Sequence[Length] = ..." in shown


def test_types_of_keywords_are_those_of_the_tables():
    written = option_keywords.WRITTEN.read_text(encoding="utf-8")
    assert written == option_keywords.text(), "run scripts/option_keywords.py"
    hints = get_type_hints(NetSettings)
    others = {*get_type_hints(Settings), "net", "handles", "glide", "close_to", "symmetry"}
    assert set(hints) - set(OPTIONS) == others - {"tuning"}
    for name, option in OPTIONS.items():
        if option.choices:
            assert get_args(hints[name]) == option.choices, name


def definition_of(name):
    """The source of a function on documents."""
    (function,) = (
        item
        for path in sorted((ROOT / "freecad_ortho" / "documents").glob("*.py"))
        for item in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(item, ast.FunctionDef) and item.name == name
    )
    return function


def arguments_of(name):
    """Names and defaults of a function on documents, as its source has them."""
    function = definition_of(name)
    plain, spelled = function.args.args, function.args.kwonlyargs
    usual = dict(zip(reversed(plain), reversed(function.args.defaults), strict=False))
    usual |= dict(zip(spelled, function.args.kw_defaults, strict=True))
    return {arg.arg: ast.literal_eval(node) for arg, node in usual.items()}


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_function_of_a_system_has_all_its_options_with_their_defaults(system):
    found = arguments_of(f"add_{system.replace('-', '_')}")
    common = {"family": "both", "lines": (), "material": "steel", "density": 0.0}
    assert {name: found.pop(name) for name in common} == common
    assert found.pop("beams", None) is None
    wanted = {option.name: option.default for option in SYSTEMS[system].options}
    if "panel_thickness" in wanted:
        # Where nothing is said it may be that of a build-up.
        wanted["thickness"] = None
    assert found == wanted


@pytest.mark.parametrize("system", SYSTEMS)
def test_options_that_are_one_of_a_few_words_have_these_for_their_type(system):
    asked = definition_of(f"add_{system.replace('-', '_')}").args
    types = {arg.arg: ast.unparse(arg.annotation) for arg in (*asked.args, *asked.kwonlyargs)}
    words = {
        option.name: option.choices
        for option in SYSTEMS[system].options
        if option.kind == "choice" and not option.examples
    }
    for name, choices in {**words, "family": ("u", "v", "both")}.items():
        assert types[name] == option_keywords.alias(name)
        assert set(choices) <= set(get_args(getattr(option_keywords_written, types[name])))


@pytest.mark.parametrize(
    ("function", "names", "own"),
    [
        ("add_primitive", GROUPS["primitive"], set()),
        ("add_multi_net", GROUPS["multi-net"], {"points"}),
        ("add_elliptic_net", GROUPS["elliptic multi-net"], {"moving"}),
        ("net_from_faces", GROUPS["faces"], set()),
        ("net_along_curvature", GROUPS["along curvature"], {"strokes"}),
        ("form_net", GROUPS["form-finding"], set()),
        ("add_source", SOURCES, {"nets", "faces", "strokes"}),
        ("change_source", SOURCES, {"nets", "faces", "strokes"}),
    ],
)
@without_freecad
def test_the_function_of_a_source_shows_its_options(function, names, own):
    shown = inspect.signature(getattr(api, function)).parameters.values()
    asked = {one.name for one in shown if one.default is not inspect.Parameter.empty}
    options = {option.name for name in names for option in SOURCES[name].options}
    assert asked - {"document"} == options | own


def test_help_shows_keywords_that_stand_in_a_table():
    shown = inspect.signature(api.fabricate).parameters
    assert {option.name for option in SYSTEMS["beams"].options} < set(shown)
    assert not any(one.kind is inspect.Parameter.VAR_KEYWORD for one in shown.values())
    assert "edge_height: Length | None = ..." in pydoc.plain(pydoc.render_doc(api.fabricate))


def test_a_size_that_a_system_has_not_is_refused_by_naming_whose_it_is(barrel):
    with pytest.raises(
        InputError, match=r"^height: panels has no such size, it is of edge-beam, beams, nodes"
    ):
        api.fabricate(barrel, "panels", height=999)
    with pytest.raises(
        InputError, match=r"^hight: no system has such a size; there are edge_section, "
    ):
        api.fabricate(barrel, "beams", hight=999)
    with pytest.raises(InputError, match=r"^sheets: the workshop has no such size; it has sheet, "):
        api.write_fabrication(None, "nowhere", sheets="3000x1500")
    with pytest.raises(InputError, match=r"^optimise: has no 'fairnes'; it has fairness, "):
        api.optimise(barrel, fairnes=1)
    with pytest.raises(InputError, match=r"^offset_mesh: has no 'knd'; it has mesh, distance, "):
        api.offset_mesh(barrel, 1.0, knd="parallel")
    with pytest.raises(InputError, match=r"^read_mesh: has no 'unt'; it has path, unit, up, "):
        api.read_mesh("roof.obj", unt="m")


def test_a_function_lists_its_keywords_where_one_is_unknown():
    def add(net, /, height=200.0, *, ends="mitred"):
        """Add beams."""
        return net, height, ends

    listing = listing_keywords(add)
    assert listing("roof", 100, ends="hub") == ("roof", 100, "hub")
    assert inspect.signature(listing) == inspect.signature(add)
    assert (listing.__name__, listing.__doc__) == ("add", "Add beams.")
    with pytest.raises(InputError, match=r"^add: has no 'hight'; it has height, ends$"):
        listing("roof", hight=100)

    def free(**settings):
        return settings

    assert listing_keywords(free) is free


def first_is_mesh(name):
    parameters = list(inspect.signature(getattr(api, name)).parameters.values())
    return bool(parameters) and parameters[0].annotation == "QuadMesh" and name != "ReadMesh"


@pytest.mark.parametrize("name", [name for name in api.__all__ if first_is_mesh(name)])
def test_what_is_no_mesh_is_refused_with_the_way_to_one(name, barrel):
    function = getattr(api, name)
    others = {
        "find_form": (np.ones(1), None),
        "offset_mesh": (1.0,),
        "size_structure": ("tubes",),
    }.get(name, ())
    read = api.ReadMesh(barrel, "mm", ())
    for given, remedy in (
        ("roof.obj", r"got str; read the file with read_mesh first$"),
        (read, r"got ReadMesh; give its \.mesh$"),
        (barrel.vertices, r"got ndarray; QuadMesh\(vertices, faces\) makes one of arrays$"),
    ):
        with pytest.raises(InputError, match=r"^mesh: expected a QuadMesh, " + remedy):
            function(given, *others)
