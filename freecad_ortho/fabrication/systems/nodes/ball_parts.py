"""Balls with their holes, and the sleeves and cones of the tubes that are screwed into them."""

from __future__ import annotations

from collections import Counter

import numpy as np

from freecad_ortho.fabrication.ball_body import Ball
from freecad_ortho.fabrication.bodies import Body, Prism
from freecad_ortho.fabrication.bolt_strength import COLUMNS, Clamped
from freecad_ortho.fabrication.bolts import GRADE, HEADS, ROUND_BARS
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.ball_tubes import axis_level, ball_stations
from freecad_ortho.fabrication.systems.beams.balls import BallJoints
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.system import Table
from freecad_ortho.fabrication.turned import TurnedBody
from solver.mesh.quadmesh import FloatArray, unit_rows

_ENDS = ("start", "end")
_BOLT_COLUMNS = (
    *("bolt", "length_mm", "standard", "grade", "count"),
    *("grip_mm", "thread_mm", "hole_mm", "drill_mm", *COLUMNS),
)
_HOLE_COLUMNS = (
    *("ball", "diameter_mm", "hole", "beam", "end", "azimuth_deg", "elevation_deg"),
    *("seat_mm", "thread", "drill_mm", "depth_mm"),
)
_TURNED_COLUMNS = (
    *("kind", "count", "material", "from", "length_mm", "diameter_mm", "small_end_mm", "hole_mm"),
    *("end_mm", "opening_small_mm", "opening_mm", "mass_kg"),
)
_HEXAGON = np.pi / 3 * np.arange(6)


