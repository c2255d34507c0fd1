"""Picking vertices in the 3D view: clicks, and drags parallel to the screen."""

from __future__ import annotations

from collections.abc import Callable

from freecad_ortho.view.dragging import on_plane
from freecad_ortho.view.screen import Ray
from solver.mesh.quadmesh import FloatArray, QuadMesh


class VertexPicker:
    """Listens to a :class:`freecad_ortho.view.mouse.Mouse`.

    Args:
        mesh: its vertices can be picked.
        clicked: called with a vertex.
        dragged: called with a vertex and the (3,) place in mm that it is dragged to.

    Attributes:
        show: called when the markers are to be drawn anew.
    """

    def __init__(
        self,
        mesh: QuadMesh,
        clicked: Callable[[int], None],
        dragged: Callable[[int, FloatArray], None],
    ) -> None:
        self.points = mesh.vertices
        self.show: Callable[[], None] = lambda: None
        self._clicked, self._dragged = clicked, dragged
        self._held = -1

    def hover(self, vertex: int | None) -> None:
        """Nothing lights up."""

    def click(self, vertex: int, add: bool) -> None:
        """Pick a vertex."""
        self._clicked(vertex)

    def frame(self, vertices: list[int]) -> None:
        """Pick all in a rectangle."""
        for vertex in vertices:
            self._clicked(vertex)

    def grab(self, vertex: int) -> bool:
        """Any vertex may be dragged."""
        self._held = vertex
        return True

    def move(self, ray: Ray) -> None:
        """Drag it parallel to the screen."""
        place = on_plane(ray, self.points[self._held], ray.direction)
        self._dragged(self._held, place)

    def drop(self) -> None:
        """It stays where it was dragged to."""

    def cancel(self) -> None:
        """Put it back where it is."""
        self._dragged(self._held, self.points[self._held])

    def key(self, word: str) -> None:
        """No key has a meaning."""
