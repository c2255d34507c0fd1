"""Frames of panels: pressure plates and caps, structural silicone, setting blocks."""

import csv
import re

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Panels, build, material, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.stock import stock_list
from freecad_ortho.fabrication.systems import Nodes
from freecad_ortho.fabrication.systems.panels.frame import PressureFrame
from freecad_ortho.fabrication.systems.panels.silicone import Silicone, strips
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from tests.fabrication.test_trimming import SLANTED
from tests.meshes import grid

UNIT = material("glass:6/16/44.2")
MATERIALS = {"beams": material(), "panels": UNIT, "nodes": material()}


def plane_net(rows=4, columns=3):
    """Squares of 1 m in a plane, seen from above."""
    x, y = np.meshgrid(np.arange(float(columns)), np.arange(float(rows)), indexing="ij")
    return grid(x, y, 0 * x).scaled(1000.0)


def framed(net, frame="plate", border=(), **options):
    systems = [Beams(200, 50), Panels(30.76, 8, frame=frame, **options)]
    return build(net, systems, material=MATERIALS, border=border)


def of_kind(structure, kind):
    return [part for part in structure.parts if part.kind == kind]


@pytest.mark.parametrize("edge", ["square", "bevel"])
@pytest.mark.parametrize("frame", ["plate", "silicone"])
def test_frames_do_not_clash_and_have_the_volume_of_their_formula(roof, frame, edge):
    structure = framed(roof, frame, edge=edge)
    loose = structure.results["panels"].loose()
    assert check_clashes((*structure.parts, *loose)).clashes == ()
    for part in loose[::23]:
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
    kinds = ("pressure-plate", "cap") if frame == "plate" else ("adapter",)
    for kind in kinds:
        for part in of_kind(structure, kind)[::11]:
            solid = part.solid()
            assert solid.isValid()
            assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
            assert part.material.name == "aluminium"
            assert part.body.points[:, 0].max() - part.body.points[:, 0].min() == part.length


def test_on_a_plane_net_everything_lies_where_the_rule_says():
    structure = framed(plane_net())
    panel, plate, cap = (of_kind(structure, kind) for kind in ("panel", "pressure-plate", "cap"))
    assert len(plate) == len(cap) == len(plane_net().connectivity.edges)
    # 50 mm less twice 15 mm between panels, on 5 mm of gasket on beams up to 100 mm.
    assert panel[0].pattern.size == pytest.approx([980.0, 980.0])
    assert panel[0].points[:, 2].min() == pytest.approx(105.0)
    assert plate[0].points[:, 2].min() == pytest.approx(105 + 30.76 + 5)
    assert cap[0].points[:, 2].min() == pytest.approx(105 + 30.76 + 5 + 6)
    # Four lines of 2 m and three of 3 m, less what overlaps where they cross, meet and turn.
    area = 50 * (4 * 2000 + 3 * 3000) - (2 * 50 * 50 + 6 * 25 * 50 + 4 * 25 * 25)
    assert sum(part.volume for part in plate) == pytest.approx(6 * area)
    # A channel 15 mm high with walls of 2 mm, before mitres.
    assert 0.97 < sum(part.volume for part in cap) / ((50 * 15 - 46 * 13) * 17000) <= 1
    # Across one cap: both legs from the base to the top, walls of 2 mm on both sides.
    profile = PressureFrame(50.0).cap
    assert profile.area == pytest.approx(50 * 15 - 46 * 13, rel=1e-12)
    assert (profile.width, profile.height) == pytest.approx((50, 15))


def test_gaskets_fill_what_is_between_panels_beams_and_plates_and_blocks_stand_beside_them():
    structure = framed(plane_net())
    loose = structure.results["panels"].loose()
    gaskets = [part for part in loose if part.kind == "gasket"]
    panels = of_kind(structure, "panel")
    assert len(gaskets) == 2 * 4 * len(panels)
    levels = {"below": (100.0, 105.0), "above": (105 + 30.76, 105 + 30.76 + 5)}
    for gasket in gaskets:
        heights = gasket.points[:, 2]
        assert (heights.min(), heights.max()) == pytest.approx(levels[gasket.name.split("-")[-1]])
    # Four strips a side, mitred: 12 of the 15 mm that plates cover, on panels of 980 mm.
    strips = 5 * (980**2 - 956**2)
    assert sum(part.volume for part in gaskets) == pytest.approx(2 * len(panels) * strips)
    blocks = [part for part in loose if part.kind == "setting-block"]
    assert len(blocks) == 2 * len(panels)
    for block in blocks:
        assert block.volume == pytest.approx(100 * 5 * 32.76)
        assert sorted(np.ptp(block.points, axis=0)) == pytest.approx([5, 32.76, 100])
        # In the joint, against the panel: from its side on for as much as the block is thick.
        inside = (block.points - block.points.mean(axis=0)) @ block.frame[1]
        edge = (block.points @ block.frame[1]).max()
        [panel] = [part for part in panels if block.name.startswith(f"{part.name}-")]
        assert np.ptp(inside) == pytest.approx(5)
        assert (panel.points @ block.frame[1]).min() == pytest.approx(edge)
    assert check_clashes((*structure.parts, *loose)).clashes == ()


