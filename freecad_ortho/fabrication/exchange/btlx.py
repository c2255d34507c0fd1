"""BTLx: raw parts of timber and how machines for carpenters cut, drill and mark them.

Source: BTLx 2.0.0, schema and documentation of design2machine.com. A part's coordinates begin in
the lowest corner of its raw part: x along its length, y up its height, z across its width to the
right. All is told on reference side 4, the right one: x along, y up, depth to the left; laps that
are open below on side 2, the left one: x along, y down, depth to the right.
"""

from __future__ import annotations

import uuid
from collections.abc import Callable, Sequence
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from scipy.spatial import ConvexHull

from freecad_ortho import __version__
from freecad_ortho.fabrication.bodies import Hollow, Polyhedron
from freecad_ortho.fabrication.exchange.btlx_laps import Lap, laps, sawn_ends
from freecad_ortho.fabrication.exchange.members import Member, member_of
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, polygon_area
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.trades import is_wood
from solver.mesh.quadmesh import FloatArray

_NAMESPACE = "https://www.design2machine.com"
_VERSION = "2.0.0"
# The same structure gives the same file: no clock.
_DATE, _TIME = "2000-01-01", "00:00:00"
_SIDE, _OTHER_SIDE = "4", "2"
# Part of its box by which a section may miss being a rectangle.
_FULL = 1e-9
# Height of a name on a bar, mm, and as a part of the bar's.
_NAME, _NAME_SHARE = 20.0, 0.3


