"""What beams can be told, and what beams and nodes are both told of the hubs between them."""

from __future__ import annotations

from freecad_ortho.fabrication.bolts import BOLTS
from freecad_ortho.fabrication.profiles import names
from freecad_ortho.fabrication.sizes import size
from freecad_ortho.fabrication.systems.beams.sections import SECTIONS
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    HEIGHT,
    NO_BOUNDARY_BEAMS,
    OFFSET,
    ROUNDED,
    plate_thickness,
)
from solver.option import Option, Range

# Beams of one family run through, in pieces, and the others are bolted to fins on them.
SPLICED = ("spliced-u", "spliced-v")
THROUGH = ("through-u", "through-v")
# The others' ends follow the sides of those that run through.
COPED = ("coped-u", "coped-v")
ENDS = ("mitred", "hub", "end-plate", "cover-plate", "cone", "lapped", *THROUGH, *COPED, *SPLICED)
# Those that are bolted to nodes.
BOLTED = ("end-plate", "cover-plate", "cone", *SPLICED)
# Of hubs without bolts, mm, where nothing is said.
PLAIN_HUB = 100.0

# What beams and nodes are both told of the hubs between them.
HUB_OPTIONS = (
    Option(
        "hub_diameter",
        None,
        "length",
        "the hubs measure this across their faces",
        absent="100 mm, of bolted ones what each needs",
    ),
    Option("bolt", "M16", "choice", "beams are bolted with bolts of this size", tuple(BOLTS)),
    Option(
        *("bolts", 2, "count", "a joint has so many bolts above each other"),
        within=Range(1, 2),
    ),
    Option(
        "hub_wall",
        None,
        "length",
        "bolted hubs have walls of this thickness",
        absent="as thick as the bolts",
    ),
)

OPTIONS = (
    HEIGHT,
    plate_thickness(20.0),
    OFFSET,
    Option(
        "section",
        "plate",
        "choice",
        "the beams have this cross section, or one of the catalogue such as HEB160",
        SECTIONS,
        examples=names(),
    ),
    size("section_width", 60.0, "hollow sections and flanges are this wide"),
    Option(
        "flange_thickness",
        None,
        "length",
        "the flanges are this thick, by default as thick as the plates",
    ),
    Option("ends", "mitred", "choice", "the beams meet like this at a node", ENDS),
    Option(
        *(
            "splice_every",
            4,
            "count",
            "spliced beams have a splice after so many nodes, 0 for none",
        ),
        within=Range(0, 1000),
    ),
    *HUB_OPTIONS,
    CLEARANCE,
    NO_BOUNDARY_BEAMS,
    Option(
        "least_length",
        100.0,
        "length",
        "beams that are shorter than this at the border are left out",
    ),
    ROUNDED,
)
