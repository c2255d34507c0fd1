"""Picture of docs/exchange.md: a part of the demo roof as other readers take it out of the files.

Run with the project's Python:  python scripts/docs_exchange_read.py
Needs the packages of requirements-exchange.txt and requirements-dev.txt.

Shapes, places, names and colours are those of the files alone: cadquery reads STEP, IfcOpenShell
IFC, trimesh glTF and rhino3dm 3DM. Below each picture: how many parts it found, and their volume.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import small_pictures
from matplotlib import pyplot as plt
from matplotlib.axes import Axes

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication import Structure  # noqa: E402
from solver import QuadMesh  # noqa: E402

NET = ROOT / "examples" / "data" / "demo_roof.obj"
PICTURE = ROOT / "docs" / "pictures" / "exchange" / "read.png"
# Faces about the highest one that are built.
FACES = 24
# From where it is seen, and how many points a picture is wide and high.
TOWARDS = np.array([-0.45, 0.62, -0.64])
WIDE, HIGH = 1400, 840
INK = "#26292f"


class Seen(NamedTuple):
    """A part as it was read.

    Attributes:
        name: of the part.
        triangles: (t, 3, 3) corners in mm, z upwards.
        colour: (4,) red, green, blue and opacity between 0 and 1.
    """

    name: str
    triangles: np.ndarray
    colour: np.ndarray


def main() -> int:
    """Write the four files, read them and draw what was read."""
    structure = piece()
    expected = sum(part.volume for part in structure.parts)
    figure, places = plt.subplots(2, 2, figsize=(10, 7.2), dpi=100)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        api.write_fabrication(structure, folder, project="demo roof", write="ifc,glb,3dm")
        for axes, (title, read) in zip(places.flat, READERS.items(), strict=True):
            parts = list(read(folder))
            volume = sum(volume_of(part.triangles) for part in parts)
            assert {part.name for part in parts} == {part.name for part in structure.parts}
            assert abs(volume / expected - 1) < 1e-3, (title, volume, expected)
            show(axes, title, f"{len(parts)} parts, {volume * 1e-9:.4f} m3", parts)
            print(f"{title}: {len(parts)} parts, volume off by {volume / expected - 1:.1e}")
    figure.subplots_adjust(0.01, 0.03, 0.99, 0.96, 0.02, 0.14)
    small_pictures.save(figure, PICTURE, 128)
    return 0


def piece() -> Structure:
    """Beams, hubs and panes on the highest faces of the exact demo roof."""
    loaded = api.read_mesh(NET)
    mesh = api.optimise(loaded.mesh, "principal").mesh
    centres = mesh.vertices[mesh.faces].mean(axis=1)
    far = np.linalg.norm(centres - centres[centres[:, 2].argmax()], axis=1)
    used, faces = np.unique(mesh.faces[np.sort(far.argsort()[:FACES])], return_inverse=True)
    part = QuadMesh(mesh.vertices[used], faces.reshape(-1, 4))
    return api.fabricate(
        part,
        "nodes+beams+panels",
        section="GL24h:80x200",
        ends="hub",
        hub_diameter=260.0,
        material="nodes=steel,panels=toughened-glass",
        unit=loaded.unit,
    )


def volume_of(triangles: np.ndarray) -> float:
    """Volume within closed triangles, mm3; from a point nearby, to lose no digits."""
    corners = triangles - triangles[0, 0]
    across = np.cross(corners[:, 1], corners[:, 2])
    return float(np.einsum("tk,tk->", corners[:, 0], across)) / 6


def of_step(folder: Path) -> Iterator[Seen]:
    """Solids of the STEP file, by cadquery."""
    import cadquery

    for shape, name, place, colour in cadquery.Assembly.load(str(folder / "structure.step")):
        points, faces = shape.moved(place).tessellate(0.05, 0.2)
        corners = np.array([point.toTuple() for point in points])
        seen = colour.toTuple() if colour else (0.0, 0.0, 0.0, 1.0)
        yield Seen(name.split("/")[-1], corners[np.array(faces)], np.array(seen))


def of_ifc(folder: Path) -> Iterator[Seen]:
    """Elements of the IFC file that have a shape, by IfcOpenShell."""
    import ifcopenshell
    from ifcopenshell import geom

    model = ifcopenshell.open(folder / "structure.ifc")
    settings = geom.settings()
    settings.set("use-world-coords", True)
    for product in model.by_type("IfcElement"):
        if product.Representation:
            made = geom.create_shape(settings, product).geometry
            corners = 1000 * np.reshape(made.verts, (-1, 3))
            style = made.materials[0]
            clear = style.transparency if style.has_transparency() else 0.0
            colour = np.array([*style.diffuse.components, 1 - clear])
            yield Seen(product.Name, corners[np.reshape(made.faces, (-1, 3))], colour)


def of_glb(folder: Path) -> Iterator[Seen]:
    """Meshes of the glTF file, by trimesh."""
    import trimesh

    scene = trimesh.load_scene(folder / "structure.glb")
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        mesh = scene.geometry[name].copy().apply_transform(matrix)
        x, y, z = np.moveaxis(1000 * np.asarray(mesh.triangles), -1, 0)
        colour = np.asarray(mesh.visual.material.main_color) / 255
        yield Seen(name, np.stack([x, -z, y], axis=-1), colour)


def of_3dm(folder: Path) -> Iterator[Seen]:
    """Closed meshes of the 3DM file, by rhino3dm."""
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(folder / "structure.3dm"))
    for each in model.Objects:
        mesh = each.Geometry
        if isinstance(mesh, rhino3dm.Mesh) and mesh.IsClosed:
            points = [mesh.Vertices[number] for number in range(len(mesh.Vertices))]
            corners = np.array([[point.X, point.Y, point.Z] for point in points])
            faces = np.array([mesh.Faces[number] for number in range(len(mesh.Faces))])
            # A quad is two triangles, a triangle has its last corner twice.
            both = np.concatenate([faces[:, :3], faces[faces[:, 2] != faces[:, 3]][:, [0, 2, 3]]])
            colour = each.Attributes.DrawColor(model)
            yield Seen(each.Attributes.Name, corners[both], np.array(colour) / 255)


READERS = {
    "STEP, read by cadquery": of_step,
    "IFC, read by IfcOpenShell": of_ifc,
    "glTF, read by trimesh": of_glb,
    "3DM, read by rhino3dm": of_3dm,
}


def show(axes: Axes, title: str, words: str, parts: list[Seen]) -> None:
    """Draw the parts, with what was read above and what it comes to below."""
    axes.imshow(rendered(parts))
    axes.axis("off")
    axes.set_title(title, fontsize=12, color=INK)
    axes.text(0.5, -0.02, words, transform=axes.transAxes, ha="center", va="top", color=INK)


def rendered(parts: list[Seen]) -> np.ndarray:
    """An image of the parts from above, (HIGH, WIDE, 3) bytes."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for part in parts:
        for actor in actors(part):
            renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(WIDE, HIGH)
    window.SetAlphaBitPlanes(1)
    window.SetMultiSamples(0)
    renderer.SetUseDepthPeeling(1)
    renderer.SetUseFXAA(1)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*-TOWARDS)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.75)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(HIGH, WIDE, -1)[::-1, :, :3]


def actors(part: Seen) -> list:
    """The sides of a part in its colour, and its edges that are not smooth as lines."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    corners = part.triangles.reshape(-1, 3)
    _, first, numbers = np.unique(corners.round(2), axis=0, return_index=True, return_inverse=True)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(corners[first]), deep=True))
    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(numbers.reshape(-1).astype(np.int64), deep=True))
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(mesh)
    edges.SetFeatureAngle(30)
    edges.ColoringOff()
    made = []
    for source, colour in ((mesh, part.colour), (edges, (0.15, 0.16, 0.18, 1))):
        mapper = vtk.vtkPolyDataMapper()
        if source is mesh:
            mapper.SetInputData(mesh)
        else:
            mapper.SetInputConnection(edges.GetOutputPort())
            mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0, -2)
            mapper.SetResolveCoincidentTopologyToPolygonOffset()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*colour[:3])
        actor.GetProperty().SetOpacity(colour[3])
        actor.GetProperty().SetInterpolationToFlat()
        if source is not mesh:
            actor.GetProperty().LightingOff()
        made.append(actor)
    return made


if __name__ == "__main__":
    sys.exit(main())
