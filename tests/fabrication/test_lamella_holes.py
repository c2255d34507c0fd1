"""Lamellas that are slotted, drilled and spliced: closed from corner points, read back, quick."""

import time
from dataclasses import replace

import cadquery
import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from scipy.spatial import ConvexHull

from freecad_ortho.fabrication import Lamellas, Selection, build
from freecad_ortho.fabrication.bezier import bernstein, raised, through
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.step import read_step, write_step
from tests.fabrication.test_lamellas import check_solids, rounded
from tests.meshes import helicoid

KINDS = {
    "bent, drilled on the bends": {"strip": "developable", "position": "lying", "layers": 2},
    "twisted, slotted, spliced": {"strip": "twisted", "stock": 3000.0},
    "smooth, slotted": {"smooth": True},
    "twisted, drilled, spliced": {
        "strip": "twisted",
        "position": "lying",
        "layers": 2,
        "stock": 3000.0,
    },
    "smooth, drilled": {"smooth": True, "position": "lying", "layers": 2},
}


@pytest.fixture(scope="module", params=KINDS.values(), ids=KINDS)
def some(request):
    selection = Selection(lines=(2, 3))
    return build(rounded(), [Lamellas(60, 4, **request.param)], selection=selection)


def test_solids_are_valid_and_read_back(some, tmp_path):
    check_solids(some)
    path = tmp_path / "some.step"
    write_step(path, some.parts)
    for (name, shape), part in zip(read_step(path), some.parts, strict=True):
        assert shape.isValid(), name
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-7), name


def test_a_bolt_passes_every_hole(some):
    for part in [part for part in some.parts if part.pattern.holes][::3]:
        plate = part.body.solid()
        for drill in part.body.drills:
            start = drill.centre - 2 * drill.thickness * drill.direction
            ends = (cadquery.Vector(*start.tolist()), cadquery.Vector(*drill.direction.tolist()))
            sizes = [(0.46 * drill.diameter, True), (0.54 * drill.diameter, False)]
            for radius, passes in sizes:
                bolt = cadquery.Solid.makeCylinder(radius, 4 * drill.thickness, *ends)
                shared = BRepAlgoAPI_Common(plate.wrapped, bolt.wrapped).Shape()
                assert (cadquery.Shape.cast(shared).Volume() <= 1e-6) is passes, part.name


def test_holes_take_their_cylinders_from_the_plate(some):
    for part in some.parts:
        bored = part.body.whole.volume - part.volume if part.pattern.holes else 0.0
        cylinders = sum(np.pi / 4 * hole.diameter**2 for hole in part.pattern.holes)
        assert bored == pytest.approx(cylinders * part.thickness, rel=3e-2)


def test_plane_holes_are_cylinders_for_whoever_drills_them():
    structure = build(helicoid().scaled(3000.0), [Lamellas(40, 3, hole=6.0, stock=2500.0)])
    plate = next(part for part in structure.parts if part.kind == "splice")
    walls = [face for face in plate.solid().Faces() if face.geomType() == "CYLINDER"]
    assert len(walls) == len(plate.pattern.holes) > 0


@pytest.mark.parametrize("settings", KINDS.values(), ids=KINDS)
def test_solids_take_no_longer_than_three_times_the_writing(settings, tmp_path):
    selection = Selection(lines=(1, 2, 3))
    structure = build(rounded(), [Lamellas(60, 4, **settings)], selection=selection)
    seconds = []
    for work in (structure.solids, lambda: write_step(tmp_path / "a.step", structure.parts)):
        start = time.process_time()
        work()
        seconds.append(time.process_time() - start)
    assert seconds[0] <= 3 * seconds[1]


def test_a_face_between_two_stations_is_one_side():
    """Two sides and two edges a face, and of each slot two flanks and the floor's halves."""
    structure = build(helicoid().scaled(3000.0), [Lamellas(40, 3, strip="twisted")])
    for part in structure.parts:
        faces = len(part.pattern.axis) - 1
        slots = sum(1 for mark in part.pattern.marks if mark.text)
        assert len(part.solid().Faces()) == 4 * faces + 4 * slots + 2


def test_shorter_blocks_hold_a_plate_more_closely(some):
    for part in some.parts[::5]:
        body = getattr(part.body, "whole", part.body)
        close, loose = (
            sum(ConvexHull(piece.corners).volume for piece in pieces) / body.volume - 1
            for pieces in (body.filling(), body.pieces())
        )
        assert -1e-9 < close <= loose + 1e-9
        if any(sheet.rails is not None for sheet in getattr(body, "sheets", ())):
            assert close < 0.3 * loose, part.name
            finer = sum(ConvexHull(piece.corners).volume for piece in body.filling(4))
            assert -1e-9 < finer / body.volume - 1 < 0.5 * close, part.name


def test_pieces_of_plates_turn_their_sides_outwards(some):
    """Turned inwards they would be bounds all the same, but wide ones."""
    for part in some.parts:
        for pieces in (part.body.filling(), part.body.pieces()):
            inwards = sum(min(piece.volume, 0.0) for piece in pieces)
            assert inwards >= -1e-4 * part.volume, part.name


