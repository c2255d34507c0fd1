"""IFC 4: site, building, storey, in it a grid and assemblies of parts and bolts.

Classes, quantities and units are those of ISO 16739-1. Sides that are plane are exact, bent ones
are triangles within ``facets.CHORD`` or exact too, by choice. Parts that agree within the STEP
tolerance share a geometry.
"""

from __future__ import annotations

import uuid
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho import __version__
from freecad_ortho.fabrication.bolts import GRADE
from freecad_ortho.fabrication.colours import colour_of
from freecad_ortho.fabrication.datum import Datum
from freecad_ortho.fabrication.equal import copies
from freecad_ortho.fabrication.exchange.facets import Facets, facets, has_plane_sides, solid_of
from freecad_ortho.fabrication.exchange.ifc_assemblies import assembly_names
from freecad_ortho.fabrication.exchange.ifc_breps import advanced_brep
from freecad_ortho.fabrication.exchange.ifc_colours import Styles
from freecad_ortho.fabrication.exchange.ifc_facts import Facts, class_of
from freecad_ortho.fabrication.exchange.ifc_fasteners import fastener_type
from freecad_ortho.fabrication.exchange.ifc_grid import grid
from freecad_ortho.fabrication.exchange.ifc_profiles import profile_definition
from freecad_ortho.fabrication.fasteners import Fasteners, named
from freecad_ortho.fabrication.hardware import bolt_frames
from freecad_ortho.fabrication.material import material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles.catalogue import profile
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import ifcopenshell

# The same structure gives the same file: no clock.
_TIME = "2000-01-01T00:00:00"
# Of corners in mm: far below the CAD kernel's tolerance of points, and half as long to write.
_DIGITS = 7
# What the coordinates of the site are called; which grid they are of is known there.
_SITE = "site"
_BOLT_STEEL = f"bolt steel {GRADE}"


