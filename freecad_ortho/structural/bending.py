"""How much a shell bends: shares of its strain energy."""

from __future__ import annotations

import numpy as np

from freecad_ortho.structural.model import Model
from solver.mesh.quadmesh import FloatArray


def strain_energies(model: Model, forces: FloatArray) -> FloatArray:
    """(M, 6) twice the energy of N, Vy, Vz, T, My, Mz in members, of (K, M, 6) along them, Nmm."""
    of = model.bare.stiffness
    stiff = np.stack(
        [
            of.youngs * of.area,
            of.shear * of.shear_area_y,
            of.shear * of.shear_area_z,
            of.shear * of.torsion,
            of.youngs * of.about_y,
            of.youngs * of.about_z,
        ],
        axis=1,
    )
    squares = 0.5 * (forces[1:] ** 2 + forces[:-1] ** 2).mean(axis=0)
    return np.asarray(squares / stiff * model.bare.lengths[:, None])


def share_of_bending(energy: FloatArray) -> float:
    """Share of the strain energy (M, 6) that is not of axial forces."""
    total = float(energy.sum())
    return 1.0 - float(energy[:, 0].sum()) / total if total else 0.0
