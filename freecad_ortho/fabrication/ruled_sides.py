"""What bounds a ruled body: sides by their corners, sides cut from a surface, and holes."""

from __future__ import annotations

from dataclasses import dataclass

from solver.mesh.quadmesh import FloatArray

# Corner numbers around a side, counter-clockwise seen from outside.
Side = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class RuledSide:
    """A side that is cut from a surface along curves.

    Attributes:
        loops: corner numbers around it, counter-clockwise seen from outside, then those around each
            of its openings, clockwise; the curves between them are the body's.
        rails: (2, P, 3) control points of the two curves that straight lines join, u along them and
            v from the first to the second; None for a plane.
        places: for each loop the control points (M, 2) in u and v of each of its curves; none for a
            plane.
    """

    loops: tuple[Side, ...]
    rails: FloatArray | None = None
    places: tuple[tuple[FloatArray, ...], ...] = ()


@dataclass(frozen=True, eq=False)
class Bore:
    """A cylindrical hole square through two plane sides.

    Attributes:
        start: (3,) where its axis enters.
        end: (3,) where it leaves.
        diameter: mm.
        sides: numbers of the sides that it enters and leaves by, in the order of the body's.
    """

    start: FloatArray
    end: FloatArray
    diameter: float
    sides: tuple[int, int]
