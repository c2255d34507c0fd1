"""Forces of shells that are known, and nets along them."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, InputError, optimise
from solver.align.align import aligned
from solver.align.membrane import membrane_forces
from solver.align.reach import reaching
from solver.align.triangle_mesh import one_surface
from solver.analysis import form
from solver.mesh.closest import TriangleSurface
from tests.design_surfaces import dome, plane, triangles


def vault(u, v):
    angle = 1.6 * (u - 0.5)
    return 4 * np.sin(angle), 9 * v, 4 * np.cos(angle)


def test_a_vault_carries_across_what_pushes_on_it():
    points, faces = triangles(vault, 41, 41)
    mesh = one_surface(points, faces)
    forces = membrane_forces(mesh, len(faces), "boundary", 1.0)
    angle = np.arctan2(points[:, 0], points[:, 2])
    across = np.stack([np.cos(angle), 0 * angle, -np.sin(angle)], axis=1)
    thrust = np.einsum("vi,vij,vj->v", across, forces, across)
    away = (np.abs(angle) < 0.4) & (points[:, 1] > 1.5) & (points[:, 1] < 7.5)
    # Balance across the surface: the force over the radius is the load's part along the normal.
    np.testing.assert_allclose(thrust[away], -4 * np.cos(angle[away]), rtol=0.08)
    normal = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
    assert np.abs(np.einsum("vij,vj->vi", forces, normal)[away]).max() < 0.1


def test_forces_go_on_beyond_the_border():
    points, faces = triangles(vault, 21, 21)
    mesh = one_surface(points, faces)
    alone = membrane_forces(mesh, len(faces), "boundary", 1.0)
    # The last triangles are an apron that does not carry.
    inner = len(faces) - 2 * 20
    some = membrane_forces(mesh, inner, "boundary", 1.0)
    assert some.shape == alone.shape
    assert np.isfinite(some).all()


def test_a_shell_stands_on_its_boundary_or_its_corners():
    points, faces = triangles(dome, 31, 21)
    mesh = one_surface(points, faces)
    middle = np.linalg.norm(points[:, :2], axis=1).argmin()
    on = {
        where: np.linalg.eigvalsh(membrane_forces(mesh, len(faces), where, 2.0)[middle])
        for where in ("boundary", "corners")
    }
    # Both press in the middle; on four corners the shell is pressed harder.
    assert on["boundary"].min() < -2
    assert on["corners"].min() < 1.2 * on["boundary"].min()
    with pytest.raises(InputError, match="flat surface carries no load"):
        membrane_forces(one_surface(*triangles(plane, 11, 9)), 160, "boundary", 1.0)
    angle = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    rim = np.stack([3 * np.cos(angle), 3 * np.sin(angle), 0 * angle], axis=1)
    fan = [[k, (k + 1) % 30, 30] for k in range(30)]
    cone = one_surface(np.concatenate([rim, [[0, 0, 1]]]), np.array(fan))
    with pytest.raises(InputError, match="the border has 0 corners"):
        membrane_forces(cone, 30, "corners", 0.5)


def test_a_stress_net_is_near_to_the_shell_that_was_drawn():
    points, faces = triangles(dome, 41, 27)
    made = aligned(points, faces, net="stress", edge=2.0)
    given = Constraints(close_to=(points, faces))
    outcome = optimise(made.mesh, "stress", constraints=given)
    assert outcome.report.status == "converged"
    assert not outcome.report.flipped_faces
    surface = TriangleSurface(*reaching(made.mesh, points, faces))
    assert form.form_of(made.mesh, outcome.mesh, surface).off_surface.percent < 0.5
    with pytest.raises(InputError, match="stands on: expected boundary or corners"):
        aligned(points, faces, net="stress", edge=2.0, stands_on="walls")
