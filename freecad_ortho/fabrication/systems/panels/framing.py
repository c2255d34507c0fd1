"""What holds panels: nothing, pressure plates and caps, or structural silicone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from freecad_ortho.fabrication.fasteners import Supply
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.panels.blocks import (
    block_parts,
    block_supplies,
    setting_blocks,
)
from freecad_ortho.fabrication.systems.panels.frame import Covered, Framed, framed
from freecad_ortho.fabrication.systems.panels.gaskets import GasketPlanes, Gaskets, beam_seats
from freecad_ortho.fabrication.systems.panels.geometry import PanelGeometry
from freecad_ortho.fabrication.systems.panels.pressure_frame import PressureFrame
from freecad_ortho.fabrication.systems.panels.silicone import Silicone, silicone_table
from freecad_ortho.fabrication.systems.system import Table
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray
from solver.option import one_of

FRAMES = ("none", "plate", "silicone")
# Usual sizes of pressure plates, and of what they cover of the panels, mm.
_WIDTH, _COVER = 50.0, 15.0


@dataclass(frozen=True, eq=False)
class Held:
    """What was made to hold panels.

    Attributes:
        parts: of the frames.
        tables: lists of them.
        report: what is to be said of them.
        messages: what is out of the ordinary.
        supplies: what is bought for them.
        loose: makes gaskets and setting blocks as parts.
    """

    parts: tuple[Part, ...] = ()
    tables: tuple[Table, ...] = ()
    report: dict[str, Any] | None = None
    messages: tuple[str, ...] = ()
    supplies: tuple[Supply, ...] = ()
    loose: Callable[[], tuple[Part, ...]] = tuple


@dataclass(frozen=True)
class Framing:
    """How panels are held.

    Args:
        kind: one of ``FRAMES``.
        given_width: of pressure plates, mm, None for the usual one.
        given_cover: how far panels reach under them, mm, None for the usual one; where neither is
            given both grow where panels need it.
        gasket: thickness of the gaskets, mm.
        bite: of structural silicone, mm.

    Raises:
        InputError: an unknown kind, or sizes that cannot be used.
    """

    kind: str
    given_width: float | None
    given_cover: float | None
    gasket: float
    bite: float

    def __post_init__(self) -> None:
        one_of("frame", self.kind, FRAMES)
        # Both refuse what cannot be used.
        _ = self.frame, self.silicone

    @property
    def width(self) -> float:
        """Of pressure plates, mm, unless they grow."""
        return _WIDTH if self.given_width is None else self.given_width

    @property
    def cover(self) -> float:
        """How far panels reach under them then, mm."""
        return _COVER if self.given_cover is None else self.given_cover

    @cached_property
    def frame(self) -> PressureFrame | None:
        """Pressure plates and caps, where it is these."""
        if self.kind != "plate":
            return None
        grows = self.given_width is None and self.given_cover is None
        return PressureFrame(self.width, self.cover, self.gasket, grows)

    @cached_property
    def silicone(self) -> Silicone | None:
        """Structural silicone, where it is that."""
        return Silicone(self.bite) if self.kind == "silicone" else None

    @property
    def depth(self) -> float:
        """Of what is fixed below panels, along their sides, mm."""
        return 0.0 if self.silicone is None else self.silicone.bed

    def joint(self, gap: float) -> float:
        """Between two panels, mm: the gap that was asked for, or what the frame makes it."""
        return gap if self.frame is None else self.frame.joint

    @property
    def bed(self) -> float:
        """From what carries panels to these, mm."""
        if self.silicone is not None:
            return self.silicone.bed
        return 0.0 if self.frame is None else self.frame.gasket

    def held(
        self,
        site: Site,
        geometry: PanelGeometry,
        panels: tuple[Part, ...],
        rims: Sequence[tuple[FloatArray, FloatArray]],
        faces: Covered,
        beams: BeamGeometry | None = None,
    ) -> Held:
        """Make the frames of panels.

        Args:
            site: the net.
            geometry: of the panels.
            panels: the panels.
            rims: (N, 2) outlines below their lowest layers and of their upper sides, in their own
                coordinates.
            faces: those that have one.
            beams: below the panels.

        Raises:
            InputError: a frame too wide for an edge of the net.
        """
        if self.frame is not None:
            plates = framed(site, self.frame, geometry, panels, faces)
            return Held(
                plates.parts,
                (plates.table, setting_blocks(panels)),
                {"frame": plates.report},
                (*plates.words, *_covered(plates.report["cover_min_mm"], plates.frame, site)),
                (*plates.supplies, *block_supplies(panels)),
                lambda: _loose(site, plates, panels, rims, beams),
            )
        if self.silicone is not None:
            pairs = zip(panels, rims, strict=True)
            adapters = tuple(
                part for panel, (under, _) in pairs for part in self.silicone.adapters(panel, under)
            )
            report = {
                "bite_mm": self.silicone.bite,
                "wind_min_kN_m2": min(self.silicone.wind(panel) for panel in panels),
                "adapters_mm": sum(part.length for part in adapters),
                "mass_kg": sum(part.mass for part in adapters),
            }
            tables = silicone_table(panels, self.silicone), setting_blocks(panels)
            loose = [panel.name for panel in panels if not self.silicone.fits(panel)]
            return Held(
                adapters, tables, {"silicone": report}, _narrow(loose), block_supplies(panels)
            )
        return Held()


def _loose(
    site: Site,
    plates: Framed,
    panels: tuple[Part, ...],
    rims: Sequence[tuple[FloatArray, FloatArray]],
    beams: BeamGeometry | None,
) -> tuple[Part, ...]:
    """Gaskets and setting blocks of framed panels; panels that are bent have no gaskets here."""
    joint = plates.frame.joint
    blocks = tuple(block_parts(panels, joint))
    if any(panel.measures.warp_mm is not None for panel in panels):
        return blocks
    seats = GasketPlanes(plates.heights, plates.frame.width / 2)
    made = Gaskets(site, plates.frames, seats, beam_seats(beams), joint, plates.frame.cover)
    return (*made.parts(panels, rims), *blocks)


def _narrow(names: Sequence[str]) -> tuple[str, ...]:
    """A message where panels are too narrow for adapters."""
    if not names:
        return ()
    shown = ", ".join(names[:5]) + (" ..." if len(names) > 5 else "")
    return (
        f"panels: {counted(len(names), 'panel')} too narrow for adapters, without any: {shown}; a "
        "larger least width leaves them out",
    )


def _covered(cover: float, frame: PressureFrame, site: Site) -> tuple[str, ...]:
    """A message where plates cover less of the panels than their material needs."""
    needed = site.material.bearing
    if cover >= needed:
        return ()
    wider = frame.covering(needed - cover)
    return (
        f"panels: pressure plates cover them by {cover:.3g} mm at the narrowest, "
        f"{site.material.name} needs {needed:g} mm; take a frame width of {wider.width:g} mm with "
        f"an edge cover of {wider.cover:g} mm, or bevelled edges",
    )
