"""From a net to what errors of the workshop make of it: one call."""

from __future__ import annotations

from collections.abc import Sequence

from freecad_ortho.fabrication.tolerances import BeamRows, Landed, Tolerances, bolted, held_nodes
from freecad_ortho.mesh_files import DEFAULT_UNIT
from freecad_ortho.units import millimetres_per
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import QuadMesh, refuse_other


def tolerances(
    mesh: QuadMesh,
    *,
    unit: str = DEFAULT_UNIT,
    held: Sequence[int] | None = None,
    tolerance: float = 0.5,
    trials: int = 500,
    seed: int = 0,
    holes: float = 120.0,
    node: float = 100.0,
    play: float = 1.0,
    allowed: float = 10.0,
) -> Landed:
    """Bolt a grid shell together in many trials, its beams cut and drilled with errors.

    Args:
        mesh: the net, in ``unit``.
        unit: of its coordinates.
        held: numbers of the nodes that stay where they are, by default the boundary.
        tolerance: largest error of a cut or a hole, mm.
        trials: number of shells that are bolted together.
        seed: of the errors.
        holes: distance of the outer holes of a beam's end, mm.
        node: diameter over which a node holds a beam sideways, mm.
        play: by which a bolt may be off in its hole, mm.
        allowed: distance that nodes may land off, mm.

    Raises:
        InputError: a number that cannot be used, or nodes that the net has not.
    """
    refuse_other(mesh)
    settings = Tolerances(tolerance, trials, seed, holes, node, play, allowed)
    near = LocalOrigin.of_mesh(mesh).near_mesh(mesh).scaled(millimetres_per(unit))
    nodes = None if held is None else list(held)
    return bolted(BeamRows.of(near), held_nodes(near, nodes), settings)
