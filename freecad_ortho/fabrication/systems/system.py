"""What every system is: settings that turn a site into parts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from freecad_ortho.fabrication.fasteners import Fasteners, Supply
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.place import Place
from freecad_ortho.fabrication.site import Site
from solver.mesh.quadmesh import FloatArray
from solver.option import Option


@dataclass(frozen=True, eq=False)
class Table:
    """A list that a system adds to the files.

    Attributes:
        name: of the file, ``distortion.csv``.
        columns: names of the columns.
        rows: one a line.
        points: (N, 3) a place of each row, mm, of which further columns tell where it stands in
            the files.
        normals: (N, 3) a direction of each row, likewise.
    """

    name: str
    columns: tuple[str, ...]
    rows: tuple[tuple[object, ...], ...]
    points: FloatArray | None = None
    normals: FloatArray | None = None

    def placed(self, place: Place) -> tuple[tuple[str, ...], list[tuple[object, ...]]]:
        """Columns and rows with points and directions as they stand in the files."""
        columns, rows = self.columns, list(self.rows)
        if self.points is not None:
            columns = (*columns, "x_mm", "y_mm", "z_mm")
            rows = _with(rows, place.points(self.points), 6)
        if self.normals is not None:
            columns = (*columns, "normal_x", "normal_y", "normal_z")
            rows = _with(rows, place.directions(self.normals), 12)
        return columns, rows


def _with(
    rows: Sequence[tuple[object, ...]], values: FloatArray, digits: int
) -> list[tuple[object, ...]]:
    return [
        (*row, *(f"{value:.{digits}f}" for value in each))
        for row, each in zip(rows, values, strict=True)
    ]


@dataclass(frozen=True, eq=False)
class SystemParts:
    """What a system made of a site.

    Attributes:
        parts: in the order of their names.
        report: its section of ``report.json``, ready for JSON; lengths in mm.
        messages: anything out of the ordinary, in plain words.
        geometry: arrays that systems built after this one may lie on, see ``Site.geometry_of``.
        joints: of the parts those to be printed, one of each shape.
        tables: lists of its own to write beside those of every structure.
        fasteners: bolts that its parts are joined by.
        supplies: what else is bought for it.
        loose: makes solids of some of these, as gaskets, for files that show them.
        settings: of the system that made them; filled in by the structure.
    """

    parts: tuple[Part, ...]
    report: dict[str, Any] = field(default_factory=dict)
    messages: tuple[str, ...] = ()
    geometry: object = None
    joints: tuple[Part, ...] = ()
    tables: tuple[Table, ...] = ()
    fasteners: tuple[Fasteners, ...] = ()
    supplies: tuple[Supply, ...] = ()
    loose: Callable[[], tuple[Part, ...]] = tuple
    settings: System | None = None


class System(ABC):
    """A way to build a net. Subclasses are frozen dataclasses of settings, checked when made."""

    name: ClassVar[str]
    options: ClassVar[tuple[Option, ...]]
    # Whether its parts are cut at the border of the surface.
    trims: ClassVar[bool] = False
    # Systems whose parts would stand where its own do, and why.
    excludes: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> System:
        """Make the settings from a value for each of ``options``; by default the fields' names.

        Raises:
            InputError: a value that cannot be used.
        """
        return cls(**values)

    @classmethod
    def slotted(cls, values: Mapping[str, Any]) -> bool:
        """Whether parts with these values of the options have slots; by default none has."""
        return False

    def beside(self, others: Mapping[str, System]) -> System:
        """The settings where others are built with it, by their names; by default the same."""
        return self

    @abstractmethod
    def build(self, site: Site) -> SystemParts:
        """Work out the parts; none where the net has nothing that this system builds on.

        Raises:
            InputError: sizes that do not fit the net, or a net that is not fit for this system.
        """


def sums(parts: tuple[Part, ...]) -> dict[str, float]:
    """Total length, area, volume and mass for a system's report."""
    return {
        "length_mm": sum(part.length for part in parts),
        "area_mm2": sum(part.area for part in parts),
        "volume_mm3": sum(part.volume for part in parts),
        "mass_kg": sum(part.mass for part in parts),
    }
