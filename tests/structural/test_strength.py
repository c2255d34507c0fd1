"""Utilisation against sums by hand."""

import numpy as np
import pytest

from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.structural.strength import reduction, rules_for, torsion_modulus
from solver.errors import InputError


def one(*forces):
    """Forces in one section of one member."""
    return np.array(forces, dtype=float).reshape(1, 1, 6)


LENGTH = np.array([3000.0])


def test_reduction_is_that_of_the_tables():
    """EN 1993-1-1, figure 6.4, curves a and c at a slenderness of 1."""
    assert reduction(np.array([1.0, 0.2, 0.1]), 0.21, 0.2) == pytest.approx(
        [0.6656, 1, 1], abs=1e-4
    )
    assert reduction(np.array([1.0]), 0.49, 0.2) == pytest.approx([0.5399], abs=1e-4)


def test_a_steel_section_takes_tension_up_to_its_strength():
    rules = rules_for(profile("tube:100x60x5"), "S235")
    area = profile("tube:100x60x5").area
    assert rules.section(one(235 * area, 0, 0, 0, 0, 0), False) == pytest.approx([1.0])
    assert rules.member(one(235 * area, 0, 0, 0, 0, 0), LENGTH, False) == pytest.approx([0.0])


def test_bending_and_shear_are_added_as_mises_does():
    section = profile("plate:20x200")
    rules = rules_for(section, "S355")
    moment, shear = 100 * section.modulus_y, 60 * section.shear_area_z
    found = rules.section(one(0, 0, shear, 0, moment, 0), False)
    assert found == pytest.approx([np.sqrt(100**2 + 3 * 60**2) / 355])
    both = rules.section(one(0, 0, 0, 0, moment, 50 * section.modulus_z), False)
    assert both == pytest.approx([150 / 355])


def test_a_round_tube_bends_alike_in_all_directions():
    section = profile("chs:88.9x5")
    rules = rules_for(section, "S355")
    moment = 100 * section.modulus_y
    slant = moment / np.sqrt(2)
    assert rules.section(one(0, 0, 0, 0, slant, slant), False) == pytest.approx([100 / 355])


def test_torsion_of_closed_and_open_sections():
    """Bredt's 2 Am t; b t2 / 3 of a flat plate."""
    assert torsion_modulus(profile("chs:100x2")) == pytest.approx(2 * np.pi * 49**2 * 2, rel=1e-3)
    assert torsion_modulus(profile("plate:5x200")) == pytest.approx(200 * 25 / 3, rel=0.02)
    section = profile("IPE200")
    assert torsion_modulus(section) == pytest.approx(section.torsion / 8.5)


def test_a_column_carries_what_the_buckling_curve_leaves():
    """chs 88.9 x 5, S355, 3 m: slender 3000 / 29.7 / 76.4 = 1.32, curve a, 0.447."""
    section = profile("chs:88.9x5")
    slender = 3000 / np.sqrt(section.inertia_y / section.area) / (np.pi * np.sqrt(210e3 / 355))
    left = reduction(np.array([slender]), 0.21, 0.2)[0]
    force = left * section.area * 355
    found = rules_for(section, "S355").member(one(-force, 0, 0, 0, 0, 0), LENGTH, False)
    assert slender == pytest.approx(1.32, abs=0.01) and left == pytest.approx(0.45, abs=0.01)
    assert found == pytest.approx([1.0])


def test_an_open_section_tips_over_and_a_closed_one_does_not():
    flat, tube = profile("plate:10x200"), profile("tube:100x60x5")
    for section, tips in ((flat, True), (tube, False)):
        moment = 200 * section.modulus_y
        rules = rules_for(section, "S355")
        bent = rules.section(one(0, 0, 0, 0, moment, 0), False)
        found = rules.member(one(0, 0, 0, 0, moment, 0), LENGTH, False)
        assert (found[0] > 1.2 * bent[0]) == tips


def test_timber_takes_less_of_what_stays():
    """GL24h 80 x 200: fm,d = 0.9 x 24 / 1.25 = 17.28 MPa, 11.52 MPa of loads that stay."""
    section = profile("GL24h:80x200")
    rules = rules_for(section, "GL24h")
    moment = 17.28 * section.modulus_y
    assert rules.section(one(0, 0, 0, 0, moment, 0), False) == pytest.approx([1.0])
    assert rules.section(one(0, 0, 0, 0, moment, 0), True) == pytest.approx([1.5])
    pressed = rules.member(one(-100e3, 0, 0, 0, 0, 0), LENGTH, False)
    slender = 3000 / (80 / np.sqrt(12)) / np.pi * np.sqrt(24 / 9600)
    k = 0.5 * (1 + 0.1 * (slender - 0.3) + slender**2)
    left = 1 / (k + np.sqrt(k**2 - slender**2))
    assert pressed == pytest.approx([100e3 / 16_000 / (left * 17.28)])


@pytest.mark.parametrize(
    ("section", "material", "said"),
    [
        ("tube:100x60x5", "glass", "there are no rules for members of 'glass'; take one of steel"),
        ("tube:100x60x5", "GL24h", "tube:100x60x5 is made of steel, "),
        ("polygon:0,0 60,0 0,80", "S355", "has no axis of symmetry"),
    ],
)
def test_what_has_no_rules_is_refused(section, material, said):
    with pytest.raises(InputError, match=said):
        rules_for(profile(section), material)
