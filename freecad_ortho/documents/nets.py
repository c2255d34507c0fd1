"""Nets in documents: reading, writing and optimising them."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.documents import net_settings
from freecad_ortho.documents.common import document_or_new, require_net, transaction
from freecad_ortho.mesh_files import DEFAULT_UNIT, read_mesh
from freecad_ortho.objects import net as net_object
from freecad_ortho.objects import places, source_net
from freecad_ortho.objects.net_settings import ALL
from freecad_ortho.units import millimetres_per
from solver import Session, optimise, write_mesh
from solver.analysis.upright import side_remark
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin, measured_from
from solver.mesh.mirror import reversed_orientation
from solver.nets.settings import fixed_vertices
from solver.option import one_of

if TYPE_CHECKING:
    # Of the standard library from Python 3.11 on.
    from typing_extensions import Unpack

    from freecad_ortho.keywords import NetSettings, PassedSettings
    from solver import Outcome
    from solver.mesh.quadmesh import FloatArray, QuadMesh

# A drag by hand takes the mesh along in small steps; a sheet buckles to the side it was led to.
_DRAG_STEPS = 10
# The result of a run that a task panel has just watched, for the one call that records it.
_ready: dict[tuple[Any, ...], Outcome] = {}


def import_net(
    path: str | os.PathLike[str],
    document: FreeCAD.Document | str | None = None,
    unit: str | None = None,
    up: str = "z",
    origin: str = "local",
) -> FreeCAD.DocumentObject:
    """Read an OBJ, PLY, OFF, JSON or VTK file with quads and add a Net to a document.

    Faces may have any number of corners: such a Net is for the net ``planar``, panels and beams. A
    mesh of triangles alone is refused: quads are made of it first.

    Args:
        path: the file.
        document: a document or its name; without it the active one, or a new one.
        unit: ``mm``, ``cm``, ``m``, ``in`` or ``ft``; without it what the file says.
        up: ``z``, or ``y`` for a file whose y points up.
        origin: ``local`` puts a net that is far from the origin near it, as views and CAD kernels
            need it: a round point is taken off and kept in the Net's ``Origin``, the same for all
            nets of one site. ``keep`` leaves the net where it is.

    Returns:
        The new Net, in mm.

    Raises:
        InputError: the file does not hold a usable quad mesh, or another word for the origin.
    """
    one_of("origin", origin, ("keep", "local"))
    read = read_mesh(path, unit, up, mixed=True)
    if (read.mesh.connectivity.face_sizes == 3).all():
        # Refused with what to do: hardly ever are they meant as they are.
        read = read_mesh(path, unit, up)
    scale = millimetres_per(read.unit)
    target = document_or_new(document, Path(path).stem)
    with transaction(target, FreeCAD.Qt.translate("Ortho", "Import quad mesh")):
        taken = LocalOrigin(np.zeros(3))
        if origin == "local":
            taken = places.document_origin(target, read.mesh, scale)
        mesh = taken.near_mesh(read.mesh).scaled(scale)
        net = net_object.create(target, mesh, Path(path).stem)
        net.Origin = convert.vectors(taken.scaled(scale).shift[None])[0]
        convert.store_border(net, [scale * taken.near(line) for line in read.border])
        net.Unit = read.unit
        if mesh.connectivity.mixed:
            # The only one that takes such faces.
            net.NetType = "planar"
        net.SourceFile = os.fspath(path)
        target.recompute()
    for remark in read.remarks:
        FreeCAD.Console.PrintWarning(f"{net.Label}: {remark}\n")
    if taken.far:
        FreeCAD.Console.PrintMessage(
            FreeCAD.Qt.translate(
                "Ortho", "{}: far from the origin; put near it, and back where it is exported\n"
            ).format(net.Label)
        )
    return net


def export_net(
    net: FreeCAD.DocumentObject,
    path: str | os.PathLike[str],
    unit: str | None = None,
    origin: str | Sequence[float] = "keep",
) -> None:
    """Write a Net into an OBJ, PLY, OFF or JSON file, quads as quads, every digit kept.

    It is written where it is seen: the placement of the Part that contains it counts.

    Args:
        net: the Net.
        path: the file; what it is called says its format.
        unit: ``mm``, ``cm``, ``m``, ``in`` or ``ft``; without it that of the file it came from,
            else mm. The file names it.
        origin: what coordinates are measured from: ``keep`` for the origin of the file that the Net
            came from, ``local`` for the document's, or a point in the file's coordinates, mm.

    Raises:
        InputError: not a Net, an unknown unit or origin, or a name that says no format.
        OutputError: the file cannot be written; nothing half-written is left behind.
    """
    require_net(net)
    chosen = unit or net.Unit or DEFAULT_UNIT
    mesh = places.moved_mesh(convert.quad_mesh(net), places.container(net))
    taken = places.origin(net)
    left = LocalOrigin(taken - measured_from(origin, taken)).scaled(1 / millimetres_per(chosen))
    # Divided and not multiplied by a part: what was read in metres is written as it was read.
    metres = mesh.with_vertices(mesh.vertices / millimetres_per(chosen))
    lines = [places.moved(line, places.container(net)) for line in convert.border(net)]
    border = [left.back(line / millimetres_per(chosen)) for line in lines]
    write_mesh(path, left.back_mesh(metres), chosen, border)


def set_net(target: FreeCAD.DocumentObject, /, **settings: Unpack[NetSettings]) -> None:
    """Say what a Net is to become and what holds it, without optimising yet.

    Args:
        target: the Net.
        settings: as for :func:`optimise_net`; what is not given stays, what other nets have too.

    Raises:
        InputError: a setting that cannot be used; the Net is unchanged.
    """
    require_net(target)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Settings of the net")):
        _store(target, settings)


def optimise_net(target: FreeCAD.DocumentObject, /, **settings: Unpack[NetSettings]) -> Outcome:
    """Optimise a Net in its document; structures on it follow.

    A Net that was made by a source keeps the result and no longer follows that source. Where that
    has changed since, the Net is marked as outdated, and optimising begins anew with what the
    source makes now.

    Args:
        target: the Net.
        settings: those of :class:`freecad_ortho.keywords.NetSettings`. What is given is kept in the
            Net's properties, the rest is taken from there: ``net`` (its name); ``fix`` (``none``,
            ``corners``, ``boundary``, numbers, or a list of both); ``supports`` (``boundary``,
            which slides along its own curve, ``corners`` or numbers); ``glide`` (list of
            ``boundary``, ``z=0`` or ``(object, "Edge1")``, with vertices as a third entry);
            ``close_to`` (the same kind of list); ``handles`` (places in mm by vertex);
            ``symmetry``; the options of nets; the weights of ``solver.nets.settings.WEIGHTS``,
            ``tolerance`` and ``within`` with them.
            Not kept: ``max_steps``, ``backend``, and ``options`` and ``constraints``
            as for :func:`freecad_ortho.api.optimise`.

    Returns:
        The outcome, its mesh in mm; the report is also in the Net's ``LastReport``.

    Raises:
        InputError: settings that do not fit the mesh, or that its kind of net does not have; the
            Net is unchanged.
    """
    require_net(target)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Optimise")):
        return optimise_within(target, **settings)


def optimise_within(target: FreeCAD.DocumentObject, /, **settings: Unpack[NetSettings]) -> Outcome:
    """Do what :func:`optimise_net` does, within a transaction of the caller's."""
    mesh = source_net.starting_mesh(target)
    ready = _ready.pop(_key(target, settings, mesh.vertices), None)
    kept, passed = net_settings.divided(settings)
    with _as_before_on_failure(target):
        if source_net.is_outdated(target):
            source_net.remake(target)
        _store(target, kept)
        given = net_settings.for_solver(target, mesh)
        if ready is None:
            ready = optimise(mesh, **{**given, **passed})
        _keep(target, ready)
    side = side_remark(mesh, *given["options"].load_vectors)
    if side is not None:
        FreeCAD.Console.PrintWarning(f"{target.Label}: {side}\n")
    return ready


