"""The system of arches: one flat plate along every line that lies in a plane."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.assembly import SlotWay, judged
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import FAMILY_CHOICES, Site
from freecad_ortho.fabrication.sizes import check_options, offset_levels
from freecad_ortho.fabrication.systems.arches.planes import LinePlane, chosen_planes
from freecad_ortho.fabrication.systems.arches.plates import (
    ArchPlate,
    PlateCrossing,
    arch_plates,
    crossing,
    worst_turn_deg,
)
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    HEIGHT,
    OFFSET,
    OVERHANG,
    plate_thickness,
)
from freecad_ortho.fabrication.systems.system import System, SystemParts, Table, sums
from solver.errors import InputError
from solver.mesh.lines import FAMILIES
from solver.mesh.quadmesh import FloatArray
from solver.option import Option

_COLUMNS = ("name", "family", "line", "vertices", "length_mm", "deviation_mm", "lean_deg")
_STANDS = "would stand in one place; build one of them"


@dataclass(frozen=True)
class Arches(System):
    """A plate cut flat along every line that lies in a plane, upright in it.

    Where lines of both families do, plates cross by half laps along the line in which their planes
    meet: those of u are open above, those of v below.

    Args:
        height: of the plates, square to the line, mm.
        thickness: mm.
        offset: "above", "centre" or "below" the net.
        clearance: in the width and depth of slots, mm.
        overhang: beyond the last vertices, mm; None for half the height.
        through: "both" for half laps; "u" or "v": plates of that family run through, those of the
            other one are pieces between them.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    height: float
    thickness: float
    offset: str = "centre"
    clearance: float = 1.0
    overhang: float | None = None
    through: str = "both"

    name: ClassVar[str] = "arches"
    excludes: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("beams", "lamellas", "edge-beam", "nodes"), _STANDS
    )
    options: ClassVar[tuple[Option, ...]] = (
        HEIGHT,
        plate_thickness(20.0),
        OFFSET,
        CLEARANCE,
        OVERHANG,
        Option(
            "through",
            "both",
            "choice",
            "plates of this family run through where two cross, both by half laps",
            FAMILY_CHOICES,
        ),
    )

    def __post_init__(self) -> None:
        check_options(self, self.options)
        if self.clearance >= self.height:
            raise InputError(
                f"clearance: {self.clearance:g} mm makes slots deeper than the plates are high, "
                f"{self.height:g} mm; take less"
            )

    @classmethod
    def slotted(cls, values: Mapping[str, Any]) -> bool:
        """Every crossing of plates that both run through is one."""
        return True

    def build(self, site: Site) -> SystemParts:
        """Work out the plates of the chosen lines.

        Raises:
            InputError: no line is plane, or slots that do not fit.
        """
        planes, words = chosen_planes(site)
        crossings = self._crossings(planes)
        levels = offset_levels(self.offset, self.height)
        nodes = part_names("N", len(site.mesh.vertices))
        parts: list[Part] = []
        made: list[ArchPlate] = []
        ways: dict[str, list[SlotWay]] = {}
        for plane, own in zip(planes, crossings, strict=True):
            overhang = self.height / 2 if self.overhang is None else self.overhang
            if self.through not in ("both", plane.line.family):
                overhang = 0.0
            plates = arch_plates(plane, levels, self.thickness, overhang, own)
            for number, plate in enumerate(plates):
                name = _name(plane) + (f"-{number:02d}" if len(plates) > 1 else "")
                parts.append(self._part(site, plane, plate, name, own, nodes))
            made += plates
            ways[parts[-1].name] = self._ways(own)
        judged_parts, doubts = judged(parts, ways)
        report = self._report(planes, made, judged_parts)
        rows = tuple(_row(plane) for plane in planes)
        table = Table(
            "planes.csv",
            _COLUMNS,
            rows,
            points=np.array([plane.points.mean(axis=0) for plane in planes]) + site.shift,
            normals=np.array([plane.normal for plane in planes]),
        )
        return SystemParts(judged_parts, report, (*words, *doubts), tables=(table,))

    def _crossings(self, planes: list[LinePlane]) -> list[dict[int, PlateCrossing]]:
        """The slots of each plate, by the place of their vertex on its line."""
        middle = sum(offset_levels(self.offset, self.height)) / 2
        through: dict[int, list[tuple[int, int]]] = {}
        for number, plane in enumerate(planes):
            for place, vertex in enumerate(plane.line.vertices.tolist()):
                through.setdefault(vertex, []).append((number, place))
        found: list[dict[int, PlateCrossing]] = [{} for _ in planes]
        for pair in through.values():
            families = {planes[number].line.family for number, _ in pair}
            if len(pair) != 2 or len(families) < 2:
                # Lines that end at an irregular vertex meet there side by side.
                continue
            for (one, place), (other, _) in (pair, pair[::-1]):
                cut = "slot" if self.through == "both" else "whole"
                if self.through == planes[one].line.family:
                    cut = "none"
                found[one][place] = crossing(
                    planes[one],
                    planes[other],
                    _name(planes[other]),
                    self.thickness,
                    self.clearance,
                    middle,
                    cut,
                )
        return found

    def _ways(self, crossings: dict[int, PlateCrossing]) -> list[SlotWay]:
        """How the others are pushed into the slots of a plate, which is rigid."""
        return [
            SlotWay(
                each.other,
                each.along * (1 if each.above else -1),
                self.height / 2,
                self.clearance,
            )
            for _, each in sorted(crossings.items())
            if each.cut == "slot"
        ]

    def _part(
        self,
        site: Site,
        plane: LinePlane,
        plate: ArchPlate,
        name: str,
        crossings: dict[int, PlateCrossing],
        nodes: list[str],
    ) -> Part:
        low, line = plate.outline.min(axis=0), plane.line
        vertices = line.vertices[plate.nodes].tolist()
        marks = [nodes[vertex] for vertex in vertices]
        for number, place in enumerate(plate.nodes):
            if place in crossings:
                marks[number] += f" {crossings[place].other}"
        origin = plane.points[0] + low @ plate.frame[:2]
        body = plate.body.moved([-low[0], -low[1], 0.0])
        middle = sum(offset_levels(self.offset, self.height)) / 2
        return plate_part(
            site,
            name,
            "arch-plate",
            body,
            (origin, plate.frame),
            _pattern(name, plate, low, marks, self.height, middle),
            self.thickness,
            vertices=tuple(vertices),
            family=line.family,
            line=line.number,
            measures=Measures(gap_mm=plane.off_mm, lean_deg=plane.lean_deg),
            height=self.height,
        )

    def _report(
        self, planes: list[LinePlane], made: list[ArchPlate], parts: tuple[Part, ...]
    ) -> dict[str, Any]:
        slots = [plate.slots for plate in made]
        counts = {family: sum(p.line.family == family for p in planes) for family in FAMILIES}
        return {
            "height_mm": self.height,
            "thickness_mm": self.thickness,
            "clearance_mm": self.clearance,
            "offset": self.offset,
            "plates": counts,
            "half_laps": sum(len(each) for each in slots) // 2,
            "deviation_max_mm": max(plane.off_mm for plane in planes),
            "lean_max_deg": max(plane.lean_deg for plane in planes),
            "slots_turn_max_deg": worst_turn_deg(slots),
            "not_put_on": sum(bool(part.assembly) for part in parts),
            **sums(parts),
        }


