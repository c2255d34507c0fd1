"""Named curves in elliptic coordinates, for the command line and for a first look."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.multinet.elliptic import CoordinateCurve
from solver.option import one_of


def _straight(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return 0.2 + 0.6 * s, 0.25 + 0.4 * s


def _wave(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return 0.5 - 0.25 * np.cos(np.pi * s), s


def _quarter(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return s, 0.5 - 0.25 * np.cos(np.pi * s)


def _arch(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return 0.15 + 0.7 * np.sin(np.pi * s), 0.1 + 0.8 * s


def _ring(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return 0.5 + 0.2 * np.cos(4 * np.pi * s), 4 * s


def _loop(s: FloatArray) -> tuple[FloatArray, FloatArray]:
    return 0.5 + 0.3 * np.cos(2 * np.pi * s), 0.5 + 0.3 * np.sin(2 * np.pi * s)


@dataclass(frozen=True)
class Preset:
    """A curve in the unfolded places of the two coordinates that stay.

    Attributes:
        curve: (n,) parameters to two (n,) places (see ``EllipticSystem.unfolded``).
        closed: it returns to its start.
        meaning: what it does, in plain words.
    """

    curve: CoordinateCurve
    closed: bool
    meaning: str


PRESETS = {
    "straight": Preset(_straight, False, "both coordinates rise evenly, clear of all planes"),
    "wave": Preset(_wave, False, "the second from end to end, the first rises: both ends on seams"),
    "quarter": Preset(_quarter, False, "the first from end to end, the second rises"),
    "arch": Preset(_arch, False, "the first rises and falls while the second rises"),
    "ring": Preset(_ring, True, "all around: the second once through all signs, the first waves"),
    "loop": Preset(_loop, True, "a closed oval clear of all planes"),
}


def preset(name: str) -> Preset:
    """The preset of a name.

    Raises:
        InputError: no such preset.
    """
    one_of("curve", name, PRESETS)
    return PRESETS[name]
