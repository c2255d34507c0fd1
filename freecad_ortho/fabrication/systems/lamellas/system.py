"""The system of lamellas: parts and report."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.assembly import judged
from freecad_ortho.fabrication.bolts import SMALL, bolt_in
from freecad_ortho.fabrication.cleat import Cleat, OnCleats
from freecad_ortho.fabrication.cleat_strength import cleat_report
from freecad_ortho.fabrication.material import metal_for
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.feet.places import standing
from freecad_ortho.fabrication.systems.lamellas.above import Above, build_above
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella, lamella_on
from freecad_ortho.fabrication.systems.lamellas.bolted import crossing_bolts, splice_bolts
from freecad_ortho.fabrication.systems.lamellas.bolts import least_edge, least_width
from freecad_ortho.fabrication.systems.lamellas.border import LamellaBorder, LamellaSpan
from freecad_ortho.fabrication.systems.lamellas.cleat_parts import cleat_bolts, cleat_part
from freecad_ortho.fabrication.systems.lamellas.cleats import around, cleats_of, ends_of
from freecad_ortho.fabrication.systems.lamellas.crossings import (
    Crossing,
    at_vertices,
    crossings,
    said_of_wide,
    slot_ways,
)
from freecad_ortho.fabrication.systems.lamellas.direction import (
    StripPattern,
    pattern_of,
    straight_families,
)
from freecad_ortho.fabrication.systems.lamellas.ends import reaches
from freecad_ortho.fabrication.systems.lamellas.layers import too_near
from freecad_ortho.fabrication.systems.lamellas.parts import cut, lamella_part
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.splice_parts import splice_part
from freecad_ortho.fabrication.systems.lamellas.splices import SplicePlate, pieces_of
from freecad_ortho.fabrication.systems.lamellas.third import third_layer
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.lines import ParameterLine, ParameterLines
from solver.mesh.quadmesh import QuadMesh

# Names that a message shows.
_SHOWN = 5


@dataclass(frozen=True, eq=False)
class LamellaGeometry(OnCleats):
    """What lamellas leave to lie on.

    Attributes:
        lamellas: the pieces, those of a third layer last.
    """

    lamellas: list[Lamella]


@dataclass(frozen=True)
class Lamellas(LamellaSettings, System):
    """Strips along the chosen parameter lines, one part a line or a piece of one."""

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "lamellas"
    excludes: ClassVar[Mapping[str, str]] = {
        "nodes": "cannot be built together: lamellas run through their crossings, where slots or "
        "bolts join them; leave the nodes out"
    }

    @classmethod
    def slotted(cls, values: Mapping[str, Any]) -> bool:
        """Every crossing is one."""
        return True

    def beside(self, others: Mapping[str, System]) -> Lamellas:
        """With holes for the fins of feet, where these are built too."""
        return replace(self, feet=getattr(others.get("feet"), "places", ""))

    def build(self, site: Site) -> SystemParts:
        """Work out the lamellas.

        Raises:
            InputError: a net too far from what the patterns need, rulings that meet inside the
                width, slots or holes that do not fit.
        """
        steel = metal_for(site.material) is not site.material
        told = replace(self, steel_cleats=steel, on_wood=site.material.wood)
        return told._built(site)

    def _built(self, site: Site) -> SystemParts:
        """The lamellas of settings that are filled in."""
        pattern = pattern_of(site, self)
        if pattern.kind == "arc":
            # At the border a CMC net asks nothing: a line that runs on there is no arc any more.
            site = replace(site, lines=ParameterLines(site.mesh.connectivity))
        lines = [line for line in site.chosen_lines if len(line.vertices) > 1]
        if self.layers == 2 and any(not line.family for line in lines):
            raise InputError(
                "layers: the lines of this net cannot be told apart into families u and v, so two "
                "layers cannot be made; take layers 1"
            )
        border = LamellaBorder(site, self)
        runs = border.runs(lines)
        if not runs:
            return SystemParts(())
        whole = self._whole(site, border, runs, pattern)
        ends = self._with_cleats(whole)
        on_feet = set(standing(site, self.feet).tolist()) if self.feet else set()
        third = None if self.diagonals == "none" else third_layer(site, self, pattern, whole)
        tied = third.crossed if third is not None and self.standing else set()
        lamellas, splices = pieces_of(whole, self, ends | on_feet | tied)
        met = crossings(lamellas, self)
        count = len(site.mesh.vertices)
        cleats, lamellas, lost = cleats_of(lamellas, met, ends | on_feet, self, count)
        above = Above(lamellas)
        if third is not None:
            above = build_above(site, third, lamellas, self.standing, set(cleats))
            lamellas = above.grid
        cuts = [cut(each, here, self) for each, here in zip(lamellas, met, strict=True)]
        parts = tuple(lamella_part(made, site, self.position) for made in cuts)
        parts, doubts = judged(parts, slot_ways(lamellas, met, self, site.material))
        plates = tuple(splice_part(splice, site, self) for splice in splices)
        bolts = splice_bolts(site, splices, plates, self)
        bolts += crossing_bolts(site, lamellas, met, self, above.bolted)
        bolts += cleat_bolts(cleats.values(), site, on_feet, part_names("FT", count)) + above.bolts
        parts += plates + tuple(cleat_part(cleat, site) for cleat in cleats.values()) + above.parts
        report = self._report(lamellas, met, parts, pattern)
        report |= {"splices": len(splices), "cleats": len(cleats)} | above.report
        report |= cleat_report([cleat.sizes for cleat in cleats.values()], site.material)
        report["not_put_on"] = sum(bool(part.assembly) for part in parts)
        messages = self._messages(site.mesh, lamellas, pattern) + self._said(whole, splices)
        messages += self._said_of_layers(lamellas, met) + border.words() + doubts
        messages += said_of_wide(lamellas, met, self) + above.words()
        messages += self._said_of_cleats(lost, list(cleats.values()))
        beside = around(lamellas, on_feet, self)
        geometry = LamellaGeometry(cleats, beside, [*lamellas, *above.pieces])
        if site.trimming is not None:
            report |= {"trimmed": border.trimmed, "left_out": border.left_out}
        return SystemParts(parts, report, tuple(messages), geometry, fasteners=bolts)

    def _with_cleats(self, whole: list[Lamella]) -> set[int]:
        """Vertices that shall have one: where lamellas end, of two layers all crossings."""
        if not self.cleats:
            return set()
        return ends_of(whole) | (set(at_vertices(whole)) if self.layers == 2 else set())

    def _whole(
        self, site: Site, border: LamellaBorder, runs: list[LamellaSpan], pattern: StripPattern
    ) -> list[Lamella]:
        """One lamella a run, before it is cut to stock."""
        beyond = reaches(site.mesh, pattern.axes, [run.line for run in runs], self)
        names = [lamella_name(run.line) + run.suffix for run in runs]
        return [
            border.trim(lamella_on(site, run.line, self, pattern, name, ends), run, self)
            for run, name, ends in zip(runs, names, beyond, strict=True)
        ]

    def _report(
        self,
        lamellas: list[Lamella],
        met: list[list[Crossing]],
        parts: tuple[Part, ...],
        pattern: StripPattern,
    ) -> dict[str, Any]:
        measured = [each.measures for each in lamellas]
        slots = [each.slot.width for row in met for each in row if each.slot is not None]
        allowed = min(each.admissible_width for each in measured)
        return {
            "width_mm": self.width,
            "thickness_mm": self.thickness,
            "clearance_mm": self.clearance,
            "position": self.position,
            "layers": self.layers,
            "tilt_deg": {name: math.degrees(angle) for name, angle in pattern.tilts.items()}
            or None,
            "pattern": pattern.kind,
            "radius_mm": abs(pattern.radius) if np.isfinite(pattern.radius) else None,
            "developable": sum(not each.twisted for each in lamellas),
            "twisted": sum(each.twisted for each in lamellas),
            "crossings": sum(len(row) for row in met) // 2,
            "slot_width_min_mm": min(slots, default=None),
            "slot_width_max_mm": max(slots, default=None),
            "straightness_max_mm": max(_values(parts, "straightness_mm"), default=None),
            "radius_spread_max_mm": max(_values(parts, "radius_spread_mm"), default=None),
            "gap_max_mm": max(_values(parts, "gap_mm"), default=None),
            "lean_max_deg": max(_values(parts, "lean_deg"), default=None),
            "torsion_max_deg_per_m": max(_values(parts, "torsion_deg_per_m"), default=None),
            "bend_radius_min_mm": min(_values(parts, "min_bend_radius_mm"), default=None),
            "admissible_width_mm": allowed if np.isfinite(allowed) else None,
            **sums(parts),
        }

    def _said(self, whole: list[Lamella], splices: list[SplicePlate]) -> list[str]:
        """What a user should know about joints."""
        messages = []
        long = {splice.lamella.name for splice in splices if len(set(splice.pieces)) > 1}
        if long:
            messages.append(
                f"lamellas: {len(long)} of {len(whole)} are longer than the stock of "
                f"{self.stock:g} mm; {len(splices)} splices join their pieces"
            )
        if (splices or not self.standing) and bolt_in(self.hole) is None:
            messages.append(
                f"lamellas: no bolt of the list passes holes of {self.hole:g} mm, so it leaves "
                f"theirs out; from {SMALL[0].hole:g} mm on it has them"
            )
        joined = {splice.lamella.name for splice in splices if splice.closes}
        rings = [each.name for each in whole if each.closed and each.name not in joined]
        if rings:
            messages.append(
                f"lamellas: no splice closes {', '.join(rings[:4])}"
                f"{' ...' if len(rings) > 4 else ''}: it would need a plane edge of "
                f"{least_edge(self):.3g} mm between crossings and a width of "
                f"{least_width(self):.3g} mm; take smaller holes, or weld the ends"
            )
        return messages

    def _said_of_cleats(self, lost: list[str], cleats: list[Cleat]) -> list[str]:
        """What a user should know about cleats that have no room, or less than the others."""
        messages = []
        single = [cleat.name for cleat in cleats if len(cleat.sizes.levels) == 1]
        if single and len(single) < len(cleats):
            messages.append(
                f"lamellas: {len(single)} of {len(cleats)} cleats have one bolt in a leg, "
                f"{single[0]} for one, where edges leave no room for two; wider lamellas make room"
            )
        if lost:
            shown = ", ".join(lost[:_SHOWN]) + (" ..." if len(lost) > _SHOWN else "")
            messages.append(
                f"lamellas: {len(lost)} of {len(cleats) + len(lost)} cleats are left out, as bend "
                "lines, edges or the next crossing leave their legs no room, or lamellas cross too "
                f"flat: {shown}; smaller holes, wider lamellas or strip twisted may make room"
            )
        return messages

    def _said_of_layers(self, lamellas: list[Lamella], met: list[list[Crossing]]) -> list[str]:
        """What a user should know about two layers, and about what leans over."""
        if self.position == "tilted" and not self.cleats:
            return [
                "lamellas: nothing holds tilted ones where they end; with cleats angles hold them "
                "there"
            ]
        if self.layers == 1 or (self.standing and self.cleats):
            return []
        if self.standing:
            return [
                "lamellas: standing ones in two layers meet edge to edge, where no bolt holds "
                "them: they have no holes there; take cleats for an angle at every crossing, weld "
                "them, let them lie, or take layers 1"
            ]
        count, needed = too_near(lamellas, met, self)
        if not count:
            return []
        return [
            f"lamellas: as they bend and twist, the two layers touch at {count} crossings with a "
            f"clearance of {self.clearance:g} mm; take clearance {needed:.1f}"
        ]

    def _messages(
        self, mesh: QuadMesh, lamellas: list[Lamella], pattern: StripPattern
    ) -> list[str]:
        messages = []
        twisted = [each for each in lamellas if each.twisted]
        if twisted and self.strip == "auto":
            gap = max(each.measures.gap for each in twisted)
            messages.append(
                f"lamellas: {len(twisted)} of {len(lamellas)} twist, as plane faces "
                f"{self.width:g} mm wide would meet, slant or bend too much, {twisted[0].name} for "
                f"one; their edges stretch by up to {gap:.2g} mm an edge"
            )
        if pattern.kind == "free" and self.pattern == "auto":
            messages.append(_said_of_free(straight_families(mesh, self.standing), self.standing))
        missing = [each.name for each in lamellas if not each.exact]
        if missing and pattern.kind != "free":
            exactly = "straight" if pattern.kind == "straight" else "arcs"
            messages.append(
                f"lamellas: {', '.join(missing[:4])}{' ...' if len(missing) > 4 else ''} are not "
                f"exactly {exactly}: at the boundary the net asks nothing of a line, and they "
                "would lean over"
            )
        return messages


def lamella_name(line: ParameterLine) -> str:
    """``L-U002`` is line 2 of family u; ``L-002`` where there are no families."""
    return f"L-{line.family.upper()}{line.number:03d}"


def _said_of_free(alone: list[str], standing: bool) -> str:
    """What would make straight patterns, of a net of which these families alone have them."""
    if alone:
        lines = "asymptotic" if standing else "geodesic"
        return (
            f"lamellas: only the lines of family {alone[0]} are {lines}, so patterns are curved "
            f"as they come; those of family {alone[0]} alone are straight"
        )
    if standing:
        return (
            "lamellas: the net is neither asymptotic nor CMC, so the patterns are curved as they "
            "come; optimise for an asymptotic net for straight ones, CMC for arcs"
        )
    return (
        "lamellas: the net is not geodesic, so the patterns are curved as they come; optimise for "
        "a geodesic net for straight ones"
    )


def _values(parts: tuple[Part, ...], measure: str) -> list[float]:
    """Those values of a measure that there are."""
    values = (getattr(part.measures, measure) for part in parts)
    return [value for value in values if value is not None]