def _name(plane: LinePlane) -> str:
    return f"A-{plane.line.family.upper()}{plane.line.number:03d}"


def _row(plane: LinePlane) -> tuple[object, ...]:
    length = float(np.linalg.norm(np.diff(plane.points, axis=0), axis=1).sum())
    line = plane.line
    sizes = (f"{length:.6f}", f"{plane.off_mm:.6g}", f"{plane.lean_deg:.6f}")
    return (_name(plane), line.family, line.number, len(line.vertices), *sizes)


def _pattern(
    name: str,
    plate: ArchPlate,
    low: FloatArray,
    words: list[str],
    height: float,
    middle: float,
) -> FlatPattern:
    """The outline with the line, and beside each vertex its name and the plate that crosses."""
    axis = plate.line - low
    steps = np.diff(axis, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    angles = np.degrees(np.arctan2(steps[:, 1], steps[:, 0]))
    rises = np.column_stack([-steps[:, 1], steps[:, 0]]) / lengths[:, None]
    marks = []
    for node, text in enumerate(words):
        step, ahead = (node, 1.0) if node < len(steps) else (node - 1, -1.0)
        place = axis[node] + 0.28 * ahead * steps[step] + (middle + height / 4) * rises[step]
        size = fitted_text_size(text, 0.3 * float(lengths[step]), height / 4, 12.0)
        marks.append(Mark(place[None], text, size, float(angles[step])))
    longest = int(lengths.argmax())
    label = axis[longest] + 0.5 * steps[longest] + (middle - height / 4) * rises[longest]
    return FlatPattern(
        plate.outline - low,
        tuple(marks),
        label,
        fitted_text_size(name, 0.4 * float(lengths[longest]), height / 4),
        axis=axis,
        label_angle=float(angles[longest]),
        seen="right",
    )
