"""From a mesh and systems to all parts of a structure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from freecad_ortho.fabrication.limits import OK, Limits, verdict
from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Selection, Site
from freecad_ortho.fabrication.systems.system import System, SystemParts
from freecad_ortho.fabrication.workers import in_chunks
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from solver.offset.axes import Axes

if TYPE_CHECKING:
    import cadquery

Progress = Callable[[float, str], None]


@dataclass(frozen=True, eq=False)
class Structure:
    """All parts of a net, system by system.

    Attributes:
        mesh: the mesh, mm.
        site: where the systems were built; its mesh lies near the origin.
        results: what each system made, by its name.
        limits: what the parts are held against.
    """

    mesh: QuadMesh
    site: Site
    results: Mapping[str, SystemParts]
    limits: Limits

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """All parts, in the order of the systems."""
        return tuple(part for result in self.results.values() for part in result.parts)

    @property
    def axes(self) -> Axes:
        """At the vertices."""
        return self.site.axes

    @cached_property
    def verdicts(self) -> tuple[str, ...]:
        """For each part "ok", or in one sentence what exceeds which limit."""
        return tuple(verdict(part, self.limits, self.site.material) for part in self.parts)

    def only(self, *names: str) -> Structure:
        """Return the parts of these systems alone, built as they are beside the others."""
        return replace(self, results={name: self.results[name] for name in names})

    def compound(self, progress: Progress | None = None) -> cadquery.Compound:
        """Return one shape with the solids in the order of ``parts``, mm."""
        from freecad_ortho.fabrication.solids import compound

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
            if number % 64 == 0:
                say(number / len(self.parts), f"solid {number + 1} of {len(self.parts)}")
            result.append(part.solid())
        return result

    def _build_elsewhere(self, say: Progress, executor: Executor) -> None:
        from freecad_ortho.fabrication.solids import solid_bytes

        missing = [part for part in self.parts if not (part.has_solid or part.body.quick)]
        bodies = [part.body for part in missing]
        made = in_chunks(solid_bytes, bodies, executor, lambda done: say(0.0, "solids"))
        for part, data in zip(missing, made, strict=True):
            part.take_solid(data)

    def report(self) -> dict[str, Any]:
        """Return counts, accuracy, masses, verdict and remarks, ready for JSON; lengths in mm."""
        material = self.site.material
        return {
            "unit": "mm",
            "systems": list(self.results),
            "counts": {
                "vertices": len(self.mesh.vertices),
                "edges": len(self.mesh.connectivity.edges),
                "faces": len(self.mesh.faces),
                **{name: len(result.parts) for name, result in self.results.items()},
            },
            "planarity_gap_max_mm": float(diagonal_distances(self.site.mesh).max()),
            "lean_max_deg": float(self.axes.lean_deg.max()),
            "material": material.name,
            "density_kg_m3": material.density,
            "volume_mm3": sum(part.volume for part in self.parts),
            "mass_kg": sum(part.mass for part in self.parts),
            "verdict": self._verdict(),
            **{name: result.report for name, result in self.results.items()},
            "messages": [word for result in self.results.values() for word in result.messages],
        }

    def _verdict(self) -> dict[str, Any]:
        """How many parts pass, and why the others do not."""
        pairs = zip(self.parts, self.verdicts, strict=True)
        failing = {part.name: words for part, words in pairs if words != OK}
        return {"passed": len(self.parts) - len(failing), "failed": failing}


def build(
    mesh_mm: QuadMesh,
    systems: Sequence[System],
    *,
    material: Material = MATERIALS["steel"],
    limits: Limits | None = None,
    selection: Selection | None = None,
    progress: Progress | None = None,
) -> Structure:
    """Work out all parts of a structure; the solids are built when first asked for.

    Args:
        mesh_mm: the mesh, in mm.
        systems: in the order in which they are built; later ones may lie on earlier ones.
        material: of all parts.
        limits: what the parts are held against, by default those of ``Limits``.
        selection: which parameter lines are built on, by default all.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        InputError: no system or one twice, or a size that does not fit the mesh.
    """
    names = [system.name for system in systems]
    if not names or len(set(names)) < len(names):
        raise InputError(
            f"system: expected different systems, got {'+'.join(names) or 'none'}; choose each once"
        )
    say = progress or (lambda fraction, words: None)
    say(0.0, "net")
    results: dict[str, SystemParts] = {}
    site = replace(Site.of(mesh_mm, material, selection or Selection()), done=results)
    for number, system in enumerate(systems):
        say(number / len(systems), system.name)
        made = system.build(site)
        if not made.parts:
            raise InputError(f"{system.name}: nothing to build on this net; choose another system")
        results[system.name] = replace(made, parts=_stressed(made.parts, material))
    structure = Structure(mesh_mm, site, results, limits or Limits())
    say(1.0, f"{len(structure.parts)} parts")
    return structure


def _stressed(parts: Sequence[Part], material: Material) -> tuple[Part, ...]:
    """Parts with the bending stress at their smallest radius."""
    return tuple(
        part
        if (radius := part.measures.min_bend_radius_mm) is None
        else replace(
            part,
            measures=replace(
                part.measures, stress_MPa=material.bending_stress(part.thickness, radius)
            ),
        )
        for part in parts
    )
