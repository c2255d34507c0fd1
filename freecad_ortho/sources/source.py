"""What a source of nets asks for and gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad_ortho.units import millimetres_per
from solver.align.crosses import Crosses, Singular
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import Option


@dataclass(frozen=True, eq=False)
class Made:
    """What a source has made.

    Attributes:
        mesh: the net.
        remarks: what a user should know about it, one sentence each.
        field: the directions that its lines follow, where it follows any.
        singular: where these cannot be continued.
        border: closed polylines (N, 3) of the surface's border, which the net overhangs.
    """

    mesh: QuadMesh
    remarks: tuple[str, ...] = ()
    field: Crosses | None = None
    singular: Singular | None = None
    border: tuple[FloatArray, ...] = ()


@dataclass(frozen=True)
class Source:
    """One way to get a net.

    Attributes:
        name: unique among all sources.
        meaning: one sentence.
        options: what it asks for, in the order of a form.
        build: from the ``unit`` and the options by name (and ``meshes`` or ``surfaces``) to the
            net.
        needs: ``""``, ``net`` (one), ``nets`` (one or more) or ``faces`` (of CAD shapes).
        strokes: it may be given ``strokes``, polylines (n, 3) that its lines run along.
        stages: of a source that takes seconds: ``build`` is given ``waiting``, which it calls with
            the name of each, some several times, and passes on what that raises.
        stays: a net that is made of one stays on the surface that that one is on, and has the
            border of that surface.
    """

    name: str
    meaning: str
    options: tuple[Option, ...]
    build: Callable[..., Made]
    needs: str = ""
    strokes: bool = False
    stages: tuple[str, ...] = ()
    stays: bool = False

    @property
    def defaults(self) -> dict[str, Any]:
        """All options with their defaults."""
        return {option.name: option.default for option in self.options}

    def option(self, name: str) -> Option:
        """The option of a name, or of one that it had before.

        Raises:
            InputError: there is none.
        """
        for option in self.options:
            if name in (option.name, option.former and option.former.name):
                return option
        known = ", ".join(option.name for option in self.options) or "no options"
        raise InputError(f"{self.name}: has {known}, not '{name}'; choose one of these")

    def current(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Values by the names that options have now.

        Raises:
            InputError: an option that there is not.
        """
        found = {}
        for name, value in given.items():
            option = self.option(name)
            was = option.former if name != option.name else None
            found[option.name] = option.plain(value if was is None else was.now(value))
        return found

    def make(
        self,
        given: Mapping[str, Any],
        unit: str = "mm",
        waiting: Callable[[str], object] = lambda stage: None,
        **inputs: Any,
    ) -> Made:
        """Make the net from given options and the defaults of the others.

        Args:
            given: values by name, lengths in ``unit``.
            unit: that of the net, and of the meshes that it is made of.
            waiting: called with the name of each of the stages.
            inputs: ``meshes`` or ``surfaces``, and ``strokes``.

        Raises:
            InputError: an unknown option, or values that make no net.
        """
        scale = millimetres_per(unit)
        values = {option.name: option.default_in(scale) for option in self.options}
        values |= self.current(given)
        for option in self.options:
            value = values[option.name]
            option.check(value, unit)
            if option.kind == "points":
                values[option.name] = _points(option.name, value)
            elif option.kind == "polylines":
                values[option.name] = [_points(option.name, line) for line in value]
            elif option.kind == "singular":
                values[option.name] = None if value is None else singular(option.name, value)
            elif option.kind == "placement":
                rotation, origin = (np.asarray(x, dtype=float) for x in value)
                values[option.name] = (rotation, origin)
        if self.stages:
            inputs["waiting"] = waiting
        return self.build(unit=unit, **values, **inputs)


def singular(name: str, rows: Any) -> Singular:
    """Singular vertices from rows of x, y, z and how many lines meet there.

    Args:
        name: what they are called in a refusal.
        rows: any number of them, none too.

    Raises:
        InputError: rows of anything else.
    """
    try:
        table = np.array([tuple(row) for row in rows], dtype=np.float64).reshape(-1, 4)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{name}: expected rows of x, y, z and a number of lines, got {str(rows)[:40]}"
        ) from error
    lines = table[:, 3]
    if not (np.isfinite(table).all() and (lines == np.round(lines)).all()):
        raise InputError(f"{name}: expected finite numbers and whole ones of lines; mend them")
    return Singular(table[:, :3], lines.astype(np.int64))


def _points(name: str, value: Any) -> FloatArray:
    try:
        points = np.asarray(value, dtype=np.float64)
        if points.ndim == 2 and points.shape[1] == 2:
            points = np.pad(points, ((0, 0), (0, 1)))
        return points.reshape(-1, 3)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{name}: expected points of three numbers, got {str(value)[:40]}"
        ) from error
