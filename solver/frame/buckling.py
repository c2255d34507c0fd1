"""Linear buckling: by what factor a load may grow until the frame gives way without more."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import csc_array
from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigsh

from solver.errors import OrthoError
from solver.frame import elements
from solver.frame.response import Response
from solver.frame.system import FrameSystem, negative_pivots
from solver.mesh.quadmesh import FloatArray

# Up to so many unknowns all modes are found at once.
_FEW = 200
# How often modes are looked for.
_TRIES = 4
# Factors that are larger than this mean that nothing buckles.
_NEVER = 1e9


@dataclass(frozen=True, eq=False)
class Buckling:
    """Modes of buckling, the least factor first.

    Attributes:
        factors: (k,) of the load; fewer than were asked for, or none, where no more of it is
            compressed.
        shapes: (k, N, 6) movements of the nodes; the largest displacement is one unit of length.
    """

    factors: FloatArray
    shapes: FloatArray


def buckling(system: FrameSystem, under: Response, count: int = 5) -> Buckling:
    """The first modes of buckling under a load.

    Members buckle between their nodes as well where they are divided.

    Args:
        system: the supported frame.
        under: its response to the load.
        count: modes wanted.

    Raises:
        OrthoError: the modes were not found.
    """
    follow = system.joined.follow
    # With springs the member's own ends bow, not the nodes.
    geometric = elements.geometric(system.frame, under.ends)
    geometric = np.swapaxes(follow, 1, 2) @ geometric @ follow
    frame, moved = system.frame, under.displacements[:, :3]
    # By small movements, as all that is linear.
    longer = frame.panels.sheared_a_little(frame.nodes, moved)
    of_panels = system.assembled_panels(frame.panels.geometric(frame.nodes, longer))
    whole = system.assembled(geometric) + of_panels
    loose = -whole[system.free][:, system.free].tocsc()
    size = len(system.free)
    if size <= _FEW:
        values, vectors = eigh(loose.toarray(), system.kept.toarray())
    else:
        values, vectors = _largest(system, loose, count)
    order = np.argsort(-values)
    order = order[values[order] > 1 / _NEVER][:count]
    shapes = np.zeros((len(order), 6 * len(system.frame.nodes)))
    shapes[:, system.free] = vectors[:, order].T
    own = np.array([system.own(shape.reshape(-1, 6)) for shape in shapes])
    own = own.reshape(-1, len(system.frame.nodes), 6)
    largest = np.linalg.norm(own[:, :, :3], axis=2).max(axis=1, initial=0.0)
    return Buckling(1.0 / values[order], own / np.where(largest > 0, largest, 1)[:, None, None])


def _largest(system: FrameSystem, loose: csc_array, count: int) -> tuple[FloatArray, FloatArray]:
    """Largest values m of loose v = m K v, one over the factors, and their vectors.

    The method of Lanczos can pass over one of two modes alike, so the factors below the last one
    are counted by the signs of pivots; where some are missing, more are looked for.
    """
    size = len(system.free)
    inverse = LinearOperator((size, size), matvec=system.solve_once, dtype=np.float64)
    random = np.random.default_rng(3)
    for tries in range(_TRIES):
        wanted = min((tries + 1) * count, size - 1)
        try:
            values, vectors = eigsh(
                loose,
                wanted,
                system.kept,
                Minv=inverse,
                which="LA",
                ncv=min(size, max(24, 4 * wanted)),
                v0=system.solve_once(random.standard_normal(size)),
                tol=1e-8 if tries == 0 else 0,
            )
        except ArpackNoConvergence:
            continue
        if _complete(system, loose, values, count):
            return values, vectors
    raise OrthoError(
        "buckling: the modes were not found; ask for fewer, or look for members that are much "
        "weaker than the others"
    )


def _complete(system: FrameSystem, loose: csc_array, values: FloatArray, count: int) -> bool:
    """Whether no mode was passed over: as many pivots are negative as factors are below.

    Source: Sylvester's law of inertia, as in Bathe (1996), Finite Element Procedures, 11.6.4.
    """
    found = np.sort(values)[::-1][:count]
    last = found[found > 1 / _NEVER]
    if not len(last):
        return True
    factor = (1 - 1e-6) / float(last[-1])
    pivots = negative_pivots((system.kept - factor * loose).tocsc())
    return pivots is None or pivots == int((last > 1 / factor).sum())