def test_prisms_around_holes_hold_them(some):
    """Points on the rims of a hole lie within the circle that its prism stands about."""
    for part in [part for part in some.parts if part.pattern.holes][:1]:
        drill, prism = part.body.drills[0], part.body.holes()[0]
        flats = (prism.corners[0] + prism.corners[1]) / 2 - drill.centre
        within = np.linalg.norm(np.cross(flats, drill.direction))
        rims = []
        for edge in part.body.solid().Edges():
            points = np.array([p.toTuple() for p in edge.positions(np.linspace(0, 1, 9))])
            radii = np.linalg.norm(np.cross(points - drill.centre, drill.direction), axis=1)
            deep = np.abs((points - drill.centre) @ drill.direction)
            if radii.max() < 0.7 * drill.diameter and deep.max() < drill.thickness:
                rims.append(radii.max())
        assert rims and max(rims) < within < 0.55 * drill.diameter, part.name


@pytest.fixture(scope="module")
def bolted():
    """Two twisted laths that lie on each other, and the direction of their bolt."""
    settings = {"strip": "twisted", "position": "lying", "layers": 2}
    parts = build(helicoid(4, 4).scaled(3000.0), [Lamellas(60, 5, **settings)]).parts
    lower, upper = (
        next(part for part in parts if (part.family, part.line) == (family, 1)) for family in "uv"
    )
    (vertex,) = set(lower.vertices) & set(upper.vertices)
    return lower, upper, lower.body.drills[lower.vertices.index(vertex)].direction @ lower.frame


def test_twisted_laths_that_hardly_clash_need_no_kernel(bolted, monkeypatch):
    """Few cubic millimetres, which whole blocks tell to a half only."""
    lower, upper, across = bolted
    moved = [replace(upper, origin=upper.origin + move * across) for move in (-0.6, -0.4)]
    with monkeypatch.context() as patch:
        patch.setattr("OCP.BRepAlgoAPI.BRepAlgoAPI_Common", None)
        checks = [check_clashes([lower, each]) for each in moved]
    assert [(check.cut, len(check.clashes)) for check in checks] == [(0, 1), (0, 1)]
    common = BRepAlgoAPI_Common(lower.solid().wrapped, moved[0].solid().wrapped).Shape()
    volume = cadquery.Shape.cast(common).Volume()
    assert volume < 10
    assert checks[0].clashes[0].volume == pytest.approx(volume, rel=1 / 7)


def test_twisted_drilled_laths_that_clash_need_no_kernel(bolted, monkeypatch):
    """Two laths that are bolted, the upper one moved into the lower."""
    lower, upper, across = bolted
    ways = [replace(upper, origin=upper.origin + move * across) for move in (-3.0, 3.0)]
    with monkeypatch.context() as patch:
        patch.setattr("OCP.BRepAlgoAPI.BRepAlgoAPI_Common", None)
        checks = [check_clashes([lower, moved]) for moved in ways]
    assert sorted((check.cut, len(check.clashes)) for check in checks) == [(0, 0), (0, 1)]
    (moved, clash) = next(
        (moved, check.clashes[0])
        for moved, check in zip(ways, checks, strict=True)
        if check.clashes
    )
    common = BRepAlgoAPI_Common(lower.solid().wrapped, moved.solid().wrapped).Shape()
    assert clash.volume == pytest.approx(cadquery.Shape.cast(common).Volume(), rel=1 / 7)


def test_what_only_a_hole_holds_is_no_clash():
    """A pin in a hole shares nothing, a wider one does: what is unsure goes to the kernel."""
    structure = build(helicoid(5, 5).scaled(3000.0), [Lamellas(40, 3, hole=6.0, stock=2500.0)])
    part = next(part for part in structure.parts if part.kind == "splice")
    for share, cut, clashing in ((0.6, 1, 0), (1.3, 1, 1), (4.0, 0, 1)):
        drill = replace(part.body.drills[0], diameter=share * part.body.drills[0].diameter)
        pin = replace(part, name="pin", body=drill.around(), volume=drill.around().volume)
        check = check_clashes([part, pin])
        assert (check.cut, len(check.clashes)) == (cut, clashing)


def test_bezier_curves_stay_themselves():
    random = np.random.default_rng(3)
    poles = random.normal(size=(4, 3))
    t = np.linspace(0, 1, 11)
    values, slopes = bernstein(4, t)
    higher, _ = bernstein(7, t)
    assert higher @ raised(poles, 7) == pytest.approx(values @ poles, abs=1e-14)
    steps, _ = bernstein(4, np.linspace(0, 1, 4))
    assert through(steps @ poles) == pytest.approx(poles, abs=1e-13)
    ahead, _ = bernstein(4, t + 1e-6)
    assert (ahead - values) / 1e-6 == pytest.approx(slopes, abs=1e-4)
