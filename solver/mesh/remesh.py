"""Quads from triangles by an optional library, brought back onto the surface and its border.

The library (pyQuadriFlow) is compiled code that may crash or hang: it runs in a process of its own
with a time limit. It works in single precision and leaves the border by a few percent of its
length, so every vertex is set back: border vertices onto the border polylines, corners onto
corners, the others onto the triangles.

Source: Huang et al. (2018), QuadriFlow: a scalable and robust method for quadrangulation.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.io.intake import quad_mesh
from solver.mesh.border import Border, set_back
from solver.mesh.closest import TriangleSurface
from solver.mesh.coarsen import compact
from solver.mesh.connectivity import IntArray
from solver.mesh.mirror import SAME_PLACE, size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh

LIBRARY = "pyQuadriFlow"
# How often one looks whether it has finished, in seconds.
_LOOK = 0.1
_CHILD = """
import sys
import numpy as np
from pyQuadriFlow.pyQuadriFlow import pyquadriflow
data = np.load(sys.argv[1])
out = pyquadriflow(int(data["faces"]), int(data["seed"]), data["vertices"].tolist(),
                   data["triangles"].tolist(), False, True, False, False, False)
np.savez(sys.argv[2], vertices=np.array(out["vertices"], dtype=float).reshape(-1, 3),
         faces=np.array(out["faces"], dtype=int).reshape(-1, 4))
"""


@dataclass(frozen=True, eq=False)
class Remeshed:
    """Quads in place of triangles.

    Attributes:
        mesh: the quads; vertices on the triangles, border on the border.
        irregular: (K,) interior vertices that have not four faces.
        border_gap: largest distance from a middle of a border edge to the original border.
    """

    mesh: QuadMesh
    irregular: IntArray
    border_gap: float


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
        faces: wanted number of quads; met within about a third.
        edge: wanted edge length, instead of ``faces``.
        seed: another number gives another layout.
        time_limit: seconds that the library may take.
        corner: border vertices that turn by more than this (degrees) are kept as corners.
        waiting: called several times a second while the library works, with the part of the time
            limit that is over; what it raises ends the library and is passed on.

    Raises:
        InputError: a triangle soup, bad targets, the library missing, hanging or failing.
    """
    points, corners = _sound(vertices, triangles)
    wanted = _target(points, corners, faces, edge)
    shift, size = points.mean(axis=0), size_of(points)
    raw, quads = _run(
        (points - shift) / size, corners, wanted, seed, time_limit, waiting or (lambda part: None)
    )
    if not len(quads):
        raise InputError("remesh: the library gave no quads; try another seed or face count")
    try:
        mesh = quad_mesh(raw * size + shift, quads.tolist())[0]
        mesh = compact(mesh, mesh.faces)
    except InputError as error:
        raise InputError(
            f"remesh: the library's quads are unusable ({error}); try another seed or face count"
        ) from None
    mesh, gap = _set_back(mesh, points, corners, corner)
    net = mesh.connectivity
    return Remeshed(mesh, np.flatnonzero(~net.regular & ~net.boundary_vertices), gap)


