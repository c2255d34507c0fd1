"""Bolts: sizes, holes, distances and wrenches, by rule; one table for all that is bolted.

Sources, lengths in mm:

* heads, widths across flats and corners, lengths: hexagon head screws threaded to the head,
  EN ISO 4017, tables 1 and 2;
* washers: EN ISO 7089, table 1; on wood DIN 440, form R, which are as large as EN 1995-1-1,
  10.4.3 wants them, 3 bolts wide and 0.3 bolts thick, up to M20;
* nuts: EN ISO 4032, table 1; a thread stands a pitch out of its nut (EN 1090-2, 8.2.2);
* holes: EN 1090-2, table 11, normal round holes: 1 mm wider than the bolt up to M14, 2 mm up to
  M24, 3 mm from M27 on; below M12 the medium ones of ISO 273;
* distances: EN 1993-1-8, table 3.3: 1.2 holes to an edge, 2.2 holes between bolts;
* drills for threads: ISO 2306, coarse threads;
* thread in a plate: as deep as the bolt is thick, more than a nut of EN ISO 4032 (0.80 to 0.93 of
  that) is high, as plates are softer than nuts;
* wrench: half the width of the head of an open-ended wrench (2.1 times the width across flats, as
  those of ISO 7738), and 1 mm: the free distance from the middle of the bolt that it takes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from solver.errors import InputError
from solver.option import one_of

HEADS = "EN ISO 4017"
WASHERS = "EN ISO 7089"
WOOD_WASHERS = "DIN 440 R"
NUTS = "EN ISO 4032"
GRADE = "8.8"
# Lengths that bolts are sold in, mm.
LENGTHS = (20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70, 80, 90, 100, 110, 120, 130, 140, 150)
# Thicknesses that plates are rolled in, mm (a choice of EN 10029 and EN 10058).
PLATES = (5, 6, 8, 10, 12, 15, 20, 25, 30, 35, 40, 50, 60)
# Diameters that round bars are rolled in, mm (EN 10060, table 1, from 10 mm on).
ROUND_BARS = (
    *(10, 12, 13, 14, 15, 16, 18, 19, 20, 22, 24, 25, 26, 27, 28, 30, 32, 35, 36, 38, 40, 42, 45),
    *(48, 50, 52, 55, 60, 63, 65, 70, 73, 75, 80, 85, 90, 95, 100, 105, 110, 115, 120, 125, 130),
    *(135, 140, 145, 150, 155, 160, 165, 170, 175, 180, 190, 200, 220, 250),
)
# Distances in diameters of holes (EN 1993-1-8, table 3.3).
EDGE, SPACING = 1.2, 2.2
# Step of the lengths that threads in plates are bolted with, mm.
_STEP = 5.0


@dataclass(frozen=True)
class Bolt:
    """A size of bolts; mm.

    Attributes:
        name: ``M16``.
        diameter: of the thread.
        hole: that it passes.
        drill: of a hole that its thread is cut in.
        head: height.
        flats: across the flats of its head.
        corners: across the corners of its head.
        washer: thickness.
        washer_width: outer diameter.
        wrench: free distance from the middle of the bolt to anything beside it.
        nut: height.
        pitch: of its thread.
        washers: standard of its washers.
    """

    name: str
    diameter: float
    hole: float
    drill: float
    head: float
    flats: float
    corners: float
    washer: float
    washer_width: float
    wrench: float
    nut: float
    pitch: float
    washers: str = field(default=WASHERS, kw_only=True)

    @property
    def washer_grade(self) -> str:
        """Hardness of its washers, as they are ordered."""
        return "200 HV" if self.washers == WASHERS else "100 HV"

    @property
    def edge(self) -> float:
        """Least distance of its middle from the edge of a plate."""
        return EDGE * self.hole

    @property
    def play(self) -> float:
        """By which it may be off the middle of its hole, mm."""
        return (self.hole - self.diameter) / 2

    @property
    def spacing(self) -> float:
        """Least distance between two: by rule, and for a wrench on one beside the other's head."""
        return max(SPACING * self.hole, self.wrench + self.corners / 2)

    @property
    def thread(self) -> float:
        """Least depth of a thread in a plate."""
        return self.diameter

    def through(self, plates: float) -> float:
        """Length of a bolt through plates of this thickness, with washers and a nut.

        Raises:
            InputError: there is none as long.
        """
        beside = 2 * self.washer + self.nut + self.pitch
        needed = plates + beside
        for length in LENGTHS:
            if length >= needed:
                return float(length)
        raise InputError(
            f"bolt: {self.name} through {plates:g} mm would be {needed:.0f} mm long, the longest "
            f"is {LENGTHS[-1]} mm and holds {LENGTHS[-1] - beside:.0f} mm; take thinner plates"
        )

    @property
    def threaded_plate(self) -> float:
        """Thickness of a plate that takes the thread, whatever is left of a length of the series.

        Bolts end within it: whatever is welded behind is not in their way.
        """
        return plate_of(self.thread + _STEP)

    @property
    def clamped_plate(self) -> float:
        """Thickness of a plate under its head: as thick as the bolt."""
        return plate_of(self.diameter)


