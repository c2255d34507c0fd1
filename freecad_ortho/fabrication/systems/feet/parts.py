"""The parts of a foot: base plate, post and cap."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.bolts import Bolt
from freecad_ortho.fabrication.drilled import drilled_plate
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, Hole, Mark, fitted_text_size
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.round_tube import RoundTube
from freecad_ortho.fabrication.site import Site
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

# Sizes of plates are whole multiples of this, mm.
_STEP = 10.0
# A post is at least so many diameters long, for a welder's hand.
_SHORTEST = 0.5
_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
_UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class FootSizes:
    """What all feet have in common; mm.

    Args:
        diameter: of the post, a round tube.
        wall: of the post.
        plate: thickness of the base plate and the cap.
        bolt: size of the four anchor bolts.
        beside: from the middle of the cap to what stands on it besides, 0 for nothing.
    """

    diameter: float
    wall: float
    plate: float
    bolt: Bolt
    beside: float = 0.0

    @cached_property
    def arm(self) -> float:
        """From the middle of the base plate to its bolts, along each side.

        A wrench turns beside the post, and the bolts keep their distance (EN 1993-1-8, table 3.3).
        """
        clear = (self.diameter / 2 + self.bolt.wrench) / math.sqrt(2)
        return max(clear, self.bolt.spacing / 2)

    @cached_property
    def base(self) -> float:
        """Side of the base plate."""
        return _rounded_up(2 * (self.arm + self.bolt.edge))

    @cached_property
    def cap(self) -> float:
        """Side of the cap: it stands out beside the post for a weld, and beside fins."""
        return _rounded_up(max(self.diameter + 2 * self.wall, 2 * self.beside))

    @property
    def reach(self) -> float:
        """Of the cap from its middle."""
        return self.cap / math.sqrt(2)


def _rounded_up(size: float) -> float:
    return _STEP * math.ceil(size / _STEP - 1e-9)


def foot_parts(
    site: Site, vertex: int, name: str, sizes: FootSizes, level: float, height: float
) -> tuple[Part, Part, Part]:
    """Base plate, post and cap below a vertex.

    Args:
        site: the net.
        vertex: that stands on it.
        name: of the foot.
        sizes: of its parts.
        level: of the upper side of the cap below the vertex, along the axis, mm.
        height: from the vertex down to the lower side of the base plate, mm.

    Raises:
        InputError: a height that leaves no room for the post.
    """
    point, axis = site.mesh.vertices[vertex], site.axes.directions[vertex]
    axis = axis if axis[2] > 0 else -axis
    top = point - level * axis
    under = top - sizes.plate * axis
    foot = np.array([under[0], under[1], point[2] - height])
    # The post ends in the plane of the cap, its longest line above its shortest.
    lean = float(np.hypot(*axis[:2]) / axis[2])
    length = float(under[2] - foot[2]) - sizes.plate
    shortest = length - sizes.diameter / 2 * lean
    if shortest < _SHORTEST * sizes.diameter:
        needed = height + _SHORTEST * sizes.diameter - shortest
        raise InputError(
            f"foot height: {height:g} mm leave {max(shortest, 0.0):.0f} mm for the post below "
            f"vertex {vertex}; take at least {math.ceil(needed)} mm"
        )
    base = _plate(site, vertex, f"{name}-base", sizes, foot, np.eye(3), sizes.base)
    arm = _level_arm(site, vertex, axis)
    frame = np.stack([arm, np.cross(axis, arm), axis])
    cap = _plate(site, vertex, f"{name}-cap", sizes, under, frame, sizes.cap)
    return base, _post(site, vertex, name, sizes, foot + sizes.plate * _UP, axis, length), cap


def _post(
    site: Site,
    vertex: int,
    name: str,
    sizes: FootSizes,
    start: FloatArray,
    axis: FloatArray,
    length: float,
) -> Part:
    """The post from the base plate up, x along it."""
    frame = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    ends = np.stack([[1.0, 0.0, 0.0], frame @ axis])
    body = RoundTube(np.zeros(3), np.array([0.0, length]), ends, sizes.diameter, sizes.wall)
    tilt = math.degrees(math.acos(min(float(axis[2]), 1.0)))
    longest = length + sizes.diameter / 2 * math.tan(math.radians(tilt))
    return Part(
        name=name,
        kind="foot",
        body=body,
        origin=start + site.shift,
        frame=frame,
        pattern=None,
        length=longest,
        width=sizes.diameter,
        thickness=sizes.wall,
        area=math.pi * sizes.diameter * length,
        volume=body.volume,
        material=site.material,
        vertices=(vertex,),
        note=f"round tube {sizes.diameter:g} x {sizes.wall:g}; start: square; end: {tilt:.2f} deg",
        section_width=sizes.diameter,
        section=f"chs:{sizes.diameter:g}x{sizes.wall:g}",
    )


def _plate(
    site: Site,
    vertex: int,
    name: str,
    sizes: FootSizes,
    middle: FloatArray,
    frame: FloatArray,
    side: float,
) -> Part:
    """A square plate from the plane of a point up; the base plate has holes for the anchors."""
    outline = side * _SQUARE
    base = name.endswith("base")
    corners = side / 2 + sizes.arm * (2 * _SQUARE - 1)
    holes = tuple(Hole(place, sizes.bolt.hole) for place in corners) if base else ()
    centre = np.full(2, side / 2)
    # The edge that points to y on site.
    tick = Mark(np.array([[side / 2, 0.88 * side], [side / 2, 0.98 * side]]))
    size = fitted_text_size(name, 0.8 * sizes.diameter, 0.4 * sizes.diameter)
    pattern = FlatPattern(outline, (tick,), centre, size, holes=holes, seen="above")
    origin = middle - side / 2 * (frame[0] + frame[1])
    return plate_part(
        site,
        name,
        "foot-plate",
        drilled_plate(pattern, sizes.plate),
        (origin, frame),
        pattern,
        sizes.plate,
        vertices=(vertex,),
    )


def _level_arm(site: Site, vertex: int, axis: FloatArray) -> FloatArray:
    """(3,) unit direction square to an axis, along the first edge at its vertex."""
    edges = site.mesh.connectivity.edges
    first, second = edges[(edges == vertex).any(axis=1)][0]
    arm = site.mesh.vertices[second if first == vertex else first] - site.mesh.vertices[vertex]
    return np.asarray(unit_rows((arm - (arm @ axis) * axis)[None])[0])
