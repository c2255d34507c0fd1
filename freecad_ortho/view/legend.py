"""A colour scale in the corner of the 3D view, part of pictures too."""

from __future__ import annotations

import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.colour_scale import ColourScale
from freecad_ortho.view.colours import palette

# Corners of the window are at -1 and +1.
_LEFT, _RIGHT, _BOTTOM, _TOP = -0.95, -0.915, -0.45, 0.45
_PLATE = (-0.975, -0.70, -0.53, 0.66)
_STRIPES = 64


class Legend:
    """Coin nodes of a colour scale with a title and labels.

    Attributes:
        root: node to add to a scene; it does not count for fitting the view or for picking.
    """

    def __init__(self) -> None:
        self.root = coin.SoSwitch()
        skip = scene.left_out_of_fitting()
        self.root.addChild(skip)
        overlay = coin.SoAnnotation()
        skip.addChild(overlay)
        start = (coin.SoResetTransform(), scene.unpickable(), scene.unlit(), scene.window_camera())
        for child in (*start, _plate()):
            overlay.addChild(child)
        self._labels = coin.SoSeparator()
        overlay.addChild(self._labels)
        self._note = coin.SoText2()
        self._explained: tuple[object, ...] = ()
        self.hide()

    def show(self, title: str, note: str, scale: ColourScale) -> None:
        """Show the scale with its labels, a title, and a short note below the title."""
        self._note.string = note
        self.root.whichChild = coin.SO_SWITCH_ALL
        explained = (title, scale.signed, *scale.labels())
        if explained == self._explained:
            # As in most pictures of a net that moves.
            return
        self._explained = explained
        self._labels.removeAllChildren()
        self._labels.addChild(_bar(scale.signed))
        colour = coin.SoBaseColor()
        colour.rgb = (0.1, 0.1, 0.12)
        self._labels.addChild(colour)
        font = coin.SoFont()
        font.name = "Sans"
        font.size = 14
        self._labels.addChild(font)
        self._labels.addChild(_text(_words(title), _LEFT, _TOP + 0.13))
        self._labels.addChild(_text(self._note, _LEFT, _TOP + 0.07))
        for place, words in scale.labels():
            height = _BOTTOM + place * (_TOP - _BOTTOM)
            self._labels.addChild(_text(_words(words), _RIGHT + 0.015, height - 0.015))

    def hide(self) -> None:
        """Show nothing."""
        self.root.whichChild = coin.SO_SWITCH_NONE


def _words(words: str) -> coin.SoText2:
    text = coin.SoText2()
    text.string = words
    return text


def _text(text: coin.SoText2, x: float, y: float) -> coin.SoSeparator:
    separator = coin.SoSeparator()
    place = coin.SoTranslation()
    place.translation = (x, y, 0.0)
    separator.addChild(place)
    separator.addChild(text)
    return separator


def _plate() -> coin.SoSeparator:
    """A light ground that keeps the labels readable on any background."""
    left, right, bottom, top = _PLATE
    separator = coin.SoSeparator()
    material = coin.SoMaterial()
    material.diffuseColor = (1.0, 1.0, 1.0)
    material.transparency = 0.25
    points = coin.SoCoordinate3()
    corners = [(left, bottom, -0.1), (right, bottom, -0.1), (right, top, -0.1), (left, top, -0.1)]
    points.point.setValues(0, 4, corners)
    faces = coin.SoFaceSet()
    faces.numVertices = 4
    for child in (material, points, faces):
        separator.addChild(child)
    return separator


def _bar(signed: bool) -> coin.SoSeparator:
    """The scale itself, blue at the bottom."""
    separator = coin.SoSeparator()
    heights = np.linspace(_BOTTOM, _TOP, _STRIPES)
    points = np.zeros((2 * _STRIPES, 3))
    points[0::2, 0], points[1::2, 0] = _LEFT, _RIGHT
    points[:, 1] = np.repeat(heights, 2)
    coordinates = coin.SoCoordinate3()
    coordinates.point.setValues(0, len(points), points)
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_VERTEX
    material = coin.SoMaterial()
    shades = np.repeat(palette(np.linspace(0, 1, _STRIPES), signed), 2, axis=0)
    material.diffuseColor.setValues(0, len(shades), shades)
    mesh = coin.SoQuadMesh()
    mesh.verticesPerRow, mesh.verticesPerColumn = 2, _STRIPES
    for child in (coordinates, binding, material, mesh):
        separator.addChild(child)
    return separator
