"""Lamellas: exact patterns, valid solids, slots that fit, files that read back."""

import csv
import dataclasses
import math

import cadquery
import ezdxf
import numpy as np
import pytest
import shapely
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

from freecad_ortho import api
from freecad_ortho.fabrication import Lamellas, Selection, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems.lamellas.ends import lengthened
from solver import optimise
from solver.errors import InputError
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import QuadMesh
from solver.unroll.strip import Strip
from tests.conftest import grid_faces, shared_mesh, surface_of_revolution
from tests.meshes import helicoid, scherk, unduloid


def net(mesh, name):
    outcome = optimise(mesh, name)
    assert outcome.report.status == "converged", outcome.report.message
    return outcome.mesh.scaled(2000.0)


@pytest.fixture(scope="module")
def minimal():
    """Asymptotic net on Scherk's surface, edges of about 0.3 m."""
    return net(scherk(), "asymptotic")


@pytest.fixture(scope="module")
def round_net():
    """CMC net on an unduloid, edges of about 0.3 m."""
    return net(unduloid(11, 11), "cmc")


def flat_grid(rows=4, columns=5, angle=90.0):
    """Level parallelograms with edges of 400 mm."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    turn = math.radians(angle)
    points = np.stack([i + j * math.cos(turn), j * math.sin(turn), 0.0 * i], axis=-1)
    return QuadMesh(400.0 * points.reshape(-1, 3), grid_faces(rows, columns))


def rounded():
    """Meridians and parallels of a barrel, edges of about 0.6 m: rulings square to the lines."""
    return surface_of_revolution().scaled(1000.0)


def shared_volume(one, other):
    common = BRepAlgoAPI_Common(one.wrapped, other.wrapped)
    assert common.IsDone()
    return cadquery.Shape.cast(common.Shape()).Volume()


def worst_clash(structure, count=40):
    parts, solids = structure.parts, structure.solids()
    low = np.array([part.points.min(axis=0) for part in parts])
    high = np.array([part.points.max(axis=0) for part in parts])
    meet = ((low[:, None] <= high[None] + 1) & (low[None] <= high[:, None] + 1)).all(axis=2)
    pairs = np.argwhere(np.triu(meet, 1))
    return max(
        shared_volume(solids[i], solids[j]) / min(parts[i].volume, parts[j].volume)
        for i, j in pairs[:: max(1, len(pairs) // count)]
    )


def check_solids(structure):
    for part, solid in zip(structure.parts, structure.solids(), strict=True):
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9), part.name
        assert len(solid.Solids()) == len(solid.Shells()) == 1


@pytest.mark.parametrize(
    ("material", "given", "clearance"),
    [
        ("steel", {}, 1.0),
        ("aluminium", {}, 0.5),
        ("GL24h", {}, 1.5),
        ("GL24h", {"clearance": 0.7}, 0.7),
    ],
)
def test_slots_have_the_clearance_of_their_material_unless_one_is_given(material, given, clearance):
    sizes = {"material": material, "unit": "mm", **given}
    slots = api.fabricate(flat_grid(), "lamellas", thickness=6, **sizes).report()["lamellas"]
    assert slots["slot_width_min_mm"] == pytest.approx(6 + clearance)
    for ends in ("lapped", "hub"):
        beams = api.fabricate(flat_grid(), "beams", ends=ends, **sizes).report()["beams"]
        assert beams["clearance_mm"] == (clearance if given or ends == "lapped" else 1.0)


def test_lamellas_of_a_minimal_surface_unroll_straight(minimal):
    structure = build(minimal, [Lamellas(40, 3)])
    assert structure.results["lamellas"].report["pattern"] == "straight"
    straight = [part for part in structure.parts if not part.curved]
    assert len(straight) >= 20
    assert all(part.measures.straightness_mm is not None for part in structure.parts)
    for part in structure.parts:
        if part.curved:
            assert part.measures.straightness_mm <= 1e-3 * part.length
        else:
            assert part.measures.straightness_mm <= 1e-9 * part.length
            axis = part.pattern.axis
            assert np.ptp(axis[:, 1]) <= 1e-9 * part.length
            assert part.measures.lean_deg <= 5.0
    check_solids(structure)


def test_lamellas_of_a_cmc_net_unroll_to_arcs_of_one_radius(round_net):
    structure = build(round_net, [Lamellas(40, 3)])
    report = structure.results["lamellas"].report
    assert report["pattern"] == "arc"
    arcs = [part for part in structure.parts if part.measures.radius_mm is not None]
    inner = [part for part in arcs if len(part.vertices) > 2]
    assert len(inner) >= 10
    for part in inner:
        assert part.measures.radius_mm == pytest.approx(report["radius_mm"], rel=1e-9)
        assert part.measures.radius_spread_mm <= 1e-6
    check_solids(structure)


def test_plane_faces_fold_back_and_are_as_large_as_their_pattern():
    structure = build(rounded(), [Lamellas(120, 8, strip="developable")])
    for lamella, part in zip(
        structure.results["lamellas"].geometry.lamellas, structure.parts, strict=True
    ):
        strip = lamella.ribbon.strip
        place = strip.refolded()
        assert np.abs(place[:, 0] - strip.points).max() <= 1e-8
        assert np.abs(place[:, 1] - strip.rulings).max() <= 1e-10
        assert part.volume == pytest.approx(part.area * part.thickness, rel=1e-6)
        assert part.measures.gap_mm <= 1e-9
    check_solids(structure)


@pytest.mark.parametrize(
    ("strip", "smooth"), [("developable", False), ("twisted", False), ("twisted", True)]
)
def test_crossing_lamellas_share_no_volume(strip, smooth):
    system = Lamellas(120, 8, strip=strip, smooth=smooth)
    structure = build(rounded(), [system], selection=Selection(lines=(0, 2, 3)))
    assert worst_clash(structure, 12) <= 1e-6


def test_a_slot_without_play_would_touch(minimal):
    tight = build(flat_grid(), [Lamellas(80, 6, clearance=0.002)], selection=Selection(lines=(1,)))
    solids = tight.solids()
    assert worst_clash(tight) <= 1e-6
    moved = solids[0].translate(cadquery.Vector(0.5, 0.5, 0.5))
    assert shared_volume(moved, solids[1]) > 1.0


@pytest.mark.parametrize("angle", [90.0, 60.0])
def test_slots_are_as_wide_as_the_angle_asks(angle):
    structure = build(flat_grid(angle=angle), [Lamellas(80, 6, clearance=1.5)])
    turn = math.radians(angle)
    wanted = 6 / math.sin(turn) + 6 / math.tan(turn) + 1.5
    report = structure.results["lamellas"].report
    assert report["slot_width_min_mm"] == pytest.approx(wanted, rel=1e-9)
    assert report["slot_width_max_mm"] == pytest.approx(wanted, rel=1e-9)
    depth = 40 + 0.75
    for part in structure.parts:
        slots = len(part.vertices)
        assert part.area == pytest.approx(part.length * 80 - slots * wanted * depth, rel=1e-9)
        assert part.volume == pytest.approx(part.area * 6, rel=1e-9)
    assert worst_clash(structure) == 0.0


@pytest.mark.parametrize(("width", "thickness"), [(80.0, 3.0), (150.0, 3.0)])
def test_slots_leave_room_where_the_plates_lean_from_each_other(width, thickness):
    """On a dome over a square grid the rulings of both families differ by up to six degrees."""
    x, y = np.meshgrid(np.arange(6.0), np.arange(6.0), indexing="ij")
    z = -((x - 2.5) ** 2 + (y - 2.5) ** 2) / 20
    points = 1000.0 * np.stack([x, y, z], axis=-1).reshape(-1, 3)
    mesh = QuadMesh(points, grid_faces(6, 6))
    structure = build(mesh, [Lamellas(width, thickness)])
    assert structure.report()["lamellas"]["slot_width_max_mm"] > 3 * thickness
    assert not check_clashes(structure.parts).clashes


def test_slots_of_one_family_open_above_those_of_the_other_below():
    structure = build(flat_grid(), [Lamellas(80, 6)])
    for part in structure.parts:
        heights = part.pattern.outline[:, 1]
        floors = heights[(heights > 30) & (heights < 50)]
        assert floors == pytest.approx(39.5 if part.family == "u" else 40.5)
        z = part.points[:, 2]
        assert z.max() - z.min() == pytest.approx(80)


@pytest.mark.parametrize("beyond", [(30.0, 10.0), (30.0, -50.0), (-50.0, 10.0)])
def test_each_end_reaches_as_far_beyond_as_it_shall(beyond):
    points = np.array([[0.0, 0, 0], [200, 0, 0], [200, 300, 0]])
    strip = lengthened(Strip(points, np.tile([0.0, 0, 1], (3, 1))), beyond, "L-U001")
    assert strip.points[0] == pytest.approx([-beyond[0], 0, 0])
    assert strip.points[-1] == pytest.approx([200, 300 + beyond[1], 0])
    assert len(strip.points) == 3 + sum(more > 0 for more in beyond)


def test_names_and_neighbours_are_on_the_pattern_and_depend_on_connectivity_only(minimal):
    structure = build(minimal, [Lamellas(40, 3)])
    moved = minimal.with_vertices(minimal.vertices + 5 * np.sin(minimal.vertices / 300))
    again = build(moved, [Lamellas(40, 3, pattern="free")])
    assert [part.name for part in again.parts] == [part.name for part in structure.parts]
    by_name = {part.name: part for part in structure.parts}
    part = by_name["L-U002"]
    assert (part.family, part.line) == ("u", 2)
    for other in (mark.text for mark in part.pattern.marks if mark.text):
        assert set(by_name[other].vertices) & set(part.vertices)
    crossed = [mark.text for mark in part.pattern.marks if mark.text]
    assert len(crossed) == len(set(crossed)) == len(part.vertices)


@pytest.mark.parametrize(("strip", "layers"), [("developable", 1), ("twisted", 1), ("twisted", 2)])
def test_names_and_ticks_lie_on_the_plate(strip, layers):
    settings = Lamellas(40.0, 3.0, 14.0, strip=strip, pattern="free", layers=layers)
    for part in build(rounded(), [settings]).parts:
        plate = shapely.Polygon(part.pattern.outline)
        for mark in part.pattern.marks:
            if not mark.text:
                assert plate.buffer(1e-6).covers(shapely.LineString(mark.points))
            else:
                half = mark.size * np.array([len(mark.text), 1.0]) / 2
                box = shapely.affinity.rotate(shapely.box(*-half, *half), mark.angle)
                assert plate.contains(shapely.affinity.translate(box, *mark.points[0]))


@pytest.mark.parametrize(("layers", "level"), [(1, 0.0), (2, 20.5)])
def test_names_and_ticks_stand_square_to_the_axis(layers, level):
    """Name: in a longest face, a quarter of the width above the middle of the plate."""
    settings = Lamellas(40.0, 3.0, strip="twisted", pattern="free", layers=layers)
    for part in build(rounded(), [settings]).parts:
        pattern, under = part.pattern, layers == 1 and part.family == "v"
        middle = -level if part.family == "v" else level
        steps = np.diff(pattern.axis, axis=0)
        lengths = np.linalg.norm(steps, axis=1)
        along = steps / lengths[:, None]
        away = pattern.label - (pattern.axis[1:] + pattern.axis[:-1]) / 2
        face = int(np.argmin(np.abs(np.einsum("fk,fk->f", away, along))))
        assert lengths[face] == pytest.approx(lengths.max())
        assert away[face] @ along[face] == pytest.approx(0, abs=1e-9)
        height = away[face] @ [-along[face, 1], along[face, 0]]
        assert height == pytest.approx(middle + (-10 if under else 10))
        if layers == 2:
            # From one edge to a tenth of the width before the middle.
            ticks = np.array([mark.points for mark in pattern.marks if not mark.text])
            far = np.linalg.norm(ticks[:, :, None] - pattern.axis, axis=3).min(axis=2)
            assert far == pytest.approx(np.tile(np.abs([middle - 20, middle - 4]), (len(far), 1)))


def test_files_read_back(minimal, tmp_path):
    structure = build(minimal, [Lamellas(40, 3)], selection=Selection(lines=(3, 7)))
    write(structure, tmp_path)
    shapes = read_step(tmp_path / "structure.step")
    assert [name for name, _ in shapes] == [part.name for part in structure.parts]
    for (_, shape), part in zip(shapes, structure.parts, strict=True):
        assert shape.isValid()
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-6)
    drawing = ezdxf.readfile(tmp_path / "flat.dxf")
    assert not drawing.audit().errors
    for part in structure.parts:
        block = drawing.blocks.get(part.name)
        outline = np.array(block.query('LWPOLYLINE[layer=="CUT"]')[0].get_points("xy"))
        assert polygon_area(outline) == pytest.approx(part.area, rel=1e-9)
        axis = np.array(block.query('LWPOLYLINE[layer=="AXIS"]')[0].get_points("xy"))
        assert np.ptp(axis[:, 1]) <= 1e-9 * part.length
        texts = {text.dxf.text for text in block.query('TEXT[layer=="ENGRAVE"]')}
        assert texts == {name for name in texts if name[:3] in ("L-U", "L-V")}
        assert [text.dxf.text for text in block.query('TEXT[layer=="LABEL"]')] == [part.name]
    with (tmp_path / "parts.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert {row["kind"] for row in rows} == {"lamella"}
    assert {row["line"] for row in rows} == {"3", "7"}


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"width": 5, "thickness": 6}, "not less than the width"),
        ({"clearance": 50}, "deeper than three quarters"),
        ({"position": "lying"}, "cannot cross in one layer"),
        ({"layers": 3}, "layers: expected a whole number, 1 to 2, got"),
        ({"position": "lying", "layers": 2, "hole": 40}, "a hole of at most 33.3 mm"),
        ({"strip": "developable", "smooth": True}, "take strip twisted"),
        ({"strip": "rigid"}, "expected auto, developable"),
        ({"overhang": -4}, "overhang: expected a number above 0"),
    ],
)
def test_settings_that_cannot_be_used_are_refused(settings, words):
    with pytest.raises(InputError, match=words):
        Lamellas(**{"width": 80, "thickness": 5, **settings})


def test_nets_that_are_not_fit_are_refused_with_what_to_do(minimal):
    bumpy = minimal.with_vertices(minimal.vertices + 90 * np.sin(minimal.vertices / 200))
    with pytest.raises(InputError, match=r"misses it by .* optimise for asymptotic"):
        build(bumpy, [Lamellas(40, 3, pattern="straight")])
    with pytest.raises(InputError, match=r"rulings of L-U00. meet .* mm would do"):
        build(minimal, [Lamellas(250, 3, strip="developable")])
    with pytest.raises(InputError, match="run into each other"):
        build(flat_grid(), [Lamellas(500, 410, overhang=900)])
    with pytest.raises(InputError, match=r"L-U000 and L-V000 cross at vertex 0 at .* 8 degrees"):
        build(flat_grid(angle=8), [Lamellas(80, 3)])
    with pytest.raises(InputError, match="runs out at the end"):
        build(minimal, [Lamellas(40, 3, overhang=1)])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "kind", "width"),
    [("knet1", "asymptotic", 60), ("helical-minimal", "asymptotic", 30), ("cmc1", "cmc", 50)],
)
def test_gridshells_of_the_paper(name, kind, width):
    outcome = optimise(shared_mesh(name), kind)
    structure = build(outcome.mesh.scaled(1000.0), [Lamellas(width, 4)])
    boundary = outcome.mesh.connectivity.boundary_vertices
    inner = [part for part in structure.parts if not boundary[list(part.vertices[1:2])].any()]
    assert len(inner) >= 32
    for part in inner:
        if kind == "asymptotic":
            assert part.measures.straightness_mm <= 1e-6 * part.length
        else:
            assert part.measures.radius_spread_mm <= 1e-6 * part.length
        assert part.measures.lean_deg <= 10
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes


@pytest.mark.parametrize("strip", ["auto", "twisted"])
def test_rulings_with_few_digits_do_not_make_lamellas_lean(strip):
    exact = helicoid().scaled(2000.0)
    rounded_off = exact.with_vertices(np.round(exact.vertices, 3))
    settings = Lamellas(60.0, 4.0, strip=strip)
    one, two = (build(mesh, [settings]).results["lamellas"] for mesh in (exact, rounded_off))
    assert two.report["pattern"] == "straight" and two.report["lean_max_deg"] < 0.5
    assert {lamella.pattern for lamella in two.geometry.lamellas} == {"straight"}
    torsion = one.report["torsion_max_deg_per_m"]
    assert two.report["torsion_max_deg_per_m"] == pytest.approx(torsion, rel=1e-3)
    for part in two.parts:
        if not part.curved:
            assert part.measures.straightness_mm <= 1e-4 * part.length


def test_a_pattern_that_only_a_lamella_on_edge_has_is_refused():
    mesh = surface_of_revolution(17, 15).scaled(1000.0)
    settings = Lamellas(40.0, 3.0, position="lying", layers=2, pattern="straight")
    with pytest.raises(InputError, match=r"L-\w\d+ would lean \d\d degrees .* take pattern free"):
        build(mesh, [settings])
    free = build(mesh, [dataclasses.replace(settings, pattern="free")]).results["lamellas"]
    assert free.report["lean_max_deg"] < 10


def test_a_lamella_along_a_single_edge_has_no_radius(tmp_path):
    mesh = net(shared_mesh("cmc1"), "cmc")
    lines = ParameterLines(mesh.connectivity)
    short = next(line for line in lines.all if len(line.vertices) == 2)
    long = max(lines.of_family(short.family), key=lambda line: len(line.vertices))
    chosen = Selection(short.family, (short.number, long.number))
    structure = build(mesh, [Lamellas(50, 5)], selection=chosen)
    radii = {len(part.vertices): part.measures.radius_mm for part in structure.parts}
    assert radii.pop(2) is None
    assert list(radii.values()) == [pytest.approx(structure.report()["lamellas"]["radius_mm"])]
    write(structure, tmp_path)
    assert "radius" in (tmp_path / "report.html").read_text(encoding="utf-8")


def test_a_helicoid_may_stand_in_two_layers():
    structure = build(
        net(helicoid(9, 7), "asymptotic"),
        [Lamellas(30, 3, layers=2)],
        selection=Selection(lines=(3,)),
    )
    check_solids(structure)


def test_bends_are_positive_where_the_sides_rise_to_the_side_that_is_seen():
    structure = build(rounded(), [Lamellas(120, 8, strip="developable")])
    for lamella, part in zip(
        structure.results["lamellas"].geometry.lamellas, structure.parts, strict=True
    ):
        along, (across, _) = lamella.ribbon.strip.along, lamella.ribbon.strip.across
        rises = np.einsum("fk,fk->f", along[1:], np.cross(along, across)[:-1])
        bent = np.abs(lamella.ribbon.strip.bends[1:-1]) > 1e-9
        signs = np.sign([bend.angle_deg for bend in part.pattern.bends])
        assert (signs == np.sign(rises[bent])).all()
    assert any(part.pattern.bends for part in structure.parts)
