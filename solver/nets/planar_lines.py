"""Nets whose lines lie in planes of their own, with flat faces."""

from __future__ import annotations

from functools import partial

import numpy as np

from solver.analysis import lines, measures
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import require_angle
from solver.nets.principal import PLANARITY
from solver.problem import Problem, of_mesh
from solver.terms.in_plane import InPlane
from solver.terms.planarity import Planarity

# Share of its length by which a line bends that counts as straight.
_STRAIGHT = 1e-6


def planar_lines(problem: Problem, options: NetOptions) -> Problem:
    """Require flat faces, and that every line of one family, or of both, lies in a plane.

    Source: Wang et al. (2022), Computational design of freeform structures with planar panels and
    planar supporting beams.
    """
    families = _families(problem, options)
    if options.angle is not None:
        require_angle(problem, options, options.angle)
    problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))
    chosen = lines.long_lines(problem.mesh, families)
    planes = problem.scalars(_planes(problem, families)).reshape(-1, 4)
    counts = [len(line.vertices) for line in chosen]
    vertices = np.concatenate([line.vertices for line in chosen])
    which = np.repeat(np.arange(len(chosen)), counts)
    problem.details["planes"] = lambda mesh, _: _found(mesh, families)
    return problem.require(
        InPlane(vertices, planes[which]),
        of_mesh(lines.off_plane, families=families),
        partial(_edge, problem.mesh),
    )


def _families(problem: Problem, options: NetOptions) -> str:
    """Of which families lines are to be plane: those asked for, or of one the nearer one.

    Raises:
        InputError: there are no such lines of more than three vertices.
    """
    families = {"both": "uv"}.get(options.plane, options.plane)
    if options.plane == "one":
        off = {family: lines.off_plane(problem.mesh, family) for family in "uv"}
        long = [family for family in "uv" if lines.long_lines(problem.mesh, family)]
        families = min(long, key=lambda family: float((off[family] ** 2).sum()), default="u")
    if not lines.long_lines(problem.mesh, families):
        raise InputError(
            f"{problem.net} net: no line of family {families} has more than three vertices, or the "
            "families of the mesh cannot be told apart; give a finer mesh, or one without inner "
            "vertices where an odd number of faces meet"
        )
    return families


def _planes(problem: Problem, families: str) -> FloatArray:
    """(4 L,) unit normal and distance from the solver's origin of the plane nearest to each line.

    The plane of a line that is straight may turn about it: there it stands upright on the surface.
    """
    found = []
    normals = problem.mesh.vertex_normals
    for line in lines.long_lines(problem.mesh, families):
        points = (problem.mesh.vertices[line.vertices] - problem.centre) / problem.scale
        normal, centre = lines.nearest_plane(points)
        spread = np.linalg.svd(points - centre, compute_uv=False)
        if spread[1] <= _STRAIGHT * spread[0]:
            upright = np.cross(normals[line.vertices].mean(axis=0), points[-1] - points[0])
            normal = upright / np.linalg.norm(upright)
        found.append([*normal, normal @ centre])
    return np.ravel(found)


def _found(mesh: QuadMesh, families: str) -> list[float]:
    """Unit normal of each plane and its distance from the origin, one after the other."""
    found: list[float] = []
    for line in lines.long_lines(mesh, families):
        normal, centre = lines.nearest_plane(mesh.vertices[line.vertices])
        found += [*normal.tolist(), float(normal @ centre)]
    return found


def _edge(mesh: QuadMesh, index: int) -> str:
    return "edge {} - {}".format(*mesh.connectivity.edges[index])


NETS = (
    Net(
        "planar-lines",
        planar_lines,
        place=25,
        title="plane lines: flat beams",
        condition="flat faces, every line of one family or of both in a plane",
        purpose="arches built flat on the ground, beams cut from plate along a whole line",
        gives="Flat faces, and lines that lie in planes of their own.",
        abbreviation="plane lines",
        measures=(PLANARITY, Measure("line planes", lines.plane_lines, "edge")),
        options=("plane", "angle", "singular"),
        general=True,
        telling=True,
        nearest=True,
        conjugate=True,
        way=Way(calms=True),
    ),
)