def write_ifc(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write all parts of a structure.

    Args:
        path: file to write.
        production: of the structure.
        project: its name; identifiers follow from it and from the names of parts, and stay the
            same from run to run.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    import ifcopenshell

    model = _Model(ifcopenshell.file(schema="IFC4"), project or "structure")
    model.head(path.name)
    model.fill(production, say)
    model.file.write(str(path))


@dataclass
class _Group:
    """What stands together in an assembly.

    Attributes:
        place: of the assembly.
        elements: parts and bolts.
        panes: whether all parts are panes of glass.
    """

    place: Any
    elements: list[Any] = field(default_factory=list)
    panes: bool = True

    def add(self, part: Part, element: Any) -> None:
        """Take a part in."""
        self.elements.append(element)
        self.panes &= part.kind == "panel" and "glass" in part.material.name


class _Model:
    """An IFC file that grows."""

    def __init__(self, file: ifcopenshell.file, project: str) -> None:
        self.file, self.project = file, project
        self.space = uuid.uuid5(uuid.NAMESPACE_URL, f"freecad_ortho/{project}")
        self.materials: dict[tuple[str, str], list[Any]] = {}
        self.styles = Styles(self.make)

    def make(self, kind: str, *values: Any) -> Any:
        """An entity of attributes in their order."""
        return self.file.create_entity(kind, *values)

    def guid(self, key: str) -> str:
        """Identifier of what has this key in the project."""
        from ifcopenshell import guid

        return str(guid.compress(uuid.uuid5(self.space, key).hex))

    def head(self, name: str) -> None:
        """The file's own name and time."""
        header = self.file.header
        header.file_name.name = name
        header.file_name.time_stamp = _TIME
        header.file_name.preprocessor_version = f"freecad_ortho {__version__}"
        header.file_name.originating_system = f"freecad_ortho {__version__}"

    def fill(self, production: Production, say: Callable[[float], None]) -> None:
        """All from the project down to the parts."""
        structure = production.structure
        body = self._project(production.workshop.datum.of_files(structure.file_origin))
        site = self._spatial("IfcSite", structure.place.origin, structure.place.rotation, None)
        building = self._spatial("IfcBuilding", np.zeros(3), np.eye(3), site)
        storey = self._spatial("IfcBuildingStorey", np.zeros(3), np.eye(3), building)
        self._aggregate("site", self.root, [site])
        self._aggregate("building", site, [building])
        self._aggregate("storey", building, [storey])
        by = production.workshop.ifc_assemblies
        names = assembly_names(structure, by)
        groups = {
            name: _Group(
                self.make(
                    "IfcLocalPlacement", storey.ObjectPlacement, self._axes(np.zeros(3), np.eye(3))
                )
            )
            for name in dict.fromkeys(names.values())
        }
        owners = {name: groups[group] for name, group in names.items()}
        facts = Facts(self.make, self.guid, production)
        bolts = {id(each): names for each, names in named(structure.fasteners)}
        made = 0
        for result in structure.results.values():

            def go_on(done: int, before: int = made) -> None:
                say((before + done) / len(structure.parts))

            self._parts(result.parts, owners, body, facts, go_on)
            made += len(result.parts)
            # Bolts of a system stand in its assembly, else in that of the first part they join.
            own = owners[result.parts[0].name]
            for each in result.fasteners:
                joined = [own if by == "systems" else owners.get(n[0], own) for n in each.joins]
                self._fasteners(each, bolts.get(id(each), []), joined, body)
        contents = [self._assembly(name, group) for name, group in groups.items()]
        lines = grid(self.make, self.guid, structure, storey, self.root.RepresentationContexts[0])
        self.make(
            *("IfcRelContainedInSpatialStructure", self.guid("contained"), None, None, None),
            *([*contents, lines] if lines is not None else contents, storey),
        )
        self._materials()

    def _materials(self) -> None:
        """Materials, of bars with the profile that they have in the catalogue."""
        made: dict[str, Any] = {}
        for (name, section), parts in self.materials.items():
            if name not in made:
                made[name] = self.make("IfcMaterial", name, None, None)
            shape = profile_definition(self.make, profile(section)) if section else None
            used = made[name]
            if shape is not None:
                bar = self.make("IfcMaterialProfile", section, None, used, shape, None, None)
                used = self.make("IfcMaterialProfileSet", section, None, [bar], None)
            key = f"material {name} {section}".strip()
            self.make(
                *("IfcRelAssociatesMaterial", self.guid(key), None, None, None, parts, used),
            )

    def _project(self, datum: Datum) -> Any:
        """The project with its units; the context of bodies; where it is on site."""
        units = [
            self.make("IfcSIUnit", None, kind, prefix, name)
            for kind, prefix, name in (
                ("LENGTHUNIT", "MILLI", "METRE"),
                ("AREAUNIT", None, "SQUARE_METRE"),
                ("VOLUMEUNIT", None, "CUBIC_METRE"),
                ("PLANEANGLEUNIT", None, "RADIAN"),
                ("MASSUNIT", "KILO", "GRAM"),
            )
        ]
        axes = self._axes(np.zeros(3), np.eye(3))
        context = self.make("IfcGeometricRepresentationContext", None, "Model", 3, 1e-6, axes, None)
        if datum.is_known:
            self._on_site(context, datum)
        self.root = self.make(
            *("IfcProject", self.guid("project"), None, self.project, None, None, None, None),
            *([context], self.make("IfcUnitAssignment", units)),
        )
        return self.make(
            *("IfcGeometricRepresentationSubContext", "Body", "Model", None, None, None, None),
            *(context, None, "MODEL_VIEW", None),
        )

    def _on_site(self, context: Any, datum: Datum) -> None:
        """From the coordinates of the file, mm, to those of the site, m."""
        metre = self.make("IfcSIUnit", None, "LENGTHUNIT", None, "METRE")
        system = self.make("IfcProjectedCRS", _SITE, None, None, None, None, None, metre)
        towards = datum.turn[:, 0].tolist()
        self.make(
            *("IfcMapConversion", context, system, datum.east, datum.north, datum.height),
            *(towards[0], towards[1], 1e-3),
        )

    def _axes(self, origin: FloatArray, frame: FloatArray) -> Any:
        """A place of an origin (3,) and of axes that are the rows of a frame (3, 3)."""
        point = self.make("IfcCartesianPoint", origin.tolist())
        z, x = (self.make("IfcDirection", frame[row].tolist()) for row in (2, 0))
        return self.make("IfcAxis2Placement3D", point, z, x)

    def _spatial(self, kind: str, origin: FloatArray, rotation: FloatArray, above: Any) -> Any:
        relative = None if above is None else above.ObjectPlacement
        place = self.make("IfcLocalPlacement", relative, self._axes(origin, rotation.T))
        known = [self.guid(kind), None, kind[3:], None, None, place, None, None, "ELEMENT"]
        more = {"IfcSite": 5, "IfcBuilding": 3, "IfcBuildingStorey": 1}[kind]
        return self.make(kind, *known, *[None] * more)

    def _aggregate(self, key: str, whole: Any, parts: list[Any]) -> None:
        self.make("IfcRelAggregates", self.guid(f"of {key}"), None, None, None, whole, parts)

    def _assembly(self, name: str, group: _Group) -> Any:
        """What holds parts: a curtain wall where all of them are panes."""
        known = [self.guid(f"assembly {name}"), None, name, None, None, group.place, None, None]
        if group.panes:
            assembly = self.make("IfcCurtainWall", *known, "NOTDEFINED")
        else:
            assembly = self.make("IfcElementAssembly", *known, "FACTORY", "NOTDEFINED")
        self._aggregate(f"assembly {name}", assembly, group.elements)
        return assembly

    def _parts(
        self,
        parts: tuple[Part, ...],
        owners: Mapping[str, _Group],
        body: Any,
        facts: Facts,
        say: Callable[[int], None],
    ) -> None:
        maps: dict[int, Any] = {}
        users: dict[int, list[Any]] = {}
        same = copies(parts, facts.production.workshop.step_tolerance)
        shared = {copy.first for number, copy in enumerate(same) if copy.first != number}
        for number, (part, copy) in enumerate(zip(parts, same, strict=True)):
            if number % 16 == 0:
                say(number)
            if copy.first == number:
                exact = facts.production.workshop.ifc_parts == "exact"
                shape = self._shape_of(part, body, exact)
                self.styles.paint(shape.Items, part.material.name, colour_of(part.material))
                if number in shared:
                    maps[number] = self._type(part, shape)
            else:
                shape = None
            if copy.first in maps:
                shape = self._mapped(maps[copy.first], copy.turn, copy.shift, body)
            element = self._element(part, owners[part.name], shape)
            users.setdefault(copy.first, []).append(element)
            facts.describe(part, element)
        for first, (_, kind) in maps.items():
            key = f"of type {parts[first].name}"
            self.make("IfcRelDefinesByType", self.guid(key), None, None, None, users[first], kind)

    def _fasteners(
        self, bolts: Fasteners, names: list[str], owners: list[_Group], body: Any
    ) -> None:
        """Bolts that are alike, each with what it joins."""
        if not names:
            return
        key = f"bolts from {names[0]}"
        kind, shared = fastener_type(self.make, self.guid, key, bolts, body)
        items = shared.MappedRepresentation.Items
        self.styles.paint(items, _BOLT_STEEL, colour_of(material("steel")))
        origin = self.make("IfcCartesianPoint", [0.0, 0.0, 0.0])
        operator = self.make("IfcCartesianTransformationOperator3D", None, None, origin, None, None)
        found = []
        rows = zip(names, bolts.places, bolt_frames(bolts), bolts.joins, owners, strict=True)
        for name, point, frame, joins, owner in rows:
            item = self.make("IfcMappedItem", shared, operator)
            shape = self.make(
                "IfcShapeRepresentation", body, "Body", "MappedRepresentation", [item]
            )
            own = self.make("IfcLocalPlacement", owner.place, self._axes(point, frame))
            form = self.make("IfcProductDefinitionShape", None, None, [shape])
            found.append(
                self.make(
                    *("IfcMechanicalFastener", self.guid(f"bolt {name}"), None, name),
                    *(f"joins {', '.join(joins)}", bolts.name, own, form, None),
                    *(bolts.bolt.diameter, float(bolts.length), "BOLT"),
                )
            )
            owner.elements.append(found[-1])
        self.materials.setdefault((_BOLT_STEEL, ""), []).extend(found)
        self.make("IfcRelDefinesByType", self.guid(f"of type {key}"), None, None, None, found, kind)

    def _shape_of(self, part: Part, body: Any, exact: bool) -> Any:
        """The sides of a part; bent ones as facets where they are not to be exact, or cannot."""
        if exact and not has_plane_sides(part):
            item = advanced_brep(self.make, solid_of(part))
            if item is not None:
                return self.make("IfcShapeRepresentation", body, "Body", "AdvancedBrep", [item])
        return self._shape(facets(part), body)

    def _shape(self, sides: Facets, body: Any) -> Any:
        points = self.make("IfcCartesianPointList3D", np.round(sides.points, _DIGITS).tolist())
        rings = [[[int(k) + 1 for k in ring] for ring in rings] for rings in sides.sides]
        if sides.exact:
            faces = [
                self.make("IfcIndexedPolygonalFaceWithVoids", outer, openings)
                if openings
                else self.make("IfcIndexedPolygonalFace", outer)
                for outer, *openings in rings
            ]
            item = self.make("IfcPolygonalFaceSet", points, True, faces, None)
        else:
            around = [outer for outer, *_ in rings]
            item = self.make("IfcTriangulatedFaceSet", points, None, True, around, None)
        return self.make("IfcShapeRepresentation", body, "Body", "Tessellation", [item])

    def _type(self, part: Part, shape: Any) -> tuple[Any, Any]:
        """The geometry that equal parts share, and their type."""
        kind, word, _ = class_of(part)
        origin = self._axes(np.zeros(3), np.eye(3))
        shared = self.make("IfcRepresentationMap", origin, shape)
        key = f"type {part.name}"
        return shared, self.make(
            *(f"{kind}Type", self.guid(key), None, part.name, None, None, None, [shared], None),
            *(None, word),
        )

    def _mapped(
        self, shared: tuple[Any, Any], turn: FloatArray, shift: FloatArray, body: Any
    ) -> Any:
        point = self.make("IfcCartesianPoint", shift.tolist())
        x, y, z = (self.make("IfcDirection", row.tolist()) for row in turn.astype(float))
        operator = self.make("IfcCartesianTransformationOperator3D", x, y, point, 1.0, z)
        item = self.make("IfcMappedItem", shared[0], operator)
        return self.make("IfcShapeRepresentation", body, "Body", "MappedRepresentation", [item])

    def _element(self, part: Part, owner: _Group, shape: Any) -> Any:
        kind, word, _ = class_of(part)
        own = self.make("IfcLocalPlacement", owner.place, self._axes(part.origin, part.frame))
        form = self.make("IfcProductDefinitionShape", None, None, [shape])
        element = self.make(
            *(kind, self.guid(f"part {part.name}"), None, part.name, None, part.kind, own, form),
            *(part.name, word),
        )
        owner.add(part, element)
        body = part.body
        standard = isinstance(body, ProfiledBody) and bool(body.profile.standard)
        section = part.section if standard else ""
        self.materials.setdefault((part.material.name, section), []).append(element)
        return element