def _bolt(diameter: float, clearance: float, *sizes: float) -> Bolt:
    return Bolt(f"M{diameter:g}", diameter, diameter + clearance, *sizes)


# Below the sizes that beams are bolted with: for lamellas and cleats.
SMALL = (
    _bolt(5, 0.5, 4.2, 3.5, 8, 8.79, 1.0, 10, 10, 4.7, 0.8),
    _bolt(6, 0.6, 5.0, 4.0, 10, 11.05, 1.6, 12, 12, 5.2, 1.0),
    _bolt(8, 1, 6.8, 5.3, 13, 14.38, 1.6, 16, 15, 6.8, 1.25),
    _bolt(10, 1, 8.5, 6.4, 16, 17.77, 2.0, 20, 18, 8.4, 1.5),
)
BOLTS: Mapping[str, Bolt] = {
    bolt.name: bolt
    for bolt in (
        _bolt(12, 1, 10.2, 7.5, 18, 20.03, 2.5, 24, 20, 10.8, 1.75),
        _bolt(16, 2, 14.0, 10.0, 24, 26.75, 3.0, 30, 27, 14.8, 2.0),
        _bolt(20, 2, 17.5, 12.5, 30, 33.53, 3.0, 37, 33, 18.0, 2.5),
        _bolt(24, 2, 21.0, 15.0, 36, 39.98, 4.0, 44, 39, 21.5, 3.0),
        _bolt(27, 3, 24.0, 17.0, 41, 45.20, 4.0, 50, 45, 23.8, 3.0),
        _bolt(30, 3, 26.5, 18.7, 46, 50.85, 4.0, 56, 50, 25.6, 3.5),
    )
}


# Thickness and outer diameter of washers on wood by diameters of bolts, mm (DIN 440, form R).
_ON_WOOD = {5: (2, 18), 6: (2, 22), 8: (3, 28), 10: (3, 34), 12: (4, 44), 16: (5, 56), 20: (6, 72)}


def bolt_of(name: str) -> Bolt:
    """The size of a name.

    Raises:
        InputError: naming those there are.
    """
    one_of("bolt", name, BOLTS)
    return BOLTS[name]


def on_wood(bolt: Bolt) -> Bolt:
    """The same with the washers that wood needs under heads and nuts; larger than M20 as it is."""
    if bolt.diameter not in _ON_WOOD:
        return bolt
    thick, wide = _ON_WOOD[round(bolt.diameter)]
    return replace(bolt, washer=thick, washer_width=wide, washers=WOOD_WASHERS)


def bolt_in(hole: float) -> Bolt | None:
    """The largest bolt that a hole passes, mm; None where it is too small for any."""
    fitting = [bolt for bolt in (*SMALL, *BOLTS.values()) if bolt.hole <= hole + 1e-9]
    return fitting[-1] if fitting else None


def plate_of(thickness: float) -> float:
    """The thinnest plate that is as thick as this, mm.

    Raises:
        InputError: there is none.
    """
    for plate in PLATES:
        if plate >= thickness:
            return float(plate)
    raise InputError(f"bolt: no plate is {thickness:g} mm thick; take smaller bolts")


def longest_within(room: float) -> float:
    """The longest bolt of the series that a depth takes, mm; 0 for none."""
    return float(max((length for length in LENGTHS if length <= room), default=0))
