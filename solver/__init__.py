"""Discrete orthogonal structures: nets, terms and the Gauss-Newton solver. Knows no CAD."""

from solver.errors import InputError, OrthoError, OutputError
from solver.mesh.quadmesh import QuadMesh
from solver.nets.constraints import Constraints
from solver.nets.options import NetOptions
from solver.optimise import optimise, start_optimisation
from solver.report import Outcome, Report, StepRecord
from solver.session import Session

__all__ = [
    "Constraints",
    "InputError",
    "NetOptions",
    "OrthoError",
    "Outcome",
    "OutputError",
    "QuadMesh",
    "Report",
    "Session",
    "StepRecord",
    "optimise",
    "start_optimisation",
]