def _sound(vertices: ArrayLike, triangles: ArrayLike) -> tuple[FloatArray, IntArray]:
    """Merge vertices at one place, drop what has no area, refuse what is no surface."""
    points = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    corners = np.asarray(triangles, dtype=np.int64)
    TriangleSurface(points, corners)
    tree = cKDTree(points)
    first = np.array(
        [min(near) for near in tree.query_ball_point(points, SAME_PLACE * size_of(points))]
    )
    corners = first[corners]
    two, three = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
    corners = corners[np.linalg.norm(np.cross(two, three), axis=1) > 0]
    if not len(corners):
        raise InputError("triangles: none has an area; export the surface again")
    kept, numbers = np.unique(corners, return_inverse=True)
    points, corners = points[kept], numbers.reshape(-1, 3)
    sides = np.sort(np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    counts = np.unique(sides, axis=0, return_counts=True)[1]
    if (counts > 2).any():
        raise InputError(
            f"triangles: {int((counts > 2).sum())} edges have more than two triangles; separate "
            "the sheets that meet there first"
        )
    if (counts == 1).sum() > 0.75 * 3 * len(corners) and len(corners) > 2:
        raise InputError(
            "triangles: a soup of loose triangles, not a surface; join vertices at the same place "
            "(a larger tolerance) and export again"
        )
    return points, corners


def _target(points: FloatArray, corners: IntArray, faces: int | None, edge: float | None) -> int:
    if (faces is None) == (edge is None):
        raise InputError("remesh: expected either a number of faces or an edge length; give one")
    if edge is not None:
        if not (np.isfinite(edge) and edge > 0):
            raise InputError(f"edge: expected a positive length, got {edge:g}")
        one, two = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
        faces = round(0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum()) / edge**2)
    assert faces is not None
    if not 4 <= faces <= 200_000:
        raise InputError(f"faces: expected 4 to 200000 quads, got {faces}; change the target")
    return faces


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
    if not time_limit > 0:
        raise InputError(f"time limit: expected seconds above 0, got {time_limit:g}")
    with tempfile.TemporaryDirectory(prefix="remesh-") as folder:
        given, made = Path(folder) / "in.npz", Path(folder) / "out.npz"
        np.savez(given, vertices=points, triangles=corners, faces=faces, seed=seed)
        path = os.pathsep.join(part for part in sys.path if part)
        code, said = _wait(
            [_interpreter(), "-c", _CHILD, str(given), str(made)],
            {**os.environ, "PYTHONPATH": path},
            time_limit,
            waiting,
        )
        if code or not made.is_file():
            last = (said.strip().splitlines() or ["no message"])[-1][:100]
            raise InputError(
                f"remesh: the library failed ({last}); try another seed or face count, or clean "
                "the triangles"
            )
        with np.load(made) as data:
            return data["vertices"], data["faces"].astype(np.int64)


def _interpreter() -> str:
    """A Python of this version: inside another program ``sys.executable`` is that program."""
    name = f"python{sys.version_info.major}.{sys.version_info.minor}"
    if Path(sys.executable).stem.lower().startswith("python"):
        return sys.executable
    folder = Path(sys.base_prefix)
    for place in (folder / "bin" / name, folder / "python.exe", folder / "bin" / "python.exe"):
        if place.is_file():
            return str(place)
    return shutil.which(name) or shutil.which("python3") or sys.executable


def _wait(
    command: list[str],
    environment: dict[str, str],
    time_limit: float,
    waiting: Callable[[float], object],
) -> tuple[int, str]:
    """Exit code and messages of a process that is ended at its time limit.

    Raises:
        InputError: the time was not enough.
    """
    start = time.monotonic()
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=environment
    ) as process:
        try:
            while True:
                try:
                    _, said = process.communicate(timeout=_LOOK)
                    return process.returncode, said
                except subprocess.TimeoutExpired:
                    part = (time.monotonic() - start) / time_limit
                    if part >= 1:
                        raise InputError(
                            f"remesh: the library did not finish within {time_limit:g} s and was "
                            "stopped; allow more time, ask for fewer faces or try another seed"
                        ) from None
                    waiting(part)
        finally:
            process.kill()


def _set_back(
    mesh: QuadMesh, points: FloatArray, triangles: IntArray, corner: float
) -> tuple[QuadMesh, float]:
    """Smooth within the surface; give the largest gap between the two borders as well."""
    border = _border(points, triangles, corner)
    done = set_back(mesh, TriangleSurface(points, triangles), border)
    net = done.connectivity
    if border is None or not net.boundary_edges.any():
        return done, 0.0
    middles = done.vertices[net.edges[net.boundary_edges]].mean(axis=1)
    gaps = border.curve.closest(middles)[0] - middles
    return done, float(np.linalg.norm(gaps, axis=1).max())


def _border(points: FloatArray, triangles: IntArray, corner: float) -> Border | None:
    """The border's segments, and the vertices where it turns sharply; None without a border."""
    half = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    pairs, counts = np.unique(np.sort(half, axis=1), axis=0, return_counts=True)
    rim = pairs[counts == 1]
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
    # Triangles without area count as segments.
    curve = TriangleSurface(points, rim[:, [0, 1, 1]])
    return Border(curve, points[np.concatenate([vertices[plain][sharp], vertices[~plain]])])
