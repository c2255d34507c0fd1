"""Lists of nodes and stock, families, clashes and the readable report."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.clash import ClashCheck, check_clashes
from freecad_ortho.fabrication.groups import groups_of
from freecad_ortho.fabrication.nodes import nodes
from freecad_ortho.fabrication.part import some_names
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.report import report_page
from freecad_ortho.fabrication.stock import different_tubes, stock_list
from freecad_ortho.fabrication.systems import Nodes
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh


def table(path):
    with path.open(newline="") as stream:
        return list(csv.DictReader(stream))


def test_nodes_of_a_plane_grid(plane):
    structure = build(plane, [Beams(200, 12), Panels(20, 15)])
    found = nodes(structure.site, structure.parts)
    assert [node.vertex for node in found] == list(range(20))
    for node in found:
        edges = (plane.connectivity.edges == node.vertex).any(axis=1).sum()
        assert len(node.neighbours) == len(node.angles_deg) == edges
        assert sum(node.angles_deg) == pytest.approx(360)
        assert np.allclose(np.mod(node.angles_deg, 90), 0, atol=1e-6)
        assert np.allclose(node.slopes_deg, 0, atol=1e-9)
        assert np.allclose(node.point, plane.vertices[node.vertex])
        assert np.allclose(node.axis, [0, 0, 1])
        expected = [part.name for part in structure.parts if node.vertex in part.vertices]
        assert list(node.parts) == expected
    inside = next(node for node in found if node.vertex == 5)
    assert inside.neighbours == (1, 4, 9, 6)
    assert groups_of(structure.parts, found).report()["nodes"]["different"] == 3


def test_angles_of_nodes_are_those_between_the_edges(roof):
    structure = build(roof, [Beams(200, 12)])
    for node in nodes(structure.site, structure.parts)[::7]:
        arms = roof.vertices[list(node.neighbours)] - roof.vertices[node.vertex]
        arms /= np.linalg.norm(arms, axis=1)[:, None]
        assert np.degrees(np.arcsin(arms @ node.axis)) == pytest.approx(node.slopes_deg)
        flat = arms - np.outer(arms @ node.axis, node.axis)
        flat /= np.linalg.norm(flat, axis=1)[:, None]
        cosines = (flat * np.roll(flat, -1, axis=0)).sum(axis=1)
        assert np.cos(np.radians(node.angles_deg)) == pytest.approx(cosines, abs=1e-9)


def test_families_of_a_plane_grid(plane):
    structure = build(plane, [Beams(200, 12), Panels(20, 15)])
    equal = groups_of(structure.parts, nodes(structure.site, structure.parts))
    assert [len(group) for group in equal.lengths["beam"]] == [31]
    assert [len(group) for group in equal.shapes["panel"]] == [12]
    # Beams inside, and those of the rim that are mitred on their left or on their right alone.
    firsts = {equal.equal_to[part.name] for part in structure.parts}
    assert firsts == {"B0000", "B0001", "B0003", "P0000"}


def test_no_member_of_a_family_is_beyond_the_tolerance(roof):
    structure = build(roof, [Beams(200, 12), Panels(20, 15)])
    parts = {part.name: part for part in structure.parts}
    equal = groups_of(structure.parts, nodes(structure.site, structure.parts))
    for groups in equal.lengths.values():
        assert sorted(name for group in groups for name in group) == sorted(
            name for name in parts if name[0] == groups[0][0][0]
        )
        for group in groups:
            assert all(abs(parts[n].length - parts[group[0]].length) <= 0.5 for n in group)
    # A surface of revolution: in each of six rows all panels are alike but those at both ends.
    assert len(equal.shapes["panel"]) == 12


def test_stock_holds_every_beam_once_and_what_sawing_takes(roof):
    parts = build(roof, [Beams(200, 12), Panels(20, 15)]).parts
    shop = Workshop(stock=4000, saw=5, trim=12, rest=300)
    stock = stock_list(parts, shop)
    beams = {part.name: part.length for part in parts if part.kind == "beam"}
    assert sorted(name for bar in stock.bars for name in bar.parts) == sorted(beams)
    assert stock.too_long == ()
    for bar in stock.bars:
        cut = sum(beams[name] for name in bar.parts)
        assert bar.cut == pytest.approx(cut)
        # Both ends are trimmed, and the last part too is cut from what is left.
        assert bar.used == pytest.approx(cut + 5 * len(bar.parts) + 2 * 12)
        assert bar.used <= bar.length == 4000
        assert bar.usable == (bar.left >= 300)
        assert bar.left == pytest.approx(4000 - bar.used)
    # First fit decreasing needs at most 11/9 of the best there is, which the sum bounds.
    lengths = sum(beams.values()) + 5 * len(beams)
    assert len(stock.bars) <= 11 / 9 * (lengths / (4000 - 24)) + 1
    assert stock_list(parts, Workshop()).bars[0].length == 6000


def test_waste_is_what_is_neither_cut_nor_kept():
    square = QuadMesh(
        1000.0 * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), [[0, 1, 2, 3]]
    )
    made = build(square, [Beams(200, 12)])
    cut = sum(part.length for part in made.parts)
    for least, kept in ((300, 4 * (1600 - 5 - 2 * 12) - cut), (900, 0.0)):
        shop = Workshop(stock=1600, saw=5, trim=12, rest=least)
        report = produce(made, shop).report()["stock"]
        assert (report["bars"], report["length_mm"]) == (4, 1600)
        assert (report["saw_mm"], report["trim_mm"]) == (5, 12)
        (section,) = report["sections"]
        assert (section["parts"], section["thickness_mm"]) == (4, 12)
        assert section["width_min_mm"] == pytest.approx(section["width_max_mm"])
        assert report["rests_kept_mm"] == pytest.approx(kept)
        assert report["waste"] == pytest.approx(1 - (cut + kept) / 6400)
    assert produce(build(square, [Panels(20, 15)])).report()["stock"]["waste"] is None


def test_a_bar_as_long_as_its_part_alone_is_too_short(roof):
    part = build(roof, [Beams(200, 12)]).parts[0]
    needed = part.length + 2 * 10 + 3
    assert len(stock_list([part], Workshop(stock=needed)).bars) == 1
    with pytest.raises(InputError, match=rf"stock: 1 part does not fit .*: {part.name}; take"):
        stock_list([part], Workshop(stock=needed - 0.1))
    assert len(stock_list([part], Workshop(stock=part.length, trim=0, saw=0)).bars) == 1
    # Without a length said, bars are long enough for what sawing takes.
    long = replace(part, length=5990.0)
    assert stock_list([long], Workshop()).bars[0].length == 7000


def test_tubes_within_the_tolerance_of_rolling_are_one_section(roof, tmp_path):
    structure = build(roof, [Beams(200, 12, section="hollow", section_width=80)])
    heights = {part.name: part.width for part in structure.parts}
    spread = max(heights.values()) / min(heights.values())
    assert len({round(height, 1) for height in heights.values()}) > 5 and spread < 1.04
    assert len(different_tubes(structure.parts, 2.0)) == 1
    write(structure, tmp_path, workshop=Workshop(section_tolerance=2.0))
    bars = table(tmp_path / "stock.csv")
    assert sorted(name for bar in bars for name in bar["parts"].split()) == sorted(heights)
    (section,) = {bar["section"] for bar in bars}
    middle = (max(heights.values()) + min(heights.values())) / 2
    assert section == f"tube {middle:.0f} x 80 x 12"
    for bar in bars:
        on_it = [heights[name] for name in bar["parts"].split()]
        assert float(bar["width_mm"]) == pytest.approx(max(on_it), abs=1e-6)
        assert float(bar["width_min_mm"]) == pytest.approx(min(on_it), abs=1e-6)
        assert bar["rest"] == ("kept" if float(bar["left_mm"]) >= 500 else "scrap")
    (entry,) = json.loads((tmp_path / "report.json").read_text())["stock"]["sections"]
    assert (entry["section"], entry["bars"], entry["parts"]) == (section, len(bars), len(heights))
    page = (tmp_path / "report.html").read_text()
    assert page.count(f"<td>{section}</td>") == 1
    assert f"<td>{min(heights.values()):.1f} to {max(heights.values()):.1f}</td>" in page


def test_tubes_beyond_the_tolerance_share_no_bar(roof):
    structure = build(roof, [Beams(200, 12, section="hollow", section_width=80)])
    heights = {part.name: part.width for part in structure.parts}
    bars = stock_list(structure.parts, Workshop(section_tolerance=0.1)).bars
    assert sorted(name for bar in bars for name in bar.parts) == sorted(heights)
    for bar in bars:
        on_it = [heights[name] for name in bar.parts]
        assert bar.widths == (min(on_it), max(on_it))
        assert max(on_it) <= min(on_it) * 1.001 / 0.999
    tubes = different_tubes(structure.parts, 0.1)
    assert len(tubes) > 1 and sum(map(len, tubes)) == len(heights)
    plates = build(roof, [Beams(200, 12)])
    assert len(stock_list(plates.parts, Workshop()).bars) < len(bars)
    assert plates.report()["messages"] == []


def test_a_part_is_cut_from_a_sheet_or_from_a_bar(roof, tmp_path):
    """Plates lie on sheets where they fit, on bars where they do not; tubes are sawn from bars."""
    structure = build(roof, [Beams(200, 12), Panels(20, 15)])
    write(structure, tmp_path, workshop=Workshop(sheet=(3000, 1500)))
    rows = table(tmp_path / "parts.csv")
    assert table(tmp_path / "stock.csv") == []
    assert all(row["cut_from"].startswith("sheet-") for row in rows)
    lengths = sorted(float(row["length_mm"]) for row in rows if row["kind"] == "beam")
    middle = (lengths[0] + lengths[-1]) / 2
    beams = structure.only("beams")
    write(beams, tmp_path, workshop=Workshop(sheet=(middle + 20, 500)))
    rows = table(tmp_path / "parts.csv")
    sawn = {name for bar in table(tmp_path / "stock.csv") for name in bar["parts"].split()}
    assert sawn == {row["name"] for row in rows if float(row["length_mm"]) > middle}
    assert all(row["cut_from"][0] == ("S" if row["name"] in sawn else "s") for row in rows)
    (words,) = json.loads((tmp_path / "report.json").read_text())["messages"]
    assert words.startswith(f"sheet: {len(sawn)} parts too large for a sheet, sawn from bars inst")


def test_curved_patterns_are_on_no_bar_and_tell_the_height_of_the_beam(roof, tmp_path):
    structure = build(roof, [Beams(200, 12, ends="lapped")])
    write(structure, tmp_path)
    rows = table(tmp_path / "parts.csv")
    curved = {row["name"] for row in rows if float(row["width_mm"]) > 300}
    assert curved and all(190 < float(row["height_mm"]) < 210 for row in rows)
    bars = table(tmp_path / "stock.csv")
    assert {name for bar in bars for name in bar["parts"].split()} == {
        row["name"] for row in rows
    } - curved
    assert all(float(bar["width_mm"]) <= 315 for bar in bars)


def test_parts_longer_than_the_stock_are_all_named(roof):
    structure = build(roof, [Beams(200, 12)])
    names = ", ".join(part.name for part in structure.parts)
    count = len(structure.parts)
    with pytest.raises(
        InputError, match=rf"stock: {count} parts do not fit on 700 mm.*: {names}; "
    ):
        produce(structure, Workshop(stock=700))
    lengths = sorted(part.length for part in structure.parts)
    some = produce(structure, Workshop(stock=(lengths[0] + lengths[-1]) / 2 + 23))
    long = [part.name for part in some.stock.too_long]
    assert 0 < len(long) < count
    assert sorted(long + [n for bar in some.bars for n in bar.parts]) == names.split(", ")
    told = dict(zip((part.name for part in structure.parts), some.verdicts, strict=True))
    words = f"too long for bars of {some.workshop.stock:g} mm"
    assert [name for name, verdict in told.items() if verdict == words] == sorted(long)
    assert sum(verdict == "ok" for verdict in told.values()) == count - len(long)
    (words,) = some.messages
    assert f"{len(long)} parts do not fit" in words and f": {some_names(long, 10)}; take" in words
    assert some.report()["stock"]["too_long"] == long


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
def test_parts_that_touch_do_not_clash(meshes, name):
    parts = build(meshes[name], [Beams(200, 12), Panels(20, 15)]).parts
    check = check_clashes(parts)
    assert check.near > len(parts)
    assert not check.clashes


def test_twisted_beams_cut_into_each_other_a_little(twisted):
    """Their mitre planes are not one plane; what they share is well below a part's volume."""
    parts = {part.name: part for part in build(twisted, [Beams(200, 12)]).parts}
    clashes = check_clashes(list(parts.values())).clashes
    assert clashes
    for clash in clashes:
        assert set(parts[clash.first].vertices) & set(parts[clash.second].vertices)
        assert 1e-6 < clash.volume / parts[clash.first].volume < 1e-4


