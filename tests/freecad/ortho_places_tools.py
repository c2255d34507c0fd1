"""Nets far from the origin and parts that are turned, for suites on where things stand."""

import json

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import DocumentCase

from freecad_ortho import api
from freecad_ortho.fabrication.step import read_step

# National grid coordinates in mm: no float of seven digits tells these meshes' vertices apart.
OFFSET = np.array([500123250.0, 5412345500.0, 412000.0])
SMALL = {"rows": 4, "columns": 5}
TURNED = FreeCAD.Placement(
    FreeCAD.Vector(3000, -2000, 500), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40)
)


def placed(points, *placements):
    for place in reversed(placements):
        points = np.array([tuple(place.multVec(FreeCAD.Vector(*point))) for point in points])
    return points


class PlaceCase(DocumentCase):
    def far_file(self, name="far", offset=OFFSET):
        near = api.read_mesh(tools.wavy_mesh(**SMALL))
        path = tools.SCRATCH / f"{name}.obj"
        mesh = near.mesh.with_vertices((near.mesh.vertices + offset) / 1000)
        api.write_mesh(path, mesh, "m")
        return path

    def part(self, *features, placement=TURNED):
        part = self.document.addObject("App::Part", "Part")
        part.Placement = placement
        for feature in features:
            part.addObject(feature)
        self.document.recompute()
        return part

    def written(self, structures, **settings):
        """Centres of the solids in a STEP file by their names, and the report."""
        folder = tools.SCRATCH / "files"
        api.export_fabrication(structures, folder, **settings)
        report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        found = read_step(folder / "structure.step")
        return {name: np.array(shape.Center().toTuple()) for name, shape in found}, report

    def seen(self, feature):
        """Centres of a structure's solids where FreeCAD shows them."""
        own = feature.Shape.copy()
        own.Placement = feature.getGlobalPlacement()
        centres = [np.array(tuple(solid.CenterOfMass)) for solid in own.Solids]
        return dict(zip(feature.PartNames, centres, strict=True))

    def assertTurned(self, feature):
        found, expected = feature.Placement.toMatrix().A, TURNED.toMatrix().A
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-9)

    def assertSamePlaces(self, found, expected, within=1e-3):
        self.assertEqual(set(found), set(expected))
        for name, place in found.items():
            np.testing.assert_allclose(place, expected[name], rtol=0, atol=within)
