"""Hollow hubs, and the end plates of beams that are bolted to them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.bolt_strength import COLUMNS, Clamped
from freecad_ortho.fabrication.bolts import BOLTS, GRADE, HEADS, WASHERS
from freecad_ortho.fabrication.drilled import drilled_plate
from freecad_ortho.fabrication.fasteners import Fasteners, gathered
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.end_plates import WIDEST, EndPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.nodes.hollow import BoltHole, hollow_hub
from freecad_ortho.fabrication.systems.nodes.hubs import face_normals, gaps_after
from freecad_ortho.fabrication.systems.nodes.seats import seats
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.system import Table
from freecad_ortho.words import counted
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

_ENDS = ("start", "end")
_HOLE_COLUMNS = ("hub", "plate", "azimuth_deg", "from_lower_mm", "face_mm", "hole_mm")
_BOLT_COLUMNS = (
    *("bolt", "length_mm", "standard", "grade", "count", "washers"),
    *("grip_mm", "thread_mm", "hole_mm", "drill_mm", *COLUMNS),
)


class HubMaking:
    """Hubs one after the other, and the plates that stand on them."""

    def __init__(self, site: Site, beams: BeamGeometry, sizes: EndPlates) -> None:
        self.site, self.beams, self.sizes = site, beams, sizes
        self.seats = seats(site, beams, sizes)
        self.plates: dict[tuple[int, int], Part] = {}
        self.single: list[str] = []
        self.holes: list[tuple[object, ...]] = []
        self.placed: list[tuple[FloatArray, FloatArray, tuple[str, ...]]] = []
        self.nodes = part_names("N", len(site.mesh.vertices))
        self.names = part_names("B", len(beams.lengths))
        self.families, self.lines = site.edge_family, site.lines.edge_line.tolist()

    def hub(self, star: Star) -> Part:
        """The hub of a vertex; its plates go into ``plates``."""
        site, vertex, count = self.site, star.vertex, len(self.names)
        axis = site.axes.directions[vertex]
        places = [(int(half % count), int(half // count)) for half in star.half_edges]
        met = [k for k, place in enumerate(places) if self.beams.meeting[place]]
        offset = float(np.linalg.norm(site.axes.offsets[vertex]))
        low, high = (level * offset for level in self.beams.levels)
        low = min([low, *(float(self.seats.low[places[k]]) for k in met)])
        holes = []
        for k in met:
            heights = self._bolts(vertex, places[k], low, high)
            holes += [BoltHole(k, height, self.sizes.bolt.hole) for height in heights]
            self.plates[places[k]] = self._plate(vertex, places[k], heights)
            self._note_holes(star, k, places[k], [height - low for height in heights])
            self._place_bolts(vertex, places[k], heights)
        radius = float(self.beams.hub_radii[vertex])
        body = hollow_hub(star.turn, radius, self.sizes.wall, (low, high), holes)
        first = unit_rows((star.arms[0] - (star.arms[0] @ axis) * axis)[None])[0]
        return Part(
            name=self.nodes[vertex],
            kind="node",
            body=body,
            origin=site.mesh.vertices[vertex] + site.shift,
            frame=np.stack([first, np.cross(axis, first), axis]),
            pattern=None,
            length=high - low,
            width=2 * radius,
            thickness=self.sizes.wall,
            area=0.0,
            volume=body.volume,
            material=site.material,
            vertices=(vertex,),
            measures=Measures(lean_deg=float(site.axes.lean_deg[vertex])),
            note=f"{len(holes)} holes of {self.sizes.bolt.hole:g} mm for {self._bolt_words()}: "
            "hub-holes.csv",
            assembly="; ".join(
                words for k in met for words in self._doubts(star, k, self.names[places[k][0]])
            ),
        )

    def _note_holes(
        self, star: Star, beam: int, place: tuple[int, int], above: list[float]
    ) -> None:
        """What a hub is drilled by: from its first beam on, from its lower end up, mm."""
        plate = f"{self.names[place[0]]}-{_ENDS[place[1]]}"
        turned = float(np.degrees(star.turn[beam] - star.turn[0])) % 360
        face = float(self.beams.hub_radii[star.vertex])
        self.holes += [
            (self.nodes[star.vertex], plate, f"{turned:.4f}", f"{height:.3f}")
            + (f"{face:.3f}", f"{self.sizes.bolt.hole:g}")
            for height in above
        ]

    def hole_list(self) -> Table:
        """The bolt holes of all hubs."""
        return Table("hub-holes.csv", _HOLE_COLUMNS, tuple(self.holes))

    def _place_bolts(self, vertex: int, place: tuple[int, int], heights: list[float]) -> None:
        """Note where the bolts of a plate stand, their heads within the hub."""
        out, up = self.seats.out[place], self.seats.up[place]
        wall, washer = self.sizes.wall, self.sizes.bolt.washer
        under = float(self.beams.hub_radii[vertex]) - wall - washer
        joins = self.nodes[vertex], f"{self.names[place[0]]}-{_ENDS[place[1]]}"
        origin = self.site.mesh.vertices[vertex] + self.site.shift + under * out
        self.placed += [(origin + height * up, out, joins) for height in heights]

    def _bolt_words(self) -> str:
        return f"{self.sizes.bolt.name}x{self.sizes.length:g}"

    def _bolts(self, vertex: int, place: tuple[int, int], low: float, high: float) -> list[float]:
        """Heights of the bolts of a beam, where its plate and the hub are both behind them.

        A steep one that has no room for two above each other has one.
        """
        low = max(low, float(self.seats.low[place]))
        room = min(high, float(self.seats.high[place])) - low
        sizes, bolt = self.sizes, self.sizes.bolt
        if room < 2 * bolt.edge:
            fitting = [each.name for each in BOLTS.values() if 2 * each.edge <= room]
            smaller = f"bolts of {fitting[-1]} or " if fitting else ""
            raise InputError(
                f"bolts: at {self.nodes[vertex]} beam {self.names[place[0]]} has {room:.1f} mm of "
                f"height for bolts, one of {bolt.name} takes {2 * bolt.edge:.1f} mm; take "
                f"{smaller}higher beams"
            )
        middle = low + room / 2
        if sizes.count > 1 and room < 2 * bolt.edge + bolt.spacing:
            self.single.append(f"{self.names[place[0]]}-{_ENDS[place[1]]}")
            return [middle]
        if sizes.count == 1:
            return [middle]
        apart = max(room / 2, bolt.spacing)
        return [middle - apart / 2, middle + apart / 2]

    @property
    def bolts(self) -> int:
        """Of all plates that are made."""
        return self.sizes.count * len(self.plates) - len(self.single)

    def remarks(self) -> tuple[str, ...]:
        """Where there is one bolt in place of two."""
        if not self.single:
            return ()
        return (
            f"nodes: {counted(len(self.single), 'end plate')} without room for two bolts "
            f"{self.sizes.bolt.name} above each other, {self.single[0]} for one, with one in the "
            "middle; higher beams or smaller bolts make room",
        )

    def _plate(self, vertex: int, place: tuple[int, int], heights: list[float]) -> Part:
        """The end plate of a beam, seen from the hub."""
        edge, end = place
        sizes, low = self.sizes, float(self.seats.low[place])
        holes = tuple(
            Hole(np.array([sizes.width / 2, height - low]), sizes.bolt.drill) for height in heights
        )
        name = f"{self.names[edge]}-{_ENDS[end]}"
        size = np.array([sizes.width, float(self.seats.high[place]) - low])
        pattern = _pattern(name, self.nodes[vertex], size, holes)
        origin, frame = self.seats.place(edge, end, sizes.width)
        plate = plate_part(
            self.site,
            name,
            "end-plate",
            drilled_plate(pattern, sizes.thickness),
            (self.site.mesh.vertices[vertex] + origin, frame),
            pattern,
            sizes.thickness,
            vertices=(vertex,),
            family=self.families[edge],
            line=self.lines[edge],
        )
        # A hole drilled for a thread looks like any other in a drawing.
        threads = counted(len(heights), f"thread {sizes.bolt.name}", f"threads {sizes.bolt.name}")
        return replace(plate, note=f"{threads} through, drilled {sizes.bolt.drill:g} mm")

    def _doubts(self, star: Star, arm: int, beam: str) -> list[str]:
        """What keeps the bolts of a beam from being put in and tightened."""
        sizes, bolt = self.sizes, self.sizes.bolt
        inner = float(self.beams.hub_radii[star.vertex]) - sizes.wall
        gaps = gaps_after(star.turn)
        beside = inner * np.tan(min(gaps[arm], gaps[arm - 1], WIDEST) / 2)
        words = []
        if beside < bolt.wrench - 1e-9:
            words.append(
                f"the bolt of beam {beam} cannot be reached: {beside:.1f} mm beside the next wall "
                f"of the hub, a wrench for {bolt.name} needs {bolt.wrench:g} mm"
            )
        free = _across(star.turn, arm, inner) - sizes.taken
        if free < sizes.way_in - 1e-9:
            words.append(
                f"the bolt of beam {beam} cannot be put in: {free:.1f} mm are free within the hub, "
                f"{self._bolt_words()} needs {sizes.way_in:g} mm"
            )
        return words

    @property
    def clamped(self) -> Clamped:
        """A bolt by its plates: sheared between wall and end plate, or pulled at the wall."""
        sizes, bolt = self.sizes, self.sizes.bolt
        plate, apart = min(sizes.wall, sizes.thread), bolt.spacing if sizes.count > 1 else None
        return Clamped(bolt, 1, plate, sizes.wall, bolt.edge, apart, self.site.material)

    @property
    def fasteners(self) -> Fasteners:
        """The bolts in their places."""
        sizes = self.sizes
        holds = "hubs and end plates"
        return gathered(sizes.bolt, sizes.length, sizes.grip, 1, False, holds, self.placed)

    def bolt_list(self) -> Table:
        """One row, as all bolts are alike."""
        sizes, bolt = self.sizes, self.sizes.bolt
        count = self.bolts
        row = (
            *(bolt.name, sizes.length, HEADS, GRADE, count, f"{count} {WASHERS}"),
            *(sizes.grip, sizes.thread, bolt.hole, bolt.drill, *self.clamped.row()),
        )
        return Table("bolts.csv", _BOLT_COLUMNS, (row,))


def _across(turn: FloatArray, arm: int, inner: float) -> float:
    """How far a hub is free from the middle of one of its faces to the other side, mm."""
    towards = -np.cos(face_normals(turn)[0] - turn[arm])
    ahead = towards > 1e-9
    return float((inner * (1 + towards[ahead]) / towards[ahead]).min())


def _pattern(name: str, node: str, size: FloatArray, holes: tuple[Hole, ...]) -> FlatPattern:
    """A rectangle with its holes, the names of the plate and of its node between or beside them."""
    width, height = size.tolist()
    outline = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    first, last = float(holes[0].centre[1]), float(holes[-1].centre[1])
    radius = holes[0].diameter / 2
    if len(holes) > 1:
        middle, room = (first + last) / 2, last - first - 2 * radius
        label, mark, room = middle + room / 4, middle - room / 4, room / 2
    else:
        label, mark = (height + last + radius) / 2, (first - radius) / 2
        room = min(height - last, first) - radius
    size_of_name = fitted_text_size(name, 0.9 * width, 0.8 * room, 12.0)
    size_of_node = fitted_text_size(node, 0.9 * width, 0.8 * room, 12.0)
    marks = (Mark(np.array([[width / 2, mark]]), node, size_of_node),)
    place = np.array([width / 2, label])
    return FlatPattern(outline, marks, place, size_of_name, holes=holes, seen="hub")
