"""The system of louvres: in every face the parallelogram of the midpoints of its sides.

It is plane whatever the face, and a rhombus where the face's diagonals are equal, as they are in an
orthogonal net. It may be turned about the line between two opposite corners.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 20.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_size, rounded_down
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.panels.geometry import half_angle_tangents, inset
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.lines import FAMILIES
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.option import Option


@dataclass(frozen=True)
class Louvres(System):
    """A plate in every face, half of its thickness to each side of the net.

    Args:
        thickness: of the plates, mm.
        gap: between the sides of a plate and those of its neighbours' parallelograms, mm; beside
            beams their width is added.
        axis: "u" or "v", the family of lines that the plate turns about.
        tilt: by which it is turned, degrees.

    Raises:
        InputError: a size that is not positive and finite, or an unknown family.
    """

    thickness: float
    gap: float
    axis: str = "u"
    tilt: float = 0.0

    name: ClassVar[str] = "louvres"
    options: ClassVar[tuple[Option, ...]] = (
        Option("thickness", 12.0, "length", "the plates are this thick"),
        Option(
            "panel_thickness",
            None,
            "length",
            "the panels are this thick, by default as thick as the plates",
        ),
        Option("gap", 8.0, "length", "the joint between two panels is this wide"),
        Option(
            "louvre_axis", "u", "choice", "the louvres turn about lines of this family", FAMILIES
        ),
        Option("tilt", 0.0, "angle", "the louvres are turned by this angle about their lines"),
    )

    def __post_init__(self) -> None:
        check_size("panel thickness", self.thickness)
        check_size("gap", self.gap)
        if self.axis not in FAMILIES:
            raise InputError(f"louvre axis: expected u or v, got '{self.axis}'")
        if not abs(self.tilt) < 90:
            raise InputError(f"tilt: expected between -90 and 90 degrees, got {self.tilt:g}")

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Louvres:
        """Make the settings from options; louvres are as thick as the beams unless told."""
        plate = values["panel_thickness"]
        plate = values["thickness"] if plate is None else plate
        return cls(plate, values["gap"], values["louvre_axis"], values["tilt"])

    def build(self, site: Site) -> SystemParts:
        """Work out the louvres.

        Raises:
            InputError: a gap that leaves nothing of a face, or plates that would touch.
        """
        beams = site.geometry_of("beams", BeamGeometry)
        beside = 0.0 if beams is None else 2 * float(beams.section_half)
        middle, frame, flat = self._parallelograms(site)
        outline = inset(flat, np.full((len(flat), 4), (self.gap + beside) / 2))
        self._refuse(site, flat, outline)
        parts = self._parts(site, middle, frame, outline)
        angle = _angles(flat)
        report = {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "tilt_deg": self.tilt,
            "sides_differ_max_mm": float(_differences(flat).max()),
            "angle_min_deg": float(angle.min()),
            "angle_max_deg": float(angle.max()),
            **sums(parts),
        }
        return SystemParts(parts, report)

    def _parallelograms(self, site: Site) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Middles (F, 3), frames (F, 3, 3) and corners (F, 4, 2) of the turned parallelograms.

        The first and third corner lie on the axis, x of the frame.
        """
        corner = site.mesh.vertices[site.mesh.faces]
        points = (corner + np.roll(corner, -1, axis=1)) / 2
        first = site.lines.edge_family[site.mesh.connectivity.face_edges[:, 0]]
        on_second = first == np.where(self.axis == "u", 0, 1)
        on_second |= (first < 0) & (self.axis == "u")
        points = np.where(on_second[:, None, None], np.roll(points, -1, axis=1), points)
        middle = points.mean(axis=1)
        along = unit_rows(points[:, 0] - points[:, 2])
        normal = unit_rows(np.cross(points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]))
        across = np.cross(normal, along)
        arms = points - middle[:, None]
        flat = np.stack(
            [np.einsum("fck,fk->fc", arms, along), np.einsum("fck,fk->fc", arms, across)], axis=2
        )
        cosine, sine = np.cos(np.radians(self.tilt)), np.sin(np.radians(self.tilt))
        turned = cosine * across + sine * normal
        return middle, np.stack([along, turned, np.cross(along, turned)], axis=1), flat

    def _parts(
        self, site: Site, middle: FloatArray, frame: FloatArray, outline: FloatArray
    ) -> tuple[Part, ...]:
        names = part_names("LV", len(outline))
        faces = site.mesh.faces.tolist()
        half = self.thickness / 2
        parts = []
        for face, name in enumerate(names):
            low = outline[face].min(axis=0)
            flat = outline[face] - low
            body = Polyhedron(
                np.concatenate([np.column_stack([flat, np.full(4, z)]) for z in (-half, half)]),
                BOX_SIDES,
            )
            parts.append(
                plate_part(
                    site,
                    name,
                    "louvre",
                    body,
                    (middle[face] + low @ frame[face, :2], frame[face]),
                    _pattern(name, flat),
                    self.thickness,
                    vertices=tuple(faces[face]),
                    face=face,
                )
            )
        return tuple(parts)

    def _refuse(self, site: Site, flat: FloatArray, outline: FloatArray) -> None:
        along, kept = (np.roll(one, -1, axis=1) - one for one in (flat, outline))
        left = np.einsum("fcd,fcd->fc", kept, along) / np.einsum("fcd,fcd->fc", along, along)
        if left.min() <= 1e-3:
            face = int(left.min(axis=1).argmin())
            largest = self.gap / (1 - float(left.min()))
            raise InputError(
                f"gap: {self.gap:g} mm leaves nothing of the louvre in face {face}; take a gap "
                f"below {rounded_down(largest)} mm"
            )
        mesh = site.mesh
        corner = mesh.vertices[mesh.faces]
        side = np.roll(corner, -1, axis=1) - corner
        bend = half_angle_tangents(mesh.connectivity, mesh.face_normals, side)
        closing = self.thickness / 2 * np.abs(np.nan_to_num(bend))
        tips = np.linalg.norm(flat, axis=2).min(axis=1) - np.linalg.norm(outline, axis=2).min(
            axis=1
        )
        wrong = closing.max(axis=1) >= tips
        if wrong.any():
            face = int(wrong.argmax())
            raise InputError(
                f"gap: {self.gap:g} mm is too little for louvres {self.thickness:g} mm thick at "
                f"face {face}, where neighbours lean together; take a larger gap or thinner plates"
            )


def _angles(flat: FloatArray) -> FloatArray:
    """(F,) angle at the corners on the axis, degrees."""
    one, two = flat[:, 1] - flat[:, 0], flat[:, 3] - flat[:, 0]
    cross = np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0])
    return np.asarray(np.degrees(np.arctan2(cross, np.einsum("fd,fd->f", one, two))))


def _differences(flat: FloatArray) -> FloatArray:
    """(F,) difference of the two side lengths, mm: zero for a rhombus."""
    lengths = np.linalg.norm(np.roll(flat, -1, axis=1) - flat, axis=2)
    return np.asarray(np.abs(lengths[:, 0] - lengths[:, 1]))


def _pattern(name: str, flat: FloatArray) -> FlatPattern:
    """Outline with the axis drawn through and the name beside it."""
    middle = flat.mean(axis=0)
    width = float(np.linalg.norm(flat[0] - flat[2]))
    height = float(np.ptp(flat[:, 1]))
    size = fitted_text_size(name, 0.3 * width, 0.3 * height)
    place = middle + [0.0, size]
    tick = Mark(np.stack([flat[0], flat[0] + 0.12 * (middle - flat[0])]))
    return FlatPattern(flat, (tick,), place, size, axis=flat[[0, 2]])
