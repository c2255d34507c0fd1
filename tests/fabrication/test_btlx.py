"""Files for carpenters' machines: parts rebuilt by a reader of its own, against STEP's solids."""

import json
import os
import re
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely
import shapely.affinity
from scipy.spatial import ConvexHull

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build, write
from freecad_ortho.fabrication.exchange.btlx import write_btlx
from freecad_ortho.fabrication.exchange.btlx_laps import laps, without_flat_corners
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.step import read_step
from tests.fabrication.btlx_reader import SPACE, plate_of, rebuilt, ring, tag, to_model

# The name of the schema's file, BTLx_2_0_0.xsd of design2machine.com, which may not be passed on.
SCHEMA_FILE = "BTLX_SCHEMA"
# Elements of processings in their order, and least and largest values, as the schema has them.
SCHEMA = {
    "JackRafterCut": {
        "Orientation": ("start", "end"),
        "StartX": (-1e5, 1e5),
        "StartY": (0, 5e4),
        "StartDepth": (0, 5e4),
        "Angle": (0.1, 179.9),
        "Inclination": (0.1, 179.9),
    },
    "Drilling": {
        "StartX": (-1e5, 1e5),
        "StartY": (-5e4, 5e4),
        "Angle": (0, 360),
        "Inclination": (0.1, 179.9),
        "DepthLimited": ("yes", "no"),
        "Depth": (0, 5e4),
        "Diameter": (0, 5e4),
    },
    "Text": {
        "StartX": (-1e5, 1e5),
        "StartY": (-5e4, 5e4),
        "Angle": (-180, 180),
        "AlignmentVertical": ("bottom", "center", "top"),
        "AlignmentHorizontal": ("left", "center", "right"),
        "TextHeightAuto": ("yes", "no"),
        "TextHeight": (0, 5e4),
        "Text": (),
    },
    "Lap": {
        "Orientation": ("start", "end"),
        "StartX": (-1e5, 1e5),
        "StartY": (-5e4, 5e4),
        "Angle": (0.1, 179.9),
        "Inclination": (0.1, 179.9),
        "Slope": (-89.9, 89.9),
        "Length": (0, 1e5),
        "Width": (0, 5e4),
        "Depth": (-5e4, 5e4),
        "LeadAngleParallel": ("yes", "no"),
        "LeadAngle": (0.1, 179.9),
        "LeadInclinationParallel": ("yes", "no"),
        "LeadInclination": (0.1, 179.9),
        "MachiningLimits": (),
    },
    "FreeContour": {"Contour": (), "DualContour": ()},
    "PenContour": {"Contour": ()},
}
COMPONENT = ["Transformations", "GrainDirection", "ReferenceSide", "Processings"]
JOBS = {
    "bars": ([Beams(200, 20, section="GL24h:80x200")], "steel"),
    "plates": ([Beams(200, 40)], "timber"),
    "panels": ([Panels(20, 15, edge="bevel")], "plywood"),
    "lamellas": ([Lamellas(60, 4)], "plywood"),
    "drilled": ([Lamellas(60, 4, hole=9, layers=2)], "plywood"),
    "lapped": ([Beams(200, 40, ends="lapped")], "timber"),
    "straight": ([Lamellas(60, 4)], "plywood"),
    "milled": ([Lamellas(90, 12, cutter=4)], "plywood"),
}
# Kinds of boards: processings that cut their edges, and whether slots are laps.
BOARDS = {
    "lamellas": ({"FreeContour": 1}, True),
    "drilled": ({"FreeContour": 1}, False),
    "lapped": ({"FreeContour": 1}, True),
    "straight": ({"JackRafterCut": 2}, True),
    "milled": ({"FreeContour": 1}, False),
}
TURN = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


@pytest.fixture(scope="module")
def made(roof, twisted, tmp_path_factory):
    """For each job its parts, the elements of parts by their names, and the solids of the STEP."""
    found = {}
    for name, (systems, material) in JOBS.items():
        some = Selection(family="u", lines=(3,))
        if name in ("panels", *BOARDS):
            some = Selection()
        place = Place(TURN, np.array([1e4, -2e4, 500.0]))
        net = twisted if name == "straight" else roof
        job = build(net, systems, material=MATERIALS[material], selection=some, place=place)
        folder = tmp_path_factory.mktemp(name)
        path, project = folder / "structure.btlx", 'Dach <ü> & "7"'
        if name in BOARDS:
            write_btlx(path, produce(job), project, lambda done: None)
        else:
            write(job, folder, workshop=Workshop(write="btlx"), project=project)
        root = ElementTree.parse(path).getroot()
        parts = {each.get("Designation"): each for each in root.iter(f"{SPACE}Part")}
        solids = {} if name in BOARDS else dict(read_step(folder / "structure.step"))
        found[name] = job.parts, root, parts, solids
    return found


@pytest.mark.parametrize("name", JOBS)
def test_files_are_as_the_schema_has_them(made, name):
    parts, root, read, _ = made[name]
    assert tag(root) == "BTLx"
    assert root.get("Version") == "2.0.0"
    assert [tag(each) for each in root] == ["FileHistory", "Project"]
    assert root[1].get("Name") == 'Dach <ü> & "7"'
    assert list(read) == [part.name for part in parts]
    for element in read.values():
        assert [tag(each) for each in element] == COMPONENT
        assert all(float(element.get(name)) > 0 for name in ("Length", "Height", "Width"))
        assert int(element.get("SingleMemberNumber")) > 0
        (stands,) = element.iter(f"{SPACE}Transformation")
        assert re.fullmatch(r"\{[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}\}", stands.get("GUID"))
        numbers = [each.get("ProcessID") for each in element.find(f"{SPACE}Processings")]
        assert numbers == [str(k + 1) for k in range(len(numbers))]
        for each in element.find(f"{SPACE}Processings"):
            known = SCHEMA[tag(each)]
            names = [tag(child) for child in each]
            assert names == [word for word in known if word in names]
            assert each.get("ReferencePlaneID") in (("2", "4") if tag(each) == "Lap" else ("4",))
            for child in each:
                bounds = known[tag(child)]
                if bounds and isinstance(bounds[0], str):
                    assert child.text in bounds
                elif bounds:
                    assert bounds[0] <= float(child.text) <= bounds[1]


