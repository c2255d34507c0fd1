"""Cold-bent panels: stresses by formula, limits by build-up, solids and patterns of bent plates."""

import csv
import re

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build, material, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.systems.panels.cold import ColdBent, lasting_strength, unbent
from freecad_ortho.fabrication.systems.panels.planes import Planes
from solver.errors import InputError
from tests.conftest import ROOT
from tests.meshes import grid

TOUGHENED = material("toughened-glass")


def warped(warp, width=1500.0, height=1000.0, lean=0.0):
    """One face whose last corner is so far off the plane of the others."""
    x, y = np.meshgrid([0.0, width], [0.0, height], indexing="ij")
    return grid(x + lean * y, y, warp * x * y / (width * height))


def bent(warp, made_of=TOUGHENED, thickness=8.0, **sizes):
    panels = Panels(thickness, 8, bending="cold")
    return build(warped(warp, **sizes), [panels], material=made_of)


def test_a_rectangle_carries_the_stress_of_pure_twist():
    """sigma = G t h / (a b), at the corners by less: G is E / (2 (1 + nu))."""
    measures = bent(20.0).parts[0].measures
    twist = 70_000 / 2.4 * 8 * 20 / (1500 * 1000)
    assert measures.warp_mm == pytest.approx(20.0, rel=1e-3)
    assert measures.cold_MPa == pytest.approx(twist, rel=2e-3)
    assert measures.gap_mm is None
    allowed = (45 * 0.29 / 1.8 + 75 / 1.2) / 2
    assert measures.bend_use_percent == pytest.approx(
        100 * max(twist / allowed, 20 / (16.8 * 8)), rel=2e-3
    )


def test_a_skewed_plate_bends_more_one_way():
    """Bending of w = h u v in skewed axes, differentiated by hand."""
    lean, warp, a, b = 0.5, 20.0, 1500.0, 1000.0
    measures = bent(warp, lean=lean).parts[0].measures
    # u = (x - lean y) / a, v = y / b: w_xx = 0, w_xy = h / (a b), w_yy = -2 lean h / (a b).
    hessian = warp / (a * b) * np.array([[0.0, 1.0], [1.0, -2 * lean]])
    one, two = np.linalg.eigvalsh(hessian)
    factor = 70_000 * 8 / (2 * (1 - 0.04))
    expected = factor * max(abs(one + 0.2 * two), abs(two + 0.2 * one))
    assert measures.cold_MPa == pytest.approx(expected, rel=1e-2)


@pytest.mark.parametrize(
    ("name", "expected"),
    [("glass", 3.625), ("strengthened-glass", 14.04), ("toughened-glass", 34.875)],
)
def test_half_of_what_lasts_may_be_used(name, expected):
    """EN 16612: 0.29 x 45 / 1.8, and what tempering adds over 1.2."""
    assert lasting_strength(name, 0.0) == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize(
    ("warp", "made_of", "thickness", "passes"),
    [
        (3.0, TOUGHENED, 8.0, True),
        (3.0, material("glass:6/16/44.2"), 30.76, True),
        (40.0, material("glass:6/16/44.2"), 30.76, False),
        (150.0, TOUGHENED, 8.0, False),
    ],
)
def test_the_verdict_says_how_much_of_it_is_used(warp, made_of, thickness, passes):
    structure = bent(warp, made_of, thickness)
    (verdict,) = structure.verdicts
    if passes:
        assert verdict == "ok"
        flat = build(warped(warp), [Panels(thickness, 8)], material=made_of)
        assert "gap" in flat.verdicts[0]
    else:
        use = structure.parts[0].measures.bend_use_percent
        assert f"is {use:.0f} % of what {made_of.name} may be bent to cold" in verdict


def test_each_pane_bends_by_itself_and_the_thickest_is_stressed_most():
    unit = bent(10.0, material("glass:6/16/44.2"), 30.76).parts[0].measures
    single = bent(10.0, material("glass"), 6.0).parts[0].measures
    assert unit.cold_MPa == pytest.approx(single.cold_MPa)


