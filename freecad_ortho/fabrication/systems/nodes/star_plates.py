"""Stars: a plate an arm, welded along the axis, and the cover plates that bolt beams to them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import numpy as np

from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Polyhedron, prism_sides
from freecad_ortho.fabrication.bolt_strength import COLUMNS, Clamped
from freecad_ortho.fabrication.bolts import GRADE, HEADS, NUTS, WASHERS
from freecad_ortho.fabrication.drilled import drilled, drilled_plate
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.pattern import Bevel, FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates, half_slopes
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, Cuts
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.web_holes import AWAY, bolt_places, joint_middles
from freecad_ortho.fabrication.systems.nodes.hubs import gaps_after
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.quadmesh import FloatArray

_ENDS = ("start", "end")
# Numbers of the left and the right side of an arm, at the start and the end of a beam: its corners
# run from the axis to the right and back on the left, or from the right to the axis and on.
_SIDES = ((5, 3), (5, 2))
_BOLT_COLUMNS = (
    *("bolt", "length_mm", "standard", "grade", "count", "washers", "nuts"),
    *("grip_mm", "hole_mm", *COLUMNS),
)


class StarMaking:
    """Stars one after the other, and the cover plates of the beams at each."""

    kind: ClassVar[str] = "star"
    holds: ClassVar[str] = "webs and arms of stars"

    def __init__(
        self, site: Site, beams: BeamGeometry, section: Section, covers: CoverPlates, mitres: Cuts
    ) -> None:
        self.site, self.beams, self.covers, self.mitres = site, beams, covers, mitres
        edges = site.mesh.connectivity.edges
        self.levels = section.web_levels(beams)
        self.middles = joint_middles(beams, section, covers, edges)
        self.places = bolt_places(self.middles, covers, -1)
        self.beside = bolt_places(self.middles, covers, 1)
        self.web = "" if section.kind == "plate" else "-web"
        self.placed: list[tuple[FloatArray, FloatArray, tuple[str, ...]]] = []
        self.plates: dict[tuple[int, int, str], Part] = {}
        self.nodes = part_names("N", len(site.mesh.vertices))
        self.names = part_names("B", len(beams.lengths))
        self.weld_gap = 0.0
        self.families, self.lines = site.edge_family, site.lines.edge_line.tolist()

    def arms(self, star: Star) -> tuple[Part, ...]:
        """The arms of a star; its cover plates go into ``plates``."""
        count = len(self.names)
        made = []
        for k, half in enumerate(star.half_edges.tolist()):
            place = half % count, half // count
            if self.beams.meeting[place] and self.meets(star, k):
                made.append(self._arm(star, k, place))
                for side in ("left", "right"):
                    self.plates[(*place, side)] = self._cover(star.vertex, place, side)
                self._place_bolts(made[-1].name, place)
        return tuple(made)

    def meets(self, star: Star, number: int) -> bool:
        """Whether a beam has an arm."""
        return True

    def _arm(self, star: Star, number: int, place: tuple[int, int]) -> Part:
        """The plate of one arm, in the coordinates of its beam: along, up, to the right."""
        edge, end = place
        corners = self._corners(star, number, place)
        flat = corners[:, :2]
        origin = np.append(flat.min(axis=0), 0.0)
        body = Polyhedron(corners - origin, prism_sides(5))
        holes = tuple(
            Hole(each - origin[:2], self.covers.bolt.hole) for each in self.places[edge, end]
        )
        half = self.covers.web / 2
        name = f"{self.nodes[star.vertex]}-{number + 1}"
        # The middle plane: from the axis, or from the beam, to the other end and back.
        inner, outer = (0, 2) if end == 0 else (2, 0)
        outline = np.array([flat[k] for k in (inner, outer, outer + 5, inner + 5)]) - origin[:2]
        if end:
            outline = outline[[1, 0, 3, 2]]
        pattern = _pattern(name, self._part_of(edge), outline, holes, bevels_of(body), end)
        frame = self.beams.frame[edge]
        return plate_part(
            self.site,
            name,
            "node",
            drilled(body, holes, (-half, half), _SIDES[end]),
            (self.beams.start[edge] + origin @ frame, frame),
            pattern,
            self.covers.web,
            vertices=(star.vertex,),
            family=self.families[edge],
            line=self.lines[edge],
            assembly="; ".join(self._doubts(star, number, self.names[edge])),
        )

    def _corners(self, star: Star, number: int, place: tuple[int, int]) -> FloatArray:
        """(10, 3) corners of an arm, five below and five above."""
        edge, end = place
        half, slope = self.covers.web / 2, float(self.beams.slopes[edge, end])
        reach = float(self.beams.hub_radii[star.vertex]) * np.hypot(1.0, slope)
        start = float(self.beams.lengths[edge]) if end else 0.0
        middle, right, left = self._start(star, number, place)
        steps = [(middle, 0.0), (right, half), (reach, half), (reach, -half), (left, -half)]
        if end:
            steps = [steps[k] for k in (2, 1, 0, 4, 3)]
        rings = []
        for level in self.levels:
            up = float(level[edge])
            rings += [(start + slope * up + AWAY[end] * away, up, side) for away, side in steps]
        return np.array(rings)

    def _start(self, star: Star, number: int, place: tuple[int, int]) -> tuple[float, float, float]:
        """How far an arm begins from the axis, along its beam: in its middle, right and left."""
        edge, end = place
        # The mitres on the right and left, see ``Cuts``.
        right, left = self.mitres.slope[edge][[0, 3] if end == 0 else [1, 2]].tolist()
        half = self.covers.web / 2
        return 0.0, half * right, half * left

    def _cover(self, vertex: int, place: tuple[int, int], side: str) -> Part:
        """A cover plate at the end of a beam."""
        edge, end = place
        name = f"{self.names[edge]}-{_ENDS[end]}-{side}"
        return self.cover(name, edge, self.middles[edge, end], side, self.nodes[vertex], (vertex,))

    def cover(
        self,
        name: str,
        edge: int,
        middle: FloatArray,
        side: str,
        mark: str,
        vertices: tuple[int, ...],
    ) -> Part:
        """A cover plate about a middle (2,) along the beam and up, seen from outside."""
        covers = self.covers
        size = np.array([2 * covers.half_length, covers.height])
        places = [
            np.array([sign * covers.back, height]) for sign in (-1, 1) for height in covers.heights
        ]
        holes = tuple(Hole(size / 2 + each, covers.bolt.hole) for each in places)
        pattern = _cover_pattern(name, mark, size, holes)
        turn = np.diag([1.0, 1.0, 1.0] if side == "right" else [-1.0, 1.0, -1.0])
        corner = np.append(middle, 0.0) + turn @ np.array(
            [-covers.half_length, -covers.height / 2, covers.web / 2]
        )
        frame = self.beams.frame[edge]
        return plate_part(
            self.site,
            name,
            "cover-plate",
            drilled_plate(pattern, covers.thickness),
            (self.beams.start[edge] + corner @ frame, turn @ frame),
            pattern,
            covers.thickness,
            vertices=vertices,
            family=self.families[edge],
            line=self.lines[edge],
        )

    def _place_bolts(self, arm: str, place: tuple[int, int]) -> None:
        """Note where the bolts of a joint stand, their heads on the right of the beam."""
        edge, end = place
        plates, web = f"{self.names[edge]}-{_ENDS[end]}", self._part_of(edge) + self.web
        for name, places in ((arm, self.places), (web, self.beside)):
            self.bolt_through(edge, places[edge, end], plates, name)

    def _part_of(self, edge: int) -> str:
        """Name of the beam along an edge, or of the folded plate that it is a part of."""
        return self.beams.folded.get(edge, self.names[edge])

    def bolt_through(self, edge: int, flat: FloatArray, plates: str, joined: str) -> None:
        """Note bolts at places (N, 2) in the plane of a beam, through what both plates join."""
        covers, frame = self.covers, self.beams.frame[edge]
        origin = self.beams.start[edge] + self.site.shift
        out = covers.web / 2 + covers.thickness + covers.bolt.washer
        joins = f"{plates}-right", joined, f"{plates}-left"
        points = origin + np.column_stack([flat, np.full(len(flat), out)]) @ frame
        self.placed += [(point, -frame[2], joins) for point in points]

    def more(self) -> dict[str, float]:
        """What the report says of these nodes alone."""
        return {}

    def remarks(self) -> tuple[str, ...]:
        """Messages about these nodes."""
        return ()

    @property
    def fasteners(self) -> Fasteners:
        """The bolts in their places."""
        covers = self.covers
        return gathered(covers.bolt, covers.length, self.grip, 2, True, self.holds, self.placed)

    @property
    def grip(self) -> float:
        """What lists call the grip: from under the head to the nut, washers within it, mm."""
        return self.covers.grip + 2 * self.covers.bolt.washer

    def _doubts(self, star: Star, arm: int, beam: str) -> list[str]:
        """What keeps the bolts of a beam from being put in and tightened."""
        gaps, covers, bolt = gaps_after(star.turn), self.covers, self.covers.bolt
        slopes = half_slopes(np.array([gaps[arm], gaps[arm - 1]]))
        radius = float(self.beams.hub_radii[star.vertex])
        words = []
        needed = float(covers.wrench(slopes).max())
        if radius < needed - 1e-9:
            words.append(
                f"the bolts of beam {beam} cannot be reached: {bolt.wrench - needed + radius:.1f} "
                f"mm beside the next beam, a wrench for {bolt.name} needs {bolt.wrench:g} mm"
            )
        needed = float(covers.way_in(slopes).min())
        if radius < needed - 1e-9:
            words.append(
                f"the bolts of beam {beam} cannot be put in beside the next beams: "
                f"{bolt.name}x{covers.length:g} needs arms {needed:.0f} mm long, these have "
                f"{radius:g} mm"
            )
        return words

    @property
    def clamped(self) -> Clamped:
        """A bolt by its plates: sheared on both sides of the web."""
        covers, bolt = self.covers, self.covers.bolt
        plate, apart = min(covers.web, 2 * covers.thickness), covers.apart or None
        head = covers.thickness
        return Clamped(bolt, 2, plate, head, bolt.edge, apart, self.site.material)

    def bolt_list(self) -> Table:
        """One row, as all bolts are alike."""
        covers, bolt = self.covers, self.covers.bolt
        count = len(self.placed)
        row = (
            *(bolt.name, covers.length, HEADS, GRADE, count),
            *(f"{2 * count} {WASHERS}", f"{count} {NUTS}", self.grip, bolt.hole),
            *self.clamped.row(),
        )
        return Table("bolts.csv", _BOLT_COLUMNS, (row,))


def _pattern(
    name: str,
    beam: str,
    outline: FloatArray,
    holes: Sequence[Hole],
    bevels: tuple[Bevel, ...],
    end: int,
) -> FlatPattern:
    """An arm seen from the right of its beam, its names between the axis and the holes."""
    inner = outline[[0, 3], 0].max() if end == 0 else outline[[1, 2], 0].min()
    bolts = np.array([hole.centre[0] for hole in holes])
    edge = bolts.min() - holes[0].diameter / 2 if end == 0 else bolts.max() + holes[0].diameter / 2
    width, height = abs(float(edge - inner)), float(np.ptp(outline[:, 1]))
    middle = np.array([(edge + inner) / 2, outline[:, 1].mean()])
    size_of_name = fitted_text_size(name, 0.8 * width, height / 4, 12.0)
    size_of_beam = fitted_text_size(beam, 0.8 * width, height / 4, 12.0)
    shift = np.array([0.0, height / 8])
    marks = (Mark((middle - shift)[None], beam, size_of_beam),)
    return FlatPattern(
        outline,
        marks,
        middle + shift,
        size_of_name,
        holes=tuple(holes),
        bevels=bevels,
        seen="right",
    )


def _cover_pattern(name: str, node: str, size: FloatArray, holes: tuple[Hole, ...]) -> FlatPattern:
    """A rectangle with its holes, the names above and below its middle."""
    width, height = size.tolist()
    outline = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    across = sorted({float(hole.centre[0]) for hole in holes})
    room = across[-1] - across[0] - holes[0].diameter
    size_of_name = fitted_text_size(name, 0.9 * room, height / 4, 12.0)
    size_of_node = fitted_text_size(node, 0.9 * room, height / 4, 12.0)
    marks = (Mark(np.array([[width / 2, 0.4 * height]]), node, size_of_node),)
    label = np.array([width / 2, 0.6 * height])
    return FlatPattern(outline, marks, label, size_of_name, holes=holes, seen="outside")
