"""A net that the project does not have, in one file as those that it has."""

from __future__ import annotations

from solver.analysis import measures
from solver.nets import Measure, Net
from solver.nets.options import NetOptions
from solver.problem import Problem, of_mesh
from solver.terms.planarity import Planarity


def flat(problem: Problem, options: NetOptions) -> Problem:
    """Require flat faces and nothing else."""
    return problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))


FLAT = Net(
    "flat",
    flat,
    place=150,
    title="flat: whatever their angles",
    condition="flat faces",
    purpose="flat panels of any outline",
    gives="Flat faces at any angle.",
    measures=(Measure("flatness", measures.planarity, "face"),),
    options=("length",),
)
