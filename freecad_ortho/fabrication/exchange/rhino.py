"""3DM (Rhino 7): the net, its lines and axes, and all parts, on layers by kind; in mm."""

from __future__ import annotations

import base64
import uuid
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from freecad_ortho.fabrication.colours import colour_of
from freecad_ortho.fabrication.exchange.facets import facets
from freecad_ortho.fabrication.exchange.rhino_solids import solid_of
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.production import Production
from solver.mesh.quadmesh import FloatArray

_VERSION = 7
# Corners of triangles of one part that are as near, mm, are one.
_SAME_DIGITS = 6
# Of lines and of the net itself: red, green, blue, opacity.
_NET, _LINES, _AXES = (120, 120, 120, 255), (30, 60, 120, 255), (170, 60, 40, 255)
# The block of the file that holds its times: what it begins with, where both are, a day in 2000 as
# the C library counts: seconds, minutes, hours, day, month, year, day of the week and of the year.
_HISTORY, _TIMES = b"\x21\x80\x00\x20", (5, 41)
_DAY = np.array([0, 0, 0, 1, 0, 100, 6, 0], dtype="<i4").tobytes()


def write_3dm(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write the parts and the net they follow.

    Args:
        path: file to write.
        production: of the structure.
        project: its name; identifiers follow from it and from the names of parts.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    import rhino3dm

    model = _Model(rhino3dm, project)
    model.net(production)
    parts = production.structure.parts
    verdicts = production.verdicts
    for number, (part, verdict) in enumerate(zip(parts, verdicts, strict=True)):
        if number % 16 == 0:
            say(number / len(parts))
        model.part(part, verdict, production)
    path.write_bytes(model.data())


class _Model:
    """A file that grows."""

    def __init__(self, rhino: Any, project: str) -> None:
        self.rhino, self.file = rhino, rhino.File3dm()
        self.file.Settings.ModelUnitSystem = rhino.UnitSystem.Millimeters
        self.file.ApplicationName = "freecad_ortho"
        self.space = uuid.uuid5(uuid.NAMESPACE_URL, f"freecad_ortho/{project}")
        self.layers: dict[str, int] = {}

    def layer(self, name: str, colour: tuple[int, int, int, int]) -> int:
        """Number of the layer of a name."""
        if name not in self.layers:
            layer = self.rhino.Layer()
            layer.Name, layer.Color = name, (*colour[:3], 255)
            layer.Id = uuid.uuid5(self.space, f"layer {name}")
            self.layers[name] = self.file.Layers.Add(layer)
        return self.layers[name]

    def attributes(self, name: str, layer: int) -> Any:
        """Name, layer and identifier of an object."""
        made = self.rhino.ObjectAttributes()
        made.Name, made.LayerIndex = name, layer
        made.Id = uuid.uuid5(self.space, f"object {layer} {name}")
        return made

    def mesh(self, points: FloatArray, faces: list[list[int]]) -> Any:
        """A mesh of triangles and quads."""
        made = self.rhino.Mesh()
        made.Vertices.UseDoublePrecisionVertices = True
        for point in points.tolist():
            made.Vertices.AddPoint3d(*point)
        for face in faces:
            made.Faces.AddFace(*face)
        made.Normals.ComputeNormals()
        return made

    def line(self, points: FloatArray, name: str, layer: int) -> None:
        """A polyline through points (n, 3)."""
        corners = [self.rhino.Point3d(*point) for point in points.tolist()]
        curve = self.rhino.PolylineCurve(corners)
        self.file.Objects.AddCurve(curve, self.attributes(name, layer))

    def net(self, production: Production) -> None:
        """The net as a mesh of quads, its parameter lines, and the axes of the nodes.

        Where faces have several sizes the mesh is one of triangles.
        """
        structure = production.structure
        site, place = structure.site, structure.place
        points = place.points(site.mesh.vertices + site.shift)
        net = site.mesh.connectivity
        made = self.mesh(points, net.triangles.tolist() if net.mixed else net.polygons)
        self.file.Objects.AddMesh(made, self.attributes("net", self.layer("net", _NET)))
        layer = self.layer("lines", _LINES)
        for line in site.chosen_lines:
            self.line(points[line.vertices], f"{line.family}{line.number}", layer)
        layer, names = self.layer("axes", _AXES), part_names("N", len(points))
        reach = 0.1 * site.mesh.mean_edge
        for node in production.nodes:
            tip = points[node.vertex] + reach * place.directions(node.axis)
            self.line(np.array([points[node.vertex], tip]), names[node.vertex], layer)

    def part(self, part: Part, verdict: str, production: Production) -> None:
        """A part as a closed mesh or a solid, with what is known of it as texts."""
        attributes = self.attributes(part.name, self.layer(part.kind, colour_of(part.material)))
        facts = {"material": part.material.name, "verdict": verdict, "mass_kg": f"{part.mass:.3f}"}
        if part.line is not None:
            facts["line"] = f"{part.family}{part.line}"
        for name, value in facts.items():
            attributes.SetUserString(name, value)
        solid = None
        if production.workshop.rhino_parts == "solids":
            solid = solid_of(self.rhino, part, production.structure.place)
        if solid is None:
            self.file.Objects.AddMesh(self._closed(part, production), attributes)
        elif isinstance(solid, self.rhino.Extrusion):
            self.file.Objects.AddExtrusion(solid, attributes)
        else:
            self.file.Objects.AddBrep(solid, attributes)

    def _closed(self, part: Part, production: Production) -> Any:
        """A part as a closed mesh of triangles."""
        corners = facets(part).triangles.reshape(-1, 3)
        keys = np.round(corners, _SAME_DIGITS)
        _, first, numbers = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        place = production.structure.place
        points = place.points(part.origin + corners[first] @ part.frame)
        triangles = numbers.reshape(-1, 3)
        return self.mesh(points, triangles.tolist())

    def data(self) -> bytes:
        """The bytes of the file, without a clock: the same structure gives the same."""
        options = self.rhino.File3dmWriteOptions()
        options.Version = _VERSION
        data = bytearray(base64.b64decode(self.file.Encode(options)))
        start = data.index(_HISTORY) + 12
        end = start + int.from_bytes(data[start - 8 : start], "little") - 4
        for place in _TIMES:
            data[start + place : start + place + len(_DAY)] = _DAY
        data[end : end + 4] = zlib.crc32(data[start:end]).to_bytes(4, "little")
        return bytes(data)
