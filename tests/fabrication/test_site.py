"""Models in national grid coordinates, and models with a datum: no digit is lost on the way."""

import csv
import json

import numpy as np
import pytest

from freecad_ortho.__main__ import main
from freecad_ortho.fabrication.datum import Datum
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.step import read_step
from solver import read_mesh, write_mesh

needs_ifc = pytest.mark.skipif(
    FORMATS["ifc"].missing, reason="needs the packages of requirements-exchange.txt"
)
# East, north and height of a national grid, m; a double there is good for a nanometre.
FAR = np.array([3500120.5, 5400033.25, 412.5])
BUILD = ("--unit", "m", "--system", "beams", "--family", "u", "--lines", "0,3")


def built(root, roof, points, *options):
    """The net with these vertices in metres, and the folder of its files."""
    mesh = roof.with_vertices(points)
    write_mesh(root / "net.obj", mesh, "m")
    files = root / "files"
    arguments = ["fabricate", str(root / "net.obj"), "-o", str(files), *BUILD, *options]
    assert main([*arguments, "--write", "assembly,ifc"]) == 0
    read = read_mesh(root / "net.obj").vertices
    np.testing.assert_allclose(read, points, rtol=0, atol=1e-8)
    return read, files


@pytest.fixture(scope="module")
def far(roof, tmp_path_factory):
    return built(tmp_path_factory.mktemp("far"), roof, roof.vertices / 1000 + FAR)


@pytest.fixture(scope="module")
def placed(roof, tmp_path_factory):
    origin = ",".join(map(str, FAR))
    options = (f"--site-origin={origin}", "--site-rotation=30")
    return built(tmp_path_factory.mktemp("placed"), roof, roof.vertices / 1000, *options)


def turned(points):
    angle = np.radians(30)
    turn = [[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    return points @ np.array(turn) + FAR


def surveyed(files):
    with (files / "assembly" / "survey.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    names = ("east_m", "north_m", "height_m")
    return {int(row["point"][1:]): [float(row[name]) for name in names] for row in rows}


@pytest.mark.parametrize("name", ["far", "placed"])
def test_points_come_back_to_the_last_digit_that_is_written(name, request):
    points, files = request.getfixturevalue(name)
    wanted = points if name == "far" else turned(points)
    for vertex, point in surveyed(files).items():
        np.testing.assert_allclose(point, wanted[vertex], rtol=0, atol=5.1e-6)


@needs_ifc
@pytest.mark.parametrize("name", ["far", "placed"])
def test_ifc_says_where_it_is_on_site(name, request):
    import ifcopenshell
    import ifcopenshell.validate
    from ifcopenshell.util import geolocation, placement

    points, files = request.getfixturevalue(name)
    wanted = points if name == "far" else turned(points)
    model = ifcopenshell.open(files / "structure.ifc")
    log = ifcopenshell.validate.json_logger()
    ifcopenshell.validate.validate(model, log, express_rules=True)
    assert log.statements == []
    with (files / "nodes.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows[::5]:
        near = [float(row[f"{k}_mm"]) for k in "xyz"]
        assert np.abs(near).max() < 1e6, "what is far is shifted once"
        seen = geolocation.auto_xyz2enh(model, *near)
        # A corner of the list has a millionth of a millimetre.
        np.testing.assert_allclose(seen, wanted[int(row["vertex"])], rtol=0, atol=5e-9)
    beam = next(each for each in model.by_type("IfcBeam"))
    assert np.abs(placement.get_local_placement(beam.ObjectPlacement)[:3, 3]).max() < 1e6


@pytest.mark.parametrize("name", ["far", "placed"])
def test_step_and_report_say_it_too(name, request):
    points, files = request.getfixturevalue(name)
    site = json.loads((files / "report.json").read_text(encoding="utf-8"))["site"]
    head = (files / "structure.step").read_bytes()[:2000].decode("ascii")
    assert str(Datum(**site)) in head.replace("\n", "")
    if name == "placed":
        assert list(site.values()) == [*FAR, 30.0]
    (_, solid), *_ = read_step(files / "structure.step")
    middle = np.array(solid.Center().toTuple())
    wanted = points if name == "far" else turned(points)
    seen = Datum(**site).turn @ middle / 1000 + [site["east"], site["north"], site["height"]]
    low, high = wanted.min(axis=0), wanted.max(axis=0)
    assert (seen > low - 0.3).all()
    assert (seen < high + 0.3).all()


def test_a_model_at_its_place_says_nothing(structure, tmp_path):
    from freecad_ortho.fabrication.production import produce

    assert produce(structure).on_site == ""
