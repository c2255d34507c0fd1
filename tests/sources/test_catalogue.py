"""The tables of sources: every one makes a net from its defaults, and says what is wrong."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_ortho.sources import GROUPS, SOURCES, source
from freecad_ortho.sources.multinets import QUADRICS, drawn_net, first_polyline, quadric_of
from freecad_ortho.sources.quadric_shape import quadric_mesh
from solver import InputError
from solver.analysis import measures
from solver.mesh.primitives import primitive
from solver.multinet import multi_net_residual
from solver.option import NUMBERS
from tests.solver.mesh.test_derived import star_of

TURNED = (np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), np.array([10.0, 20, 30]))
SHEET = primitive("rectangle", 9, 9, length=8000.0, width=8000.0)


def inputs(entry):
    """Meshes for a source that needs some; a plane of symmetry may not cut the net."""
    beside = SHEET.with_vertices(SHEET.vertices + [8000.0, 0, 0])
    nets = {"net": [beside if entry.name == "mirror" else SHEET], "nets": [SHEET, beside]}
    return {"meshes": nets[entry.needs]} if entry.needs in nets else {}


@pytest.mark.parametrize("name", sorted(set(SOURCES) - {"faces", "along curvature"}))
def test_defaults_make_a_net(name):
    entry = source(name)
    made = entry.make({}, **inputs(entry))
    assert len(made.mesh.faces) > 10
    assert not measures.flipped(made.mesh).any()
    assert all("\n" not in remark for remark in made.remarks)


def test_every_source_is_in_one_group():
    members = [name for group in GROUPS.values() for name in group]
    assert sorted(members) == sorted(SOURCES)


@pytest.mark.parametrize("entry", SOURCES.values(), ids=lambda entry: entry.name)
def test_every_option_is_explained(entry):
    for option in entry.options:
        assert option.meaning and not option.meaning.endswith(".")
        assert option.kind != "choice" or option.default in option.choices
        assert len(option.parts) == (
            len(option.default)
            if isinstance(option.default, tuple) and option.kind in NUMBERS
            else 1
        )


def test_orient_turns_the_other_side_up_unless_told():
    net = source("orient").make({}, meshes=[SHEET]).mesh
    assert np.allclose(net.vertex_normals, -SHEET.vertex_normals)


def test_coarsening_what_does_not_fit_says_what_would():
    """A mesh with irregular vertices is no grid; that is not what is wrong with it."""
    with pytest.raises(InputError, match=r"do not divide into blocks of 3 x 3 .* trim rows"):
        source("coarsen").make({"every": (3, 3)}, meshes=[star_of(5, 4)])


@pytest.mark.parametrize(
    ("name", "options", "words"),
    [
        ("sphere", {"radios": 3}, "has sampling, radius"),
        ("sphere", {"sampling": (5,)}, "expected 2 finite numbers"),
        ("sphere", {"radius": "big"}, "radius: expected a finite number, got 'big'"),
        ("sphere", {"radius": float("nan")}, "radius: expected a finite number, got nan"),
        ("catenoid", {"lines": "wavy"}, "lines: expected principal or asymptotic"),
        ("multi-net", {"semi_axes": (1.0, 0.0, 2.0)}, "semi axes: expected a number above 0 mm"),
        ("multi-net", {"t_range": (-1e9, 1e6)}, "t: expected"),
        ("multi-net", {"points": [(1.0, 2.0, 3.0)]}, "at least 2 points"),
        ("multi-net", {"reflect": "w"}, "some of x, y, z"),
        (
            "elliptic multi-net",
            {"semi_axes": (1.0, 2.0, 3.0)},
            "semi axes: expected three different ones, the largest first",
        ),
        ("elliptic multi-net", {"curve": "formulas", "first_formula": "import os"}, "formula"),
        ("form-finding", {"supports": "roof"}, "boundary, corners or"),
        ("form-finding", {"lift": "0;100"}, "VERTEX:HEIGHT"),
        ("form-finding", {"lift": "40:100"}, "no support"),
        ("trim", {"rings": 0}, "got none"),
        ("trim", {"rings": 9}, "no face is left"),
        ("subdivide", {"levels": 40}, "levels"),
        ("subdivide", {"levels": 1.5}, "levels: expected a whole number, 1 or more, got 1.5"),
        ("subdivide", {"levels": True}, "levels: expected a finite number, got True"),
        ("sphere", {"sampling": (-2, 5)}, "sampling: expected a whole number, 2 or more"),
        ("ellipsoid", {"sampling": (0, 0)}, "sampling: expected a whole number, 2 or more"),
        ("sphere", {"sampling": (5000, 50000)}, "5000 x 50000 are more than 10,000,000 vertices"),
        ("multi-net", {"sampling": (10**9, 4)}, "more than 10,000,000 vertices; take fewer"),
        ("offset", {"distance": 0.0}, "distance: expected a number other than 0, got 0"),
        ("weld", {"tolerance": -5.0}, "tolerance: expected 0 mm or more, got -5"),
        ("multi-net", {"closed": "x"}, "closed: expected True or False, got 'x'"),
        ("multi-net", {"points": "x"}, "points: expected points of three numbers, got x"),
        ("form-finding", {"lift": 3}, "lift: expected a text, got 3"),
    ],
)
def test_bad_options_get_one_line(name, options, words):
    entry = source(name)
    with pytest.raises(InputError, match=words) as caught:
        entry.make(options, **inputs(entry))
    assert "\n" not in str(caught.value)


def test_a_profile_that_is_turned_lies_in_a_plane_with_the_axis():
    profile = next(one for one in SOURCES["rotational"].options if one.name == "profile")
    assert not np.array(profile.default)[:, 2].any()


def test_no_such_source():
    with pytest.raises(InputError, match="expected catenoid"):
        source("magic")


def test_a_placement_moves_the_net_and_nothing_else():
    here = source("sphere").make({}).mesh
    there = source("sphere").make({"placement": TURNED}).mesh
    np.testing.assert_allclose(there.vertices, here.vertices @ TURNED[0].T + TURNED[1], atol=1e-9)


@pytest.mark.parametrize("kind", QUADRICS)
def test_a_first_polyline_lies_on_its_quadric_wherever_that_is(kind):
    quadric = quadric_of(kind, (9000.0, 6000.0, 4000.0), TURNED)
    points = quadric.from_frame(first_polyline(quadric))
    assert quadric.distance(points).max() < 1e-6
    assert quadric.distance(quadric_mesh(quadric).vertices).max() < 1e-6
    net = drawn_net(kind, (9000.0, 6000.0, 4000.0), (), False, TURNED)
    low, high = net.admissible
    mesh = net.sampled(9, 7, (0.5 * low, min(0.5 * high, -low)))
    assert multi_net_residual(mesh).bound < 1e-12


@pytest.mark.parametrize("kind", QUADRICS)
def test_a_quadric_is_shown_all_around(kind):
    """With three planes of symmetry, wherever it is."""
    quadric = quadric_of(kind, (9000.0, 6000.0, 4000.0), TURNED)
    points = (quadric_mesh(quadric).vertices - TURNED[1]) @ TURNED[0]
    low, high = points.min(axis=0), points.max(axis=0)
    np.testing.assert_allclose(low, -high, rtol=1e-9)
    np.testing.assert_allclose(points.mean(axis=0), 0.0, atol=1e-9 * high.max())


def test_a_shown_sphere_is_as_large_as_it_is():
    shown = quadric_mesh(quadric_of("ellipsoid", (500.0, 500.0, 500.0), TURNED))
    zone = 4 * np.pi * 500.0**2 * np.cos(0.12)
    assert np.linalg.norm(shown.face_area_vectors, axis=1).sum() == pytest.approx(zone, rel=0.01)
