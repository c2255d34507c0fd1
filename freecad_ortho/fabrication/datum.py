"""From the coordinates of the model to those of the site: a datum and a turn about the upright."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.place import Place
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class Datum:
    """Where the origin of the model is on site.

    Attributes:
        east: m.
        north: m.
        height: m.
        turn_deg: by which the model's x axis is turned from east, counter-clockwise from above.
    """

    east: float = 0.0
    north: float = 0.0
    height: float = 0.0
    turn_deg: float = 0.0

    @classmethod
    def of(cls, origin: str, turn_deg: float) -> Datum:
        """Make it of three numbers with commas between them, in metres; empty for zero.

        Raises:
            InputError: not three numbers, or a turn that is none.
        """
        try:
            numbers = [float(word) for word in origin.split(",")] if origin.strip() else [0.0] * 3
        except ValueError:
            numbers = []
        if len(numbers) != 3 or not np.isfinite([*numbers, turn_deg]).all():
            raise InputError(
                "site origin: expected east,north,height in metres and a rotation in degrees, as "
                f"3500000,5400000,412.5 and 30, got '{origin[:40]}' and {turn_deg}"
            )
        east, north, height = numbers
        return cls(east, north, height, turn_deg)

    @property
    def turn(self) -> FloatArray:
        """(3, 3) turns vectors of the model (columns) to east, north and up."""
        angle = np.radians(self.turn_deg)
        cosine, sine = np.cos(angle), np.sin(angle)
        return np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1.0]])

    def of_files(self, file_origin: FloatArray) -> Datum:
        """Where the origin of coordinates in files is on site.

        Args:
            file_origin: (3,) of the model's coordinates, mm.
        """
        east, north, height = (
            self.turn @ file_origin / 1000 + [self.east, self.north, self.height]
        ).tolist()
        return Datum(east, north, height, self.turn_deg)

    @property
    def is_known(self) -> bool:
        """Whether it says anything."""
        return self != Datum()

    def __str__(self) -> str:
        """In words, in metres and degrees."""
        return (
            f"origin at east {self.east:.6f} m, north {self.north:.6f} m, height "
            f"{self.height:.6f} m, x axis turned by {self.turn_deg:.10g} degrees from east"
        )

    def points(self, place: Place, near: FloatArray) -> FloatArray:
        """(n, 3) points of a structure, east, north and height in metres.

        What is far is turned by itself, so that no digit of what is near is lost.

        Args:
            place: where the structure stands in the model.
            near: (n, 3) in its own coordinates, mm.
        """
        turn = self.turn
        base = turn @ place.origin / 1000 + [self.east, self.north, self.height]
        return np.asarray(base + place.directions(near) @ turn.T / 1000)
