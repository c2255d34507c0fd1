"""Properties of a net's view provider: plain colours, the colour map's range, overlays."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.objects.properties import Property

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

PROPERTIES = (
    Property(
        "App::PropertyColor",
        "FaceColor",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Colour of the faces where no colour map is shown"),
        default=(0.80, 0.84, 0.88),
    ),
    Property(
        "App::PropertyColor",
        "LineColor",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Colour of the edges"),
        default=(0.15, 0.17, 0.20),
    ),
    Property(
        "App::PropertyFloat",
        "LineWidth",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Width of the edges in pixels"),
        default=1.5,
    ),
    Property(
        "App::PropertyInteger",
        "LowestDecade",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Residuals: blue at and below 10 to this power"),
        default=-6,
    ),
    Property(
        "App::PropertyInteger",
        "HighestDecade",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Residuals: red at and above 10 to this power"),
        default=-1,
    ),
    Property(
        "App::PropertyBool",
        "AutomaticRange",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Lengths, curvatures, angles: range from the values"),
        default=True,
    ),
    Property(
        "App::PropertyFloat",
        "LowestValue",
        "Colour map",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Blue at and below this value (mm, 1/m, 1/m2, degrees) if not automatic",
        ),
        default=0.0,
    ),
    Property(
        "App::PropertyFloat",
        "HighestValue",
        "Colour map",
        QT_TRANSLATE_NOOP(
            "App::Property", "Red at and above this value (mm, 1/m, 1/m2, degrees) if not automatic"
        ),
        default=1.0,
    ),
    Property(
        "App::PropertyBool",
        "Legend",
        "Colour map",
        QT_TRANSLATE_NOOP("App::Property", "Show the colour scale in the 3D view"),
        default=True,
    ),
    Property(
        "App::PropertyBool",
        "Upside",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show an arrow on the side that is up"),
        default=True,
    ),
    Property(
        "App::PropertyBool",
        "ParameterLines",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show the parameter lines u and v in two colours"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Diagonals",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show both diagonals of each face"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "MedialLines",
        "Overlays",
        QT_TRANSLATE_NOOP(
            "App::Property", "Show the lines between the midpoints of opposite edges"
        ),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Axes",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show the torsion-free axes at the vertices"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Rulings",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show the rulings of strips along the parameter lines"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "StarSpheres",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show spheres through some of the vertex stars"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "IrregularVertices",
        "Overlays",
        QT_TRANSLATE_NOOP(
            "App::Property", "Mark inner vertices with more or fewer than four edges"
        ),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Supports",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Mark the supported vertices, those of the boundary"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Loads",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show the load of each free vertex"),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "Forces",
        "Overlays",
        QT_TRANSLATE_NOOP(
            "App::Property", "Show the forces in the edges under equal loads, red for tension"
        ),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "GaussImage",
        "Overlays",
        QT_TRANSLATE_NOOP(
            "App::Property", "Show the normals of the faces on a sphere beside the net"
        ),
        default=False,
    ),
    Property(
        "App::PropertyBool",
        "ReflectionLines",
        "Overlays",
        QT_TRANSLATE_NOOP("App::Property", "Show reflection lines instead of colours"),
        default=False,
    ),
)

OVERLAY_NAMES = tuple(item.name for item in PROPERTIES if item.group == "Overlays")
