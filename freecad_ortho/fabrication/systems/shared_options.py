"""Options that several systems have: each is declared once, so that one word means one thing."""

from __future__ import annotations

from freecad_ortho.fabrication.sizes import OFFSETS, size
from solver.option import NOT_NEGATIVE, Option

HEIGHT = size("height", 200.0, "the beams are this high")
PANEL_THICKNESS = Option(
    *("panel_thickness", None, "length"),
    "the panels are this thick, by default as thick as the plates",
)
OFFSET = Option(
    *("offset", "centre", "choice", "the parts lie above the net, about it or below it", OFFSETS),
)
# Of hubs, arms and caps, where none is given; slots have that of their material.
USUAL_CLEARANCE = 1.0
CLEARANCE = Option(
    *("clearance", None, "length", "slots and hubs leave this much air"),
    absent="1 mm, slots by material",
    within=NOT_NEGATIVE,
)
NO_BOUNDARY_BEAMS = Option(
    "no_boundary_beams", False, "flag", "no beams are made along the boundary"
)
LEAST_WIDTH = Option(
    *("least_width", 60.0, "length"),
    "pieces of panels at the border that are narrower than this are slivers",
)
OVERHANG = Option(
    *("overhang", None, "length"),
    "the strips go this far beyond their last vertex, by default half their width",
)
STOCK = Option(
    *("stock", None, "length"),
    "strips are cut from this length; longer ones are spliced",
    absent="as long as it takes",
)
ROUNDED = Option(
    *("rounded", False, "flag"),
    "solids have the rounded corners and roots of a section of the catalogue",
)


def plate_thickness(usual: float) -> Option:
    """The thickness of the plates, mm."""
    return size("thickness", usual, "the plates are this thick")


def joint(usual: float, between: str = "panels") -> Option:
    """The width of the joints, mm."""
    return size("gap", usual, f"the joint between two {between} is this wide")
