"""Bolts in IFC: a type for each size and grip with the shape that all of it share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from freecad_ortho.fabrication.bolts import GRADE, HEADS
from freecad_ortho.fabrication.fasteners import Fasteners
from freecad_ortho.fabrication.hardware import hexagon
from solver.mesh.quadmesh import FloatArray

# Hole of a washer less the bolt's diameter, half of it, mm, as where bolts are drawn.
_PLAY = 0.5
_SET = "Ortho_Fastener"

Make = Callable[..., Any]


def fastener_type(
    make: Make, guid: Callable[[str], str], key: str, bolts: Fasteners, body: Any
) -> tuple[Any, Any]:
    """The type of bolts that are alike, with their washers and nut.

    Args:
        make: an entity of attributes in their order.
        guid: the identifier of a key.
        key: that tells these bolts from others.
        bolts: of one size, length and grip.
        body: the context of bodies.

    Returns:
        The type and its representation map.
    """
    bolt = bolts.bolt
    hexagon_line = make("IfcPolyline", _ring(make, hexagon(bolt.corners)))
    head = make("IfcArbitraryClosedProfileDef", "AREA", None, hexagon_line)
    shank = make("IfcCircleProfileDef", "AREA", None, None, bolt.diameter / 2)
    bodies = [_extruded(make, head, -bolt.head, 0.0), _extruded(make, shank, 0.0, bolts.length)]
    inner = bolt.diameter / 2 + _PLAY
    wall = bolt.washer_width / 2 - inner
    for low in (0.0, bolts.grip - bolt.washer)[: bolts.washers]:
        ring = make("IfcCircleHollowProfileDef", "AREA", None, None, bolt.washer_width / 2, wall)
        bodies.append(_extruded(make, ring, low, low + bolt.washer))
    if bolts.nut:
        middle = make("IfcAxis2Placement2D", _point(make, 0.0, 0.0), None)
        hole = make("IfcCircle", middle, bolt.diameter / 2)
        nut = make("IfcArbitraryProfileDefWithVoids", "AREA", None, hexagon_line, [hole])
        bodies.append(_extruded(make, nut, bolts.grip, bolts.grip + bolt.nut))
    shape = make("IfcShapeRepresentation", body, "Body", "SweptSolid", bodies)
    shared = make("IfcRepresentationMap", _axes(make, np.zeros(3)), shape)
    facts = [
        *(("Standard", "IfcText", HEADS), ("Grade", "IfcText", GRADE)),
        *(("Grip_mm", "IfcReal", float(bolts.grip)), ("Washers", "IfcInteger", bolts.washers)),
        *(("Nuts", "IfcInteger", int(bolts.nut)), ("Holds", "IfcText", bolts.holds)),
    ]
    values = [
        make("IfcPropertySingleValue", name, None, make(kind, value), None)
        for name, kind, value in facts
    ]
    known = make("IfcPropertySet", guid(f"{_SET} {key}"), None, _SET, None, values)
    made = make(
        *("IfcMechanicalFastenerType", guid(f"type {key}"), None, bolts.name, None, None),
        *([known], [shared], None, None, "BOLT", bolt.diameter, float(bolts.length)),
    )
    return made, shared


def _extruded(make: Make, section: Any, low: float, high: float) -> Any:
    up = make("IfcDirection", [0.0, 0.0, 1.0])
    place = _axes(make, np.array([0.0, 0.0, low]))
    return make("IfcExtrudedAreaSolid", section, place, up, float(high - low))


def _axes(make: Make, origin: FloatArray) -> Any:
    point = make("IfcCartesianPoint", origin.tolist())
    return make("IfcAxis2Placement3D", point, None, None)


def _ring(make: Make, corners: FloatArray) -> list[Any]:
    points = [_point(make, *corner) for corner in corners.tolist()]
    return [*points, points[0]]


def _point(make: Make, x: float, y: float) -> Any:
    return make("IfcCartesianPoint", [x, y])
