"""Parts of a net in national grid coordinates: the same as near the origin, in files by choice."""

from __future__ import annotations

import csv
import json

import cadquery
import numpy as np
import pytest
from OCP.TopLoc import TopLoc_Location

from freecad_ortho import api
from freecad_ortho.fabrication import Place, build, write
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems import systems_of
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces

# In mm: ten thousand kilometres from the origin.
OFFSET = np.array([1e10, -1e10, 5e9])
SYSTEMS = "beams+panels"


def written(structure, folder, **settings):
    """Parts of the STEP file, rows of the list of nodes, and the report."""
    api.write_fabrication(structure, folder, **settings)
    with (folder / "nodes.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    return read_step(folder / "structure.step"), rows, report


def in_own_coordinates(shape):
    return cadquery.Shape.cast(shape.wrapped.Located(TopLoc_Location()))


@pytest.fixture(scope="module")
def strip(roof):
    """A corner of the roof, of eight faces."""
    corner = np.arange(70).reshape(7, 10)[:3, :5].ravel()
    return QuadMesh(roof.vertices[corner], grid_faces(3, 5))


@pytest.fixture(scope="module")
def near(strip):
    return api.fabricate(strip, SYSTEMS)


@pytest.fixture(scope="module", params=["m", "mm"])
def far(request, strip):
    scale = {"m": 1000.0, "mm": 1.0}[request.param]
    return api.fabricate(
        strip.with_vertices((strip.vertices + OFFSET) / scale), SYSTEMS, unit=request.param
    )


def test_about_the_local_origin_every_solid_is_whole(near, far, tmp_path):
    parts, rows, report = written(far, tmp_path)
    assert np.array(report["origin_mm"]) == pytest.approx(OFFSET)
    assert report["file_origin_mm"] == report["origin_mm"]
    assert len(parts) == len(near.parts)
    for (name, shape), part in zip(parts, near.parts, strict=True):
        assert name == part.name and shape.isValid()
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-5)
        assert np.abs(np.array(shape.Center().toTuple())).max() < 2e5
    points = np.array([[float(row[f"{axis}_mm"]) for axis in "xyz"] for row in rows])
    assert points + report["file_origin_mm"] == pytest.approx(near.mesh.vertices + OFFSET, abs=1e-5)
    assert any("measured from 10000000000, -10000000000" in word for word in report["messages"])


def test_kept_coordinates_are_the_place_of_the_assembly(near, far, tmp_path):
    parts, rows, report = written(far, tmp_path, origin="keep")
    assert report["file_origin_mm"] == [0, 0, 0]
    assert np.array(report["origin_mm"]) == pytest.approx(OFFSET)
    for (name, shape), part in zip(parts, near.parts, strict=True):
        own = in_own_coordinates(shape)
        assert name == part.name and own.isValid()
        assert own.Volume() == pytest.approx(part.volume, rel=1e-5)
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-5)
        middle = np.array(shape.Center().toTuple()) - OFFSET
        assert middle == pytest.approx(np.array(part.solid().Center().toTuple()), abs=1e-3)
    points = np.array([[float(row[f"{axis}_mm"]) for axis in "xyz"] for row in rows])
    assert points == pytest.approx(near.mesh.vertices + OFFSET, abs=1e-5)
    assert any("take a local origin" in word for word in report["messages"])


def test_checks_find_the_same(near, far, tmp_path):
    here, there = (
        written(structure, tmp_path / name)[2] for name, structure in (("near", near), ("far", far))
    )
    assert there["clash_check"]["clashes"] == pytest.approx(here["clash_check"]["clashes"])
    assert there["verdict"] == here["verdict"]
    assert there["counts"] == here["counts"]
    assert there["mass_kg"] == pytest.approx(here["mass_kg"], rel=1e-5)


def test_a_point_of_ones_own(near, tmp_path):
    parts, rows, report = written(near, tmp_path, origin=(1000, 2000, -500))
    assert report["file_origin_mm"] == [1000, 2000, -500]
    middle = np.array(parts[0][1].Center().toTuple())
    own = np.array(near.parts[0].solid().Center().toTuple())
    assert middle == pytest.approx(own - [1000, 2000, -500], abs=1e-6)
    assert float(rows[0]["z_mm"]) == pytest.approx(near.mesh.vertices[0, 2] + 500, abs=1e-5)
    with pytest.raises(InputError, match="expected keep, local or a point"):
        near.measured_from("here")
    with pytest.raises(InputError, match="expected keep, local or a point"):
        near.measured_from((1, 2))


def test_near_the_origin_the_choice_makes_no_difference(near, tmp_path):
    for origin in ("keep", "local"):
        api.write_fabrication(near, tmp_path / origin, origin=origin)
    for path in (tmp_path / "keep").iterdir():
        assert path.read_bytes() == (tmp_path / "local" / path.name).read_bytes()
    assert b"'site'" not in (tmp_path / "keep" / "structure.step").read_bytes()


def test_places_that_differ_by_rounding_are_one():
    def turned(angle, *origin):
        cosine, sine = np.cos(angle), np.sin(angle)
        return Place(np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]]), np.array(origin))

    here, far = turned(0.3, 1.0, 2.0, 3.0), turned(0.3, 4e9, 5e9, 6e9)
    assert here.near(turned(0.3 + 1e-10, 1.0, 2.0, 3.0 + 5e-7))
    assert not here.near(turned(0.3 + 1e-8, 1.0, 2.0, 3.0))
    assert not here.near(turned(0.3, 1.0, 2.0, 3.0 + 2e-6))
    # A number of ten digits has no more than that.
    assert far.near(turned(0.3, 4e9 + 1.0, 5e9, 6e9)) and not far.near(
        turned(0.3, 4e9, 5e9 + 9, 6e9)
    )


def test_a_structure_that_is_turned_is_written_turned(strip, near, tmp_path):
    angle = np.radians(30)
    rotation = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    place = Place(rotation, np.array([5000.0, -2000.0, 300.0]))
    structure = build(strip, systems_of(SYSTEMS, {}), place=place)
    write(structure, tmp_path)
    parts = read_step(tmp_path / "structure.step")
    for (_, shape), part in zip(parts, near.parts, strict=True):
        assert shape.isValid()
        own = np.array(part.solid().Center().toTuple())
        assert np.array(shape.Center().toTuple()) == pytest.approx(place.points(own), abs=1e-6)
    row = next(csv.DictReader((tmp_path / "nodes.csv").open(encoding="utf-8")))
    assert [float(row[f"axis_{axis}"]) for axis in "xyz"] == pytest.approx(
        place.directions(near.axes.directions[0]), abs=1e-8
    )
