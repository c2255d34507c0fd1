"""Quads from triangles by an optional library, brought back onto the surface and its border.

The library (pyQuadriFlow) is compiled code that may crash or hang: it runs in a process of its own
with a time limit. It works in single precision and leaves the border by a few percent of its
length, so every vertex is set back: border vertices onto the border polylines, corners onto
corners, the others onto the triangles. It also closes openings that its quads are too large for:
the new border is held against the old one, and where one was lost the quads are made smaller.

Source: Huang et al. (2018), QuadriFlow: a scalable and robust method for quadrangulation.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.isolated import Isolated, LibraryError
from solver.mesh.border import Border, set_back
from solver.mesh.closest import TriangleSurface
from solver.mesh.coarsen import compact
from solver.mesh.connectivity import IntArray
from solver.mesh.intake import quad_mesh
from solver.mesh.mirror import size_of
from solver.mesh.openings import Loops, Misfit, far_loop, other_loops
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.quadriflow import LIBRARY, Quadriflow
from solver.mesh.triangles import sound_triangles
from solver.option import Option, Range

# Most quads that are made, and the longest that the library may take, in seconds.
_MOST, _LONGEST = 200_000, 3600.0
# Seconds that it has for another try, even where none are left.
_LEAST = 0.1
# How many times as many quads are tried one after the other where a border was lost.
_FINER = (1.0, 1.4, 2.0, 2.8, 4.0)
# Where an opening needs so many times as many, none of these is worth its time.
_HOPELESS = 10.0
# How far the two borders may be from each other, in mean edges.
_REACH = 0.5
# An edge of this part of its width keeps an opening, as a rule.
_OF_OPENING = 1 / 7

# What may be said about the quads.
OPTIONS = (
    Option(
        *("faces", None, "count", "there are about so many quads"),
        brief="wanted number of quads",
        within=Range(4, _MOST),
    ),
    Option(
        *("edge", None, "length", "quads have edges about this long"),
        title="Edge length",
        brief="wanted edge length instead",
    ),
    Option(
        *("corner", 40.0, "angle", "border vertices that turn by more than this are kept"),
        within=Range(0.0, 180.0),
    ),
    Option(
        *("seed", 0, "count", "another number gives another layout of quads"),
        title="Layout",
    ),
    Option(
        *("time_limit", 60.0, "number", "the library may take so many seconds"),
        title="Time limit (s)",
        within=Range(0.0, _LONGEST, above=True),
    ),
)


@dataclass(frozen=True, eq=False)
class Remeshed:
    """Quads in place of triangles.

    Attributes:
        mesh: the quads; vertices on the triangles, border on the border.
        irregular: (K,) interior vertices that have not four faces.
        border_gap: largest distance between the original border and the new one, either way.
        remarks: what is to be said about it, in plain words.
    """

    mesh: QuadMesh
    irregular: IntArray
    border_gap: float
    remarks: tuple[str, ...] = ()


def quads_from_triangles(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    faces: int | None = None,
    edge: float | None = None,
    seed: int = 0,
    time_limit: float = 60.0,
    corner: float = 40.0,
    waiting: Callable[[float], object] | None = None,
) -> Remeshed:
    """Remesh a triangle mesh to quads.

    Args:
        vertices: (V, 3) coordinates, in the model's unit.
        triangles: (T, 3) vertex numbers.
        faces: wanted number of quads; met within about a third, and up to four times as many where
            openings need smaller ones.
        edge: wanted edge length, instead of ``faces``.
        seed: another number gives another layout.
        time_limit: seconds that the library may take, an hour at most.
        corner: border vertices that turn by more than this (degrees) are kept as corners.
        waiting: called several times a second while the library works, with the part of the time
            limit that is over; what it raises ends the library and is passed on.

    Raises:
        InputError: a triangle soup, bad targets, the library missing, hanging or failing, or an
            opening that would be closed.
    """
    for option, value in zip(OPTIONS, (faces, edge, corner, seed, time_limit), strict=True):
        option.check(value, "")
    points, corners = sound_triangles(vertices, triangles)
    wanted = _target(points, corners, faces, edge)
    given = _Given.of(points, corners, corner, seed)
    until = time.monotonic() + time_limit
    lost: Misfit | None = None
    for tried in dict.fromkeys(min(round(wanted * factor), _MOST) for factor in _FINER):
        left = time_limit if lost is None else max(until - time.monotonic(), _LEAST)
        try:
            found = _tried(given, tried, left, waiting or (lambda part: None))
        except LibraryError as error:
            raise InputError(_failure(error, lost, wanted, tried)) from None
        if isinstance(found, Remeshed):
            words = "" if lost is None else f"with {wanted} quads {lost.what}; made smaller"
            return replace(found, remarks=(words,) if words else ())
        if lost is None or (lost.width is None and found.width is not None):
            lost = found
        if _needed(lost, given) > _HOPELESS * wanted:
            break
    assert lost is not None
    raise InputError(_refusal(lost, given, wanted, tried))


@dataclass(frozen=True, eq=False)
class _Given:
    """What is meshed anew: triangles, and their border."""

    points: FloatArray
    triangles: IntArray
    surface: TriangleSurface
    loops: Loops
    border: Border | None
    seed: int

    @classmethod
    def of(cls, points: FloatArray, triangles: IntArray, corner: float, seed: int) -> _Given:
        loops = Loops.of(points, triangles)
        surface = TriangleSurface(points, triangles)
        return cls(points, triangles, surface, loops, _border(loops, corner), seed)


def _tried(
    given: _Given, faces: int, time_limit: float, waiting: Callable[[float], object]
) -> Remeshed | Misfit:
    """Quads set back onto surface and border, or what is wrong with them."""
    shift, size = given.points.mean(axis=0), size_of(given.points)
    raw, quads = _run(
        (given.points - shift) / size, given.triangles, faces, given.seed, time_limit, waiting
    )
    if not len(quads):
        return Misfit("the library gave no quads", None)
    try:
        mesh = quad_mesh(raw * size + shift, quads.tolist())[0]
        mesh = compact(mesh, mesh.faces)
    except InputError as error:
        return Misfit(f"the library's quads are unusable ({error})", None)
    # Vertices of a lost opening have nowhere to go, and its corners would draw others away.
    found = other_loops(given.loops, Loops.of(mesh.vertices, mesh.faces))
    if found is not None:
        return found
    mesh = set_back(mesh, given.surface, given.border)
    after = Loops.of(mesh.vertices, mesh.faces)
    found = far_loop(given.loops, after, _REACH * mesh.mean_edge)
    if found is not None:
        return found
    gap = 0.0
    if after.count:
        gap = float(max(given.loops.gaps(after).max(), after.gaps(given.loops).max()))
    net = mesh.connectivity
    return Remeshed(mesh, np.flatnonzero(~net.regular & ~net.boundary_vertices), gap)


def _failure(error: LibraryError, lost: Misfit | None, wanted: int, tried: int) -> str:
    """What to say where the library gave nothing, at first or when more quads were tried."""
    if lost is None:
        return (
            f"remesh: the library failed ({error}); allow more time, ask for fewer faces, try "
            "another seed or clean the triangles"
        )
    return (
        f"remesh: with {wanted} quads {lost.what}, and with {tried} the library failed ({error}); "
        "allow more time, try another seed or clean the triangles"
    )


def _refusal(lost: Misfit, given: _Given, wanted: int, tried: int) -> str:
    """What to say and do where the border could not be kept."""
    remedy = "try another seed or face count"
    if lost.width is not None:
        needed = _needed(lost, given)
        finer = f"ask for about {needed:.0f} faces" if needed > tried else "try another seed"
        remedy = f"{finer}, or close it in the triangles where it is not meant"
    last = f" to {tried}" if tried > wanted else ""
    return f"remesh: with {wanted}{last} quads {lost.what}; {remedy}"


def _needed(lost: Misfit, given: _Given) -> float:
    """About how many quads keep an opening; two digits."""
    if lost.width is None:
        return 0.0
    return float(f"{_area(given.points, given.triangles) / (_OF_OPENING * lost.width) ** 2:.2g}")


def _target(points: FloatArray, corners: IntArray, faces: int | None, edge: float | None) -> int:
    if (faces is None) == (edge is None):
        raise InputError("remesh: expected either a number of faces or an edge length; give one")
    if edge is not None:
        faces = round(min(_area(points, corners) / edge / edge, 1e18))
        if not OPTIONS[0].range.holds(faces):
            raise InputError(
                f"edge: expected a length that gives {OPTIONS[0].range.words('quads')}, {edge:g} "
                f"gives {faces}; change it"
            )
    assert faces is not None
    return faces


def _area(points: FloatArray, corners: IntArray) -> float:
    one, two = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
    return 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())


def _run(
    points: FloatArray,
    corners: IntArray,
    faces: int,
    seed: int,
    time_limit: float,
    waiting: Callable[[float], object],
) -> tuple[FloatArray, IntArray]:
    """Call the library in its own process."""
    if importlib.util.find_spec(LIBRARY) is None:
        raise InputError(
            f"remesh: the library {LIBRARY} is not installed; install it with 'pip install "
            f"{LIBRARY}', or bring quads"
        )
    with Isolated(Quadriflow) as library:
        vertices, quads = library.call(
            *("quads", points, corners, faces, seed), time_limit=time_limit, waiting=waiting
        )
    return vertices, quads


def _border(loops: Loops, corner: float) -> Border | None:
    """The border's segments, and the vertices where it turns sharply; None without a border."""
    points, rim = loops.points, loops.segments
    if not len(rim):
        return None
    both = np.concatenate([rim, rim[:, ::-1]])
    both = both[np.argsort(both[:, 0], kind="stable")]
    vertices, start, valence = np.unique(both[:, 0], return_index=True, return_counts=True)
    plain = valence == 2
    one, two = both[start[plain], 1], both[start[plain] + 1, 1]
    before, after = points[one] - points[vertices[plain]], points[two] - points[vertices[plain]]
    cosine = (before * after).sum(axis=1)
    cosine /= np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    sharp = cosine > -np.cos(np.radians(corner))
    return Border(loops.curve, points[np.concatenate([vertices[plain][sharp], vertices[~plain]])])
