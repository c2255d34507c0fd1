"""3DM files: what Rhino's own library finds in them, and nets read from them."""

import sys
from importlib.util import find_spec
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from freecad_ortho import api, file_libraries, rhino_files
from freecad_ortho.__main__ import main
from freecad_ortho.curve_files import read_curves
from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.exchange.rhino import write_3dm
from freecad_ortho.fabrication.exchange.rhino_solids import solid_of
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver import read_mesh, write_mesh
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.meshes import grid

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
def test_parts_are_solids_where_their_sides_are_plane(roof, tmp_path):
    """Plates and hubs are extrusions, bevelled panels B-reps, a drilled tube stays a mesh."""
    import rhino3dm

    some = Selection(family="u", lines=(3,))
    systems = [Beams(200, 20, ends="end-plate"), Nodes("bolted"), Panels(20, 15, edge="bevel")]
    job = build(roof, systems, selection=some, place=Place(origin=FAR))
    model = {}
    for words in ("solids", "meshes"):
        path = tmp_path / f"{words}.3dm"
        shop = Workshop(rhino_parts=words)
        write_3dm(path, produce(job, shop), "Dach", lambda done: None)
        model[words] = by_layer(rhino3dm.File3dm.Read(str(path)))
    kinds = {"beam": "Extrusion", "end-plate": "Extrusion", "panel": "Brep", "node": "Mesh"}
    for part in job.parts:
        found = model["solids"][part.kind][part.name].Geometry
        assert type(found).__name__ == kinds[part.kind]
        assert type(model["meshes"][part.kind][part.name].Geometry).__name__ == "Mesh"
        if part.kind == "node":
            continue
        body = found.ToBrep(True) if part.kind != "panel" else found
        assert body.IsValid
        assert body.IsSolid
        holes = len(part.pattern.holes)
        assert (holes > 0) == (part.kind == "end-plate")
        if part.kind != "panel":
            assert len(body.Faces) == len(part.pattern.outline) + holes + 2
        places = (body.Vertices[k].Location for k in range(len(body.Vertices)))
        seen = np.array([[p.X, p.Y, p.Z] for p in places]) - FAR
        for end in (np.min, np.max):
            np.testing.assert_allclose(end(seen, axis=0), end(part.points, axis=0), atol=1e-4)
        drilled = sum(hole.diameter**2 for hole in part.pattern.holes) * np.pi / 4
        volume = part.volume + drilled * part.thickness
        assert ConvexHull(seen).volume == pytest.approx(volume, rel=1e-6)


@needed
@needed
def test_a_panel_with_an_opening_is_an_extrusion_with_one():
    import rhino3dm

    x, y = np.meshgrid(np.arange(2.0), np.arange(2.0), indexing="ij")
    net = grid(1000.0 * x, 1000.0 * y, 0 * x)
    turn = np.linspace(0, 2 * np.pi, 9)[:-1]
    ring = np.stack([500 + 200 * np.cos(turn), 500 + 200 * np.sin(turn), 0 * turn], axis=1)
    around = np.array([[-9.0, -9, 0], [1009, -9, 0], [1009, 1009, 0], [-9, 1009, 0]])
    (part,) = build(net, [Panels(20, 10)], border=[around, ring]).parts
    assert len(part.pattern.cutouts) == 1
    found = solid_of(rhino3dm, part, Place())
    assert found is not None
    body = found.ToBrep(True)
    assert body.IsValid and body.IsSolid
    assert len(body.Faces) == len(part.pattern.outline) + len(part.pattern.cutouts[0]) + 2


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
    monkeypatch.setattr(file_libraries, "find_spec", lambda name: None)
    monkeypatch.delitem(sys.modules, "rhino3dm", raising=False)
    with pytest.raises(InputError, match=r"needs the package 'rhino3dm'; install it"):
        api.read_mesh(tmp_path / "net.3dm")


def curve_file(path, unit):
    """A polyline, a circle of radius 2 about (5, 0, 1), and a mesh that is no curve."""
    import rhino3dm

    model = rhino3dm.File3dm()
    model.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, unit)
    corners = [rhino3dm.Point3d(*place) for place in ((0, 0, 0), (1, 0, 0), (1, 2, 0.5))]
    model.Objects.AddCurve(rhino3dm.PolylineCurve(corners))
    model.Objects.AddCircle(rhino3dm.Circle(rhino3dm.Point3d(5, 0, 1), 2.0))
    model.Objects.AddMesh(rhino3dm.Mesh())
    model.Write(str(path), 7)
    return path