class BallMaking:
    """Balls one after the other, and what stands on their seats."""

    def __init__(self, site: Site, beams: BeamGeometry, joints: BallJoints) -> None:
        self.site, self.beams, self.joints = site, beams, joints
        self.diameters = joints.diameters(beams.hub_radii)
        self.stations, self.level = ball_stations(beams), axis_level(beams)
        self.pieces: dict[tuple[int, int], tuple[Part, Part]] = {}
        self.holes: list[tuple[object, ...]] = []
        self.placed: list[tuple[FloatArray, FloatArray, tuple[str, ...]]] = []
        self.sizes: list[float] = []
        self.nodes = part_names("N", len(site.mesh.vertices))
        self.names = part_names("B", len(beams.lengths))
        self.cone, self.sleeve = self._cone(), self._sleeve()

    def ball(self, star: Star) -> Part:
        """The ball of a vertex; what stands on it goes into ``pieces``, its holes into ``holes``.

        z is the node axis, and x lies below or above the first of its beams.
        """
        site, vertex, count = self.site, star.vertex, len(self.names)
        axis = site.axes.directions[vertex]
        places = [(int(half % count), int(half // count)) for half in star.half_edges]
        met = [k for k, place in enumerate(places) if self.beams.meeting[place]]
        first = unit_rows((star.arms[0] - (star.arms[0] @ axis) * axis)[None])[0]
        frame = np.stack([first, np.cross(axis, first), axis])
        ways = star.arms[met] @ frame.T
        joints, diameter = self.joints, float(self.diameters[vertex])
        self.sizes.append(diameter)
        seat = float(self.beams.hub_radii[vertex])
        body = Ball(diameter / 2, ways, seat, joints.bolt.drill, joints.depth)
        for number, (k, way) in enumerate(zip(met, ways, strict=True)):
            self._hole(vertex, places[k], number, way, diameter)
            self.pieces[places[k]] = self._on_seat(vertex, places[k], star.arms[k])
        return Part(
            name=self.nodes[vertex],
            kind="node",
            body=body,
            origin=self._middle(vertex) + site.shift,
            frame=frame,
            pattern=None,
            length=diameter,
            width=diameter,
            thickness=diameter,
            area=0.0,
            volume=body.volume,
            material=site.material,
            vertices=(vertex,),
            measures=Measures(lean_deg=float(site.axes.lean_deg[vertex])),
            note=f"{len(met)} holes {joints.bolt.name}, {joints.depth:g} mm deep: ball-holes.csv",
        )

    def _middle(self, vertex: int) -> FloatArray:
        """(3,) of a ball, in the site's mesh."""
        site = self.site
        return np.asarray(site.mesh.vertices[vertex] + self.level * site.axes.offsets[vertex])

    def _hole(
        self, vertex: int, place: tuple[int, int], number: int, way: FloatArray, diameter: float
    ) -> None:
        """One row of the list that balls are drilled by."""
        azimuth = float(np.degrees(np.arctan2(way[1], way[0]))) % 360
        elevation = float(np.degrees(np.arcsin(np.clip(way[2], -1, 1))))
        bolt = self.joints.bolt
        self.holes.append(
            (
                *(self.nodes[vertex], diameter, number + 1, self.names[place[0]]),
                # A direction that rounds to a whole turn is none.
                *(_ENDS[place[1]], round(azimuth, 3) % 360, round(elevation, 3)),
                round(float(self.beams.hub_radii[vertex]), 3),
                *(bolt.name, bolt.drill, self.joints.depth),
            )
        )

    def _on_seat(self, vertex: int, place: tuple[int, int], arm: FloatArray) -> tuple[Part, Part]:
        """Cone and sleeve of a beam, z from the ball to the beam.

        They are of no line: what is sawn from bars for one are its tubes, these are turned.
        """
        edge, end = place
        up = self.level * float(self.beams.rise[edge])
        along, upright, right = self.beams.frame[edge]
        middle = self.beams.start[edge] + float(self.stations[edge, end]) * along + up * upright
        frame = np.stack([right, np.cross(arm, right), arm])
        reach, name = float(self.beams.hub_radii[vertex]), f"{self.names[edge]}-{_ENDS[end]}"
        head = middle + (reach + self.joints.sleeve + self.joints.end) * arm + self.site.shift
        self.placed.append((head, -arm, (name, f"{name}-sleeve", self.nodes[vertex])))
        sleeve, cone = (
            Part(
                name=name + suffix,
                kind=kind,
                body=body,
                origin=middle + away * arm + self.site.shift,
                frame=frame,
                pattern=None,
                length=length,
                width=width,
                thickness=thickness,
                area=0.0,
                volume=body.volume,
                material=self.site.material,
                vertices=(vertex,),
                note=words,
            )
            for suffix, kind, body, away, length, width, thickness, words in (
                ("-sleeve", "sleeve", self.sleeve, reach, *self._sleeve_sizes()),
                ("", "cone", self.cone, reach + self.joints.sleeve, *self._cone_sizes()),
            )
        )
        return cone, sleeve

    def _sleeve_sizes(self) -> tuple[float, float, float, str]:
        """Length, width and wall of sleeves, and what they are turned from."""
        joints = self.joints
        wall = (joints.flats - joints.bolt.hole) / 2
        return (
            joints.sleeve,
            joints.flats,
            wall,
            f"hexagon bar {joints.flats:g}, pinned to its bolt",
        )

    def _cone_sizes(self) -> tuple[float, float, float, str]:
        """Length, width and wall of cones, and what they are."""
        joints = self.joints
        words = f"welded to its tube, end {joints.end:g} mm with a hole of {joints.bolt.hole:g} mm"
        return joints.cone, joints.tube, joints.wall, words

    def _cone(self) -> Body:
        """From its small end: the hole for the bolt, room for its head, then as the tube."""
        joints = self.joints
        outer = [(0.0, joints.corners / 2), (joints.cone, joints.tube / 2)]
        hole, behind = joints.bolt.hole / 2, joints.room
        inner = [(0.0, hole), (joints.end, hole), (joints.end, behind)]
        return TurnedBody(
            np.array(outer), np.array([*inner, (joints.cone, joints.tube / 2 - joints.wall)])
        )

    def _sleeve(self) -> Body:
        corners = self.joints.corners / 2 * np.stack([np.cos(_HEXAGON), np.sin(_HEXAGON)], axis=1)
        return Prism(corners, 0.0, self.joints.sleeve, self.joints.bolt.hole)

    @property
    def clamped(self) -> Clamped:
        """A bolt as it is pulled at the end of its cone; sleeves take what presses."""
        bolt, end = self.joints.bolt, self.joints.end
        return Clamped(bolt, 0, 0.0, end, bolt.edge, None, self.site.material)

    @property
    def fasteners(self) -> Fasteners:
        """The bolts in their places, screwed in."""
        joints = self.joints
        grip = joints.end + joints.sleeve
        return gathered(joints.bolt, joints.length, grip, 0, False, "cones and balls", self.placed)

    def _turned(self) -> Table:
        """What a turner makes: cones and sleeves, which are all alike, and balls by size; mm.

        ``from`` is the bar to take, ``end_mm`` the thickness at a cone's small end; its opening
        widens behind that.
        """
        joints, site = self.joints, self.site
        count, hole = len(self.pieces), joints.bolt.hole
        bar = next((f"round bar {size}" for size in ROUND_BARS if size >= joints.tube), "forging")
        rows: list[tuple[object, ...]] = []
        if count:
            cone, sleeve = next(iter(self.pieces.values()))
            opening = (round(2 * joints.room, 3), round(joints.tube - 2 * joints.wall, 3))
            rows += [
                (
                    *("cone", count, cone.material.name, bar, round(joints.cone, 3), joints.tube),
                    *(round(joints.corners, 3), hole, joints.end, *opening, round(cone.mass, 3)),
                ),
                (
                    *("sleeve", count, sleeve.material.name, f"hexagon bar {joints.flats:g}"),
                    *(round(joints.sleeve, 3), "", "", hole, "", "", "", round(sleeve.mass, 3)),
                ),
            ]
        for size, number in sorted(Counter(self.sizes).items()):
            mass = site.material.mass(np.pi / 6 * size**3)
            rows.append(
                (
                    *("ball", number, site.material.name, f"ball {size:g}", size, size),
                    *("", "", "", "", "", round(mass, 3)),
                )
            )
        return Table("turned-parts.csv", _TURNED_COLUMNS, tuple(rows))

    def tables(self) -> tuple[Table, ...]:
        """Bolts, which are all alike, holes of balls, and what is turned."""
        joints, bolt = self.joints, self.joints.bolt
        row = (
            *(bolt.name, joints.length, HEADS, GRADE, len(self.pieces)),
            *(joints.end + joints.sleeve, joints.thread, bolt.hole, bolt.drill),
            *self.clamped.row(),
        )
        return (
            Table("bolts.csv", _BOLT_COLUMNS, (row,)),
            Table("ball-holes.csv", _HOLE_COLUMNS, tuple(self.holes)),
            self._turned(),
        )
