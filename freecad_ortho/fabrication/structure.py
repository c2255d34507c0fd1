"""From a mesh and systems to all parts of a structure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.fasteners import Fasteners, Supply
from freecad_ortho.fabrication.limits import OK, Limits, verdict, von_mises
from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.site import Selection, Site
from freecad_ortho.fabrication.solids import compound, solid_bytes
from freecad_ortho.fabrication.systems.system import System, SystemParts
from freecad_ortho.fabrication.workers import in_chunks
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin, measured_from
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.seams import seams
from solver.offset.axes import Axes

if TYPE_CHECKING:
    import cadquery

Progress = Callable[[float, str], None]
# A border beyond the net by less, mm, is not worth a word.
_MISSED = 1.0


@dataclass(frozen=True, eq=False)
class Structure:
    """All parts of a net, system by system.

    Mesh, parts and solids of a net that is far from the origin lie about a local origin: there no
    digits are lost, and the CAD kernel's tolerance means something.

    Attributes:
        mesh: the mesh, mm.
        site: where the systems were built; its mesh lies near the origin.
        results: what each system made, by its name.
        limits: what the parts of each system are held against, by its name.
        place: puts what lies about the local origin where it stands in files.
        origin: (3,) the local origin in the coordinates of the model, mm; zero where it is near.
        file_origin: (3,) what coordinates in files are measured from, in those of the model, mm.
        shift: (3,) what was taken off the mesh that was given, mm.
    """

    mesh: QuadMesh
    site: Site
    results: Mapping[str, SystemParts]
    limits: Mapping[str, Limits]
    place: Place = field(default_factory=Place)
    origin: FloatArray = field(default_factory=lambda: np.zeros(3))
    file_origin: FloatArray = field(default_factory=lambda: np.zeros(3))
    shift: FloatArray = field(default_factory=lambda: np.zeros(3))

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """All parts, in the order of the systems."""
        return tuple(part for result in self.results.values() for part in result.parts)

    @property
    def fasteners(self) -> tuple[Fasteners, ...]:
        """Bolts of all systems, in the coordinates of the parts."""
        return tuple(each for result in self.results.values() for each in result.fasteners)

    @property
    def supplies(self) -> tuple[Supply, ...]:
        """What else is bought."""
        return tuple(each for result in self.results.values() for each in result.supplies)

    @property
    def axes(self) -> Axes:
        """At the vertices."""
        return self.site.axes

    @cached_property
    def verdicts(self) -> tuple[str, ...]:
        """For each part "ok", or in one sentence what exceeds which limit."""
        return tuple(
            verdict(part, self.limits[name])
            for name, result in self.results.items()
            for part in result.parts
        )

    def common_limit(self, measure: str) -> float | None:
        """The limit of a measure that all systems share; None where they differ or have none."""
        values = {getattr(self.limits[name], measure, None) for name in self.results}
        return values.pop() if len(values) == 1 else None

    @property
    def masses(self) -> dict[str, float]:
        """Mass of the parts of each material, kg, by its name, the heaviest first."""
        found: dict[str, float] = {}
        for part in self.parts:
            found[part.material.name] = found.get(part.material.name, 0.0) + part.mass
        return dict(sorted(found.items(), key=lambda entry: -entry[1]))

    def only(self, *names: str) -> Structure:
        """Return the parts of these systems alone, built as they are beside the others."""
        return replace(self, results={name: self.results[name] for name in names})

    def measured_from(self, origin: str | Sequence[float]) -> Structure:
        """The same with coordinates in files measured from elsewhere.

        Args:
            origin: ``keep`` for the model's own, ``local`` for the local origin, or a point, mm.

        Raises:
            InputError: neither a word nor a point.
        """
        point = measured_from(origin, self.origin)
        moved = point - self.file_origin
        return replace(self, place=self.place.less(moved), file_origin=point)

    def compound(self, progress: Progress | None = None) -> cadquery.Compound:
        """Return one shape with the solids in the order of ``parts``, mm."""
        return compound(self.solids(progress))

    def solids(
        self, progress: Progress | None = None, executor: Executor | None = None
    ) -> list[cadquery.Solid]:
        """Return the solids in the order of ``parts``, mm; built once.

        Args:
            progress: called with a fraction and words; may raise to stop.
            executor: builds them elsewhere; those whose bodies are slow to build.
        """
        say = progress or (lambda fraction, words: None)
        if executor is not None:
            self._build_elsewhere(say, executor)
        result = []
        for number, part in enumerate(self.parts):
            if number % 64 == 0 or not part.body.quick:
                say(number / len(self.parts), f"solid {number + 1} of {len(self.parts)}")
            result.append(part.solid())
        return result

    def _build_elsewhere(self, say: Progress, executor: Executor) -> None:
        missing = [part for part in self.parts if not (part.has_solid or part.body.quick)]
        bodies = [part.body for part in missing]
        made = in_chunks(solid_bytes, bodies, executor, lambda done: say(0.0, "solids"))
        for part, data in zip(missing, made, strict=True):
            part.take_solid(data)

    def report(self) -> dict[str, Any]:
        """Return counts, accuracy, masses, verdict and remarks, ready for JSON; lengths in mm."""
        return {
            "unit": "mm",
            "systems": list(self.results),
            "counts": {
                "vertices": len(self.mesh.vertices),
                "edges": len(self.mesh.connectivity.edges),
                "faces": self.mesh.connectivity.face_count,
                **{name: len(result.parts) for name, result in self.results.items()},
            },
            "planarity_gap_max_mm": float(diagonal_distances(self.site.mesh).max()),
            "lean_max_deg": float(self.axes.lean_deg.max()),
            "materials": self._materials(),
            "volume_mm3": sum(part.volume for part in self.parts),
            "mass_kg": sum(part.mass for part in self.parts),
            "verdict": self._verdict(),
            "origin_mm": self.origin.tolist(),
            "file_origin_mm": self.file_origin.tolist(),
            **{name: result.report for name, result in self.results.items()},
            "messages": self._messages(),
        }

    def _materials(self) -> dict[str, Any]:
        """What is made of each material, by its name."""
        known = {part.material.name: part.material for part in self.parts}
        return {
            name: {
                "density_kg_m3": known[name].density,
                "parts": sum(part.material.name == name for part in self.parts),
                "volume_mm3": sum(p.volume for p in self.parts if p.material.name == name),
                "mass_kg": mass,
            }
            for name, mass in self.masses.items()
        }

    def _messages(self) -> list[str]:
        """What the systems say, after what is to be said about the mesh."""
        said = [word for result in self.results.values() for word in result.messages]
        return [*seams(self.mesh).remarks(), *self._far(), *self._missed(), *said]

    def _missed(self) -> list[str]:
        """Where the border is beyond the net."""
        trimming = self.site.trimming
        if trimming is None or trimming.missed < _MISSED:
            return []
        return [
            f"border: the net ends before it along {trimming.missed / 1000:.3g} m, and is not cut "
            "there"
        ]

    def _far(self) -> list[str]:
        """Where coordinates are measured from, where that is not the model's origin."""
        if not self.origin.any() and not self.file_origin.any():
            return []
        local = np.array_equal(self.origin, self.file_origin)
        point = self.origin if local else self.file_origin
        shown = ", ".join(f"{value:.12g}" for value in point.tolist())
        if point.any():
            return [f"coordinates in files are measured from {shown} mm, which is near the net"]
        return [
            "the net is far from the origin, and coordinates in files are those of the model: a "
            "CAD kernel may call solids invalid there, which are whole near it; take a local origin"
        ]

    def _verdict(self) -> dict[str, Any]:
        """How many parts pass, and why the others do not."""
        pairs = zip(self.parts, self.verdicts, strict=True)
        failing = {part.name: words for part, words in pairs if words != OK}
        return {"passed": len(self.parts) - len(failing), "failed": failing}


