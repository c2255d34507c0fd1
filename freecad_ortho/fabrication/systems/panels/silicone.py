"""Structural silicone: frames of adapters that panels are glued onto, mitred at their corners."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.bodies import Polyhedron, prism_sides
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.plate_limits import smallest_box
from freecad_ortho.fabrication.sizes import check_size
from freecad_ortho.fabrication.systems.panels.geometry import inset
from freecad_ortho.fabrication.systems.system import Table
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# Thickness of the joint, mm, and bounds of the bite: EAD 090010-00-0404 (before it ETAG 002-1).
_JOINT, _LEAST_BITE, _MOST_BITE = 6.0, 6.0, 18.0
# Design stress of a structural silicone in tension, MPa, as its approval has it (ETAG 002-1).
_DESIGN_STRESS = 0.14
# The adapter, mm: wider than the bite by room for the spacer tape beside it, and as high.
_TAPE, _HEIGHT = 8.0, 20.0
# An adapter is longer than this many of its widths.
_LONG = 3.0
# A circle of so many of them as radius has to fit into a panel.
_ROOM = 2.5
# What two strips that are mitred share by rounding, mm2.
_CONTACT = 1e-6
COLUMNS = ("panel", "bite_mm", "joint_mm", "length_mm", "wind_kN_m2")


@dataclass(frozen=True)
class Silicone:
    """A joint of structural silicone between panel and adapter.

    Args:
        bite: width of the joint, mm.

    Raises:
        InputError: a bite that is not allowed.
    """

    bite: float = 12.0

    def __post_init__(self) -> None:
        check_size("bite", self.bite)
        if not _LEAST_BITE <= self.bite <= _MOST_BITE:
            raise InputError(
                f"bite: expected {_LEAST_BITE:g} to {_MOST_BITE:g} mm with a joint of {_JOINT:g} "
                f"mm, got {self.bite:g}; take one of these"
            )

    @property
    def bed(self) -> float:
        """From the beams to the panel, mm."""
        return _JOINT + _HEIGHT

    @property
    def width(self) -> float:
        """Of the adapter, mm."""
        return self.bite + _TAPE

    def wind(self, panel: Part) -> float:
        """Wind pressure that the bite bears, kN/m2: 2 sigma bite / a, a the panel's shorter side.

        Source: ETAG 002-1, annex 2, A2.3.2: the panel bears on its longer sides.
        """
        assert panel.pattern is not None
        _, shorter = smallest_box(panel.pattern.outline)
        return 1000 * 2 * _DESIGN_STRESS * self.bite / shorter

    def adapters(self, panel: Part, under: FloatArray) -> tuple[Part, ...]:
        """Adapters below the long sides of a panel's lower outline (N, 2)."""
        if not self.fits(panel):
            return ()
        rings = strips(under, self.width)
        return tuple(
            self._adapter(panel, f"{panel.name}-a{number + 1}", ring)
            for number, ring in enumerate(rings)
        )

    def fits(self, panel: Part) -> bool:
        """Whether a panel is wide enough for adapters along all of its sides."""
        import shapely

        assert panel.pattern is not None
        plate = shapely.Polygon(panel.pattern.outline)
        return not plate.buffer(-_ROOM * self.width).is_empty

    def _adapter(self, panel: Part, name: str, ring: FloatArray) -> Part:
        """The adapter over a trapezoid (4, 2) of the pattern, its first side outside."""
        along = ring[1] - ring[0]
        along = along / np.linalg.norm(along)
        turn = np.array([along, [-along[1], along[0]]])
        flat = (ring - ring[0]) @ turn.T
        levels = np.repeat([-self.bed, -_JOINT], 4)
        body = Polyhedron(np.column_stack([np.tile(flat, (2, 1)), levels]), prism_sides(4))
        turned = np.vstack([turn @ panel.frame[:2], panel.frame[2:]])
        plan = np.degrees(np.arctan((flat[[3, 2], 0] - flat[[0, 1], 0]) / self.width))
        length = float(np.ptp(flat[:, 0]))
        section = f"adapter {self.width:g}x{_HEIGHT:g}"
        return replace(
            panel,
            name=name,
            kind="adapter",
            body=body,
            origin=panel.origin + ring[0] @ panel.frame[:2],
            frame=turned,
            pattern=None,
            length=length,
            width=_HEIGHT,
            thickness=self.width,
            area=2 * (self.width + _HEIGHT) * length,
            volume=body.volume,
            material=MATERIALS["aluminium"],
            note=f"{section}; start: plan {plan[0]:.2f} deg; end: plan {-plan[1]:.2f} deg",
            section=section,
            section_width=self.width,
            measures=Measures(),
            weighed=None,
            assembly="",
        )


