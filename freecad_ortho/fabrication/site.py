"""Where systems build: the net, its axes and lines, the material, and what is built already."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol, TypeVar

import numpy as np

from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.trimming import Trimming
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.lines import FAMILIES, ParameterLine, ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.offset.axes import Axes, torsion_free_axes
from solver.option import Option

FAMILY_CHOICES = (*FAMILIES, "both")
# Of all systems, beside their tables.
FAMILY = Option("family", "both", "choice", "Parameter lines that are built on", FAMILY_CHOICES)
Geometry = TypeVar("Geometry")
# The CAD kernel tells points apart that are 1e-7 mm from each other; far longer edges lose that.
_LONGEST_EDGE = 1e6


@dataclass(frozen=True)
class Selection:
    """Which parameter lines are built on.

    Args:
        family: "u", "v" or "both".
        lines: numbers in the families chosen, None for all.

    Raises:
        InputError: an unknown family, or a line number below 0.
    """

    family: str = "both"
    lines: tuple[int, ...] | None = None

    def __post_init__(self) -> None:
        FAMILY.check(self.family)
        if self.lines is not None and (not self.lines or min(self.lines) < 0):
            raise InputError(
                f"lines: expected numbers from 0 on, got {list(self.lines)}; name at least one"
            )

    @property
    def everything(self) -> bool:
        """True where nothing is left out."""
        return self.family == "both" and self.lines is None


class Built(Protocol):
    """What those that build later may know of a system that was built before."""

    @property
    def geometry(self) -> object:
        """Arrays to lie on, see :meth:`Site.geometry_of`."""

    @property
    def settings(self) -> object:
        """The system."""


@dataclass(frozen=True, eq=False)
class Site:
    """A place to build on.

    Attributes:
        mesh: near the origin, mm; there no digits are lost, wherever the model is.
        shift: (3,) brings the geometry into the place of the model, mm.
        axes: torsion-free, at the vertices.
        lines: all parameter lines of the net.
        selection: which of them are wanted.
        material: of the parts that are being made.
        done: what the systems before made, by their names.
        trimming: what the border leaves of the net, None where all of it is built.
    """

    mesh: QuadMesh
    shift: FloatArray
    axes: Axes
    lines: ParameterLines
    selection: Selection = Selection()
    material: Material = MATERIALS["steel"]
    done: Mapping[str, Built] = field(default_factory=dict)
    trimming: Trimming | None = None

    @classmethod
    def of(cls, mesh_mm: QuadMesh, selection: Selection, border: Sequence[FloatArray] = ()) -> Site:
        """Make a site of a mesh in mm, trimmed along closed polylines (N, 3).

        Raises:
            InputError: edges of kilometres, lines that the net does not have, or a border of
                something else.
        """
        _refuse_long_edges(mesh_mm)
        centre = mesh_mm.vertices[mesh_mm.connectivity.referenced].mean(axis=0)
        mesh = mesh_mm.with_vertices(mesh_mm.vertices - centre)
        lines = ParameterLines.of(mesh)
        axes = torsion_free_axes(mesh)
        loops = [line - centre for line in border]
        trimming = Trimming.of(mesh, axes.offsets, loops) if loops else None
        site = cls(mesh, centre, axes, lines, selection, trimming=trimming)
        site._refuse_missing_lines()
        return site

    def _refuse_missing_lines(self) -> None:
        numbers = {line.number for line in self.chosen_lines}
        missing = sorted(set(self.selection.lines or ()) - numbers)
        if self.selection.everything or (numbers and not missing):
            return
        counts = [f"{len(self.lines.of_family(family))} {family}" for family in FAMILIES]
        named = ", ".join(map(str, missing)) if missing else "such family"
        raise InputError(
            f"lines: the net has {' and '.join(counts)} lines, counted from 0, and no {named}; "
            "choose others"
        )

    @cached_property
    def chosen_lines(self) -> tuple[ParameterLine, ...]:
        """The parameter lines that are built on."""
        family, numbers = self.selection.family, self.selection.lines
        return tuple(
            line
            for line in self.lines.all
            if family in ("both", line.family) and (numbers is None or line.number in numbers)
        )

    @cached_property
    def chosen_edges(self) -> BoolArray:
        """(E,) true for the edges of the chosen lines."""
        if self.selection.everything:
            return np.ones(len(self.mesh.connectivity.edges), dtype=bool)
        chosen = np.zeros(len(self.mesh.connectivity.edges), dtype=bool)
        for line in self.chosen_lines:
            chosen[line.edges] = True
        return chosen

    def geometry_of(self, system: str, kind: type[Geometry]) -> Geometry | None:
        """What a system left to lie on, None where it was not built before.

        Raises:
            TypeError: it is of another kind.
        """
        if system not in self.done:
            return None
        found = self.done[system].geometry
        if not isinstance(found, kind):
            raise TypeError(f"{system}: left {type(found).__name__}, not {kind.__name__}")
        return found

    @property
    def edge_family(self) -> list[str]:
        """Letter of each edge's family, "" where families cannot be told apart."""
        return [("u", "v", "")[number] for number in self.lines.edge_family.tolist()]


def _refuse_long_edges(mesh: QuadMesh) -> None:
    longest = float(mesh.edge_lengths.max())
    if longest > _LONGEST_EDGE:
        edge = int(mesh.edge_lengths.argmax())
        first, second = mesh.connectivity.edges[edge]
        raise InputError(
            f"mesh: edge {edge} (vertices {first} and {second}) is {longest / 1e6:.3g} km long; "
            "check the unit"
        )
