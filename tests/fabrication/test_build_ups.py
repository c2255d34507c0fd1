"""Build-ups of glass: how they are written, what they weigh, panels whose layers stand back."""

import csv
import re

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build, material, write
from freecad_ortho.fabrication.clash import check_clashes
from solver.errors import InputError
from tests.conftest import ROOT
from tests.fabrication.test_trimming import SLANTED, circle
from tests.meshes import grid

STEPPED = "glass:8/16/44.2@20"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("glass:8", [("glass", 8.0, 0.0)]),
        ("glass:8+1.52+8", [("glass", 8.0, 0.0), ("PVB", 1.52, 0.0), ("glass", 8.0, 0.0)]),
        ("glass:44.2", [("glass", 4.0, 0.0), ("PVB", 0.76, 0.0), ("glass", 4.0, 0.0)]),
        ("glass:1012.4", [("glass", 10.0, 0.0), ("PVB", 1.52, 0.0), ("glass", 12.0, 0.0)]),
        (
            "Toughened-Glass: 8 / 16ar / 66.2s@25",
            [
                ("toughened-glass", 8.0, 0.0),
                ("argon", 16.0, 25.0),
                ("strengthened-glass", 6.0, 25.0),
                ("PVB", 0.76, 25.0),
                ("strengthened-glass", 6.0, 25.0),
            ],
        ),
        (
            "glass:10+1.52sg+8t@15",
            [("glass", 10.0, 0.0), ("ionoplast", 1.52, 15.0), ("toughened-glass", 8.0, 15.0)],
        ),
    ],
)
def test_build_ups_are_read_as_the_trade_writes_them(text, expected):
    assert [(each.of, each.thickness, each.step) for each in material(text).layers] == expected


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("glass:", "has a layer ''"),
        ("glass:8+1.52", "ends a pane with an interlayer"),
        ("glass:6/16", "ends with a cavity"),
        ("glass:66.38", "a pane of 66.38 mm, float glass is 2 to 25 mm"),
        ("glass:44.0", "has no film in 44.0"),
        ("glass:8q", "has 'q' in 8q, where s, t may be"),
        ("glass:8@5", "every layer set back"),
        ("glass:6/16@4/6", "sets 16@4 back"),
        ("glass:6/0/6", "a layer of 0 mm"),
        ("glas:6/16/6", "expected steel, .* or a build-up such as glass:8"),
    ],
)
def test_what_is_no_build_up_is_refused_in_one_line(text, words):
    with pytest.raises(InputError, match=words) as refused:
        material(text)
    assert "\n" not in str(refused.value)


def test_layers_have_densities_and_the_weakest_pane_counts():
    unit = material("glass:8t/16/44.2")
    # 8 + 4 + 4 mm of glass, 0.76 mm of polyvinyl butyral of 1070 kg/m3.
    assert unit.mass(1e6 * unit.thickness) == pytest.approx(2.5 * 16 + 1.07 * 0.76)
    assert unit.bending_limit == material("glass").bending_limit
    # Interlayers creep: the thickest pane alone bends.
    assert unit.bending_stress(unit.thickness, 5000.0) == material("glass").bending_stress(
        8.0, 5000.0
    )


def prism_volume(part, step, low, high):
    """Of a layer, from the pattern: the polygon set back by formula."""
    import shapely

    outline = shapely.Polygon(part.pattern.outline)
    return outline.buffer(-step, join_style="mitre", mitre_limit=50).area * (high - low)


@pytest.mark.parametrize(
    "panels", [Panels(32.76, 15), Panels(32.76, 15, edge="bevel")], ids=["square", "bevel"]
)
def test_a_layer_stands_back_all_around(roof, panels):
    structure = build(roof, [panels], material=material(STEPPED))
    assert not check_clashes(structure.parts).clashes
    for part in structure.parts[::9]:
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        if panels.edge == "square":
            # Inside, from below: 8.76 mm laminated and 16 mm of cavity set back, 8 mm whole.
            expected = prism_volume(part, 20, 0, 24.76) + prism_volume(part, 0, 24.76, 32.76)
            assert part.volume == pytest.approx(expected, rel=1e-9)
            heavy = 2500e-9 * prism_volume(part, 0, 0, 8) + prism_volume(part, 20, 0, 1) * (
                8 * 2500e-9 + 0.76 * 1070e-9
            )
            assert part.mass == pytest.approx(heavy, rel=1e-9)


def test_several_steps_and_pieces_at_a_border():
    x, y = np.meshgrid(np.arange(8.0), np.arange(9.0))
    net = grid(x, y, 0 * x).scaled(1000.0)
    build_up = material("glass:6@10+1.52+6+0.76+6@30")
    structure = build(
        net,
        [Panels(20.28, 15, least_width=200, slivers="leave-out")],
        material=build_up,
        border=[SLANTED, circle(3450, 3520, 300)],
    )
    assert structure.results["panels"].report["trimmed"]
    for part in structure.parts:
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
    whole = structure.parts[0]
    assert whole.volume == pytest.approx(
        sum(
            prism_volume(whole, step, 0, thick) for step, thick in ((30, 6.76), (0, 6), (10, 7.52))
        ),
        rel=1e-9,
    )


def test_a_step_that_leaves_nothing_is_refused_with_the_panel(roof):
    with pytest.raises(InputError, match=r"set back by 700 mm leave nothing of a side of P00"):
        build(roof, [Panels(28, 15)], material=material("glass:6/16/6@700"))


def test_a_lower_layer_that_stands_back_takes_from_the_bearing(roof):
    made = [
        build(
            roof, [Beams(200, 60), Panels(28, 15)], material={"beams": material(), "panels": unit}
        )
        for unit in map(material, ("glass:6/16/6", "glass:6/16/6@10", "glass:6@10/16/6"))
    ]
    whole, lower, upper = (each.results["panels"].report["bearing_min_mm"] for each in made)
    assert lower == pytest.approx(whole - 10)
    assert upper == pytest.approx(whole)


def test_lists_have_every_layer_and_its_size(roof, tmp_path):
    structure = build(roof, [Panels(32.76, 15)], material=material(STEPPED))
    write(structure, tmp_path)
    with (tmp_path / "layers.csv").open(newline="") as stream:
        rows = [row for row in csv.DictReader(stream) if row["part"] == "P0004"]
    assert [row["of"] for row in rows] == ["glass", "cavity", "glass", "PVB", "glass"]
    assert [row["step_mm"] for row in rows] == ["0", "20", "20", "20", "20"]
    part = next(part for part in structure.parts if part.name == "P0004")
    assert sum(float(row["mass_kg"]) for row in rows) == pytest.approx(part.mass, abs=1e-5)
    assert float(rows[0]["length_mm"]) == pytest.approx(part.length, abs=1e-5)
    assert float(rows[1]["width_mm"]) < part.width - 39
    report = structure.report()["panels"]["build_up"]
    assert report["weight_kg_m2"] == pytest.approx(2.5 * 16 + 1.07 * 0.76)
    assert report["thickness_mm"] == pytest.approx(32.76)


def test_the_manual_has_their_weights():
    text = (ROOT / "docs" / "fabrication.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(glass:\S+)` \| ([\d.]+) \| ([\d.]+) \|$", text, re.MULTILINE)
    assert len(rows) >= 6
    for name, thickness, weight in rows:
        made = material(name)
        assert float(thickness) == made.thickness
        assert weight == f"{sum(layer.weight for layer in made.layers):.1f}"
