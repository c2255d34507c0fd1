"""What a drawing is made of, as every version of DXF has it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.nesting.sheet import turned
from freecad_ortho.fabrication.strokes import text_strokes
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    from ezdxf.layouts import BaseLayout

# Names of the line type of the plate's far side and of the style of texts.
FAR_SIDE, STYLE = "FAR_SIDE", "SINGLE_STROKE"
_ORIGIN = np.zeros(2)


class DxfPen:
    """Draws into a block or a drawing, turned about its origin and then moved.

    Args:
        space: where it draws.
        text: how it writes: "text", "strokes" or "none".
        angle: degrees.
        shift: (2,) mm.
    """

    def __init__(
        self, space: BaseLayout, text: str, angle: float = 0.0, shift: FloatArray = _ORIGIN
    ) -> None:
        self._space, self._text = space, text
        self._angle, self._shift = angle, shift

    def polyline(self, layer: str, points: FloatArray, closed: bool = False) -> None:
        """Draw a line through points (N, 2), mm."""
        attributes = {"layer": layer}
        corners = self._placed(points).tolist()
        if self._space.dxfversion == "AC1009":
            # R12 has no light polylines.
            self._space.add_polyline2d(corners, close=closed, dxfattribs=attributes)
        else:
            self._space.add_lwpolyline(corners, close=closed, dxfattribs=attributes)

    def line(self, layer: str, ends: FloatArray, hidden: bool = False) -> None:
        """Draw a straight line between two points (2, 2), mm; dashed on the plate's far side."""
        attributes = {"layer": layer} | ({"linetype": FAR_SIDE} if hidden else {})
        start, end = self._placed(ends).tolist()
        self._space.add_line(start, end, dxfattribs=attributes)

    def circle(self, layer: str, centre: FloatArray, radius: float) -> None:
        """Draw a circle about (2,), mm."""
        middle = self._placed(centre[None])[0].tolist()
        self._space.add_circle(middle, radius, dxfattribs={"layer": layer})

    def words(self, layer: str, words: str, place: FloatArray, size: float, angle: float) -> None:
        """Write a line of text about its middle, letters ``size`` mm high, in degrees."""
        if self._text == "strokes":
            for stroke in text_strokes(words, place, size, angle):
                self.polyline(layer, stroke)
        elif self._text == "text":
            from ezdxf.enums import TextEntityAlignment

            text = self._space.add_text(
                words,
                height=size,
                rotation=angle + self._angle,
                dxfattribs={"layer": layer, "style": STYLE},
            )
            middle = self._placed(place[None])[0].tolist()
            text.set_placement(middle, align=TextEntityAlignment.MIDDLE_CENTER)

    def _placed(self, points: FloatArray) -> FloatArray:
        return np.asarray(turned(points, self._angle) + self._shift)
