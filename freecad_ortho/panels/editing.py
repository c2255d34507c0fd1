"""Live editing of a net: handles, drags, and one undo step for each drag that is let go."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any

import FreeCAD
import numpy as np
from PySide import QtCore

from freecad_ortho import convert, documents, preferences
from freecad_ortho.documents import net_settings
from freecad_ortho.objects import constraints
from freecad_ortho.objects.net_settings import ALL
from freecad_ortho.panels.live import Live
from freecad_ortho.panels.watch import NetWatch
from freecad_ortho.view import dragging
from freecad_ortho.view.handles import CHOSEN, HANDLE, HELD, HOVERED
from freecad_ortho.view.mouse import Mouse
from freecad_ortho.view.screen import Ray, redraw
from freecad_ortho.window import context, messages
from solver.errors import OrthoError
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

# Seconds without a picture of the net after which the handles move on without it; a picture more
# for each move of the mouse would hold up that of the net.
_LATE = 0.1

_SETTINGS = {item.name for item in ALL}


class Editing:
    """What happens between a double click on a net and Close.

    The document is touched only when a drag is let go and the exact net is found: one undo step
    and one line of a macro. Until then the picture moves, not the net.

    Args:
        net: the Net.
        told: called after each change with a sentence for the user, or with None.
        lost: called, with the reason or nothing to say, when there is nothing left to edit.

    Attributes:
        points: (V, 3) positions that are on the screen.
        handles: where the handles are drawn to, by vertex.
        chosen: the handles that move together; the last one is the one that is held.
        mode: how the mouse moves them, one of :data:`freecad_ortho.view.dragging.MODES`.
    """

    def __init__(
        self,
        net: FreeCAD.DocumentObject,
        told: Callable[[str | None], None],
        lost: Callable[[str], None],
    ) -> None:
        self._net, self._told, self._lost = net, told, lost
        self._stale = False
        self.handles: dict[int, FloatArray] = dict.fromkeys(net.Handles, np.zeros(3))
        self.chosen: list[int] = []
        self.mode = dragging.VIEW_PLANE
        self.live: Live | None = None
        self.committing = False
        self._hovered: int | None = None
        self._shown = 0.0
        self._starts: dict[int, FloatArray] = {}
        self._normal = np.zeros(3)
        self._surface: TriangleSurface | None = None
        self._read()
        self._watch = NetWatch(net, lambda: self._lost(""), self._reread)
        self.mouse = Mouse(net.ViewObject, self)
        self._mark()

    @property
    def busy(self) -> bool:
        """Tell whether a drag is under way or the exact net is being sought."""
        return bool(self._starts)

    def end(self, gone: bool = False) -> None:
        """Leave the net as it is stored; doing it again changes nothing.

        Args:
            gone: whether the net is being deleted, so that it must not be touched.
        """
        if not self._watch.watching:
            return
        self._watch.end()
        self._stop()
        self.mouse.remove()
        if not gone:
            self._keep_handles()
            self._net.ViewObject.Proxy.show_stored()

    def _keep_handles(self) -> None:
        """Have the net keep handles that were chosen or removed since the last drag."""
        if set(self.handles) != set(self._net.Handles):
            places = {vertex: tuple(map(float, at)) for vertex, at in self.handles.items()}
            with messages.errors_shown():
                context.run("set_net", self._net, handles=places)

    def _reread(self, name: str) -> None:
        """Follow a property of the net that something else has changed, undo for one."""
        if self.committing or (name not in ("Vertices", "Faces") and name not in _SETTINGS):
            return
        self._stop()
        if not self._stale:
            # Faces and vertices change one after the other: look when both have.
            self._stale = True
            QtCore.QTimer.singleShot(0, self.refresh)

    def refresh(self) -> None:
        """Take the net anew where it was changed; what cannot be edited any more ends editing."""
        if not self._stale:
            return
        self._stale = False
        if self._watch.net is None:
            return
        try:
            self._read()
        except OrthoError as error:
            self._lost(str(error))
            return
        self._mark()
        self._told(translate("Ortho", "The net was changed."))

    def hover(self, vertex: int | None) -> None:
        """Light up the vertex under the mouse."""
        self._hovered = vertex
        self._mark()

    def click(self, vertex: int, add: bool) -> None:
        """Make a vertex a handle and choose it; with Ctrl in addition to the others, or no more."""
        if self._refused(vertex):
            return
        if not add:
            self.chosen = [vertex]
        elif vertex in self.chosen:
            self.chosen.remove(vertex)
        else:
            self.chosen.append(vertex)
        self._add([vertex])
        self._told(None)

    def frame(self, vertices: list[int]) -> None:
        """Choose all vertices in a rectangle."""
        free = [vertex for vertex in vertices if not self._fixed[vertex]]
        self.chosen = [vertex for vertex in self.chosen if vertex not in free] + free
        self._add(free)
        self._told(None)

    def grab(self, vertex: int) -> bool:
        """Begin to drag a vertex, and with it all that are chosen."""
        if self._refused(vertex):
            return False
        if vertex not in self.chosen:
            self.chosen = [vertex]
        self.chosen = [one for one in self.chosen if one != vertex] + [vertex]
        self._add([vertex])
        return self._begin()

    def move(self, ray: Ray) -> None:
        """Move the chosen handles with the mouse."""
        held = self._starts[self.chosen[-1]]
        self.shift(self._aimed(ray, held) - held)

    def drop(self) -> None:
        """Find the exact net for where the handles are; then it is one undo step."""
        if self.live is not None:
            self.live.settle()
            self._told(translate("Ortho", "Finding the exact net ..."))

    def cancel(self) -> None:
        """Undo the drag that is under way."""
        self._stop()
        self._show(self._mesh.vertices)
        self._told(translate("Ortho", "Put back."))

    def key(self, word: str) -> None:
        """Choose a way to drag, or remove handles."""
        if word == "delete":
            self.remove(self.chosen)
        else:
            self.choose_mode(word)

    def choose_mode(self, mode: str) -> None:
        """Drag in another way, from now on."""
        self.mode = mode
        self._told(None)

    def remove(self, vertices: Iterable[int]) -> None:
        """Let vertices be handles no more."""
        if self.busy:
            return
        for vertex in list(vertices):
            self.handles.pop(vertex, None)
        self.chosen = [vertex for vertex in self.chosen if vertex in self.handles]
        self.live = None
        self._mark()
        self._told(None)

    def move_to(self, place: FloatArray) -> None:
        """Put the chosen handle, and the others as far, to a place in mm."""
        if self.chosen and not self.busy and self._begin():
            self.shift(np.asarray(place) - self._starts[self.chosen[-1]])
            self.drop()

    def shift(self, way: FloatArray) -> None:
        """Move the chosen handles from where the drag began, (3,) in mm."""
        for vertex in self.chosen:
            place = self._starts[vertex] + way
            if self.mode == dragging.ON_SURFACE and self._surface is not None:
                place = self._surface.closest(place[None])[0][0]
            self.handles[vertex] = place
        self.live.aim({vertex: self.handles[vertex] for vertex in self.live.session.targets})
        if time.perf_counter() - self._shown > _LATE:
            self._mark()

    def _read(self) -> None:
        """Take the net as it is stored; handles are where their vertices are."""
        self._mesh = convert.quad_mesh(self._net)
        self.points = self._mesh.vertices
        self.live, self._surface = None, None
        count = len(self.points)
        self.handles = {v: self.points[v].copy() for v in self.handles if v < count}
        self._hovered = None
        self._fixed = self._fixed_mask()
        self.handles = {v: place for v, place in self.handles.items() if not self._fixed[v]}
        self.chosen = [vertex for vertex in self.chosen if vertex in self.handles]

    def _fixed_mask(self) -> Any:
        return net_settings.held(self._net, self._mesh)

    def _refused(self, vertex: int) -> bool:
        if self._fixed[vertex]:
            self._told(translate("Ortho", "Vertex {} is fixed.").format(vertex))
        return bool(self._fixed[vertex])

    def _add(self, vertices: list[int]) -> None:
        for vertex in vertices:
            if vertex not in self.handles:
                self.handles[vertex] = self.points[vertex].copy()
                if not self.busy:
                    self.live = None
        self._mark()

    def _begin(self) -> bool:
        """Start stepping, in the session of the last drag where it still fits."""
        with messages.errors_shown():
            drawn, held = self._parted()
            if self.live is None or set(self.live.session.targets) != set(drawn):
                if self.live is not None:
                    self.live.stop()
                chosen = preferences.solver_settings()
                session = documents.dragging(self._net, self._mesh, drawn, held, **chosen)
                self.live = Live(session, self._stepped, self._settled)
            elif self.live.settling:
                # Taken up again before it was exact: both drags become one step.
                self.live.stop()
            self._starts = {vertex: self.handles[vertex].copy() for vertex in self.chosen}
            self._normal = self._mesh.with_vertices(self.points).vertex_normals[self.chosen[-1]]
            if self.mode == dragging.ON_SURFACE:
                self._surface = self._reference_surface()
            return True
        return False

    def _parted(self) -> tuple[list[int], list[int]]:
        """The handles that are drawn away, and those that hold the net."""
        places = self._mesh.vertices
        drawn = [
            vertex
            for vertex, place in self.handles.items()
            if vertex in self.chosen or not np.array_equal(place, places[vertex])
        ]
        return drawn, [vertex for vertex in self.handles if vertex not in drawn]

    def _reference_surface(self) -> TriangleSurface:
        """The faces that the net stays near, else the shape it has now."""
        near = constraints.reference_surface(self._net, self._mesh)
        return TriangleSurface.from_quads(self._mesh) if near is None else near

    def _aimed(self, ray: Ray, place: FloatArray) -> FloatArray:
        if self.mode in dragging.AXES:
            return dragging.on_axis(ray, place, dragging.AXES[self.mode])
        if self.mode == dragging.ALONG_NORMAL:
            return dragging.on_axis(ray, place, self._normal)
        if self.mode == dragging.ON_SURFACE and self._surface is not None:
            return dragging.on_surface(ray, place, self._surface)
        return dragging.on_plane(ray, place, ray.direction)

    def _stepped(self, points: FloatArray) -> None:
        self._show(points)
        redraw()
        self._told(None)

    def _settled(self, outcome: Any, error: str | None) -> None:
        if error is not None:
            self.cancel()
            self._told(error)
            return
        drawn, held = self._parted()
        places = {vertex: tuple(map(float, self.handles[vertex])) for vertex in drawn}
        # The macro line computes this again when it is replayed; here it only takes the result.
        chosen = preferences.solver_settings()
        settings = {"drag": places, "hold": held, **chosen}
        documents.keep_outcome(self._net, settings, self._mesh.vertices, outcome)
        self._starts = {}
        self.committing = True
        try:
            with messages.errors_shown():
                more = {"hold": held} if held else {}
                context.run("drag_net", self._net, places, **more, **chosen)
        finally:
            self.committing = False
        self._read()
        self._show(self.points)
        self._told(outcome.report.message)

    def _stop(self) -> None:
        """End a drag; the handles go back to their vertices."""
        if self.live is not None:
            self.live.stop()
        self.live, self._starts = None, {}
        self.mouse.release()
        for vertex in self.handles:
            self.handles[vertex] = self._mesh.vertices[vertex].copy()

    def _show(self, points: FloatArray) -> None:
        self.points = points
        self._net.ViewObject.Proxy.show_vertices(points)
        self._mark()

    def _mark(self) -> None:
        self._shown = time.perf_counter()
        vertices = list(self.handles)
        kinds = [CHOSEN if vertex in self.chosen else HANDLE for vertex in vertices]
        places = [self.handles[vertex] for vertex in vertices]
        held = np.flatnonzero(self._fixed).tolist()
        kinds += [HELD] * len(held)
        places += list(self.points[held])
        if self._hovered is not None and not self.busy:
            kinds.append(HOVERED)
            places.append(self.points[self._hovered])
        self.mouse.handles.show(np.array(places).reshape(-1, 3), kinds)
        ends = np.array([self.handles[vertex] for vertex in vertices]).reshape(-1, 3)
        self.mouse.handles.show_lines(self.points[vertices].reshape(-1, 3), ends)
