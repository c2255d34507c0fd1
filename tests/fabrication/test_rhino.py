"""3DM files: what Rhino's own library finds in them, and nets read from them."""

import sys
from importlib.util import find_spec

import numpy as np
import pytest
import trimesh

from freecad_ortho import api, rhino_files
from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.site import Selection
from solver.errors import InputError

needed = pytest.mark.skipif(
    find_spec("rhino3dm") is None, reason="needs rhino3dm (requirements-exchange.txt)"
)
# Coordinates of a national grid, mm.
FAR = np.array([3.5e9, 5.4e9, 4e5])


@pytest.fixture(scope="module")
def made(roof, tmp_path_factory):
    """A structure far from the origin, its folder, and the file as the library reads it."""
    rhino = pytest.importorskip("rhino3dm")
    some = Selection(family="u", lines=(3,))
    job = build(roof, [Beams(200, 20), Panels(20, 15)], selection=some, place=Place(origin=FAR))
    folder = tmp_path_factory.mktemp("rhino")
    write(job, folder, workshop=Workshop(write="3dm"), project="Dach ü")
    return job, folder, rhino.File3dm.Read(str(folder / "structure.3dm"))


def by_layer(model):
    names = [layer.Name for layer in model.Layers]
    found = {}
    for each in model.Objects:
        found.setdefault(names[each.Attributes.LayerIndex], {})[each.Attributes.Name] = each
    return found


@needed
def test_parts_are_closed_meshes_on_layers_by_kind(made):
    import rhino3dm

    job, _, model = made
    assert model.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Millimeters
    layers = by_layer(model)
    for kind in ("beam", "panel"):
        assert set(layers[kind]) == {part.name for part in job.parts if part.kind == kind}
    for part in job.parts[::5]:
        found = layers[part.kind][part.name]
        assert found.Attributes.GetUserString("material") == part.material.name
        mesh = found.Geometry
        points = np.array([[p.X, p.Y, p.Z] for p in mesh.Vertices.ToPoint3dArray()])
        faces = [mesh.Faces[k][:3] for k in range(len(mesh.Faces))]
        seen = trimesh.Trimesh(points - points[0], faces, process=False)
        assert seen.is_watertight
        assert seen.volume == pytest.approx(part.volume, rel=1e-6)
        corners = job.place.points(part.points)
        np.testing.assert_allclose(points.min(axis=0), corners.min(axis=0), rtol=0, atol=1e-5)
        np.testing.assert_allclose(points.max(axis=0), corners.max(axis=0), rtol=0, atol=1e-5)


@needed
def test_lines_and_axes_are_curves(made):
    job, _, model = made
    layers, site = by_layer(model), job.site
    assert set(layers["lines"]) == {f"{line.family}{line.number}" for line in site.chosen_lines}
    (line,) = site.chosen_lines
    curve = layers["lines"]["u3"].Geometry
    points = np.array([[p.X, p.Y, p.Z] for p in map(curve.Point, range(curve.PointCount))])
    expected = job.place.points(site.mesh.vertices[line.vertices] + site.shift)
    np.testing.assert_allclose(points, expected, rtol=0, atol=1e-5)
    axis = layers["axes"][f"N{line.vertices[0]:04d}"].Geometry
    start, end = ([p.X, p.Y, p.Z] for p in (axis.PointAtStart, axis.PointAtEnd))
    arm = np.array(end) - np.array(start)
    expected = site.axes.directions[line.vertices[0]]
    np.testing.assert_allclose(arm / np.linalg.norm(arm), expected, rtol=0, atol=1e-6)


@needed
def test_the_same_bytes_in_another_folder(made, tmp_path):
    job, folder, _ = made
    write(job, tmp_path, workshop=Workshop(write="3dm"), project="Dach ü")
    data = (tmp_path / "structure.3dm").read_bytes()
    assert data == (folder / "structure.3dm").read_bytes()
    assert str(folder).encode("utf-16-le") not in data


def rhino_file(path, unit, *meshes):
    rhino = pytest.importorskip("rhino3dm")
    model = rhino.File3dm()
    model.Settings.ModelUnitSystem = getattr(rhino.UnitSystem, unit)
    for net in meshes:
        mesh = rhino.Mesh()
        mesh.Vertices.UseDoublePrecisionVertices = True
        for point in net.vertices.tolist():
            mesh.Vertices.AddPoint3d(*point)
        for face in net.faces.tolist():
            mesh.Faces.AddFace(*face)
        model.Objects.AddMesh(mesh, rhino.ObjectAttributes())
    model.Write(str(path), 7)


@needed
def test_nets_are_read_with_their_unit(roof, tmp_path):
    for unit, word in (("Meters", "m"), ("Feet", "ft"), ("Millimeters", "mm")):
        rhino_file(tmp_path / "net.3dm", unit, roof)
        loaded = api.read_mesh(tmp_path / "net.3dm")
        assert loaded.unit == word
        np.testing.assert_array_equal(loaded.mesh.vertices, roof.vertices)
        np.testing.assert_array_equal(loaded.mesh.faces, roof.faces)
    rhino_file(tmp_path / "net.3dm", "Yards", roof)
    with pytest.raises(InputError, match=r"net\.3dm: the unit 'Yards' is not known"):
        api.read_mesh(tmp_path / "net.3dm")
    assert api.read_mesh(tmp_path / "net.3dm", unit="m").unit == "m"


@needed
def test_what_is_no_mesh_is_refused(tmp_path):
    rhino_file(tmp_path / "empty.3dm", "Meters")
    with pytest.raises(InputError, match=r"empty\.3dm: has no mesh in it; make one"):
        api.read_mesh(tmp_path / "empty.3dm")
    (tmp_path / "bad.3dm").write_bytes(b"3D Geometry File Format " + bytes(range(200)))
    with pytest.raises(InputError, match=r"bad\.3dm: cannot be read"):
        api.read_mesh(tmp_path / "bad.3dm")


def test_the_missing_library_is_named(tmp_path, monkeypatch):
    (tmp_path / "net.3dm").write_bytes(b"3D")
    monkeypatch.setattr(rhino_files, "find_spec", lambda name: None)
    monkeypatch.delitem(sys.modules, "rhino3dm", raising=False)
    with pytest.raises(InputError, match=r"needs the package 'rhino3dm'; install it"):
        api.read_mesh(tmp_path / "net.3dm")
