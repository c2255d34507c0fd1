"""The library that makes quads of triangles (pyQuadriFlow), as it is called in its own process.

Source: Huang et al. (2018), QuadriFlow: a scalable and robust method for quadrangulation.
"""

from __future__ import annotations

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

LIBRARY = "pyQuadriFlow"


class Quadriflow:
    """Calls of the library; for :class:`solver.isolated.Isolated`."""

    def quads(
        self, points: FloatArray, triangles: IntArray, faces: int, seed: int
    ) -> tuple[FloatArray, IntArray]:
        """Vertices (V, 3) and quads (F, 4) of about so many faces, from points and triangles."""
        from pyQuadriFlow.pyQuadriFlow import pyquadriflow

        given = (points.tolist(), triangles.tolist())
        # Not sharp, but with the border kept.
        out = pyquadriflow(faces, seed, *given, False, True, False, False, False)
        vertices = np.array(out["vertices"], dtype=np.float64).reshape(-1, 3)
        return vertices, np.array(out["faces"], dtype=np.int64).reshape(-1, 4)