def flip_net(target: FreeCAD.DocumentObject) -> None:
    """Turn the other side of a Net up; offsets and all that stands on it follow.

    Args:
        target: the Net; vertex and face numbers and the families of its lines stay.

    Raises:
        InputError: not a Net, or an empty one.
    """
    require_net(target)
    mesh = reversed_orientation(convert.quad_mesh(target))
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Flip net")):
        target.Flipped = not target.Flipped
        convert.store_mesh(target, mesh)
        target.Document.recompute()


def drag_net(
    target: FreeCAD.DocumentObject,
    places: Mapping[int, Sequence[float]],
    /,
    hold: Sequence[int] = (),
    **settings: Unpack[NetSettings],
) -> Outcome:
    """Drag vertices of a Net towards places; the others follow so that it stays its kind of net.

    Args:
        target: the Net.
        places: where to, in mm, by vertex; soft: the net wins.
        hold: vertices that stay exactly where they are. Both are the Net's handles from then on.
        settings: as for :func:`optimise_net`.

    Returns:
        The outcome, its mesh in mm.

    Raises:
        InputError: a vertex that does not exist or is fixed, settings that do not fit the mesh; the
            Net is unchanged.
    """
    require_net(target)
    mesh = convert.quad_mesh(target)
    given = {**settings, "drag": dict(places), "hold": list(hold)}
    kept, passed = net_settings.divided(settings)
    ready = _ready.pop(_key(target, given, mesh.vertices), None)
    with transaction(target.Document, FreeCAD.Qt.translate("Ortho", "Drag vertices")):
        _store(target, kept)
        if ready is None:
            session = dragging(target, mesh, list(places), hold, **passed)
            ready = _dragged(session, mesh, places)
        moved = ready.mesh.vertices
        handles = {vertex: moved[vertex].tolist() for vertex in {*places, *hold}}
        net_settings.store(target, {"handles": handles})
        _keep(target, ready)
    return ready


