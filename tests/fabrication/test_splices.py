"""Lamellas longer than the stock: pieces that fit it, plates that fit them, names that stay."""

import itertools
import math

import ezdxf
import numpy as np
import pytest

from freecad_ortho.fabrication import Lamellas, Selection, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.test_lamellas import check_solids, flat_grid, minimal, rounded  # noqa: F401
from tests.meshes import helicoid


def joints_along(structure, family, axis):
    """Places of the joints of each line of a family along an axis of the model, mm."""
    found = {}
    for part in structure.parts:
        if part.kind == "splice" and part.family == family:
            found.setdefault(part.line, []).append(float(part.origin[axis]))
    return {line: sorted(places) for line, places in found.items()}


def test_pieces_fit_the_stock_and_joints_are_staggered():
    structure = build(flat_grid(5, 13), [Lamellas(60, 4, stock=2000.0)])
    pieces = [part for part in structure.parts if part.kind == "lamella"]
    plates = [part for part in structure.parts if part.kind == "splice"]
    assert max(part.length for part in pieces) <= 2000
    assert structure.report()["lamellas"]["splices"] == len(plates) > 0
    long = {part.family for part in plates}
    assert len(long) == 1
    (family,) = long
    places = joints_along(structure, family, 0 if family == "u" else 1)
    spans = [np.ptp(each) for each in places.values()]
    assert max(spans) > 0
    for line in range(len(places) - 1):
        nearest = np.abs(np.subtract.outer(places[line], places[line + 1])).min()
        assert nearest >= 400 - 1e-6
    whole = build(flat_grid(5, 13), [Lamellas(60, 4)])
    # What is cut away is the clearance at each joint, nothing else of the axes.
    lost = sum(part.length for part in whole.parts) - sum(part.length for part in pieces)
    assert lost == pytest.approx(len(plates) * 1.0, abs=1e-6)


def test_solids_are_valid_and_nothing_clashes():
    structure = build(flat_grid(4, 9), [Lamellas(60, 4, stock=1500.0)])
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes
    plate = next(part for part in structure.parts if part.kind == "splice")
    length = 1.0 + 2 * 4.8 * 9
    assert plate.length == pytest.approx(length)
    assert plate.volume == pytest.approx(4 * (length * 60 - 8 * math.pi / 4 * 81), rel=1e-9)
    assert plate.area == pytest.approx(plate.volume / 4, rel=1e-9)


def test_holes_of_plates_and_pieces_lie_on_one_another():
    structure = build(flat_grid(4, 9), [Lamellas(60, 4, stock=1500.0)])
    by_name = {part.name: part for part in structure.parts}
    plates = [part for part in structure.parts if part.kind == "splice"]
    for plate in plates:
        stem, number = plate.name[1:].rsplit("-", 1)
        assert_bolted(plate, [by_name[f"L{stem}-{int(number) + k}"] for k in (0, 1)])


def assert_bolted(plate, pieces):
    """Every hole of the plate lies on one hole of the pieces, of all of which it is the nearest."""
    drills = [drill for piece in pieces for drill in in_place(piece)]
    for centre, direction in in_place(plate):
        away = [np.linalg.norm(np.cross(centre - other, direction)) for other, _ in drills]
        assert min(away) <= 1e-9
        assert sorted(away)[1] > 10


@pytest.mark.parametrize("hole", [9.0, 4.0])
def test_a_plate_names_each_piece_on_its_half(hole):
    for part in build(flat_grid(4, 9), [Lamellas(60, 4, hole=hole, stock=1500.0)]).parts:
        if part.kind == "splice":
            stem, number = part.name[1:].rsplit("-", 1)
            places = {mark.text: mark.points[0] for mark in part.pattern.marks if mark.text}
            first, second = (places.pop(f"L{stem}-{int(number) + k}") for k in (0, 1))
            assert not places
            assert first[0] == pytest.approx(part.length / 4)
            assert second[0] == pytest.approx(3 / 4 * part.length)
            assert len(part.name) * part.pattern.label_size <= part.length
            for mark in part.pattern.marks:
                assert len(mark.text) * mark.size <= part.length / 2


def in_place(part):
    """Middle and direction of every hole of a part in space."""
    return [
        (part.origin + drill.centre @ part.frame, drill.direction @ part.frame)
        for drill in part.body.drills
    ]


