"""E_equi: forces along the edges carry the loads of the unsupported vertices."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.statics import VerticalLoads
from solver.terms.base import Linearisation, Size, coordinates_of, points_of


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Balance at vertices of one valence.

        r = sum_j q_j (v - v_j) + p e_z,   q_j = w_j  or  -w_j^2  or  w_j^2

    with the force density q (positive in tension) of each edge, and the load p, positive downwards,
    divided by the mean load. Three rows a vertex. The force densities are unknowns shared by both
    ends of an edge; as squares they keep one sign.

    Args:
        centres: (n,) unsupported vertices.
        neighbours: (n, s) their neighbours.
        densities: (n, s) position of each edge's unknown w in the flat vector.
        loads: how the loads follow from the shape.
        sign: 0 for any force, -1 for compression only, 1 for tension only.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.5 (E_Equi).
    """

    centres: IntArray
    neighbours: IntArray
    densities: IntArray
    loads: VerticalLoads
    sign: int = 0
    load: FloatArray | None = None
    name: str = "equilibrium"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3 + 3 s + s) coordinates of centre and neighbours, then the edges' unknowns."""
        points = np.concatenate([self.centres[:, None], self.neighbours], axis=1)
        return np.concatenate([coordinates_of(points), self.densities], axis=1)

    @property
    def size(self) -> Size:
        """Three equations a vertex; the force densities are counted with the unknowns."""
        return Size(0, 3 * len(self.centres))

    def follow(self, x: FloatArray) -> Equilibrium:
        """Renew the loads at the current shape."""
        return replace(self, load=self.loads.at(x)[self.centres])

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 3 + 4 s)."""
        count, valence = self.neighbours.shape
        split = 3 * (valence + 1)
        v = points_of(x, self.unknowns[:, :split])
        w = x[self.densities]
        q, by_w = (w, np.ones_like(w)) if self.sign == 0 else (self.sign * w**2, 2 * self.sign * w)
        spans = v[:, :1] - v[:, 1:]
        load = self.loads.at(x)[self.centres] if self.load is None else self.load
        residual = np.einsum("ns,nsc->nc", q, spans)
        residual[:, 2] += load
        jacobian = np.zeros((count, 3, split + valence))
        for c in range(3):
            jacobian[:, c, c] = q.sum(axis=1)
            jacobian[:, c, 3 + c : split : 3] = -q
        jacobian[:, :, split:] = np.swapaxes(by_w[:, :, None] * spans, 1, 2)
        return Linearisation(residual, jacobian)
