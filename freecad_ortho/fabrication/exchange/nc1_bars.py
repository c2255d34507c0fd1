"""Bars as NC1 has them: the code and sizes of their section, and how their ends are cut."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.bodies import Hollow
from freecad_ortho.fabrication.exchange.members import Member, member_of
from freecad_ortho.fabrication.exchange.nc1_faces import (
    SQUARE,
    Contour,
    level_face,
    upright_face,
)
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles.catalogue import profile
from freecad_ortho.fabrication.profiles.profile import Profile
from freecad_ortho.fabrication.profiles.rolled import rolled_sizes
from freecad_ortho.fabrication.round_tube import RoundTube
from solver.mesh.quadmesh import FloatArray

# Steps around the development of a round tube.
_AROUND = 72


@dataclass(frozen=True, eq=False)
class Nc1Bar:
    """What the head of a file says about a part, and its contours.

    Attributes:
        name: of the section.
        code: I, U, M, RO, T or B.
        length: from tip to tip, mm.
        sizes: height, width, thickness of flange and web, radius, mm.
        per_metre: mass, kg/m, and painted surface, m2/m; of sheets per m2.
        cuts: angles of web at start and end, of flange at start and end, degrees.
        contours: of its faces, where its ends are more than one cut each.
    """

    name: str
    code: str
    length: float
    sizes: tuple[float, float, float, float, float]
    per_metre: tuple[float, float]
    cuts: tuple[float, float, float, float]
    contours: tuple[Contour, ...] = ()


def bar_of(part: Part) -> Nc1Bar | None:
    """The bar that a part is, None for plates and for sections that NC1 has no code for."""
    member = member_of(part)
    if member is None or part.pattern is not None:
        return None
    if isinstance(part.body, ProfiledBody):
        return _profiled(part, part.body.profile, member)
    if isinstance(part.body, RoundTube):
        diameter, wall = part.body.diameter, part.body.wall
        return _bar(part, profile(f"chs:{diameter:g}x{wall:g}"), "RO", member, wall, wall, 0.0)
    if isinstance(part.body, Hollow):
        height, width = (float(size) for size in member.high - member.low)
        wall = part.thickness
        area = height * width - (height - 2 * wall) * (width - 2 * wall)
        per_metre = part.material.mass(1000 * area), 2 * (height + width) / 1000
        sizes = height, width, wall, wall, 0.0
        name = f"RHS{height:.1f}x{width:g}x{wall:g}"
        return _with_cuts(Nc1Bar(name, "M", 0.0, sizes, per_metre, (0.0,) * 4), member)
    return None


def _profiled(part: Part, section: Profile, member: Member) -> Nc1Bar | None:
    if not section.standard:
        # A polygon of one's own.
        return None
    # With its roundings, which solids may leave out.
    section = profile(section.name)
    wall, outer = section.wall, section.rings[0]
    if len(section.rings) == 2 and all(side.centre is not None for side in outer.sides):
        return _bar(part, section, "RO", member, wall, wall, 0.0)
    if section.rectangular and len(section.rings) == 2:
        return _bar(part, section, "M", member, wall, wall, float(outer.radii.max()))
    if section.rectangular:
        return _bar(part, section, "B", member, 0.0, section.width, 0.0)
    rolled = rolled_sizes(section.name)
    if rolled is None:
        return None
    code = {"UPE": "U", "tee": "T"}.get(section.series, "I")
    if code == "U":
        member = _turned(member)
    return _bar(part, section, code, member, rolled.flange, rolled.web, rolled.root)


def _bar(
    part: Part,
    section: Profile,
    code: str,
    member: Member,
    flange: float,
    web: float,
    radius: float,
) -> Nc1Bar:
    width = 0.0 if code == "B" else section.width
    sizes = section.height, width, flange, web, radius
    per_metre = section.mass_per_metre(part.material), section.perimeter / 1000
    return _with_cuts(Nc1Bar(section.name, code, 0.0, sizes, per_metre, (0.0,) * 4), member)


def _with_cuts(bar: Nc1Bar, member: Member) -> Nc1Bar:
    """The bar with its length and cuts: in its head where one plane cuts each end."""
    low, high = member.reach
    cuts = [[_turn(planes, column) for planes in (member.starts, member.ends)] for column in (1, 2)]
    contours: tuple[Contour, ...] = ()
    if len(member.starts) > 1 or len(member.ends) > 1:
        contours = _faces(bar, member)
    return Nc1Bar(
        *(bar.name, bar.code, high - low, bar.sizes, bar.per_metre),
        (cuts[0][0], cuts[0][1], cuts[1][0], cuts[1][1]),
        contours,
    )


def _turn(planes: FloatArray, column: int) -> float:
    """Angle of a cut from square, counter-clockwise; 0 where there are two cuts."""
    return -float(np.degrees(np.arctan(planes[0, column]))) + 0.0 if len(planes) == 1 else 0.0


def _faces(bar: Nc1Bar, member: Member) -> tuple[Contour, ...]:
    """The contours of all faces of a section."""
    (low, left), (high, right) = member.low.tolist(), member.high.tolist()
    flange, web = bar.sizes[2], bar.sizes[3]
    if bar.code == "RO":
        return (_developed(member),)
    if bar.code == "M":
        return (
            upright_face("v", member, right, web, (low, high)),
            upright_face("h", member, left, web, (low, high)),
            level_face("o", member, high, flange),
            level_face("u", member, low, flange),
        )
    middle = right - web / 2 if bar.code == "U" else 0.0
    found = [upright_face("v", member, middle, web, (low, high))]
    if bar.code in ("I", "U", "T"):
        found.append(level_face("o", member, high, flange))
    if bar.code in ("I", "U"):
        found.append(level_face("u", member, low, flange))
    return tuple(found)


def _developed(member: Member) -> Contour:
    """The outside of a round tube rolled out: from its lower side on, over the front."""
    radius = float(member.high[0] - member.low[0]) / 2
    angles = np.linspace(0, 2 * np.pi, _AROUND + 1)
    centre = (member.low + member.high) / 2
    section = centre + radius * np.column_stack([-np.cos(angles), np.sin(angles)])
    across, base = radius * angles, member.reach[0]
    ends = np.column_stack([member.end_at(section) - base, across])
    starts = np.column_stack([member.start_at(section) - base, across])
    points = np.concatenate([ends, starts[::-1]])
    return Contour("v", points, (SQUARE,) * len(points))


def _turned(member: Member) -> Member:
    """Half a turn about the upright: what was behind is in front, what was the end the start."""
    signs = np.array([-1.0, -1.0, 1.0])
    outline = member.outline * [1.0, -1.0]
    return Member(outline, (member.ends * signs)[::-1], (member.starts * signs)[::-1])
