"""The system of louvres: in every face the parallelogram of the midpoints of its sides.

It is plane whatever the face, and a rhombus where the face's diagonals are equal, as they are in an
orthogonal net. It may be turned about the line between two opposite corners.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 20.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Body, Polyhedron
from freecad_ortho.fabrication.part import Part, part_names, piece_name
from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size, longest_within
from freecad_ortho.fabrication.plate_bodies import plate_body
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_options, rounded_down
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.panels.geometry import half_angle_tangents, inset
from freecad_ortho.fabrication.systems.panels.trimmed import (
    Trimmed,
    trimmed,
    trimmed_pattern,
)
from freecad_ortho.fabrication.systems.shared_options import (
    LEAST_WIDTH,
    PANEL_THICKNESS,
    joint,
    plate_thickness,
)
from freecad_ortho.fabrication.systems.sheets import left_out_words, narrower, trimming_report
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.lines import FAMILIES
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.option import Option, Range


@dataclass(frozen=True, eq=False)
class _Lying:
    """Louvres of all faces before they are turned.

    Attributes:
        middles: (F, 3) of the parallelograms, in the site's mesh.
        frames: (F, 3, 3) rows along the axis, across it, up.
        corners: (F, 4, 2) of the parallelograms from there, the first and third on the axis.
        faces: (F, 4, 2) corners of the faces, in the same planes.
    """

    middles: FloatArray
    frames: FloatArray
    corners: FloatArray
    faces: FloatArray


@dataclass(frozen=True)
class Louvres(System):
    """A plate in every face, half of its thickness to each side of the net.

    Args:
        thickness: of the plates, mm.
        gap: between the sides of a plate and those of its neighbours' parallelograms, mm; beside
            beams their width is added.
        axis: "u" or "v", the family of lines that the plate turns about.
        tilt: by which it is turned, degrees.
        least_width: pieces at the border are left out where no circle of this diameter fits in, mm.

    Raises:
        InputError: a size that is not positive and finite, or an unknown family.
    """

    thickness: float
    gap: float
    axis: str = "u"
    tilt: float = 0.0
    least_width: float = 60.0

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "louvres"
    options: ClassVar[tuple[Option, ...]] = (
        plate_thickness(12.0),
        PANEL_THICKNESS,
        joint(8.0),
        Option(
            "louvre_axis", "u", "choice", "the louvres turn about lines of this family", FAMILIES
        ),
        Option(
            *("tilt", 0.0, "angle", "the louvres are turned by this angle about their lines"),
            within=Range(-90.0, 90.0, above=True, below=True),
        ),
        LEAST_WIDTH,
    )

    def __post_init__(self) -> None:
        check_options(self, self.options, thickness="panel_thickness", axis="louvre_axis")

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Louvres:
        """Make the settings from options; louvres are as thick as the beams unless told."""
        plate = values["panel_thickness"]
        plate = values["thickness"] if plate is None else plate
        names = "gap louvre_axis tilt least_width"
        return cls(plate, *(values[name] for name in names.split()))

    def build(self, site: Site) -> SystemParts:
        """Work out the louvres.

        Raises:
            InputError: a gap that leaves nothing of a face, or plates that would touch.
        """
        beams = site.geometry_of("beams", BeamGeometry)
        beside = 0.0 if beams is None else 2 * float(beams.section_half)
        lying = self._parallelograms(site)
        flat = lying.corners
        outline = inset(flat, np.full((len(flat), 4), (self.gap + beside) / 2))
        made = np.ones(len(flat), dtype=bool) if site.trimming is None else site.trimming.made
        self._refuse(site, flat, outline, made)
        parts, left_out = self._parts(site, lying, outline)
        angle = _angles(flat[made])
        report = {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "tilt_deg": self.tilt,
            "sides_differ_max_mm": float(_differences(flat[made]).max()),
            "angle_min_deg": float(angle.min()),
            "angle_max_deg": float(angle.max()),
            **sums(parts),
        }
        if site.trimming is not None:
            cut = sum(part.face in site.trimming.regions for part in parts)
            report |= trimming_report(cut, left_out)
        words = left_out_words(self.name, left_out, narrower(self.least_width))
        return SystemParts(parts, report, tuple(words))

    def _parallelograms(self, site: Site) -> _Lying:
        corner = site.mesh.vertices[site.mesh.faces]
        points = (corner + np.roll(corner, -1, axis=1)) / 2
        first = site.lines.edge_family[site.mesh.connectivity.face_edges[:, 0]]
        on_second = first == np.where(self.axis == "u", 0, 1)
        on_second |= (first < 0) & (self.axis == "u")
        points = np.where(on_second[:, None, None], np.roll(points, -1, axis=1), points)
        middle = points.mean(axis=1)
        along = unit_rows(points[:, 0] - points[:, 2])
        normal = unit_rows(np.cross(points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]))
        frame = np.stack([along, np.cross(normal, along), normal], axis=1)
        flat, faces = (
            np.einsum("fck,fdk->fcd", some - middle[:, None], frame[:, :2])
            for some in (points, corner)
        )
        return _Lying(middle, frame, flat, faces)

    def _turned(self, frame: FloatArray) -> FloatArray:
        """(3, 3) directions of a louvre that is turned about its axis, x."""
        cosine, sine = np.cos(np.radians(self.tilt)), np.sin(np.radians(self.tilt))
        across = cosine * frame[1] + sine * frame[2]
        return np.stack([frame[0], across, np.cross(frame[0], across)])

    def _parts(
        self, site: Site, lying: _Lying, outline: FloatArray
    ) -> tuple[tuple[Part, ...], dict[str, float]]:
        """The louvres, and by their names areas of pieces that are too narrow, mm2."""
        names = part_names("LV", len(outline))
        trimming = site.trimming
        parts: list[Part] = []
        left_out: dict[str, float] = {}
        for face, name in enumerate(names):
            if trimming is None or trimming.whole[face]:
                parts.append(self._whole(site, lying, face, name, outline[face]))
            elif face in trimming.regions:
                regions = trimming.flat_regions(face, lying.faces[face])
                pieces = trimmed(outline[face], outline[face], outline[face], regions)
                for number, piece in enumerate(pieces):
                    own = piece_name(name, number)
                    if piece.width < self.least_width:
                        left_out[own] = piece.area
                    else:
                        parts.append(self._piece(site, lying, face, own, outline[face], piece))
        return tuple(parts), left_out

    def _whole(self, site: Site, lying: _Lying, face: int, name: str, outline: FloatArray) -> Part:
        low = outline.min(axis=0)
        flat = outline - low
        half = self.thickness / 2
        body = Polyhedron(
            np.concatenate([np.column_stack([flat, np.full(4, z)]) for z in (-half, half)]),
            BOX_SIDES,
        )
        return self._part(site, lying, face, (name, low, 0.0), body, _pattern(name, flat))

    def _piece(
        self,
        site: Site,
        lying: _Lying,
        face: int,
        name: str,
        outline: FloatArray,
        piece: Trimmed,
    ) -> Part:
        """What the border leaves of a louvre: cut as it lies, then turned."""
        low = piece.outline.min(axis=0)
        piece, axis = piece.moved(-low), outline[[0, 2]] - low
        body = plate_body(piece.outline, piece.outline, self.thickness, piece.cutouts)
        pattern = replace(trimmed_pattern(name, piece, []), axis=_within(axis, piece))
        return self._part(site, lying, face, (name, low, -self.thickness / 2), body, pattern)

    def _part(
        self,
        site: Site,
        lying: _Lying,
        face: int,
        named: tuple[str, FloatArray, float],
        body: Body,
        pattern: FlatPattern,
    ) -> Part:
        """The part of a body that begins at a place (2,) in its plane and at a level."""
        name, low, level = named
        frame = self._turned(lying.frames[face])
        return plate_part(
            site,
            name,
            "louvre",
            body,
            (lying.middles[face] + np.append(low, level) @ frame, frame),
            pattern,
            self.thickness,
            vertices=tuple(site.mesh.faces[face].tolist()),
            face=face,
        )

    def _refuse(self, site: Site, flat: FloatArray, outline: FloatArray, made: BoolArray) -> None:
        along, kept = (np.roll(one, -1, axis=1) - one for one in (flat, outline))
        left = np.einsum("fcd,fcd->fc", kept, along) / np.einsum("fcd,fcd->fc", along, along)
        left = np.where(made[:, None], left, 1.0)
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
        wrong = (closing.max(axis=1) >= tips) & made
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
    return FlatPattern(flat, (tick,), place, size, axis=flat[[0, 2]], seen="above")


def _within(axis: FloatArray, piece: Trimmed) -> FloatArray | None:
    """The longest part (2, 2) of an axis that lies on a piece, None where it is off it."""
    import shapely

    return longest_within(axis, shapely.Polygon(piece.outline, piece.cutouts))
