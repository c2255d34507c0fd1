"""Coin nodes of a net's overlays, each behind a switch of its own."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.overlay_shapes import OVERLAYS, Balls, Lines, Points, Shape
from solver.mesh.quadmesh import QuadMesh

_TRANSPARENCY = 0.6


class Overlays:
    """What is drawn on top of a net.

    Attributes:
        root: node to add to a scene; a click goes through it to the net.
    """

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self.root.addChild(scene.unpickable())
        self._groups = {name: coin.SoSeparator() for name in OVERLAYS}
        for group in self._groups.values():
            self.root.addChild(group)

    def show(self, mesh: QuadMesh | None, chosen: Collection[str], moving: bool = False) -> None:
        """Draw the chosen overlays of a mesh and no others.

        Args:
            mesh: in mm; None draws nothing.
            chosen: names out of ``OVERLAYS``.
            moving: leave those as they are that are too slow to follow each step.
        """
        for name, (shapes, quick) in OVERLAYS.items():
            if moving and not quick:
                continue
            group = self._groups[name]
            group.removeAllChildren()
            if mesh is not None and name in chosen:
                for shape in shapes(mesh):
                    group.addChild(shape_node(shape))


def shape_node(shape: Shape) -> coin.SoSeparator:
    """The Coin node of a shape."""
    if isinstance(shape, Lines):
        return _lines(shape)
    return _points(shape) if isinstance(shape, Points) else _balls(shape)


def _lines(shape: Lines) -> coin.SoSeparator:
    made = _coloured(shape.colour, lit=False)
    style = coin.SoDrawStyle()
    style.lineWidth = shape.width
    lines = coin.SoLineSet()
    counts = np.full(len(shape.ends), 2, dtype=np.int32)
    lines.numVertices.deleteValues(0)
    lines.numVertices.setValues(0, len(counts), counts)
    # In front of the edges that lie under them.
    offset = coin.SoPolygonOffset()
    offset.styles = coin.SoPolygonOffset.LINES
    offset.factor, offset.units = -1.0, -1.0
    for child in (style, offset, _coordinates(shape.ends.reshape(-1, 3)), lines):
        made.addChild(child)
    return made


def _points(shape: Points) -> coin.SoSeparator:
    made = _coloured(shape.colour, lit=False)
    style = coin.SoDrawStyle()
    style.pointSize = shape.size
    points = coin.SoPointSet()
    points.numPoints = len(shape.places)
    for child in (style, _coordinates(shape.places), points):
        made.addChild(child)
    return made


def _balls(shape: Balls) -> coin.SoSeparator:
    made = _coloured(shape.colour, lit=True)
    for centre, radius in zip(shape.centres.tolist(), shape.radii.tolist(), strict=True):
        one = coin.SoSeparator()
        place = coin.SoTranslation()
        place.translation = tuple(centre)
        sphere = coin.SoSphere()
        sphere.radius = radius
        one.addChild(place)
        one.addChild(sphere)
        made.addChild(one)
    return made


def _coloured(colour: tuple[float, float, float], lit: bool) -> coin.SoSeparator:
    made = coin.SoSeparator()
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.PHONG if lit else coin.SoLightModel.BASE_COLOR
    material = coin.SoMaterial()
    material.diffuseColor = tuple(colour)
    material.transparency = _TRANSPARENCY if lit else 0.0
    made.addChild(light)
    made.addChild(material)
    return made


def _coordinates(points: Any) -> coin.SoCoordinate3:
    made = coin.SoCoordinate3()
    made.point.deleteValues(0)
    if len(points):
        made.point.setValues(0, len(points), points)
    return made