def build(
    mesh_mm: QuadMesh,
    systems: Sequence[System],
    *,
    material: Material | Mapping[str, Material] = MATERIALS["steel"],
    limits: Limits | Mapping[str, Limits] | None = None,
    selection: Selection | None = None,
    progress: Progress | None = None,
    place: Place | None = None,
    origin: FloatArray | None = None,
    border: Sequence[FloatArray] = (),
) -> Structure:
    """Work out all parts of a structure; the solids are built when first asked for.

    Args:
        mesh_mm: the mesh, in mm.
        systems: in the order in which they are built; later ones may lie on earlier ones.
        material: of all parts, or of each system by its name.
        limits: what all parts are held against, or those of each system by its name; by default
            those of ``Limits``.
        selection: which parameter lines are built on, by default all.
        progress: called with a fraction and words; may raise to stop.
        place: where the mesh's coordinates stand in the model, by default they are the model's.
        origin: (3,) what was taken off the model's coordinates already, mm.
        border: closed polylines (N, 3) along which parts are trimmed, in the coordinates of the
            mesh; by default all of the net is built.

    Raises:
        InputError: no system or one twice, a size that does not fit the mesh, or a border that does
            not.
    """
    names = [system.name for system in systems]
    if not names or len(set(names)) < len(names):
        raise InputError(
            f"system: expected different systems, got {'+'.join(names) or 'none'}; choose each once"
        )
    for system in systems:
        for other in system.excludes.keys() & set(names):
            raise InputError(f"system: {system.name}+{other} {system.excludes[other]}")
    together = {system.name: system for system in systems}
    systems = [system.beside(together) for system in systems]
    say = progress or (lambda fraction, words: None)
    say(0.0, "net")
    results: dict[str, SystemParts] = {}
    materials = material if isinstance(material, Mapping) else dict.fromkeys(names, material)
    held = limits if isinstance(limits, Mapping) else dict.fromkeys(names, limits or Limits())
    local = LocalOrigin.of_mesh(mesh_mm)
    near = local.near_mesh(mesh_mm)
    site = Site.of(near, selection or Selection(), [local.near(line) for line in border])
    for number, system in enumerate(systems):
        say(number / len(systems), system.name)
        here = replace(site, material=materials[system.name], done=dict(results))
        made = system.build(here)
        if not made.parts:
            raise InputError(f"{system.name}: nothing to build on this net; choose another system")
        _refuse_thickness(system.name, made.parts)
        said = made.messages
        if site.trimming is not None and not system.trims:
            said = (*said, f"{system.name}: they run on over the border, which does not cut them")
        results[system.name] = replace(
            made, parts=_stressed(made.parts), messages=said, settings=system
        )
    stands = place or Place()
    moved = stands.directions(local.shift)
    taken = moved if origin is None else origin + moved
    structure = Structure(near, site, results, held, stands.less(-moved), taken, shift=local.shift)
    say(1.0, f"{len(structure.parts)} parts")
    return structure


def _refuse_thickness(system: str, parts: Sequence[Part]) -> None:
    """Refuse parts that are not as thick as the build-up that they are made of."""
    for part in parts:
        thickness = part.material.thickness
        if thickness is not None and abs(part.thickness - thickness) > 1e-6:
            raise InputError(
                f"{system}: {part.material.name} is {thickness:g} mm thick and {part.name} "
                f"{part.thickness:g} mm; set a thickness of {thickness:g} mm"
            )


def _stressed(parts: Sequence[Part]) -> tuple[Part, ...]:
    """Parts with the bending stress at their smallest radius, and what shear makes of it."""
    return tuple(replace(part, measures=_with_stress(part)) for part in parts)


def _with_stress(part: Part) -> Measures:
    radius, shear = part.measures.min_bend_radius_mm, part.measures.shear_MPa
    if radius is None and shear is None:
        return part.measures
    bending = None if radius is None else part.material.bending_stress(part.thickness, radius)
    combined = von_mises(bending or 0.0, shear or 0.0)
    return replace(part.measures, stress_MPa=bending, combined_MPa=combined)