def write_btlx(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write all parts of timber that are sawn from rectangular bars or cut from boards.

    Args:
        path: file to write.
        production: of the structure.
        project: its name.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    root = ElementTree.Element("BTLx", xmlns=_NAMESPACE, Version=_VERSION, Language="en")
    history = ElementTree.SubElement(root, "FileHistory")
    known = {"ProgramName": "freecad_ortho", "ProgramVersion": __version__}
    known |= {"Date": _DATE, "Time": _TIME}
    ElementTree.SubElement(history, "InitialExportProgram", known)
    head = ElementTree.SubElement(root, "Project", Name=project or "structure")
    parts = production.structure.parts
    found: list[ElementTree.Element] = []
    for number, part in enumerate(parts):
        if number % 64 == 0:
            say(number / len(parts))
        made = _raw(part, production) if is_wood(part.material) else None
        if made is not None:
            found.append(_part(part, made, len(found) + 1, production.structure.place, project))
    if found:
        ElementTree.SubElement(head, "Parts").extend(found)
    ElementTree.indent(root)
    text = ElementTree.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n', encoding="utf-8")


class _Raw:
    """A raw part: the box from which a part is made, and what is done to it.

    Attributes:
        low: (3,) its lowest corner in the part's own coordinates, mm.
        size: (3,) length, height and width, mm.
        processings: in the order in which they are done.
    """

    def __init__(self, low: FloatArray, high: FloatArray) -> None:
        self.low, self.size = low, high - low
        self.processings: list[ElementTree.Element] = []

    def add(
        self, kind: str, values: dict[str, str | float] | None = None, **attributes: str
    ) -> ElementTree.Element:
        """A processing on the reference side with elements in their order."""
        number = str(len(self.processings) + 1)
        known = {"Name": kind, "ProcessID": number, "ReferencePlaneID": _SIDE} | attributes
        made = ElementTree.Element(kind, known)
        for name, value in (values or {}).items():
            text = value if isinstance(value, str) else _number(value)
            ElementTree.SubElement(made, name).text = text
        self.processings.append(made)
        return made


def _raw(part: Part, production: Production) -> _Raw | None:
    """The raw part of a bar or a board, None for what is neither."""
    member = member_of(part)
    if member is not None and _is_rectangular(part, member):
        return _bar(part, member)
    pattern = production.named_patterns.get(part.name)
    return None if pattern is None else _board(part, pattern)


def _is_rectangular(part: Part, member: Member) -> bool:
    """Whether a member fills its box across."""
    if isinstance(part.body, ProfiledBody):
        area = part.body.profile.area
    elif isinstance(part.body, Polyhedron) and not isinstance(part.body, Hollow):
        area = float(ConvexHull(member.outline).volume)
    else:
        return False
    return abs(area / float(np.prod(member.high - member.low)) - 1) <= _FULL


def _bar(part: Part, member: Member) -> _Raw:
    """A bar whose ends are cut by planes."""
    low, high = member.reach
    raw = _Raw(np.array([low, *member.low]), np.array([high, *member.high]))
    for orientation, planes in (("start", member.starts), ("end", member.ends)):
        for place, up, right in planes.tolist():
            # Where the lower edge of the right side is cut.
            start = place + up * member.low[0] + right * member.high[1] - low
            raw.add("JackRafterCut", _cut(orientation, float(start), up, right))
    if part.pattern is not None:
        _texts(raw, part.name, part.pattern)
    else:
        size = min(_NAME, _NAME_SHARE * float(raw.size[1]))
        _text(raw, part.name, raw.size[:2] / 2, size, 0.0)
    return raw


def _cut(orientation: str, start: float, up: float, right: float) -> dict[str, str | float]:
    """A cut whose plane moves along by ``up`` per mm up and by ``right`` per mm to the right.

    The upright through the side's normal and across is turned about the normal by the angle, then
    about its own upright by the inclination, both from square, 90 degrees.
    """
    turn = -np.arctan(up)
    tilt = np.arctan(right * np.cos(turn))
    sign = 1.0 if orientation == "start" else -1.0
    return {
        "Orientation": orientation,
        "StartX": start,
        "StartY": 0.0,
        "StartDepth": 0.0,
        "Angle": 90.0 + sign * float(np.degrees(turn)),
        "Inclination": 90.0 + sign * float(np.degrees(tilt)),
    }


def _board(part: Part, pattern: FlatPattern) -> _Raw:
    """A board that is cut along its flat pattern."""
    lower, upper = _rings(part, pattern)
    both = np.concatenate([lower, upper])
    low, high = both.min(axis=0), both.max(axis=0)
    raw = _Raw(np.array([*low, 0.0]), np.array([*high, part.thickness]))
    if lower is upper:
        _edges(raw, upper - low)
    else:
        contour = raw.add("FreeContour", ToolPosition="right", CounterSink="no")
        dual = ElementTree.SubElement(contour, "DualContour")
        _line(ElementTree.SubElement(dual, "PrincipalContour"), upper - low, 0.0)
        _line(ElementTree.SubElement(dual, "AssociatedContour"), lower - low, -part.thickness)
    for cutout in pattern.cutouts:
        ring = cutout if polygon_area(cutout) > 0 else cutout[::-1]
        opening = raw.add("FreeContour", ToolPosition="left", CounterSink="yes")
        line = ElementTree.SubElement(opening, "Contour", DepthBounded="no", Inclination="0")
        _line(line, ring - low, 0.0)
    for hole in pattern.holes:
        x, y = (hole.centre - low).tolist()
        values: dict[str, str | float] = {"StartX": x, "StartY": y, "Angle": 0.0}
        values |= {"Inclination": 90.0, "DepthLimited": "no", "Diameter": hole.diameter}
        raw.add("Drilling", values)
    for mark in pattern.marks:
        if not mark.text:
            line = ElementTree.SubElement(raw.add("PenContour"), "Contour")
            _line(line, mark.points - low, 0.0, closed=False)
    _texts(raw, part.name, pattern, low)
    return raw


def _edges(raw: _Raw, outline: FloatArray) -> None:
    """The edges of a square-edged board: ends that are sawn or a contour, and its slots as laps."""
    filled, slots = laps(outline)
    ends = sawn_ends(filled)
    if ends is None:
        contour = raw.add("FreeContour", ToolPosition="right", CounterSink="no")
        line = ElementTree.SubElement(contour, "Contour", DepthBounded="no", Inclination="0")
        _line(line, filled, 0.0)
    else:
        for orientation, (place, slope) in zip(("start", "end"), ends, strict=True):
            raw.add("JackRafterCut", _cut(orientation, place, slope, 0.0))
    for slot in slots:
        _slot(raw, slot)


def _slot(raw: _Raw, lap: Lap) -> None:
    """A lap through the board, from the left end of its floor on, open at the board's edge.

    Its angle is what stands between the wall at its start and the part before it.
    """
    values: dict[str, str | float] = {"Orientation": "start"}
    values |= {"StartX": float(lap.start[0]), "StartY": float(lap.start[1])}
    values |= {"Angle": 180.0 - lap.angle_deg, "Inclination": 90.0, "Slope": 0.0}
    values |= {"Length": lap.length, "Width": lap.width, "Depth": float(raw.size[2])}
    values |= {"LeadAngleParallel": "no", "LeadAngle": 90.0}
    values |= {"LeadInclinationParallel": "yes", "LeadInclination": 90.0}
    made = raw.add("Lap", values, ReferencePlaneID=_OTHER_SIDE if lap.below else _SIDE)
    limits = {f"FaceLimited{face}": "yes" for face in ("Start", "End", "Front", "Bottom")}
    limits |= {"FaceLimitedBack": "no", "FaceLimitedTop": "no"}
    ElementTree.SubElement(made, "MachiningLimits", limits)


def _rings(part: Part, pattern: FlatPattern) -> tuple[FloatArray, FloatArray]:
    """(n, 2) twice: outlines of the far side and of the side that is seen; one where they agree."""
    if isinstance(part.body, Polyhedron) and pattern.bevels:
        corners = part.body.corners
        half = len(corners) // 2
        lower, upper = corners[:half], corners[half:]
        if np.ptp(lower[:, 2]) < _FULL and np.ptp(upper[:, 2]) < _FULL:
            return lower[:, :2], upper[:, :2]
    return pattern.outline, pattern.outline


def _line(contour: ElementTree.Element, points: FloatArray, z: float, closed: bool = True) -> None:
    """Fill a contour with a polygon (n, 2) or an open line, at a height from the side."""
    rows = points.tolist()
    ElementTree.SubElement(contour, "StartPoint", _point((*rows[0], z)))
    for row in [*rows[1:], rows[0]] if closed else rows[1:]:
        side = ElementTree.SubElement(contour, "Line")
        ElementTree.SubElement(side, "EndPoint", _point((*row, z)))


def _texts(raw: _Raw, name: str, pattern: FlatPattern, low: FloatArray | None = None) -> None:
    """The name and the other texts of a flat pattern."""
    base = raw.low[:2] if low is None else low
    _text(raw, name, pattern.label - base, pattern.label_size, pattern.label_angle)
    for mark in pattern.marks:
        if mark.text:
            _text(raw, mark.text, mark.points[0] - base, mark.size, mark.angle)


def _text(raw: _Raw, text: str, middle: FloatArray, size: float, angle_deg: float) -> None:
    x, y = middle.tolist()
    values: dict[str, str | float] = {"StartX": x, "StartY": y, "Angle": angle_deg}
    values |= {"AlignmentVertical": "center", "AlignmentHorizontal": "center"}
    values |= {"TextHeightAuto": "no", "TextHeight": size, "Text": text}
    raw.add("Text", values)


def _part(part: Part, raw: _Raw, number: int, place: Place, project: str) -> ElementTree.Element:
    """The element of a part: its sizes, where it stands, and what is done to it."""
    length, height, width = raw.size.tolist()
    made = ElementTree.Element(
        "Part",
        {
            "SingleMemberNumber": str(number),
            "Designation": part.name,
            "Annotation": f"{part.family}{part.line}" if part.family else part.kind,
            "Group": part.kind,
            "Material": part.material.name,
            "Count": "1",
            **{"Length": _number(length), "Height": _number(height), "Width": _number(width)},
            "Weight": f"{part.mass:.3f}",
        },
    )
    guid = str(uuid.uuid5(uuid.NAMESPACE_URL, f"freecad_ortho/{project}/{part.name}"))
    stands = ElementTree.SubElement(
        ElementTree.SubElement(made, "Transformations"), "Transformation", GUID=f"{{{guid}}}"
    )
    position = ElementTree.SubElement(stands, "Position")
    corner = place.points(part.origin + raw.low @ part.frame)
    ElementTree.SubElement(position, "ReferencePoint", _point(corner.tolist()))
    for name, row in (("XVector", 0), ("YVector", 1)):
        direction = place.directions(part.frame[row]).tolist()
        ElementTree.SubElement(position, name, _point(direction, 12))
    ElementTree.SubElement(made, "GrainDirection", X="1", Y="0", Z="0", Align="no")
    ElementTree.SubElement(made, "ReferenceSide", Side=_SIDE, Align="no")
    ElementTree.SubElement(made, "Processings").extend(raw.processings)
    return made


def _point(values: Sequence[float], digits: int = 4) -> dict[str, str]:
    return {name: _number(value, digits) for name, value in zip("XYZ", values, strict=True)}


def _number(value: float, digits: int = 4) -> str:
    """A number without an exponent, and without a sign where it is zero."""
    text = f"{value:.{digits}f}"
    return text.lstrip("-") if float(text) == 0 else text
