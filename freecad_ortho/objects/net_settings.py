"""Properties of a net that say what it is to become and what holds it on the way."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.objects.properties import HIDDEN, OUTPUT, Property

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# The recipes of the solver; a test compares them.
NETS = (
    "principal",
    "orthogonal",
    "circular",
    "conical",
    "geodesic",
    "dog",
    "chebyshev",
    "geodesic-chebyshev",
    "asymptotic",
    "cmc",
    "snet",
    "stress",
    "isometric",
)
FIX_RULES = ("none", "corners", "boundary")
FORCES = ("free", "compression", "tension")
AUTOMATIC = -1.0

TARGET = (
    Property(
        "App::PropertyEnumeration",
        "NetType",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "The net that optimising and editing aim at"),
        default="principal",
        choices=NETS,
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyBool",
        "DiagonalNet",
        "Target",
        QT_TRANSLATE_NOOP(
            "App::Property", "Ask it of the diagonals of the faces, not of the edges"
        ),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyAngle",
        "MedialAngle",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Orthogonal nets: angle between the two directions"),
        default=90.0,
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyLength",
        "TargetRadius",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "CMC nets: radius of the vertex spheres; 0 is free"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyLength",
        "TargetEdge",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Chebyshev nets: length of the edges; 0 is free"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyBool",
        "PerFamily",
        "Target",
        QT_TRANSLATE_NOOP(
            "App::Property", "Chebyshev nets: each direction has a length of its own"
        ),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyLinkHidden",
        "IsometricTo",
        "Target",
        QT_TRANSLATE_NOOP(
            "App::Property", "Isometric nets: net whose faces give the shape; empty: as it starts"
        ),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyFloat",
        "VertexWeight",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Stress nets: downward load at every vertex"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyFloat",
        "AreaWeight",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Stress nets: downward load of a square millimetre"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyFloat",
        "EdgeWeight",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Stress nets: weight of a millimetre of edge"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyEnumeration",
        "AllowedForces",
        "Target",
        QT_TRANSLATE_NOOP("App::Property", "Stress nets: forces that edges may carry"),
        choices=FORCES,
        flags=OUTPUT,
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


def _weight(name: str, tooltip: str) -> Property:
    return Property(
        "App::PropertyFloat", name, "Weights", tooltip, default=AUTOMATIC, flags=OUTPUT | HIDDEN
    )


WEIGHTS = (
    _weight(
        "FairnessWeight",
        QT_TRANSLATE_NOOP("App::Property", "How strongly lines are drawn straight; -1 automatic"),
    ),
    _weight(
        "ClosenessWeight",
        QT_TRANSLATE_NOOP("App::Property", "How strongly vertices stay at the start; -1 automatic"),
    ),
    _weight(
        "MultiWeight",
        QT_TRANSLATE_NOOP(
            "App::Property", "How strongly pairs of faces stay orthogonal; -1 automatic"
        ),
    ),
    _weight(
        "IsometryWeight",
        QT_TRANSLATE_NOOP("App::Property", "How strongly faces keep their shape; -1 automatic"),
    ),
    Property(
        "App::PropertyFloat",
        "TargetTolerance",
        "Weights",
        QT_TRANSLATE_NOOP("App::Property", "Largest residual that counts as zero"),
        default=1e-10,
        flags=OUTPUT | HIDDEN,
    ),
)

ALL = (*TARGET, *CONSTRAINTS, *WEIGHTS)
