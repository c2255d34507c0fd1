"""Frames of panels: pressure plates and caps along the edges of the net, mitred at its nodes.

A stick system as facades have it: panels lie on gaskets on the beams and reach under plates that
are screwed onto the beams between them and covered by caps. So the joint between two panels is the
plate's width less what it covers of both.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad_ortho.fabrication.fasteners import Supply
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles import Profile
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.fins import runs_through
from freecad_ortho.fabrication.systems.beams.frames import (
    Frames,
    around_axes,
    beam_frames,
    edge_name,
)
from freecad_ortho.fabrication.systems.beams.geometry import Cuts, coped, mitred, square
from freecad_ortho.fabrication.systems.beams.options import COPED
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry
from freecad_ortho.fabrication.systems.panels.pressure_frame import (
    PLATE,
    WALL,
    WIDEST,
    PressureFrame,
)
from freecad_ortho.fabrication.systems.system import Table
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Screws are no further apart, mm, in what makers of systems publish.
_SCREWS = 250.0
_SAW_WORDS = (
    "{}; start: elevation {:.2f}, plan right {:.2f} left {:.2f} deg; "
    "end: elevation {:.2f}, plan right {:.2f} left {:.2f} deg"
)
COLUMNS = (
    *("plate", "cap", "panels", "length_mm", "screws"),
    *("gasket_least_mm", "gasket_most_mm", "cover_least_mm"),
)


@dataclass(frozen=True, eq=False)
class Covered:
    """Faces that panels cover.

    Attributes:
        made: (F,) true where there is one.
        bow: (F,) how far it may be from its face's plane, mm.
        onto: (F,) the face whose panel goes on over this one, where that is so; else -1.
    """

    made: BoolArray
    bow: FloatArray
    onto: IntArray

    def of(self, face: int) -> int:
        """The face whose panel covers a face."""
        return face if self.onto[face] < 0 else int(self.onto[face])

    def edges(self, sides: IntArray) -> BoolArray:
        """(E,) edges between faces (E, 2) where a panel ends; none in the middle of one."""
        own = np.where(self.onto >= 0, self.onto, np.arange(len(self.onto)))
        beside = self.made[sides] & (sides >= 0)
        within = beside.all(axis=1) & (own[sides[:, 0]] == own[sides[:, 1]])
        return np.asarray(beside.any(axis=1) & ~within)


@dataclass(frozen=True, eq=False)
class Framed:
    """What frames are made of.

    Attributes:
        parts: plates and caps, edge by edge.
        table: the list of them.
        report: sums, and the extremes of gaskets and of what plates cover, mm.
        supplies: gaskets and screws.
        frame: the sizes that they have.
        words: on sizes that grew.
        frames: planes of the members.
        heights: (E,) of the plates' lower sides above the edges, mm; NaN where there is none.
    """

    parts: tuple[Part, ...]
    table: Table
    report: dict[str, Any]
    supplies: tuple[Supply, ...]
    frame: PressureFrame
    words: tuple[str, ...]
    frames: Frames
    heights: FloatArray


def framed(
    site: Site,
    frame: PressureFrame,
    geometry: PanelGeometry,
    panels: Sequence[Part],
    faces: Covered,
) -> Framed:
    """Plates and caps along every edge that has a panel beside it.

    Args:
        site: the net.
        frame: their sizes.
        geometry: of the panels.
        panels: the panels.
        faces: those that have one.

    Raises:
        InputError: a frame too wide for an edge of the net.
    """
    frame, members, beside, words = _fitted(site, frame, geometry, faces)
    names = part_names("F", len(members.built))
    own = {part.face: part.name for part in reversed(panels)}
    panel_names = {face: own.get(faces.of(face), "") for face in range(len(faces.made))}
    edges = np.flatnonzero(members.built).tolist()
    heights = np.where(members.built, beside.highest + frame.gasket, np.nan)
    parts, rows = [], []
    sealed, screws = 0.0, 0
    for edge in edges:
        under = float(heights[edge])
        name = names[edge]
        plate = members.part(f"{name}-plate", edge, under, (frame.plate, PLATE))
        cap = members.part(f"{name}-cap", edge, under + PLATE, (frame.cap, WALL))
        if beside.cover[edge] < site.material.bearing:
            little = (
                f"covers panels by {beside.cover[edge]:.3g} mm only, {site.material.name} needs"
            )
            plate = replace(plate, assembly=f"{little} {site.material.bearing:g} mm")
        parts += [plate, cap]
        around = site.mesh.connectivity.edge_faces[edge].tolist()
        beside_it = [panel_names[face] for face in around if face >= 0 and panel_names[face]]
        sealed += 2 * len(beside_it) * plate.length
        screws += math.ceil(plate.length / _SCREWS) + 1
        rows.append(
            (
                *(plate.name, cap.name, " ".join(beside_it)),
                *(f"{plate.length:.6f}", math.ceil(plate.length / _SCREWS) + 1),
                *(f"{frame.gasket:.3f}", f"{under - float(beside.lowest[edge]):.3f}"),
                f"{float(beside.cover[edge]):.3f}",
            )
        )
    report = {
        "edges": len(edges),
        "width_mm": frame.width,
        "joint_mm": frame.joint,
        "plates_mm": sum(part.length for part in parts[::2]),
        "gasket_min_mm": frame.gasket,
        "gasket_max_mm": float((beside.highest - beside.lowest)[edges].max()) + frame.gasket,
        "cover_min_mm": float(beside.cover[edges].min()),
        "mass_kg": sum(part.mass for part in parts),
    }
    supplies = (
        Supply("gasket", f"{frame.gasket:g} mm", sealed / 1000, "m", "panels in frames"),
        Supply("screw", "by the system", screws, "piece", "pressure plates"),
    )
    table = Table("frames.csv", COLUMNS, tuple(rows))
    return Framed(
        *(tuple(parts), table, report, supplies),
        *(frame, words, members.frames, heights),
    )


def _fitted(
    site: Site, frame: PressureFrame, geometry: PanelGeometry, faces: Covered
) -> tuple[PressureFrame, _Members, _Beside, tuple[str, ...]]:
    """The frame that covers panels as their material needs, where it may grow and there is room."""
    members = _Members.of(site, frame.width, faces)
    beside = _Beside.of(members, frame, geometry, faces)
    short = site.material.bearing - float(beside.cover[members.built].min())
    if short <= 0 or not frame.grows:
        return frame, members, beside, ()
    wider = frame.covering(short)
    if wider.width > WIDEST:
        return frame, members, beside, ()
    try:
        members = _Members.of(site, wider.width, faces)
    except InputError:
        # The net has no room for it: the verdicts say what is missing.
        return frame, members, beside, ()
    words = (
        f"panels: pressure plates and caps are {wider.width:g} mm wide and cover {wider.cover:g} "
        f"mm, as {frame.width:g} mm would leave less than the {site.material.bearing:g} mm that "
        f"{site.material.name} needs where faces meet at an angle"
    )
    return wider, members, _Beside.of(members, wider, geometry, faces), (words,)


@dataclass(frozen=True, eq=False)
class _Members:
    """Straight members along the edges, cut as beams of their width are.

    Attributes:
        site: the net.
        frames: planes of the members.
        cuts: where they end.
        built: (E,) edges that have one.
    """

    site: Site
    frames: Frames
    cuts: Cuts
    built: BoolArray

    @classmethod
    def of(cls, site: Site, width: float, faces: Covered) -> _Members:
        """Members of a width along the edges of faces that have a panel."""
        built = faces.edges(site.mesh.connectivity.edge_faces)
        frames = beam_frames(site.mesh, site.axes)
        border = None
        if site.trimming is not None:
            border = BorderEnds.at_border(site, frames)
            built = built & border.within
            cuts = _cuts(site, frames, width, built)
            built = built & (border.lengths(site.mesh.edge_lengths, cuts, width / 2) > width)
        cuts = _cuts(site, frames, width, built)
        if border is not None:
            both = np.stack([built, built], axis=1)
            cuts = cuts.where(both, square(frames, 0 * frames.slope))
            border = replace(border, cut=border.cut & built[:, None])
            frames, cuts = border.applied(frames, cuts, site.mesh.edge_lengths, width / 2)
        members = cls(site, frames, cuts, built)
        members._refuse_wide(width)
        return members

    def _refuse_wide(self, width: float) -> None:
        setback = self.cuts.setback(width / 2)
        taken = np.maximum(setback[:, 0] + setback[:, 1], setback[:, 2] + setback[:, 3])
        room = self.site.mesh.edge_lengths
        wrong = self.built & (taken >= room)
        if wrong.any():
            edge = int(np.argmax(np.where(wrong, taken / room, 0.0)))
            raise InputError(
                f"frame width: {width:g} mm does not fit "
                f"{edge_name(self.site.mesh, np.arange(len(room)) == edge)}, whose mitres need "
                f"{taken[edge]:.1f} of its {room[edge]:.1f} mm; take at most "
                f"{rounded_down(width * float(room[edge] / taken[edge]))} mm"
            )

    def part(self, name: str, edge: int, under: float, section: tuple[Profile, float]) -> Part:
        """One member whose lower side is at a height above its edge, mm.

        Args:
            name: of the part.
            edge: its number.
            under: the height.
            section: of the member, and its wall, mm.
        """
        profile, wall = section
        up = under + profile.height / 2
        body = self._body(edge, up, profile)
        site, frames = self.site, self.frames
        degrees = [
            math.degrees(math.atan(value))
            for end in (body.first, body.last)
            for value in (end.up, end.right, end.left)
        ]
        return Part(
            name=name,
            kind="cap" if name.endswith("cap") else "pressure-plate",
            body=body,
            origin=site.mesh.vertices[site.mesh.connectivity.edges[edge, 0]]
            + up * frames.up[edge]
            + site.shift,
            frame=np.stack([frames.along[edge], frames.up[edge], -frames.left[edge]]),
            pattern=None,
            length=float(np.ptp(body.points[:, 0])),
            width=profile.height,
            thickness=wall,
            area=body.skin,
            volume=body.volume,
            material=MATERIALS["aluminium"],
            vertices=tuple(site.mesh.connectivity.edges[edge].tolist()),
            family=site.edge_family[edge],
            line=int(site.lines.edge_line[edge]),
            note=_SAW_WORDS.format(profile.name, *degrees),
            section_width=profile.width,
            section=profile.name,
        )

    def _body(self, edge: int, up: float, profile: Profile) -> ProfiledBody:
        slopes = self.frames.slope[edge] / self.frames.rise[edge]
        ends = self.cuts.middle[edge] * [1.0, -1.0] + [0.0, self.site.mesh.edge_lengths[edge]]
        first, last = (ends + up * slopes).tolist()
        right_first, right_last, left_last, left_first = self.cuts.slope[edge].tolist()
        return ProfiledBody(
            profile,
            End(first, float(slopes[0]), right_first, left_first),
            End(last, float(slopes[1]), -right_last, -left_last),
        )


def _cuts(site: Site, frames: Frames, width: float, built: BoolArray) -> Cuts:
    """Ends of members of the edges that are built, (E,): coped as the beams are, else mitred."""
    around = around_axes(site.mesh, site.axes, frames.along, built)
    beams = site.done["beams"].settings if "beams" in site.done else None
    ends = getattr(beams, "ends", "")
    if ends not in COPED:
        return mitred(frames, around)
    through = runs_through(site.lines, ends)
    alone = around_axes(site.mesh, site.axes, frames.along, built & through)
    others = coped(frames, around, through, width, getattr(beams, "clearance", 0.0))
    return mitred(frames, alone).where(np.stack([through, through], axis=1), others)


@dataclass(frozen=True, eq=False)
class _Beside:
    """Panels below the members, one row an edge; mm, NaN where there is none.

    Attributes:
        highest: (E,) height of the panels' upper sides above the edge where they are highest under
            the member.
        lowest: (E,) where they are lowest.
        cover: (E,) least width that the member covers of a panel.
    """

    highest: FloatArray
    lowest: FloatArray
    cover: FloatArray

    @classmethod
    def of(
        cls,
        members: _Members,
        frame: PressureFrame,
        geometry: PanelGeometry,
        faces: Covered,
    ) -> _Beside:
        """Look up planes and edges of the panels that there are."""
        made, bow = faces.made, faces.bow
        net, frames, mesh = members.site.mesh.connectivity, members.frames, members.site.mesh
        edge, half = net.face_edges, frame.width / 2
        on_left = net.edge_faces[edge, 0] == np.arange(len(edge))[:, None]
        outwards = np.where(on_left, 1.0, -1.0)[..., None] * frames.left[edge]
        start = mesh.vertices[net.edges[edge, 0]]
        normal = geometry.planes.frame[:, 2]
        on_top = geometry.planes.middle + geometry.levels[1][:, None] * normal
        rise = np.einsum("fk,fsk->fs", normal, frames.up[edge])
        heights = []
        for along in (0 * rise, mesh.edge_lengths[edge]):
            for across in (frame.joint / 2, half):
                point = start + along[..., None] * frames.along[edge] + across * outwards
                above = np.einsum("fk,fsk->fs", normal, on_top[:, None] - point)
                heights.append(above / rise)
        rims = geometry.planes.in_space(
            geometry.corners.trimmed(geometry.upper), geometry.levels[1]
        )
        away = np.einsum("fsek,fsk->fse", rims - start[:, :, None], outwards).max(axis=2)
        chosen = edge[made]
        highest, lowest = np.full(len(net.edges), -np.inf), np.full(len(net.edges), np.inf)
        cover = np.full(len(net.edges), np.inf)
        np.maximum.at(highest, chosen, (np.max(heights, axis=0) + bow[:, None])[made])
        np.minimum.at(lowest, chosen, (np.min(heights, axis=0) - bow[:, None])[made])
        np.minimum.at(cover, chosen, half - away[made])
        return cls(highest, lowest, cover)
