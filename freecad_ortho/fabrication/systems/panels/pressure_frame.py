"""Sizes of pressure plates and of the caps that are clipped onto them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.profiles import Profile, polygon
from freecad_ortho.fabrication.sizes import rounded_down
from solver.errors import InputError

# Sizes that stick systems have in common, mm: the plate, and the cap that is clipped onto it.
PLATE, _CAP, WALL = 6.0, 15.0, 2.0
# Wider ones in steps of twice this, up to a width, mm.
_STEP, WIDEST = 5.0, 120.0


@dataclass(frozen=True)
class PressureFrame:
    """A pressure plate and its cap.

    Args:
        width: of both, mm.
        cover: how far panels reach under the plate, mm.
        gasket: thickness of the gaskets under and above the panels, mm.
        grows: whether a wider one may be made where panels need it.

    Raises:
        InputError: sizes that leave no joint.
    """

    width: float = 50.0
    cover: float = 15.0
    gasket: float = 5.0
    grows: bool = False

    def __post_init__(self) -> None:
        if self.joint <= 0:
            raise InputError(
                f"edge cover: {self.cover:g} mm on both sides leave no joint under a frame of "
                f"{self.width:g} mm; take less than {rounded_down(self.width / 2)} mm"
            )

    @property
    def joint(self) -> float:
        """Between two panels, mm."""
        return self.width - 2 * self.cover

    def covering(self, more: float) -> PressureFrame:
        """One that covers panels by so much more, mm, in steps, with the same joint."""
        added = _STEP * math.ceil(more / _STEP - 1e-9)
        return replace(self, width=self.width + 2 * added, cover=self.cover + added)

    @cached_property
    def plate(self) -> Profile:
        """The section of the pressure plate."""
        half = self.width / 2
        ring = np.array([[-half, 0.0], [half, 0.0], [half, PLATE], [-half, PLATE]])
        return polygon(f"pressure plate {self.width:g}x{PLATE:g}", ring)

    @cached_property
    def cap(self) -> Profile:
        """The section of the cap, a channel that is open below."""
        half, inner = self.width / 2, self.width / 2 - WALL
        right = [[half, 0.0], [half, _CAP], [-half, _CAP], [-half, 0.0]]
        left = [[-inner, 0.0], [-inner, _CAP - WALL], [inner, _CAP - WALL], [inner, 0.0]]
        return polygon(f"cap {self.width:g}x{_CAP:g}x{WALL:g}", np.array(right + left))
