"""Shapes from forces: membranes, cable nets and hanging models, as starts for a design."""

from solver.formfinding.equilibrium import FormFound, find_form
from solver.formfinding.forces import (
    CableNet,
    Membrane,
    Tension,
    VertexLoads,
    family_densities,
    supported,
)

__all__ = [
    "CableNet",
    "FormFound",
    "Membrane",
    "Tension",
    "VertexLoads",
    "family_densities",
    "find_form",
    "supported",
]