def strips(outline: FloatArray, width: float) -> list[FloatArray]:
    """(4, 2) each: strips of this width within the long sides of an outline (N, 2).

    Two that meet are mitred; beside a short side one ends square, or flush with that side where it
    leans in. Of two that would run into each other along it the shorter one ends before.
    """
    ahead = np.roll(outline, -1, axis=0) - outline
    length = np.linalg.norm(ahead, axis=1)
    long = length >= _LONG * width
    mitred = inset(outline[None], np.where(long, width, 0.0)[None])[0]
    along = ahead / length[:, None]
    inward = np.column_stack([-along[:, 1], along[:, 0]])
    # How far a side leans in over the next one, per mm; 0 where it leans out.
    leans = np.maximum((along * np.roll(-along, 1, axis=0)).sum(axis=1), 0.0)
    flush = width * leans / np.sqrt(np.maximum(1.0 - leans**2, 1e-6))
    found = []
    for side in np.flatnonzero(long).tolist():
        after = (side + 1) % len(outline)
        start = outline[side] + flush[side] * along[side] + width * inward[side]
        end = outline[after] - flush[after] * along[side] + width * inward[side]
        inner = (
            mitred[side] if long[side - 1] else start,
            mitred[after] if long[after] else end,
        )
        if (inner[1] - inner[0]) @ along[side] > 0:
            found.append(np.array([outline[side], outline[after], inner[1], inner[0]]))
    return _apart(found, width)


def _apart(rings: list[FloatArray], width: float) -> list[FloatArray]:
    """The same strips, in their order, cut back where they share space; none is left too short."""
    lengths = [float(np.linalg.norm(ring[1] - ring[0])) for ring in rings]
    kept: dict[int, FloatArray] = {}
    for number in sorted(range(len(rings)), key=lambda k: -lengths[k]):
        ring: FloatArray | None = rings[number]
        for other in kept.values():
            ring = None if ring is None else _ended_before(ring, other, _LONG * width)
        if ring is not None:
            kept[number] = ring
    return [kept[number] for number in sorted(kept)]


def _ended_before(ring: FloatArray, other: FloatArray, least: float) -> FloatArray | None:
    """A strip cut square where it meets another one; None if less than ``least`` is left."""
    import shapely

    shared = shapely.intersection(shapely.Polygon(ring), shapely.Polygon(other))
    if shared.area <= _CONTACT:
        return ring
    along = (ring[1] - ring[0]) / np.linalg.norm(ring[1] - ring[0])
    place = (ring - ring[0]) @ along
    met = (shapely.get_coordinates(shared) - ring[0]) @ along
    cut, ends = (met.min(), [1, 2]) if met.min() > place[1] - met.max() else (met.max(), [0, 3])
    shorter = ring.copy()
    shorter[ends] += (cut - place[ends])[:, None] * along
    outer, inner = shorter[1] - shorter[0], shorter[2] - shorter[3]
    return shorter if min(outer @ along, inner @ along) >= least else None


def silicone_table(panels: Sequence[Part], silicone: Silicone) -> Table:
    """The joints of panels, and the wind that each bears."""
    rows = [
        (
            *(panel.name, f"{silicone.bite:g}", f"{_JOINT:g}"),
            *(f"{_perimeter(panel):.3f}", f"{silicone.wind(panel):.3f}"),
        )
        for panel in panels
    ]
    return Table("silicone.csv", COLUMNS, tuple(rows))


def _perimeter(panel: Part) -> float:
    assert panel.pattern is not None
    outline = panel.pattern.outline
    return float(np.linalg.norm(np.roll(outline, -1, axis=0) - outline, axis=1).sum())