def test_gaskets_end_with_the_beams_that_they_lie_on():
    """Beams end before hubs, and gaskets do not lie on these; above they run through."""
    sizes = Beams(200, 50, ends="hub", hub_diameter=160), Nodes(diameter=160)
    structure = build(plane_net(), [*sizes, Panels(30.76, 8, frame="plate")], material=MATERIALS)
    loose = structure.results["panels"].loose()
    assert check_clashes((*structure.parts, *loose)).clashes == ()
    longest = max(part.length for part in loose if part.name.endswith("below"))
    assert longest == pytest.approx(1000 - 2 * 81)


def test_gaskets_and_blocks_are_in_the_file_of_solids_where_these_are_asked_for(tmp_path):
    structure = framed(plane_net())
    loose = structure.results["panels"].loose()
    for hardware, wanted in (("list", []), ("solids", [part.name for part in loose])):
        write(structure, tmp_path, workshop=Workshop(hardware=hardware))
        names = [name for name, _ in read_step(tmp_path / "structure.step")]
        assert names == [part.name for part in structure.parts] + wanted
    text = (tmp_path / "structure.step").read_text().replace(" ", "")
    # Blocks are alike, and so are gaskets of one length: few products for many places.
    assert len(re.findall(r"=PRODUCT\('P\d+-block", text.replace("\n", ""))) == 1


def test_a_gap_beside_a_frame_is_said_not_to_count():
    systems = [Panels(8, gap, frame="plate") for gap in (8, 20, 12)]
    made = [build(plane_net(), [each]).report()["messages"] for each in systems]
    assert [len(messages) for messages in made[:2]] == [0, 0]
    assert "joints of 20 mm; the gap of 12 mm that was given does not count" in made[2][0]


@pytest.mark.parametrize("frame", ["plate", "silicone"])
def test_frames_end_at_the_border(frame):
    structure = framed(plane_net(8, 9), frame, border=[SLANTED], least_width=150)
    assert check_clashes(structure.parts).clashes == ()
    whole = framed(plane_net(8, 9), frame)
    kinds = {part.kind for part in structure.parts}
    for kind in kinds:
        volumes = [sum(p.volume for p in of_kind(one, kind)) for one in (structure, whole)]
        assert 0.3 * volumes[1] < volumes[0] < 0.9 * volumes[1], kind
        assert min(part.volume for part in of_kind(structure, kind)) > 0


def test_frames_go_together_with_hubs(roof):
    systems = [Beams(200, 50, ends="hub", hub_diameter=160), Nodes(diameter=160)]
    structure = build(roof, [*systems, Panels(30.76, 8, frame="plate")], material=MATERIALS)
    assert check_clashes(structure.parts).clashes == ()


def test_caps_are_coped_where_the_beams_are(roof):
    systems = [Beams(200, 50, ends="coped-u"), Panels(30.76, 8, frame="plate")]
    structure = build(roof, systems, material=MATERIALS)
    assert check_clashes(structure.parts).clashes == ()
    caps = of_kind(structure, "cap")
    lengths = {family: [cap.length for cap in caps if cap.family == family] for family in "uv"}
    mitred = {
        family: [cap.length for cap in of_kind(framed(roof), "cap") if cap.family == family]
        for family in "uv"
    }
    # Those that run through lose nothing, the others their width at the least.
    assert sum(lengths["u"]) >= sum(mitred["u"]) - 1e-6
    assert np.all(np.array(mitred["v"]) - lengths["v"] > 25)


