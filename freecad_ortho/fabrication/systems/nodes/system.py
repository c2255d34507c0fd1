"""The system of nodes: settings, parts, equal ones, report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.material import metal_for
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_options, check_size, offset_levels, size
from freecad_ortho.fabrication.systems.beams.balls import BallJoints
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from freecad_ortho.fabrication.systems.beams.frames import around_axes, beam_frames
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, mitred
from freecad_ortho.fabrication.systems.beams.options import (
    BOLTED,
    HUB_OPTIONS,
    PLAIN_HUB,
    SPLICED,
)
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.system import Beams
from freecad_ortho.fabrication.systems.edge_beam.hubs import (
    beside_edge_beam,
    no_room_words,
    without_hubs,
)
from freecad_ortho.fabrication.systems.nodes.ball_parts import BallMaking
from freecad_ortho.fabrication.systems.nodes.bolted import (
    equal_names,
    equal_report,
    with_balls,
    with_cover_plates,
    with_end_plates,
)
from freecad_ortho.fabrication.systems.nodes.fin_plates import FinMaking
from freecad_ortho.fabrication.systems.nodes.hubs import face_widths, hub
from freecad_ortho.fabrication.systems.nodes.sockets import least_radius, socket
from freecad_ortho.fabrication.systems.nodes.star_plates import StarMaking
from freecad_ortho.fabrication.systems.nodes.stars import Star, stars
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    HEIGHT,
    NO_BOUNDARY_BEAMS,
    OFFSET,
    plate_thickness,
)
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.option import Option

KINDS = ("hub", "bolted", "star", "ball", "through", "socket")
# How beams end that nodes of a kind join; those that a socket holds end in several ways.
ENDS_OF = {
    "hub": "hub",
    "bolted": "end-plate",
    "star": "cover-plate",
    "ball": "cone",
    "through": SPLICED[0],
}
BOLTED_KINDS = tuple(kind for kind, ends in ENDS_OF.items() if ends in BOLTED)


@dataclass(frozen=True)
class Nodes(System):
    """A joint at every vertex: a hub that beams are butted on, or a socket under a crossing.

    Where there are beams, these say how high and thick they are, what lies above the net, how much
    room is left, how wide the hubs are that they end at, and how they are bolted to these.

    Args:
        kind: "hub", a prism about the axis with a face square to each beam, as high as the beams;
            "bolted", a hollow one with an end plate on each beam that is bolted to it from inside;
            "star", plates welded along the axis, one a beam, bolted to its web by cover plates;
            "through", plates welded to the beams that run through, one for each of the others;
            "ball", a ball that round tubes are screwed into, each by a bolt in its conical end;
            "socket", a printed disc under the beams with a slot for each plate.
        diameter: of the hub across its faces, of the star, the ball or the disc, mm; by default
            100, of bolted hubs, stars and balls as large as each has to be.
        bore: diameter of a hole along the hub's axis, mm; 0 for none.
        depth: how far plates stand in a socket, mm; its disc is a third as thick.
        height: of the beams, mm.
        thickness: of the beams, mm.
        offset: of the beams.
        clearance: on both sides of a plate in a socket together, and below it, mm.
        boundary_beams: false where the edges of the boundary have no beams.
        bolt: size of the bolts.
        bolts: above each other, 1 or 2.
        wall: thickness of the walls of bolted hubs, mm; by default as thick as the bolts.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    kind: str = "hub"
    diameter: float | None = None
    bore: float = 0.0
    depth: float = 30.0
    height: float = 200.0
    thickness: float = 20.0
    offset: str = "centre"
    clearance: float = 1.0
    boundary_beams: bool = True
    bolt: str = "M16"
    bolts: int = 2
    wall: float | None = None

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "nodes"
    options: ClassVar[tuple[Option, ...]] = (
        Option("node", "hub", "choice", "the beams are joined by hubs or sockets", KINDS),
        *HUB_OPTIONS,
        Option(
            "bore",
            0.0,
            "length",
            "the hubs have a hole of this diameter along their axis",
            absent="none",
        ),
        size("socket_depth", 30.0, "the plates stand this deep in the sockets"),
        HEIGHT,
        plate_thickness(20.0),
        OFFSET,
        CLEARANCE,
        NO_BOUNDARY_BEAMS,
    )

    def __post_init__(self) -> None:
        check_options(
            self,
            self.options,
            kind="node",
            diameter="hub_diameter",
            depth="socket_depth",
            wall="hub_wall",
        )
        check_size("hub diameter", self.across)
        if not 0 <= self.bore < 0.8 * self.across:
            raise InputError(
                f"bore: expected 0 to {0.8 * self.across:g} mm in a hub of {self.across:g} mm, "
                f"got {self.bore:g}"
            )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Nodes:
        """Make the settings from options."""
        given = dict(values)
        given["boundary_beams"] = not given.pop("no_boundary_beams")
        names = {"kind": "node", "diameter": "hub_diameter", "depth": "socket_depth"}
        names["wall"] = "hub_wall"
        return cls(**{own: given.pop(option) for own, option in names.items()}, **given)

    @property
    def across(self) -> float:
        """Diameter of hubs without bolts and of sockets, mm."""
        return PLAIN_HUB if self.diameter is None else self.diameter

    def build(self, site: Site) -> SystemParts:
        """Work out the joints at the vertices of the chosen edges.

        Raises:
            InputError: a hub too small for its beams, or beams that leave it no room.
        """
        beams = site.done["beams"].settings if "beams" in site.done else None
        if isinstance(beams, Beams):
            return self._fitting(beams)._build(site, beams)
        if self.kind in BOLTED_KINDS:
            beams = self._as_beams()
            geometry = replace(beams.build(site), settings=beams)
            return self._build(replace(site, done={**site.done, "beams": geometry}), beams)
        return self._build(site, None)

    def _as_beams(self) -> Beams:
        """The beams that bolted nodes without any would join."""
        tube = f"chs:{self.height:g}x{self.thickness:g}"
        return Beams(
            self.height,
            self.thickness,
            self.offset,
            section=tube if self.kind == "ball" else "plate",
            ends=ENDS_OF[self.kind],
            hub_diameter=self.diameter,
            clearance=self.clearance,
            boundary_beams=self.boundary_beams,
            bolt=self.bolt,
            bolts=self.bolts,
            hub_wall=self.wall,
        )

    def _fitting(self, beams: Beams) -> Nodes:
        """These joints with the sizes of the beams that they join."""
        ends = ENDS_OF.get(self.kind)
        if (
            ends is not None
            and beams.ends != ends
            and not (ends in SPLICED and beams.ends in SPLICED)
        ):
            raise InputError(
                f"nodes: the beams are {beams.ends} and leave no room for hubs; set ends {ends}, "
                f"or take other nodes"
            )
        if ends is None and (beams.ends in ENDS_OF.values() or beams.section != "plate"):
            raise InputError(
                "nodes: sockets hold plates that reach their axes; set section plate and ends "
                "mitred or lapped, or take hubs for nodes"
            )
        return replace(
            self,
            diameter=self.diameter if ends is None else beams.hub_diameter,
            height=beams.sizes.height,
            thickness=beams.profile.overall_width,
            offset=beams.offset,
            clearance=beams.clearance,
            boundary_beams=beams.boundary_beams,
            bolt=beams.bolt,
            bolts=beams.bolts,
            wall=beams.hub_wall,
        )

    def _build(self, site: Site, beams: Beams | None) -> SystemParts:
        if self.kind in BOLTED_KINDS:
            site = replace(site, material=metal_for(site.material))
        frames = beam_frames(site.mesh, site.axes)
        geometry = site.geometry_of("beams", BeamGeometry)
        built = site.chosen_edges.copy()
        if not self.boundary_beams:
            built &= ~site.mesh.connectivity.boundary_edges
        within = np.ones(len(site.mesh.vertices), dtype=bool)
        if site.trimming is not None:
            kept = np.isin(np.arange(len(built)), list(site.trimming.spans))
            built &= kept if geometry is None else geometry.built
            within = site.trimming.vertices(site.mesh.connectivity.edges)
        bolted = None if geometry is None or self.kind not in BOLTED_KINDS else geometry.bolted
        if geometry is None or bolted is None:
            room = ~without_hubs(site, self.across)
        else:
            room = geometry.hub_radii > 0
        if not built.any():
            return SystemParts(())
        around = around_axes(site.mesh, site.axes, frames.along, built)
        meeting = [star for star in stars(frames, around) if within[star.vertex]]
        joined = [star for star in meeting if room[star.vertex]]
        names = part_names("N", len(site.mesh.vertices))
        missing = [star.vertex for star in meeting if not room[star.vertex]]
        left_out = [names[vertex] for vertex in beside_edge_beam(site, missing)]
        if geometry is not None and isinstance(bolted, EndPlates):
            made = with_end_plates(site, geometry, bolted, joined)
        elif geometry is not None and isinstance(bolted, BallJoints):
            made = with_balls(BallMaking(site, geometry, bolted), joined)
        elif geometry is not None and isinstance(bolted, CoverPlates):
            section = beams.profile if beams is not None else None
            assert isinstance(section, Section)
            making = FinMaking if isinstance(bolted, FinPlates) else StarMaking
            mitres = mitred(frames, around)
            made = with_cover_plates(making(site, geometry, section, bolted, mitres), joined)
        else:
            made = self._plain(site, names, joined)
        report = made.report | ({"no_room": left_out} if left_out else {})
        return replace(made, report=report, messages=(*made.messages, *no_room_words(left_out)))

    def _plain(self, site: Site, names: Sequence[str], joined: Sequence[Star]) -> SystemParts:
        """Solid hubs, or sockets."""
        parts = tuple(self._part(site, names[star.vertex], star) for star in joined)
        groups = equal_names(parts)
        report = {
            "kind": self.kind,
            "diameter_mm": self.across,
            **equal_report(groups),
            **sums(parts),
        }
        printed = tuple(part for part in parts if part.name in groups)
        return SystemParts(parts, report, geometry=self._hubs(site, parts), joints=printed)

    def _hubs(self, site: Site, parts: tuple[Part, ...]) -> dict[int, FloatArray]:
        """(2, K, 3) lower and upper corners of the hub at each vertex, in the site's mesh, mm."""
        if self.kind != "hub":
            return {}
        return {part.vertices[0]: (part.points - site.shift).reshape(2, -1, 3) for part in parts}

    def _part(self, site: Site, name: str, star: Star) -> Part:
        vertex, _, arms, turn = star
        axis = site.axes.directions[vertex]
        length = float(np.linalg.norm(site.axes.offsets[vertex]))
        body = self._body(name, turn, arms @ axis, length)
        return Part(
            name=name,
            kind="node",
            body=body,
            origin=site.mesh.vertices[vertex] + site.shift,
            frame=_frame(arms[0], axis),
            pattern=None,
            length=float(np.ptp(body.points[:, 2])),
            width=self.across,
            thickness=self.across,
            area=0.0,
            volume=body.volume,
            material=site.material,
            vertices=(vertex,),
            measures=Measures(lean_deg=float(site.axes.lean_deg[vertex])),
        )

    def _body(self, name: str, turn: FloatArray, rises: FloatArray, length: float) -> Body:
        """Body of one joint: directions of its beams, their rise, and length of its offset."""
        radius = self.across / 2
        low, high = (level * length for level in offset_levels(self.offset, self.height))
        if self.kind == "hub":
            narrow = float(face_widths(turn, radius).min())
            if narrow < self.thickness:
                raise InputError(
                    f"hub: {name} has {narrow:.1f} mm for beams {self.thickness:g} mm thick; take "
                    f"at least {self.across * self.thickness / narrow:.0f} mm hub diameter"
                )
            return hub(turn, radius, low, high, self.bore)
        half = (self.thickness + self.clearance) / 2
        least = 1.2 * least_radius(turn, half)
        if radius < least:
            raise InputError(
                f"hub: the socket {name} leaves no pillars between plates {self.thickness:g} mm "
                f"thick; take at least {2 * least:.0f} mm hub diameter"
            )
        # Undersides of plates that slope down from the axis stay above the disc.
        slopes = rises / np.sqrt(1 - rises**2)
        floor = low + min(0.0, float(slopes.min())) * radius - self.clearance / 2
        levels = np.array([floor - self.depth / 3, floor, floor + self.depth])
        return socket(turn, radius, half, levels)


def _frame(arm: FloatArray, axis: FloatArray) -> FloatArray:
    """(3, 3) x towards the first beam, z along the axis."""
    first = unit_rows((arm - (arm @ axis) * axis)[None])[0]
    return np.stack([first, np.cross(axis, first), axis])
