"""Rows of faces between neighbouring parameter lines of a family."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.lines import FAMILIES, ParameterLines
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Row:
    """One row of faces.

    Attributes:
        name: ``R-U002`` is row 2 of family u; rows are counted in the order of their smallest
            faces.
        faces: (K,) from one end to the other.
        first_sides: (K,) side of each face across which the row enters it; it leaves it across the
            opposite one, and runs with the side after it on its right.
        rungs: (K + 1, 2) vertices on the left and on the right of the row.
        closed: true where the row returns to its first face.
    """

    name: str
    faces: IntArray
    first_sides: IntArray
    rungs: IntArray
    closed: bool

    @property
    def middle(self) -> int:
        """Number in the row of its middle face."""
        return (len(self.faces) - 1) // 2

    def runs(self, made: BoolArray) -> list[Row]:
        """The parts of it whose faces are made, (F,) true, in their order."""
        chosen = made[self.faces]
        if chosen.all():
            return [self]
        row = self
        if self.closed and chosen[0] and chosen[-1]:
            row = self._begun(int(chosen.argmin()))
            chosen = made[row.faces]
        bounds = np.flatnonzero(np.diff(np.r_[False, chosen, False].astype(int)))
        return [row._part(start, end) for start, end in bounds.reshape(-1, 2).tolist()]

    def _begun(self, face: int) -> Row:
        """The same closed row from another of its faces on."""
        faces, sides = (np.roll(some, -face) for some in (self.faces, self.first_sides))
        rungs = np.roll(self.rungs[:-1], -face, axis=0)
        return Row(self.name, faces, sides, np.concatenate([rungs, rungs[:1]]), self.closed)

    def _part(self, start: int, end: int, name: str = "") -> Row:
        return Row(
            *(name or self.name, self.faces[start:end], self.first_sides[start:end]),
            *(self.rungs[start : end + 1], False),
        )

    def divided(self, lengths: FloatArray, count: int) -> list[Row]:
        """Cut it at its rungs into about equally long pieces, ``R-U002-1``, ``R-U002-2`` ...

        Args:
            lengths: (K,) of the faces along the row.
            count: of the pieces, at most K.
        """
        faces = len(self.faces)
        ends = np.concatenate([[0.0], np.cumsum(lengths)])
        places = [0]
        for number in range(1, count):
            nearest = int(np.abs(ends - ends[-1] * number / count).argmin())
            places.append(min(max(nearest, places[-1] + 1), faces - count + number))
        return self._cut([*places, faces])

    def filled(self, fits: Callable[[Row], bool]) -> list[Row]:
        """Cut it into pieces that fit, each as long as can be; a face that does not stands alone.

        Args:
            fits: whether a piece does.
        """
        places = [0]
        for end in range(2, len(self.faces) + 1):
            if end - places[-1] > 1 and not fits(self._part(places[-1], end)):
                places.append(end - 1)
        return self._cut([*places, len(self.faces)])

    def _cut(self, places: list[int]) -> list[Row]:
        """Its pieces between these numbers of faces."""
        return [
            self._part(start, end, f"{self.name}-{number}")
            for number, (start, end) in enumerate(pairwise(places), start=1)
        ]


def rows_of(lines: ParameterLines, family: str) -> list[Row]:
    """All rows between lines of a family.

    Raises:
        InputError: the families of the net cannot be told apart.
    """
    net = lines.connectivity
    wanted = FAMILIES.index(family)
    sides = lines.edge_family[net.face_edges]
    if (sides < 0).any():
        raise InputError(
            "bent-panels: the lines of this net cannot be told apart into families u and v, so it "
            "has no rows; cut it at its irregular vertices"
        )
    entry = np.where(sides[:, 0] == wanted, 1, 0)
    left, found = np.ones(len(net.faces), dtype=np.bool_), []
    for face in range(len(net.faces)):
        if left[face]:
            steps, closed = _walk(net, face, int(entry[face]))
            left[[face for face, _ in steps]] = False
            found.append((steps, closed))
    return [_row(net, steps, closed, family, k) for k, (steps, closed) in enumerate(found)]


def _row(
    net: Connectivity, steps: list[tuple[int, int]], closed: bool, family: str, number: int
) -> Row:
    faces, sides = np.array(steps, dtype=np.int64).T
    entered = np.stack([net.faces[faces, sides], net.faces[faces, (sides + 1) % 4]], axis=1)
    last = net.faces[faces[-1], [(sides[-1] + 3) % 4, (sides[-1] + 2) % 4]]
    name = f"R-{family.upper()}{number:03d}"
    return Row(name, faces, sides, np.concatenate([entered, last[None]]), closed)


def _walk(net: Connectivity, face: int, side: int) -> tuple[list[tuple[int, int]], bool]:
    """Faces of the row through a face with the sides that it enters by; from its smaller end on."""
    onward = _onward(net, face, side)
    if onward and _next(net, *onward[-1]) == (face, side):
        return onward, True
    back = _onward(net, face, (side + 2) % 4)
    forward = [(one, (enter + 2) % 4) for one, enter in reversed(back)] + onward[1:]
    backward = [(one, (enter + 2) % 4) for one, enter in reversed(forward)]
    return min(forward, backward), False


def _onward(net: Connectivity, face: int, side: int) -> list[tuple[int, int]]:
    """The face and those after it until the row ends or returns."""
    steps = [(face, side)]
    while (following := _next(net, *steps[-1])) is not None and following != steps[0]:
        steps.append(following)
        if len(steps) > len(net.faces):
            raise InputError("bent-panels: a row of faces runs into itself; cut the net there")
    return steps


def _next(net: Connectivity, face: int, side: int) -> tuple[int, int] | None:
    """The face beyond the side opposite to the one entered by, and the side that leads into it."""
    twin = int(net.twins[4 * face + (side + 2) % 4])
    return None if twin < 0 else divmod(twin, 4)