@pytest.mark.parametrize("scale, said", [(1.0, "369375.0"), (0.005, "less than 0.1")])
def test_clashes_are_found_with_their_volume(plane, scale, said):
    net, panels = plane.scaled(scale), Panels(20 * scale, 15 * scale)
    structure = build(net, [panels])
    parts = list(structure.parts)
    first = parts[0]
    parts[0] = replace(first, origin=first.origin + scale * np.array([40.0, 0.0, 5.0]))
    (clash,) = check_clashes(parts).clashes
    x = next(p for p in parts[1:] if abs(p.origin[0] - first.origin[0] - 1000 * scale) < scale)
    assert {clash.first, clash.second} == {first.name, x.name}
    assert clash.volume == pytest.approx((40 - 15) * 985 * 15 * scale**3, rel=1e-6)
    result = replace(structure.results["panels"], parts=tuple(parts))
    production = produce(replace(structure, results={"panels": result}))
    failed = production.report()["verdict"]["failed"]
    assert set(failed) == {first.name, x.name}
    assert f"cuts {first.name} by {said} mm3" in failed[x.name]


def test_pairs_of_parts_that_only_the_kernel_can_judge(plane, monkeypatch):
    """Of drilled parts half-spaces tell the most that they can share, the kernel what they do."""
    structure = build(plane, [Beams(200, 12, ends="hub"), Nodes("hub", bore=60)])
    hubs = list(structure.results["nodes"].parts)
    hubs[1] = replace(hubs[1], origin=hubs[0].origin + np.array([0.0, 0.0, 150.0]))
    (clash,) = (each for each in check_clashes(hubs).clashes if each.first == hubs[0].name)
    assert clash.volume == pytest.approx(hubs[0].volume / 4, rel=1e-9)

    class Failing(BRepAlgoAPI_Common):
        def IsDone(self):
            return False

    monkeypatch.setattr("OCP.BRepAlgoAPI.BRepAlgoAPI_Common", Failing)
    results = {"nodes": replace(structure.results["nodes"], parts=tuple(hubs))}
    production = produce(replace(structure, results=results))
    report = production.report()
    checked = report["clash_check"]
    assert checked["clashes"] == [] and len(checked["pairs_open"]) == checked["pairs_cut"] > 0
    one, other = checked["pairs_open"][0]
    assert f"may cut {other}, which the CAD kernel leaves open" in report["verdict"]["failed"][one]
    assert f"({one} and {other}" in report_page(production)