def test_plates_and_caps_are_sawn_from_bars_and_listed(roof, tmp_path):
    structure = framed(roof, frame_width=50.0)
    plates = of_kind(structure, "pressure-plate")
    bars = stock_list(structure.parts, Workshop()).bars
    sections = {bar.section for bar in bars}
    assert {"pressure plate 50x6", "cap 50x15x2"} <= sections
    assert re.fullmatch(
        r"pressure plate 50x6; start: elevation \S+, plan right \S+ left \S+ deg; end: .*",
        plates[0].note,
    )
    write(structure, tmp_path)
    with (tmp_path / "frames.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["plate"] for row in rows] == [part.name for part in plates]
    assert [float(row["length_mm"]) for row in rows] == pytest.approx(
        [part.length for part in plates], abs=1e-5
    )
    # Folded joints open the gaskets outwards: least under the plate, most at one of its edges.
    assert {row["gasket_least_mm"] for row in rows} == {"5.000"}
    assert max(float(row["gasket_most_mm"]) for row in rows) == pytest.approx(
        structure.report()["panels"]["frame"]["gasket_max_mm"], abs=1e-3
    )


def test_plates_that_cover_too_little_do_not_pass(roof):
    structure = framed(roof, edge_cover=8.0)
    pairs = zip(structure.parts, structure.verdicts, strict=True)
    failed = {part.kind: words for part, words in pairs if words != "ok"}
    assert "glass:6/16/44.2 needs 10 mm" in failed["pressure-plate"]
    assert any("pressure plates cover them by" in words for words in structure.report()["messages"])


def test_plates_are_wider_where_glass_is_not_covered_enough():
    """Over a ridge of 24 degrees square edges lean away below the plate; the joint stays."""
    x, y = np.meshgrid(np.arange(3.0), np.arange(3.0), indexing="ij")
    net = grid(x, y, -np.tan(np.radians(12)) * np.abs(x - 1)).scaled(1000.0)
    wide = framed(net)
    given = framed(net, frame_width=50.0)
    least = [one.report()["panels"]["frame"]["cover_min_mm"] for one in (given, wide)]
    added = 5 * np.ceil((10 - least[0]) / 5)
    assert least[0] < 10 <= least[1] == pytest.approx(least[0] + added)
    assert {part.section_width for part in of_kind(wide, "cap")} == {50 + 2 * added}
    areas = [sum(part.area for part in of_kind(one, "panel")) for one in (given, wide)]
    assert areas[0] == areas[1]
    assert check_clashes(wide.parts).clashes == ()
    said = [" ".join(one.report()["messages"]) for one in (given, wide)]
    assert f"take a frame width of {50 + 2 * added:g} mm with an edge cover of" in said[0]
    assert f"caps are {50 + 2 * added:g} mm wide and cover {15 + added:g} mm" in said[1]
    assert not any("covers panels" in words for words in wide.verdicts)


def test_setting_blocks_stand_below_and_carry_the_panel():
    """A plane net that stands at 30 degrees to the upright, rising along y."""
    x, y = np.meshgrid(np.arange(3.0), np.arange(4.0), indexing="ij")
    slope = np.radians(60)
    net = grid(x, np.cos(slope) * y, np.sin(slope) * y).scaled(1000.0)
    structure = framed(net)
    table = next(t for t in structure.results["panels"].tables if t.name == "setting-blocks.csv")
    panels = {part.name: part for part in of_kind(structure, "panel")}
    assert len(table.rows) == 2 * len(panels)
    for row in table.rows:
        values = dict(zip(table.columns, row, strict=True))
        panel = panels[values["panel"]]
        place = np.array([float(values["x_mm"]), float(values["y_mm"]), 0.0])
        low = panel.points[:, 2].min()
        assert (panel.origin + place @ panel.frame)[2] == pytest.approx(low, abs=1e-2)
        load = panel.mass * 9.81 * np.sin(slope) / 2
        assert float(values["load_N"]) == pytest.approx(load, abs=0.1)
    first = sorted(float(row[2]) for row in table.rows if row[0] == "P0000")
    along = sorted({*first, *(float(row[3]) for row in table.rows if row[0] == "P0000")})
    assert {150.0, 830.0} <= set(along)


def test_the_bite_says_what_wind_it_bears():
    """2 sigma bite / a: 0.14 MPa, 12 mm and 1 m give 3.36 kN/m2."""
    structure = framed(plane_net(), "silicone")
    panel = of_kind(structure, "panel")[0]
    assert Silicone(12.0).wind(panel) == pytest.approx(3.36 * 1000 / 992)
    # Panels are 6 mm of silicone and 20 mm of adapter above beams up to 100 mm.
    assert panel.points[:, 2].min() == pytest.approx(126.0)
    adapters = [part for part in of_kind(structure, "adapter") if part.name.startswith("P0000-")]
    assert sum(part.volume for part in adapters) == pytest.approx(20 * (992**2 - 952**2))
    assert [part.note.count("45.00") for part in adapters] == [2] * 4


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"frame": "clips"}, "frame: expected none, plate or silicone, got 'clips'"),
        ({"frame": "plate", "edge_cover": 25.0}, "edge cover: 25 mm on both sides leave no joint"),
        ({"frame": "silicone", "bite": 4.0}, "bite: expected 6 to 18 mm"),
    ],
)
def test_frames_that_cannot_be_are_refused(options, words):
    with pytest.raises(InputError, match=words):
        Panels(12, 8, **options)


def test_a_frame_too_wide_for_an_edge_names_it():
    with pytest.raises(InputError, match=r"frame width: 1000 mm does not fit edge \d+ .* at most"):
        framed(plane_net(), frame_width=1000.0, edge_cover=490.0)


@pytest.mark.parametrize(
    ("outline", "count"),
    [
        ([[0, 0], [600, 0], [600, 300], [0, 25]], 3),
        ([[0, 0], [900, -10], [900, 500], [0, 22]], 3),
        ([[0, 0], [600, 0], [600, 160]], 3),
        ([[0, 0], [600, 0], [600, 400], [0, 400]], 4),
    ],
)
def test_adapters_on_both_sides_of_a_short_side_do_not_run_into_each_other(outline, count):
    plate = shapely.Polygon(outline)
    made = [shapely.Polygon(ring) for ring in strips(np.array(outline, float), 20.0)]
    assert len(made) == count
    for number, one in enumerate(made):
        assert one.difference(plate).area <= 1e-6
        assert (
            max(one.intersection(other).area for other in [*made[:number], shapely.Point()]) <= 1e-6
        )
        assert one.area > 20.0 * 40.0