@pytest.mark.parametrize("name", ["bars", "plates"])
def test_bars_are_rebuilt(made, name):
    parts, _, read, solids = made[name]
    for part in parts:
        corners, solid = rebuilt(read[part.name]), solids[part.name]
        assert ConvexHull(corners).volume == pytest.approx(solid.Volume(), rel=1e-4)
        seen = np.array([vertex.toTuple() for vertex in solid.Vertices()])
        away = np.linalg.norm(seen[:, None] - corners[None], axis=2).min(axis=1)
        assert away.max() < 0.01


def test_bevelled_panels_are_rebuilt(made):
    parts, _, read, solids = made["panels"]
    dual_contours = [list(read[part.name].iter(f"{SPACE}DualContour")) for part in parts]
    assert sum(map(len, dual_contours)) == len(parts)
    for part, (dual,) in list(zip(parts, dual_contours, strict=True))[::7]:
        element = read[part.name]
        upper, lower = ring(dual[0])[:-1], ring(dual[1])[:-1]
        assert ConvexHull(np.concatenate([upper, lower])).volume == pytest.approx(
            solids[part.name].Volume(), rel=1e-4
        )
        # From the side's own coordinates, whose depth is downwards, into the model.
        origin, axes = to_model(element)
        corners = np.concatenate([upper, lower]) + [0, 0, float(element.get("Width"))]
        seen = np.array([vertex.toTuple() for vertex in solids[part.name].Vertices()])
        away = np.linalg.norm(seen[:, None] - (origin + corners @ axes)[None], axis=2)
        assert away.min(axis=1).max() < 0.01


@pytest.mark.parametrize("name", BOARDS)
def test_boards_are_rebuilt_flat(made, name):
    parts, _, read, _ = made[name]
    cuts, lapped = BOARDS[name]
    for part in parts:
        element, pattern = read[part.name], part.pattern
        for kind, count in cuts.items():
            assert len(list(element.iter(SPACE + kind))) == count
        assert len(list(element.iter(f"{SPACE}Drilling"))) == len(pattern.holes)
        crossings = len(list(element.iter(f"{SPACE}Lap")))
        assert bool(crossings) == lapped
        plate = plate_of(element)
        holes = [shapely.Point(each.centre).buffer(each.diameter / 2) for each in pattern.holes]
        low = pattern.outline.min(axis=0)
        true = shapely.affinity.translate(
            shapely.Polygon(pattern.outline) - shapely.union_all(holes), *-low
        )
        assert plate.symmetric_difference(true).area < 1e-4 * true.area
        assert plate.area * float(element.get("Width")) == pytest.approx(
            pattern.area * part.thickness, rel=1e-4
        )
        texts = [
            each.find(f"{SPACE}Text").text for each in element.iter(f"{SPACE}Text") if len(each)
        ]
        assert texts == [part.name, *(mark.text for mark in pattern.marks if mark.text)]
        lines = list(element.iter(f"{SPACE}PenContour"))
        assert len(lines) == sum(not mark.text for mark in pattern.marks)


def test_corners_at_which_an_outline_goes_straight_on_are_left_out():
    square = np.array([(10, 20), (40, 20), (70, 20), (70, 50), (70, 80), (10, 80)], dtype=float)
    kept = without_flat_corners(square)
    np.testing.assert_array_equal(kept, square[[0, 2, 4, 5]])


def test_what_stands_above_a_slot_is_left_alone():
    """A frame around a slot: a lap that is open above would cut its upper side in two."""
    around = np.array([[0, 0], [90, 0], [90, 80], [0, 80], [0, 60], [70, 60], [70, 30], [50, 30]])
    slot = np.array([[50, 10], [40, 10], [40, 30], [0, 30]])
    outline = np.concatenate([around, slot]).astype(float)
    filled, found = laps(outline)
    assert not found
    np.testing.assert_array_equal(filled, outline)
    (lap,) = laps(np.array([[0, 0], [90, 0], [90, 30], [50, 30], *slot]).astype(float))[1]
    np.testing.assert_allclose(
        [*lap.start, lap.length, lap.width, lap.angle_deg], [40, 10, 10, 20, 90]
    )


@pytest.mark.skipif(SCHEMA_FILE not in os.environ, reason=f"{SCHEMA_FILE} names no schema")
@pytest.mark.parametrize("name", JOBS)
def test_files_are_valid(made, name):
    schema = pytest.importorskip("xmlschema").XMLSchema(os.environ[SCHEMA_FILE])
    schema.validate(ElementTree.ElementTree(made[name][1]))


def test_steel_is_for_others(roof, tmp_path):
    job = build(roof, [Beams(200, 20)], selection=Selection(family="u", lines=(3,)))
    write(job, tmp_path, workshop=Workshop(write="btlx"))
    root = ElementTree.parse(tmp_path / "structure.btlx").getroot()
    assert not list(root.iter(f"{SPACE}Part"))
    said = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["messages"]
    assert [line for line in said if "structure.btlx: nothing to write" in line and "wood" in line]