@pytest.mark.slow
@pytest.mark.parametrize("layers", [1, 2])
def test_curved_lamellas_are_spliced_too(minimal, layers):  # noqa: F811
    settings = Lamellas(40, 3, hole=6.0, layers=layers, stock=2500.0)
    structure = build(minimal, [settings], selection=Selection("both", (7,)))
    pieces = [part for part in structure.parts if part.kind == "lamella"]
    assert any(part.kind == "splice" for part in structure.parts)
    assert max(part.length for part in pieces) <= 2500
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes


@pytest.mark.parametrize(
    ("width", "hole", "cuts"), [(40, 6.0, 0), pytest.param(80, 9.0, 5, marks=pytest.mark.slow)]
)
def test_plates_on_twisted_lamellas_are_told_apart_without_the_kernel(width, hole, cuts):
    settings = Lamellas(width, 3, hole=hole, strip="twisted", stock=2500.0)
    parts = build(helicoid().scaled(3000.0), [settings]).parts
    plates = sum(part.kind == "splice" for part in parts)
    check = check_clashes(parts)
    assert plates > 50 and check.near > 2 * plates and not check.clashes
    assert check.cut <= cuts


def test_lying_lamellas_are_spliced_on_their_outer_sides():
    settings = Lamellas(60, 4, position="lying", layers=2, strip="twisted", stock=1900.0)
    structure = build(rounded(), [settings], selection=Selection("both", (2, 3)))
    assert any(part.kind == "splice" for part in structure.parts)
    # On so coarse a barrel the two layers touch at their bends, whether spliced or not.
    clashes = check_clashes(structure.parts).clashes
    assert not [clash for clash in clashes if "S-" in clash.first + clash.second]
    check_solids(structure)


@pytest.mark.parametrize("size", [(5, 13), (13, 5)])
def test_plates_of_either_layer_lie_away_from_the_other_one(size):
    structure = build(flat_grid(*size), [Lamellas(60, 4, stock=2000.0, position="lying", layers=2)])
    pieces = [part for part in structure.parts if part.kind == "lamella"]
    heights = {
        family: np.mean([part.origin[2] for part in pieces if part.family == family])
        for family in "uv"
    }
    plates = [part for part in structure.parts if part.kind == "splice"]
    assert plates
    for plate in plates:
        own, other = heights[plate.family], heights["uv".replace(plate.family, "")]
        assert abs(plate.origin[2] - other) > abs(own - other) > 4


def test_short_lamellas_stay_whole_and_names_do_not_change():
    names = [part.name for part in build(flat_grid(), [Lamellas(60, 4)]).parts]
    assert [part.name for part in build(flat_grid(), [Lamellas(60, 4, stock=9e4)]).parts] == names
    one = build(flat_grid(4, 9), [Lamellas(60, 4, stock=1500.0)])
    other = build(flat_grid(4, 9).scaled(1.01), [Lamellas(60, 4, stock=1500.0)])
    assert [part.name for part in one.parts] == [part.name for part in other.parts]
    family = one.parts[-1].family.upper()
    assert f"S-{family}001-1" in [part.name for part in one.parts]
    assert f"L-{family}001-2" in [part.name for part in one.parts]


@pytest.mark.parametrize(
    "settings", [{"hole": 40.0, "width": 100.0}, {"hole": 30.0}, {"stock": 300.0}]
)
def test_where_no_splice_fits_one_line_says_so(settings):
    sizes = {"width": 60.0, "thickness": 4.0, "stock": 1500.0} | settings
    with pytest.raises(InputError, match=r"stock: L-.* no room for splices"):
        build(flat_grid(4, 9), [Lamellas(**sizes)])


def test_files_read_back(tmp_path):
    structure = build(flat_grid(4, 9), [Lamellas(60, 4, stock=1500.0)])
    write(structure, tmp_path, workshop=Workshop(stock=1500.0))
    read = dict(read_step(tmp_path / "structure.step"))
    drawing = ezdxf.readfile(tmp_path / "flat.dxf")
    for part in structure.parts:
        assert read[part.name].isValid()
        assert read[part.name].Volume() == pytest.approx(part.volume, rel=1e-6)
        holes = drawing.blocks[part.name].query('CIRCLE[layer=="HOLE"]')
        assert len(holes) == len(part.pattern.holes)
    assert {8} == {len(part.pattern.holes) for part in structure.parts if part.kind == "splice"}