def test_a_far_part_meets_nobody(plane):
    parts = list(build(plane, [Panels(20, 15)]).parts)
    apart = [replace(p, origin=p.origin * 3) for p in parts]
    assert check_clashes(apart).near == 0
    assert check_clashes(parts[:1]).near == 0


def test_what_makes_a_large_file_slow_to_open_is_said(structure, monkeypatch):
    monkeypatch.setattr("freecad_ortho.fabrication.production.check_clashes", no_clashes)
    said = {}
    for many in (len(structure.parts), len(structure.parts) - 1):
        monkeypatch.setattr("freecad_ortho.fabrication.production._MANY", many)
        for given in ({}, {"step": "in-place"}, {"step_tolerance": 0.001}):
            messages = produce(structure, Workshop(**given)).messages
            said[(many, *given)] = [words for words in messages if words.startswith("step: ")]
    (words,) = said.pop((many,))
    assert f"{len(structure.parts)} parts" in words and "in-place" in words
    assert not any(said.values())


def no_clashes(parts, *_):
    return ClashCheck(0, 0, ())


def test_progress_rises_to_one_with_the_clash_check(structure, monkeypatch):
    def clashes(parts, executor, progress):
        for done in (0.2, 0.5, 1.0):
            progress(done)
        return ClashCheck(0, 0, (), ())

    monkeypatch.setattr("freecad_ortho.fabrication.production.check_clashes", clashes)
    heard = []
    produce(structure, Workshop(sheet=(3000, 2000)), progress=lambda *said: heard.append(said))
    fractions = [fraction for fraction, _ in heard]
    assert fractions[0] == 0.0 and fractions == sorted(fractions)
    clash = [fraction for fraction, words in heard if words == "clash check"]
    assert clash == pytest.approx([0.6, 0.68, 0.8, 1.0, 1.0])


def test_flanges_are_cut_from_strips_of_their_own_width(roof):
    """Of strips as wide as webs two thirds would be lost."""
    parts = build(roof, [Beams(200, 20, section="I", section_width=60)]).parts
    widths = {part.name: float(part.pattern.size[1]) for part in parts}
    bars = stock_list(parts, Workshop()).bars
    assert sorted(name for bar in bars for name in bar.parts) == sorted(widths)
    for bar in bars:
        ordered = float(bar.section.split()[1])
        assert all(ordered / 1.5 - 1 < widths[name] <= ordered for name in bar.parts)
    flanges = [bar for bar in bars if any("-web" not in name for name in bar.parts)]
    assert {bar.section for bar in flanges} == {"strip 60 x 20"}
