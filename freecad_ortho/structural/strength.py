"""How far forces use a section and a member up: rules of EN 1993-1-1, EN 1999-1-1, EN 1995-1-1.

Forces are rows of N, Vy, Vz, T, My, Mz in N and mm, tension positive; stresses in MPa.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from freecad_ortho.fabrication.material import MATERIALS, Material
from freecad_ortho.fabrication.profiles import Profile
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# Imperfection factors of buckling curves: EN 1993-1-1, table 6.1.
CURVES = {"a0": 0.13, "a": 0.21, "b": 0.34, "c": 0.49, "d": 0.76}
# Utilisation that only wrong units come to.
_ABSURD = 1000.0
# Shear on notched and cracked timber: EN 1995-1-1, 6.1.7 (2).
_CRACKED = 0.67
# Redistribution in solid rectangles: EN 1995-1-1, 6.1.6 (2).
_RECTANGLE = 0.7


class Rules(Protocol):
    """What sections and members of one profile and material can take."""

    @property
    def words(self) -> str:
        """The rules by name."""

    @property
    def factor(self) -> float:
        """Partial factor of sections and of buckling."""

    def section(self, forces: FloatArray, permanent: bool) -> FloatArray:
        """(K, M) how far forces (K, M, 6) in sections along members use these up, 1 for wholly."""

    def member(self, forces: FloatArray, lengths: FloatArray, permanent: bool) -> FloatArray:
        """(M,) the same with buckling between the ends, for buckling lengths (M,), mm."""


@dataclass(frozen=True)
class Metal:
    """Elastic rules for metals.

    Attributes:
        profile: of the members.
        material: of the members.
        curves: buckling curves about y and z.
        limit: slenderness up to which nothing buckles.
        factor: partial factor of sections and of buckling.
        words: the rules by name.
    """

    profile: Profile
    material: Material
    curves: tuple[float, float]
    limit: float
    factor: float
    words: str

    def section(self, forces: FloatArray, permanent: bool) -> FloatArray:
        """By the stresses of Mises: EN 1993-1-1, 6.2.1 (5); the largest ones are taken together."""
        normal, shear = _stresses(self.profile, forces)
        mises = np.sqrt(normal**2 + 3 * shear**2)
        return np.asarray(mises * self.factor / self.material.bending_limit)

    def member(self, forces: FloatArray, lengths: FloatArray, permanent: bool) -> FloatArray:
        """By EN 1993-1-1, 6.3.3, annex B for elastic sections, with moments taken as even.

        Sideways buckling of beams by 6.3.2.2 for open and flat sections, without warping.
        """
        profile, strength = self.profile, self.material.bending_limit / self.factor
        push = np.maximum(-forces[:, :, 0], 0).max(axis=0)
        about_y, about_z = (np.abs(forces[:, :, k]).max(axis=0) for k in (4, 5))
        young = self.material.youngs_modulus
        reduced, ratio = [], []
        for inertia, curve in zip((profile.inertia_y, profile.inertia_z), self.curves, strict=True):
            euler = np.pi**2 * young * inertia / lengths**2
            slender = np.sqrt(profile.area * self.material.bending_limit / euler)
            reduced.append(reduction(slender, curve, self.limit))
            used = push / (reduced[-1] * profile.area * strength)
            ratio.append((used, 1 + 0.6 * np.minimum(slender, 1.0) * used))
        bent_y = about_y / (self._sideways(lengths) * profile.modulus_y * strength)
        bent_z = about_z / (profile.modulus_z * strength)
        (used_y, more_y), (used_z, more_z) = ratio
        first = used_y + more_y * bent_y + more_z * bent_z
        second = used_z + more_y * bent_y + more_z * bent_z
        return np.asarray(np.maximum(first, second))

    def _sideways(self, lengths: FloatArray) -> FloatArray:
        """(M,) what is left of the bending strength where a beam may tip over."""
        profile = self.profile
        if _closed(profile):
            return np.ones_like(lengths)
        stiff = self.material.youngs_modulus * min(profile.inertia_z, profile.inertia_y)
        critical = np.pi / lengths * np.sqrt(stiff * self.material.shear_modulus * profile.torsion)
        slender = np.sqrt(profile.modulus_y * self.material.bending_limit / critical)
        return reduction(slender, CURVES["d"], 0.2)


@dataclass(frozen=True)
class Timber:
    """Rules for rectangles of timber.

    Attributes:
        profile: of the members.
        material: of the members.
        strengths: characteristic in bending, tension and compression along the fibres, in shear.
        stiffness: lower Young's modulus, for buckling.
        straightness: of buckling, 0.1 for glued and 0.2 for solid timber.
        factor: partial factor.
        words: the rules by name.
    """

    profile: Profile
    material: Material
    strengths: tuple[float, float, float, float]
    stiffness: float
    straightness: float
    factor: float
    words: str

    def _design(self, permanent: bool) -> FloatArray:
        """Design strengths; loads that stay take more: EN 1995-1-1, table 3.1, classes 1 and 2."""
        return np.array(self.strengths) * (0.6 if permanent else 0.9) / self.factor

    def section(self, forces: FloatArray, permanent: bool) -> FloatArray:
        """By EN 1995-1-1, 6.1.6 to 6.1.8, 6.2.3 and 6.2.4; shear and torsion are added up."""
        bend, pull, push, shear = self._design(permanent)
        area, y, z = self._bent(forces)
        stretched, pressed = np.maximum(area, 0) / pull, np.maximum(-area, 0) / push
        along = stretched + pressed**2 + _both(y / bend, z / bend)
        _, sheared = _stresses(self.profile, forces, _CRACKED)
        return np.asarray(np.maximum(along, sheared / shear))

    def member(self, forces: FloatArray, lengths: FloatArray, permanent: bool) -> FloatArray:
        """By EN 1995-1-1, 6.3.2, and 6.3.3 for beams that may tip over."""
        bend, _, push, _ = self._design(permanent)
        profile = self.profile
        area, y, z = self._bent(forces)
        pressed = np.maximum(-area, 0).max(axis=0)
        y, z = y.max(axis=0) / bend, z.max(axis=0) / bend
        left = []
        for inertia in (profile.inertia_y, profile.inertia_z):
            radius = np.sqrt(inertia / profile.area)
            slender = lengths / radius / np.pi * np.sqrt(self.strengths[2] / self.stiffness)
            k = 0.5 * (1 + self.straightness * (slender - 0.3) + slender**2)
            left.append(np.minimum(1.0, 1 / (k + np.sqrt(np.maximum(k**2 - slender**2, 0)))))
        sideways = self._sideways(lengths)
        one = pressed / (left[0] * push) + y + _RECTANGLE * z
        two = pressed / (left[1] * push) + _RECTANGLE * y + z
        tips = pressed / (left[1] * push) + (y / sideways) ** 2
        return np.asarray(np.maximum(np.maximum(one, two), np.maximum(tips, y / sideways)))

    def _bent(self, forces: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        profile = self.profile
        return (
            forces[:, :, 0] / profile.area,
            np.abs(forces[:, :, 4]) / profile.modulus_y,
            np.abs(forces[:, :, 5]) / profile.modulus_z,
        )

    def _sideways(self, lengths: FloatArray) -> FloatArray:
        profile = self.profile
        shear = self.stiffness / 16
        stiff = self.stiffness * min(profile.inertia_y, profile.inertia_z) * shear * profile.torsion
        critical = np.pi * np.sqrt(stiff) / (lengths * profile.modulus_y)
        slender = np.sqrt(self.strengths[0] / critical)
        middle = 1.56 - 0.75 * slender
        return np.asarray(
            np.where(slender <= 0.75, 1.0, np.where(slender <= 1.4, middle, 1 / slender**2))
        )


def reduction(slender: FloatArray, imperfection: float, limit: float) -> FloatArray:
    """What buckling leaves of the strength: EN 1993-1-1, 6.3.1.2.

    Args:
        slender: relative slenderness.
        imperfection: factor of the buckling curve.
        limit: slenderness up to which nothing is lost.
    """
    phi = 0.5 * (1 + imperfection * (slender - limit) + slender**2)
    return np.asarray(np.minimum(1.0, 1 / (phi + np.sqrt(np.maximum(phi**2 - slender**2, 0)))))


def _both(one: FloatArray, two: FloatArray) -> FloatArray:
    return np.asarray(np.maximum(one + _RECTANGLE * two, _RECTANGLE * one + two))


def _closed(profile: Profile) -> bool:
    return len(profile.rings) > 1


def _stresses(
    profile: Profile, forces: FloatArray, part: float = 1.0
) -> tuple[FloatArray, FloatArray]:
    """(K, M) largest normal stress and largest shear stress in sections, MPa.

    Args:
        profile: of the sections.
        forces: (K, M, 6).
        part: of the section that is sheared.
    """
    n, vy, vz, t, my, mz = np.moveaxis(forces, 2, 0)
    axial = n / profile.area
    if all(side.centre is not None for side in profile.sides):
        bent = np.hypot(my / profile.modulus_y, mz / profile.modulus_z)
        normal = np.abs(axial) + bent
    else:
        corners = profile.rings[0].corners - np.array(profile.centroid)
        # The section may stand either way round.
        points = np.concatenate([corners, corners * [-1.0, 1.0]])
        at = [axial + my * z / profile.inertia_y - mz * y / profile.inertia_z for y, z in points]
        normal = np.abs(at).max(axis=0)
    shear = np.hypot(vy / profile.shear_area_y, vz / profile.shear_area_z) / part
    return normal, shear + np.abs(t) / torsion_modulus(profile)


def used_words(utilisation: float) -> str:
    """How far something is used, for a sentence; sizes that no design has ask for a mistake."""
    if utilisation <= _ABSURD:
        return f"to {100 * utilisation:.0f} %"
    return f"beyond {100 * _ABSURD:,.0f} % (are the units of net and loads right?)"


def used_share(utilisation: float) -> str:
    """How far something is used, for a table."""
    if utilisation <= _ABSURD:
        return f"{100 * utilisation:.0f} %"
    return f"> {100 * _ABSURD:,.0f} %"


def torsion_modulus(profile: Profile) -> float:
    """Torque by the shear stress that it makes, mm3: Bredt for hollow, J / t for open sections.

    For compact solid sections J / t is on the safe side by up to a third.
    """
    if _closed(profile):
        outer, inner = (_ring_area(ring.corners, ring.radii) for ring in profile.rings[:2])
        return (outer + inner) * profile.wall
    if len(profile.rings[0].corners) == 4:
        return profile.torsion / min(profile.width, profile.height)
    # Flanges are thicker than the web: the lowest step of the outline is one.
    levels = np.unique(np.round(np.abs(profile.rings[0].corners[:, 1]), 6))
    flange = float(levels[-1] - levels[-2]) if len(levels) > 1 else profile.wall
    return profile.torsion / max(profile.wall, flange)


def _ring_area(corners: FloatArray, radii: FloatArray) -> float:
    y, z = corners.T
    area = 0.5 * abs(float(y @ np.roll(z, -1) - np.roll(y, -1) @ z))
    right_angles = len(corners) == 4
    return area - (1 - np.pi / 4) * float((radii**2).sum()) if right_angles else area


# Characteristic strengths in bending, tension, compression and shear and the lower modulus, MPa:
# EN 14080, table 5, and EN 338, table 1.
_TIMBER = {
    "GL24h": ((24.0, 19.2, 24.0, 3.5), 9600.0),
    "GL28h": ((28.0, 22.3, 28.0, 3.5), 10_500.0),
    "GL30h": ((30.0, 24.0, 30.0, 3.5), 11_300.0),
    "GL32h": ((32.0, 25.6, 32.0, 3.5), 11_800.0),
    "C24": ((24.0, 14.5, 21.0, 4.0), 7400.0),
    "C30": ((30.0, 19.0, 24.0, 4.0), 8000.0),
}
_STEELS = ("steel", "S235", "S275", "S355")
DESIGNED = (*_STEELS, "stainless", "aluminium", *_TIMBER)


def rules_for(profile: Profile, name: str) -> Rules:
    """The rules for members of a profile in a material.

    Args:
        profile: of the members.
        name: of the material.

    Raises:
        InputError: a material without rules, or that such a section is not made of.
    """
    if name not in DESIGNED:
        raise InputError(
            f"material: there are no rules for members of '{name}'; take one of "
            f"{', '.join(DESIGNED)}"
        )
    if profile.materials and name not in profile.materials:
        raise InputError(
            f"material: {profile.name} is made of {', '.join(profile.materials)}, not of {name}"
        )
    if profile.inertia_yz:
        raise InputError(
            f"section: {profile.name} has no axis of symmetry, which the check needs; take another"
        )
    material = MATERIALS[name]
    if name in _TIMBER:
        return _timber(profile, material)
    if name == "aluminium":
        # Class A without welds: EN 1999-1-1, tables 6.1 and 6.6.
        return Metal(profile, material, (0.20, 0.20), 0.10, 1.10, "EN 1999-1-1, class A, no welds")
    if name == "stainless":
        # EN 1993-1-4, table 5.3, the lower ones of hollow and open sections.
        return Metal(profile, material, (0.76, 0.76), 0.20, 1.10, "EN 1993-1-4, elastic")
    curves = (CURVES[letter] for letter in curve_letters(profile))
    return Metal(profile, material, (next(curves), next(curves)), 0.20, 1.0, "EN 1993-1-1, elastic")


def curve_letters(profile: Profile) -> str:
    """Buckling curves about y and z of a steel section: EN 1993-1-1, table 6.2, S235 to S420."""
    if profile.series in ("tube", "chs"):
        return "aa"
    if profile.series in ("IPE", "HEA", "HEB", "HEM"):
        return "ab" if profile.height > 1.2 * profile.width else "bc"
    return "cc"


def _timber(profile: Profile, material: Material) -> Timber:
    if len(profile.rings) > 1 or len(profile.rings[0].corners) != 4:
        raise InputError(f"section: timber is checked as rectangles only, not as {profile.name}")
    strengths, stiffness = _TIMBER[material.name]
    glued = material.name.startswith("GL")
    return Timber(
        profile, material, strengths, stiffness, 0.1 if glued else 0.2, 1.25 if glued else 1.3,
        "EN 1995-1-1, service class 1 or 2, kmod 0.6 and 0.9",
    )  # fmt: skip