def test_bent_solids_are_closed_and_go_through_the_corners():
    structure = bent(30.0)
    (part,) = structure.parts
    solid = part.solid()
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
    assert sum(face.geomType() != "PLANE" for face in solid.Faces()) == 2
    # Of the lower side half of the thickness below the net, less half a gap on each side.
    x, y, z = part.points[:4].T
    inside = 30.0 * x * y / (1500 * 1000) - z
    assert np.abs(inside - 4.0).max() < 0.02


def test_the_pattern_is_the_flat_plate_that_is_bent():
    corners = np.array([[0, 0, 0], [900, 0, 0], [1000, 700, 25.0], [-50, 650, 0]], dtype=float)
    flat = unbent(corners)
    sides = [np.linalg.norm(np.roll(some, -1, axis=0) - some, axis=1) for some in (corners, flat)]
    assert sides[1] == pytest.approx(sides[0], rel=1e-12)
    missed = [
        np.linalg.norm(flat[k + 2] - flat[k]) - np.linalg.norm(corners[k + 2] - corners[k])
        for k in (0, 1)
    ]
    assert max(map(abs, missed)) < 0.4
    (part,) = bent(30.0).parts
    lower = part.body.corners[:4]
    expected = np.linalg.norm(np.roll(lower, -1, axis=0) - lower, axis=1)
    outline = part.pattern.outline
    got = np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1)
    assert got == pytest.approx(expected, rel=1e-12)
    assert outline.min(axis=0) == pytest.approx(0.0)


def test_bent_panels_lie_on_their_beams_without_a_clash(twisted, tmp_path):
    systems = [Beams(200, 60), Panels(8, 8, bending="cold")]
    made = {"beams": material(), "panels": TOUGHENED}
    structure = build(twisted, systems, material=made)
    clashes = check_clashes(structure.parts).clashes
    assert not [one for one in clashes if "P" in (one.first + one.second)]
    write(structure.only("panels"), tmp_path)
    with (tmp_path / "cold-bending.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == len(structure.results["panels"].parts)
    for row in rows:
        use, warp, allowed = (float(row[name]) for name in ("use_percent", "warp_mm", "allowed_mm"))
        assert warp / allowed == pytest.approx(use / 100, rel=1e-2)
    report = structure.report()["panels"]["cold_bending"]
    assert report["use_max_percent"] == pytest.approx(
        max(float(row["use_percent"]) for row in rows), rel=1e-2
    )


def test_the_force_at_a_corner_is_that_of_a_twisted_plate():
    """F = 2 D (1 - nu) h / (a b)."""
    structure = bent(20.0)
    (table,) = structure.results["panels"].tables
    stiffness = 70_000 * 8**3 / (12 * (1 - 0.04))
    expected = 2 * stiffness * 0.8 * 20 / (1500 * 1000)
    assert float(table.rows[0][-1]) == pytest.approx(expected, rel=2e-3)


def test_pressure_plates_lie_above_bent_panels():
    x, y = np.meshgrid(np.linspace(-3, 3, 4), np.linspace(-3, 3, 4), indexing="ij")
    net = grid(y, x, 0.01 * x * y).scaled(1000.0)
    systems = [Beams(200, 60), Panels(8, 8, bending="cold", frame="plate")]
    structure = build(net, systems, material={"beams": material(), "panels": TOUGHENED})
    assert check_clashes(structure.parts).clashes == ()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"edge": "bevel"}, "bevelled panels cannot be bent cold"),
        ({"frame": "silicone"}, "bent cold pull at structural silicone"),
        ({"bending": "hot"}, "bending: expected none or cold, got 'hot'"),
    ],
)
def test_what_cannot_be_bent_is_refused(options, words):
    with pytest.raises(InputError, match=words):
        Panels(8, 8, **{"bending": "cold", **options})


def test_the_manual_has_the_warp_that_is_allowed():
    text = (ROOT / "docs" / "fabrication.md").read_text(encoding="utf-8")
    part = text.split("## Cold-bent panels")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `(\S+)` \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|$", part, re.MULTILINE)
    assert len(rows) == 5
    for name, *allowed in rows:
        made = material(name)
        for size, shown in zip((1000.0, 1500.0, 2000.0), allowed, strict=True):
            net = warped(1.0, size, size)
            _, use = ColdBent.of(Planes.of(net), net).use(made, made.thickness)
            assert shown == f"{1 / use[0]:.1f}"
