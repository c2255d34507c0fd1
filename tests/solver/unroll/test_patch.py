"""Developable patches laid flat keep their edges; others say by how much they do not."""

import numpy as np
import pytest

from solver import optimise
from solver.errors import InputError
from solver.mesh.primitives import primitive
from solver.unroll.patch import flattened
from tests.conftest import shared_mesh
from tests.meshes import bent_sheet


def test_a_cylinder_along_its_generators_unrolls_exactly():
    patch = flattened(bent_sheet(turned=0.0))
    assert np.abs(patch.strain).max() <= 1e-12
    assert np.abs(patch.flat.vertices[:, 2]).max() <= 1e-12


def test_a_sheet_bent_askew_unrolls_with_little_strain():
    coarse, fine = (flattened(bent_sheet(n, n)) for n in (9, 17))
    worst = [np.abs(patch.strain).max() for patch in (coarse, fine)]
    assert worst[1] < worst[0] / 2 < 0.01


def test_a_dome_does_not_unroll_without_strain():
    patch = flattened(primitive("translational", 13, 13))
    assert np.abs(patch.strain).max() > 0.05


def test_what_cannot_be_laid_flat_is_refused():
    with pytest.raises(InputError, match="closes on itself"):
        flattened(primitive("sphere", 13, 13))


def test_chebyshev_sphere_unrolls():
    outcome = optimise(shared_mesh("chebyshev_sphere"), "chebyshev")
    patch = flattened(outcome.mesh)
    assert np.abs(patch.strain).mean() <= 5e-4
    assert np.abs(patch.strain).max() <= 1e-3
    areas = patch.flat.face_area_vectors[:, 2]
    assert (areas > 0).all() or (areas < 0).all()
