"""Discrete orthogonal structures: nets, terms and the Gauss-Newton solver. Knows no CAD.

What stands here is all that a net of one's own takes, see docs/own-net.md; the terms that there are
have a file each in :mod:`solver.terms`, the measures of bare meshes are in
:mod:`solver.analysis.measures`.
"""

from solver.errors import InputError, OrthoError, OutputError
from solver.io.polygons import read_mesh, write_mesh
from solver.mesh.quadmesh import QuadMesh
from solver.nets import Measure, Net, register, unregister
from solver.nets.constraints import (
    BoundaryGlide,
    Constraints,
    CurveGlide,
    PlaneGlide,
    SurfaceGlide,
)
from solver.nets.options import NetOptions
from solver.nets.settings import Weights
from solver.optimise import optimise, start_optimisation
from solver.problem import Problem, of_mesh
from solver.report import Outcome, Report, StepRecord
from solver.session import Session
from solver.solve import pose, solve
from solver.terms.base import Linearisation, Size, Term, points_of
from solver.terms.derivatives import derivative_error
from solver.terms.stencils import OnEdges, OnFaces, OnVertices

__all__ = [
    "BoundaryGlide",
    "Constraints",
    "CurveGlide",
    "InputError",
    "Linearisation",
    "Measure",
    "Net",
    "NetOptions",
    "OnEdges",
    "OnFaces",
    "OnVertices",
    "OrthoError",
    "Outcome",
    "OutputError",
    "PlaneGlide",
    "Problem",
    "QuadMesh",
    "Report",
    "Session",
    "Size",
    "StepRecord",
    "SurfaceGlide",
    "Term",
    "Weights",
    "derivative_error",
    "of_mesh",
    "optimise",
    "points_of",
    "pose",
    "read_mesh",
    "register",
    "solve",
    "start_optimisation",
    "unregister",
    "write_mesh",
]
