"""The table of nets: what follows from an entry, in the solver."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver import InputError, optimise
from solver.align.guides import TURNED
from solver.analysis import measures
from solver.analysis.advisor import advise
from solver.analysis.check import check
from solver.analysis.start import closer_variant
from solver.nets import NETS, all_measures, nets_with, register, unregister
from solver.nets.options import OPTIONS
from tests.conftest import wavy_grid
from tests.own_net import FLAT


@pytest.fixture
def own():
    register(FLAT)
    yield FLAT
    unregister(FLAT.name)


def test_a_net_of_ones_own_is_optimised_for_measured_and_advised(own):
    start = wavy_grid(9, 8, shear=0.3)
    outcome = optimise(start, "flat")
    assert outcome.report.status == "converged"
    assert measures.planarity(outcome.mesh).max() <= 1e-10 < measures.orthogonality(start).min()
    found = check(start)
    assert found["measures"]["flatness"]["max"] == measures.planarity(start).max()
    assert "flat" in [one["net"] for one in found["advice"]["nets"]]


def test_nets_of_flat_faces_begin_along_lines_of_curvature():
    flat = [name for name, net in NETS.items() if "planarity" in [one.name for one in net.measures]]
    assert "planar" in flat
    assert {NETS[name].lines for name in flat} == {"principal"}


def test_a_name_is_given_once_and_a_net_that_has_gone_is_unknown(own):
    with pytest.raises(InputError, match="there is a net 'flat' already"):
        register(replace(own, place=1))
    assert list(NETS)[-1] == "flat"
    unregister("flat")
    with pytest.raises(InputError, match="net: expected principal, planar"):
        optimise(wavy_grid(4, 4), "flat")
    with pytest.raises(InputError, match="net: expected principal, planar"):
        unregister("flat")
    register(own)


def test_every_net_has_its_words_and_place():
    places = [net.place for net in NETS.values()]
    assert places == sorted(set(places))
    for net in NETS.values():
        for words in (net.title, net.condition, net.purpose, net.gives, net.short):
            assert words == words.strip() != ""
        assert net.gives.endswith(".") and not net.condition.endswith(".")
        assert set(net.options) <= set(OPTIONS)
        assert {easier.net for easier in net.way.easier} <= set(NETS)
    assert all(nets_with(option) for option in OPTIONS)


def test_the_advisor_knows_every_net_that_a_mesh_alone_is_judged_by():
    advised = {(one.net, one.diagonal) for one in advise(wavy_grid(7, 6))}
    expected = {
        (net.name, diagonal)
        for net in NETS.values()
        if net.name not in ("stress", "isometric")
        for diagonal in net.variants
    }
    assert advised == expected
    flat_strip = {one.net for one in advise(wavy_grid(5, 2))}
    assert flat_strip == {
        "orthogonal",
        "isogonal",
        "planar",
        "planar-lines",
        "principal",
        "circular",
        "chebyshev",
    }


def test_a_strip_without_inner_vertices_is_not_called_curved(monkeypatch):
    bent = replace(FLAT, name="bent", shape="developable")
    monkeypatch.setitem(NETS, "bent", bent)
    (said,) = (one for one in advise(wavy_grid(5, 2)) if one.net == "bent")
    assert (said.cause, said.reason) == ("", "")
    (said,) = (one for one in advise(wavy_grid(7, 6)) if one.net == "bent")
    assert said.cause == "bends"


def test_nets_of_which_others_are_special_cases_are_advised_last():
    mesh = wavy_grid(7, 6, height=0.0, shear=0.0)
    names = [one.net for one in advise(mesh)]
    assert set(names[-5:]) == {"planar", "orthogonal", "isogonal", "snet"}


def test_every_net_with_a_variant_has_measures_of_it():
    mesh = wavy_grid(7, 6)
    assert set(check(mesh)["measures"]) == set(all_measures())
    for net in NETS.values():
        if len(net.variants) == 2:
            stars = [one for one in net.measures if one.across and not one.square]
            assert stars and stars[0].on(mesh).mean() != stars[0].on(mesh, diagonal=True).mean()
            assert closer_variant(mesh, net.name, False) is None
    assert np.isfinite([one.distance for one in advise(mesh)]).all()


def test_nets_are_aligned_as_those_that_others_begin_with():
    begins = {net.lines for net in NETS.values()} - {""}
    shapes = {net.shape for net in NETS.values()} - {"any"}
    assert begins <= set(TURNED)
    for name in set(TURNED) - begins:
        assert name in shapes, f"{name} is no net, nor what a net needs of a surface"
