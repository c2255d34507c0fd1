"""Coin nodes of a diagram of forces: areas on the members, a colour a sign, numbers at extremes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from freecad_ortho import convert
from freecad_ortho.structural.diagrams import FORCES, UNITS, Diagram, across, fitting, strips
from freecad_ortho.view import check_combination, scene
from freecad_ortho.view.colours import palette
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, unit_rows

translate = FreeCAD.Qt.translate

NONE = "None"
DIAGRAMS = (NONE, *FORCES)
# Properties of a check that diagrams are drawn from, besides those of its members.
DIAGRAMS_FROM = ("ForcesAlong", "SectionsUp")
_TRANSPARENT, _TEXT_SIZE = 0.45, 11
_POSITIVE, _NEGATIVE = palette(np.array([1.0, 0.0]), signed=True)


@dataclass(frozen=True, eq=False)
class Ordinates:
    """A diagram as it is drawn.

    Attributes:
        base: (M, K, 3) sections on the members, mm.
        tips: (M, K, 3) ends of their ordinates.
        values: (M, K) what they say.
        words: of extremes, and where they stand.
    """

    base: FloatArray
    tips: FloatArray
    values: FloatArray
    words: list[tuple[str, FloatArray]]


def ordinates(
    feature: Any, force: str, millimetres: float, combination: str = check_combination.GOVERNING
) -> Ordinates | None:
    """A diagram of a check; nothing where it has none, or while its results are written.

    Args:
        feature: the structural check.
        force: one of ``DIAGRAMS``.
        millimetres: that 1 kN or kNm is drawn long; 0 for what fits.
        combination: of the loads, by its name.
    """
    members = np.array(feature.MemberNodes, dtype=np.int64).reshape(-1, 2)
    up, at = convert.array(feature.SectionsUp), convert.array(feature.Nodes)
    forces = check_combination.forces(feature, combination, len(members))
    whole = forces is not None and len(members) == len(up)
    if force == NONE or not whole or not len(members) or members.max() >= len(at):
        return None
    diagram, ends = Diagram.through(forces[:, :, FORCES.index(force)]), at[members]
    x = unit_rows(ends[:, 1] - ends[:, 0])
    axes = np.stack([x, unit_rows(np.cross(up, x)), up], axis=1)
    long = millimetres or fitting(diagram, ends)
    base = diagram.along(ends[:, 0], ends[:, 1])
    tips = base + long * diagram.values[:, :, None] * across(force, axes)[:, None]
    words = [
        (f"{force} {diagram.values[place]:.3g} {UNITS[force]}", tips[place])
        for place in diagram.extremes()
    ]
    return Ordinates(base, tips, diagram.values, words)


class DiagramAreas:
    """Areas between members and ordinates.

    Attributes:
        root: node to add to a scene.
    """

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self._stand, self._labels = coin.SoTranslation(), coin.SoAnnotation()
        for child in (self._stand, scene.unpickable(), scene.unlit()):
            self.root.addChild(child)
        self._signs = [_Sign(colour) for colour in (_POSITIVE, _NEGATIVE)]
        for sign in self._signs:
            self.root.addChild(sign.root)
        self.root.addChild(self._labels)

    def show(self, found: Ordinates | None) -> None:
        """Draw a diagram, or nothing."""
        self._labels.removeAllChildren()
        if found is None:
            for sign in self._signs:
                sign.hide()
            return
        origin = LocalOrigin.of(found.base.reshape(-1, 3))
        self._stand.translation = tuple(origin.shift.tolist())
        base, tips = (
            origin.near(points.reshape(-1, 3)).reshape(points.shape)
            for points in (found.base, found.tips)
        )
        for sign, there in zip(self._signs, (found.values > 0, found.values < 0), strict=True):
            sign.show(base, np.where(there[:, :, None], tips, base), there)
        for words, place in found.words:
            label, stand = coin.SoSeparator(), coin.SoTranslation()
            stand.translation = tuple(origin.near(place[None])[0].tolist())
            label.addChild(stand)
            label.addChild(scene.framed(words, _TEXT_SIZE))
            self._labels.addChild(label)


class _Sign:
    """Areas of one sign, and lines at their far side."""

    def __init__(self, colour: FloatArray) -> None:
        self.root, self._points = coin.SoSeparator(), coin.SoCoordinate3()
        self._faces, self._lines = coin.SoIndexedFaceSet(), coin.SoIndexedLineSet()
        clear, solid, thin = coin.SoMaterial(), coin.SoMaterial(), coin.SoDrawStyle()
        for material in (clear, solid):
            material.diffuseColor = tuple(colour.tolist())
        clear.transparency, thin.lineWidth = _TRANSPARENT, 1.0
        for child in (self._points, clear, self._faces, solid, thin, self._lines):
            self.root.addChild(child)

    def hide(self) -> None:
        """Draw nothing."""
        for shape in (self._faces, self._lines):
            shape.coordIndex.deleteValues(0)

    def show(self, base: FloatArray, tips: FloatArray, there: FloatArray) -> None:
        """Draw what is there between (M, K, 3) points."""
        self.hide()
        members, sections = there.shape
        scene.set_points(self._points, np.concatenate([base, tips]).reshape(-1, 3))
        corners = strips(members, sections)[(there[:, 1:] | there[:, :-1]).ravel()]
        if len(corners):
            scene.set_indices(self._faces, corners)
            scene.set_indices(self._lines, corners[:, [3, 2]])
