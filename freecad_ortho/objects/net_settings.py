"""Properties of a net that say what it is to become and what holds it on the way."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.objects.option_properties import properties
from freecad_ortho.objects.properties import HIDDEN, OUTPUT, Property
from solver.nets import NETS
from solver.nets.options import OPTIONS
from solver.nets.settings import WEIGHTS
from solver.nets.supports import SUPPORTS

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

FIX_RULES = ("none", "corners", "boundary")

TARGET = (
    Property(
        "App::PropertyEnumeration",
        "NetType",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "The net that optimising and editing aim at"),
        default="principal",
        choices=NETS.keys(),
        flags=OUTPUT,
    ),
    *(
        item
        for option in (*OPTIONS.values(), SUPPORTS)
        for item in properties(option, "Target", flags=OUTPUT)
    ),
)

CONSTRAINTS = (
    Property(
        "App::PropertyEnumeration",
        "FixRule",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Vertices that do not move"),
        choices=FIX_RULES,
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyIntegerList",
        "FixedVertices",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Numbers of further vertices that do not move"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyIntegerList",
        "Handles",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Numbers of vertices that are drawn to a place"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyVectorList",
        "HandlePlaces",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Places that the handles are drawn to, in mm"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyLinkSubListHidden",
        "GlideOn",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Edges and faces that vertices glide on, exactly"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyStringList",
        "GlidingVertices",
        "Constraints",
        QT_TRANSLATE_NOOP(
            "App::Property", "Which vertices glide on each: their numbers, empty for those near it"
        ),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyStringList",
        "GlideRules",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Gliding without an object: boundary, or such as z=0"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyLinkSubListHidden",
        "CloseTo",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Faces that the net stays near as far as it can"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyString",
        "MirrorPlanes",
        "Constraints",
        QT_TRANSLATE_NOOP("App::Property", "Mirror planes through the origin: letters of x, y, z"),
        flags=OUTPUT,
    ),
)


_WEIGHTS = (
    item
    for option in WEIGHTS.values()
    for item in properties(option, "Weights", flags=OUTPUT | HIDDEN)
)

ALL = (*TARGET, *CONSTRAINTS, *_WEIGHTS)