@needed
@pytest.mark.parametrize(("unit", "scale"), [("Meters", 1000.0), ("Inches", 25.4), ("None", 1.0)])
def test_curves_come_in_the_unit_that_is_wanted(tmp_path, unit, scale):
    line, ring = read_curves(curve_file(tmp_path / "curves.3dm", unit), "mm")
    np.testing.assert_allclose(line, scale * np.array([[0, 0, 0], [1, 0, 0], [1, 2, 0.5]]))
    away = ring - scale * np.array([5, 0, 1])
    np.testing.assert_allclose(np.linalg.norm(away, axis=1), 2 * scale, rtol=1e-12)
    np.testing.assert_allclose(ring[0], ring[-1], atol=1e-9 * scale)
    assert np.abs(away[:, 2]).max() < 1e-9 * scale
    # As near to the curve as a thousandth of its radius.
    assert np.linalg.norm(np.diff(ring, axis=0), axis=1).max() < 0.09 * 2 * scale


@needed
def test_a_line_of_the_net_runs_along_a_curve_of_rhino(tmp_path):
    import rhino3dm

    x, y = np.meshgrid(np.linspace(0, 10, 21), np.linspace(0, 8, 17), indexing="ij")
    points = np.stack([x, y, 0.004 * x**2 + 0.012 * y**2], axis=-1).reshape(-1, 3)
    number = np.arange(21 * 17).reshape(21, 17)
    faces = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1)
    write_mesh(tmp_path / "surface.obj", QuadMesh(points, faces.reshape(-1, 4)), "m")
    at = np.linspace(0.5, 9.5, 60)
    across = 4 + 0.6 * np.sin(0.5 * at)
    curve = np.stack([at, across, 0.004 * at**2 + 0.012 * across**2], axis=-1)
    model = rhino3dm.File3dm()
    model.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Millimeters
    line = rhino3dm.PolylineCurve([rhino3dm.Point3d(*place) for place in (1000 * curve).tolist()])
    model.Objects.AddCurve(line)
    model.Write(str(tmp_path / "stroke.3dm"), 7)

    def turned(*options):
        """How far edges near the curve are turned from it, degrees, in the mean."""
        arguments = ["align", str(tmp_path / "surface.obj"), "--edge", "0.7"]
        out = tmp_path / "net.obj"
        assert main([*arguments, "-o", str(out), *options]) == 0
        net = read_mesh(out)
        ends = net.vertices[net.connectivity.edges]
        middles = ends.mean(axis=1)
        away = np.linalg.norm(middles[:, None] - curve[None], axis=2)
        near = away.min(axis=1) < 0.4
        along = np.gradient(curve, axis=0)[away[near].argmin(axis=1)]
        arms = ends[near, 1] - ends[near, 0]
        cosine = np.abs(np.einsum("ek,ek->e", along, arms))
        cosine /= np.linalg.norm(along, axis=1) * np.linalg.norm(arms, axis=1)
        angles = np.degrees(np.arccos(np.clip(cosine, 0, 1)))
        return float(np.minimum(angles, 90 - angles).mean())

    followed, free = turned("--stroke", str(tmp_path / "stroke.3dm")), turned()
    assert followed < 0.5 * free, (followed, free)


@needed
def test_files_without_curves_are_refused(tmp_path):
    rhino_file(tmp_path / "empty.3dm", "Meters")
    with pytest.raises(InputError, match=r"empty\.3dm: has no curve in it; draw one"):
        read_curves(tmp_path / "empty.3dm", "mm")


@needed
def test_cages_of_subdivision_are_meshes_too(monkeypatch):
    """The library makes no such surface, so the file is a stand-in; the rest is the library's."""
    import rhino3dm

    cage = rhino3dm.Mesh()
    for place in ((0, 0, 0), (2, 0, 0), (2, 3, 0), (0, 3, 1)):
        cage.Vertices.Add(*place)
    cage.Faces.AddFace(0, 1, 2, 3)
    held = SimpleNamespace(Geometry=rhino3dm.SubD())
    model = SimpleNamespace(Objects=[held], Settings=rhino3dm.File3dm().Settings)
    asked = []
    monkeypatch.setattr(
        rhino3dm.Mesh,
        "CreateFromSubDControlNet",
        staticmethod(lambda subd: asked.append(subd) or cage),
    )
    monkeypatch.setattr(rhino_files.RhinoReader, "_model", lambda self, path: model)
    points, faces, _, count = rhino_files.RhinoReader().polygons("cage.3dm")
    assert (count, asked) == (1, [held.Geometry])
    assert faces == [[0, 1, 2, 3]]
    assert points[2] == [2, 3, 0]
