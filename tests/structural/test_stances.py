"""Lamellas as members: how they stand, how they are bent into place, what is said of them."""

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.model import model_of
from freecad_ortho.structural.stances import bends
from freecad_ortho.structural.words import assumptions, warnings
from solver.errors import InputError
from solver.mesh.primitives import primitive
from solver.mesh.quadmesh import QuadMesh

RADIUS = 5000.0


@pytest.fixture(scope="module")
def barrel():
    """A vault over arcs of a circle, straight along."""
    mesh = primitive("rectangle", 7, 5, length=1.0, width=1.0)
    part = mesh.vertices - mesh.vertices.min(axis=0)
    angle = part[:, 0] - 0.5
    points = np.stack([np.sin(angle), 0.8 * part[:, 1], np.cos(angle)], axis=1)
    return mesh.with_vertices(RADIUS * points)


def check(mesh, **settings):
    return api.check_structure(mesh, **({"unit": "mm", "snow": 1.0, "material": "S235"} | settings))


def test_heights_follow_the_normals_or_lie_across_them(barrel):
    frames = {
        position: model_of(barrel, Design.of({"snow": 1.0, "position": position})).frame
        for position in ("standing", "lying", "beams")
    }
    radial = barrel.vertices[frames["standing"].members].mean(axis=1) * [1, 0, 1]
    radial = radial / np.linalg.norm(radial, axis=1)[:, None]
    along = {
        position: np.abs((frame.axes[:, 2] * radial).sum(axis=1))
        for position, frame in frames.items()
    }
    # At the border a normal is that of the last face, half a step of 1/6 rad off.
    for position in ("standing", "beams"):
        assert along[position].min() > np.cos(1 / 12) - 1e-6
    assert along["lying"].max() < np.sin(1 / 12) + 1e-6


def test_a_lying_plate_is_a_standing_one_with_its_sizes_exchanged(barrel):
    lying = check(barrel, section="plate:10x80", position="lying")
    other = check(barrel, section="plate:80x10", position="standing")
    assert lying.deflection == pytest.approx(other.deflection, rel=1e-9)
    assert lying.factor == pytest.approx(other.factor, rel=1e-6)
    standing = check(barrel, section="plate:10x80", position="standing")
    assert standing.deflection < 0.5 * lying.deflection


def test_lamellas_are_bent_by_the_curvature_across_their_thickness(barrel):
    for position, bent in (("lying", 1 / RADIUS), ("standing", 0.0)):
        model = model_of(barrel, Design.of({"snow": 1.0, "position": position}))
        found = np.array([bend for _, bend in bends(model.mesh, model.bare)])
        span = barrel.vertices[model.bare.members]
        arcs = np.array(
            [abs(span[m, 1, 0] - span[m, 0, 0]) > 1 for m, _ in bends(barrel, model.bare)]
        )
        assert arcs.sum() == 5 * 5 and (~arcs).sum() == 7 * 3
        assert found[arcs] == pytest.approx(np.full(25, bent), rel=1e-3, abs=1e-9)
        assert found[~arcs] == pytest.approx(np.zeros(21), abs=1e-9)


def test_what_lamellas_are_not_checked_for_is_said(barrel):
    found = check(barrel, section="plate:5x80", position="lying", layers=6.0, crossings="hinged")
    said = " ".join(warnings(found))
    stress = 0.5 * 210_000 * 5 / RADIUS
    assert f"have up to {stress:.0f} MPa in them" in said and "of 235 MPa" in said
    assert "slots" not in said and "lie in the net" in assumptions(found)[0]
    level = check(barrel, section="plate:5x80", position="lying")
    assert "Lying lamellas cannot cross in one layer" in " ".join(warnings(level))
    slotted = check(barrel, section="plate:5x80", position="standing", crossings="hinged")
    assert "0.5 of their height is taken for what is left" in " ".join(warnings(slotted))
    whole = check(barrel, section="plate:5x80", position="standing", slots=1.0)
    assert "sections are checked without slots" in " ".join(warnings(whole))
    assert "cross on one level, hinged" in " ".join(assumptions(slotted))
    assert (
        slotted.balance < 1e-9
        and slotted.factor < check(barrel, section="plate:5x80", position="standing").factor
    )


@pytest.mark.parametrize("second_order", [False, True])
def test_net_sections_at_slots_are_bent_by_axial_forces_beside_their_middle(barrel, second_order):
    """Two thirds of the height left: N / A' + (|My| + |N| h / 6) / W' + |Mz| / W'z, and shear."""
    left, thick, high = 2 / 3, 12.0, 150.0
    settings = {"section": "plate:12x150", "position": "standing", "second_order": second_order}
    found = check(barrel, slots=left, **settings)
    whole = check(barrel, slots=1.0, **settings)
    net = barrel.connectivity
    for one, other in zip(found.strength, whole.strength, strict=True):
        inner = ~net.boundary_vertices[net.edges]
        apart = one.section > other.section * (1 + 1e-12)
        assert not apart[~inner.any(axis=1)].any()
        assert apart[inner.all(axis=1)].all()
        np.testing.assert_array_equal(one.member, other.member)
        most = int(one.section.argmax())
        by = "slot" if one.section[most] > one.member[most] else "buckling"
        assert (one.by(most), other.by(most) != "slot") == (by, True)
        expected = other.section.copy()
        frame, rest = found.model.frame, left * high
        for end in (0, 1):
            n, vy, vz, t, my, mz = one.response.forces_at(frame, float(end)).T
            bent = (np.abs(my) + np.abs(n) * (high - rest) / 2) / (thick * rest**2 / 6)
            normal = np.abs(n) / (thick * rest) + bent + np.abs(mz) / (rest * thick**2 / 6)
            # J of a thin rectangle to 1e-3; shear on five sixths.
            torsion = rest * thick**3 / 3 * (1 - 0.63 * thick / rest)
            shear = np.hypot(vy, vz) / (thick * rest * 5 / 6) + np.abs(t) / (torsion / thick)
            there = np.sqrt(normal**2 + 3 * shear**2) / 235
            expected = np.where(inner[:, end], np.maximum(expected, there), expected)
        if second_order:
            assert (one.section >= expected * (1 - 1e-3)).all()
        else:
            np.testing.assert_allclose(one.section, expected, rtol=1e-3)


def test_what_cannot_stand_so_is_refused_in_one_line():
    words = "position: expected beams, standing, lying or tilted, got 'leaning'"
    with pytest.raises(InputError, match=words):
        Design.of({"position": "leaning"})
    with pytest.raises(InputError, match="slots: expected"):
        Design.of({"slots": 0.0})
    # Three quads around a vertex: no families.
    angle = np.arange(6) * np.pi / 3
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    points = 1000 * np.concatenate([[[0, 0, 0.3]], ring])
    mesh = QuadMesh(points, np.array([[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]]))
    for settings, said in (
        ({"position": "tilted"}, "position: the lines of this net cannot be told apart"),
        ({"crossings": "hinged"}, "layers: the lines of this net cannot be told apart"),
    ):
        with pytest.raises(InputError, match=said) as refused:
            model_of(mesh, Design.of({"snow": 1.0} | settings))
        assert "\n" not in str(refused.value)