def tube(rings=3, count=12, radius=1000.0, bulge=0.0, angle=None):
    """Rings of a cylinder or a barrel about z, closed."""
    angle = np.arange(count) * 2 * np.pi / count if angle is None else angle
    height = 400.0 * np.arange(rings)
    reach = radius + bulge * np.sin(np.pi * np.arange(rings) / (rings - 1))
    points = np.stack(
        [
            np.outer(reach, np.cos(angle)),
            np.outer(reach, np.sin(angle)),
            np.outer(height, np.ones(count)),
        ],
        axis=-1,
    )
    number = np.arange(rings * count).reshape(rings, count)
    ahead = np.roll(number, -1, axis=1)
    faces = np.stack([number[:-1], ahead[:-1], ahead[1:], number[1:]], axis=-1)
    return QuadMesh(points.reshape(-1, 3), faces.reshape(-1, 4))


def test_closed_lamellas_are_joined_by_a_splice_each():
    structure = build(tube(), [Lamellas(60, 4)])
    rings = [part for part in structure.parts if len(part.vertices) == 12]
    plates = [part for part in structure.parts if part.kind == "splice"]
    assert len(rings) == len(plates) == 3
    circumference = 12 * 2 * 1000 * math.sin(math.pi / 12)
    for ring, plate in zip(rings, plates, strict=True):
        along = np.linalg.norm(np.diff(ring.pattern.axis, axis=0), axis=1).sum()
        assert along == pytest.approx(circumference - 1.0, rel=1e-9)
        # Its flat pattern is an arc: length and width are those of its box.
        assert (ring.length, ring.width) == pytest.approx(np.ptp(ring.pattern.outline, axis=0))
        assert ring.width > 5 * ring.section_height == pytest.approx(5 * 60)
        assert plate.name == f"S{ring.name[1:]}-1"
        assert_bolted(plate, [ring])
    # Neighbouring rings are cut on opposite sides.
    for one, two in itertools.pairwise(plates):
        assert one.origin[:2] @ two.origin[:2] < -(900.0**2)
    check_solids(structure)
    assert not check_clashes(structure.parts).clashes
    assert structure.report()["lamellas"]["splices"] == 3
    assert not [words for words in structure.report()["messages"] if "splice" in words]


@pytest.mark.parametrize("long", [0, 7, 39])
def test_closed_lamellas_are_cut_where_a_splice_has_room(long):
    """One edge of 575 mm, the others of 81 mm too short for a plate."""
    shares = np.where(np.arange(40) == long, 1.0, (2 * np.pi - 1.0) / 39)
    mesh = tube(count=40, radius=600.0, angle=np.cumsum(shares) - shares)
    structure = build(mesh, [Lamellas(60, 4, hole=9.0)], selection=Selection("u"))
    plates = [part for part in structure.parts if part.kind == "splice"]
    assert len(plates) == 3
    middle = (mesh.vertices[long] + mesh.vertices[(long + 1) % 40]) / 2
    for plate in plates:
        away = np.mean([centre for centre, _ in in_place(plate)], axis=0) - middle
        assert np.linalg.norm(away[:2]) <= 1e-9


@pytest.mark.parametrize(
    "settings",
    [
        {"strip": "twisted"},
        {"strip": "twisted", "layers": 2},
        pytest.param({"position": "lying", "layers": 2, "hole": 6.0}, marks=pytest.mark.slow),
        {"stock": 2000.0},
    ],
)
def test_rings_of_a_barrel_are_closed(settings):
    structure = build(tube(5, 20, 2000.0, 300.0), [Lamellas(50, 4, **settings)])
    for line in range(5):
        on_line = [p for p in structure.parts if (p.family, p.line) == ("u", line)]
        pieces, plates = ([p for p in on_line if p.kind == k] for k in ("lamella", "splice"))
        assert len(plates) == len(pieces) >= (6 if "stock" in settings else 1)
        assert max(piece.length for piece in pieces) <= settings.get("stock", math.inf)
        for plate in plates:
            assert_bolted(plate, pieces)
    check_solids(structure)
    clashes = check_clashes(structure.parts).clashes
    assert not [clash for clash in clashes if "S-" in clash.first + clash.second]


def test_a_ring_with_no_room_for_a_splice_says_so():
    structure = build(tube(count=16), [Lamellas(100, 4, hole=40.0)])
    assert not [part for part in structure.parts if part.kind == "splice"]
    (words,) = [words for words in structure.report()["messages"] if "splice" in words]
    assert "no splice closes L-U000, L-U001, L-U002: it would need a plane edge" in words
    check_solids(structure)