def dragging(
    target: FreeCAD.DocumentObject,
    mesh: QuadMesh,
    handles: Sequence[int],
    hold: Sequence[int] = (),
    **passed: Unpack[PassedSettings],
) -> Session:
    """Start a session in which vertices of a Net are dragged, with the Net's own settings.

    Args:
        target: the Net.
        mesh: its mesh.
        handles: the vertices.
        hold: vertices that stay exactly where they are, besides those that are fixed anyway.
        passed: what else the solver is told, such as ``backend``.

    Raises:
        InputError: a vertex that does not exist or is fixed, settings that do not fit the mesh.
    """
    settings = net_settings.for_solver(target, mesh) | passed
    if hold:
        fixed = net_settings.held(target, mesh) | fixed_vertices(mesh, list(hold))
        settings["fix"] = np.flatnonzero(fixed).tolist()
    return Session(mesh, handles, settings.pop("net"), **settings)


def _dragged(session: Session, mesh: QuadMesh, places: Mapping[int, Sequence[float]]) -> Outcome:
    """Drag all handles straight to their places, slowly, as by hand, and settle there."""
    vertices, ends = (
        list(places),
        [np.asarray(place, dtype=np.float64) for place in places.values()],
    )
    for vertex, place in zip(vertices, ends, strict=True):
        if place.shape != (3,) or not np.isfinite(place).all():
            raise InputError(
                f"drag: the place of vertex {vertex} is not a point; give x, y, z in mm"
            )
    begin, end = mesh.vertices[vertices], np.array(ends)
    for part in np.linspace(0.0, 1.0, _DRAG_STEPS + 1)[1:]:
        between = begin + part * (end - begin)
        session.drag(dict(zip(vertices, between, strict=True)))
    return session.settle()


def _store(target: FreeCAD.DocumentObject, settings: dict[str, Any]) -> None:
    """Keep settings in the Net; where one is refused, also without undo, all are as before."""
    net_settings.refuse_foreign_words(target, settings)
    before = [(item.name, getattr(target, item.name)) for item in ALL]
    try:
        net_settings.store(target, settings)
        net_settings.for_solver(target, convert.quad_mesh(target))
    except BaseException:
        for name, value in before:
            setattr(target, name, value)
        raise


@contextmanager
def _as_before_on_failure(target: FreeCAD.DocumentObject) -> Iterator[None]:
    """Give an outdated net its mesh back where it is not optimised, also without undo."""
    if not source_net.is_outdated(target):
        yield
        return
    names = ("MadeFrom", "Outdated", "Remarks")
    mesh, before = convert.quad_mesh(target), {name: getattr(target, name) for name in names}
    try:
        yield
    except BaseException:
        convert.store_mesh(target, mesh)
        for name, value in before.items():
            setattr(target, name, value)
        raise


def _keep(target: FreeCAD.DocumentObject, outcome: Outcome) -> None:
    store_outcome(target, outcome)
    target.Document.recompute()


def store_outcome(target: FreeCAD.DocumentObject, outcome: Outcome) -> None:
    """Write an outcome into a Net; what stands on it follows with the next recompute."""
    convert.store_vertices(target, outcome.mesh.vertices)
    target.LastReport = json.dumps(outcome.report.as_dict())


def keep_outcome(
    target: FreeCAD.DocumentObject, settings: dict[str, Any], start: FloatArray, outcome: Outcome
) -> None:
    """Hand in what :func:`optimise_net` would compute from here, when it has been computed already.

    Args:
        target: the Net.
        settings: exactly the settings of the coming call; for :func:`drag_net` its places too, as
            ``drag``, and ``hold``.
        start: (V, 3) positions of the Net that the run began with.
        outcome: the result of the run.
    """
    _ready.clear()
    _ready[_key(target, settings, start)] = outcome


def _key(
    target: FreeCAD.DocumentObject, settings: dict[str, Any], start: FloatArray
) -> tuple[Any, ...]:
    chosen = json.dumps(settings, sort_keys=True, default=_name)
    return target.Document.Name, target.Name, chosen, start.tobytes()


def _name(value: Any) -> str:
    return str(getattr(value, "Name", value))
