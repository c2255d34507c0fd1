"""What only some nets can be told."""

from __future__ import annotations

import math
from dataclasses import dataclass

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.problem import Problem


@dataclass(frozen=True)
class NetOptions:
    """Choices beyond the name of the net.

    Attributes:
        diagonal: ask star properties of a vertex and the four opposite corners of its faces.
        radius: radius of the star spheres in model units, None for free.
        length: edge length of a Chebyshev net in model units, None for free.
        per_family: a Chebyshev net has one length for each family of parameter lines.
        angle: angle of the medial lines in degrees, 90 for orthogonal.
        reference: (V, 3) positions of the shape to which an isometric net is isometric.
        load: vertical load of each vertex of a stress net, downwards, in any unit of force.
        load_area: load of a unit of surface, in the same unit of force.
        load_length: weight of a unit of edge, in the same unit of force.
        forces: free, compression or tension: which forces the edges of a stress net may carry.
    """

    diagonal: bool = False
    radius: float | None = None
    length: float | None = None
    per_family: bool = False
    angle: float = 90.0
    reference: FloatArray | None = None
    load: float = 0.0
    load_area: float = 0.0
    load_length: float = 0.0
    forces: str = "free"

    def __post_init__(self) -> None:
        for name in ("radius", "length"):
            value = getattr(self, name)
            if value is not None and not (math.isfinite(value) and value > 0):
                raise InputError(f"{name}: expected a positive length, got {value}")
        for name in ("load", "load_area", "load_length"):
            if not math.isfinite(getattr(self, name)):
                raise InputError(f"{name}: expected a number, got {getattr(self, name)}")
        if self.forces not in ("free", "compression", "tension"):
            raise InputError(f"forces: expected free, compression or tension, got '{self.forces}'")
        if not 0 < self.angle < 180:
            raise InputError(f"angle: expected degrees between 0 and 180, got {self.angle}")

    @property
    def load_vectors(self) -> list[tuple[float, float, float]]:
        """Loads of a stress net as vectors, of a vertex, of unit area and of unit length."""
        return [(0.0, 0.0, -load) for load in (self.load, self.load_area, self.load_length)]

    def stars(self, problem: Problem) -> IntArray:
        """(S, 5) stars of the net or of its diagonal net.

        Raises:
            InputError: the mesh has no vertex with four faces around it.
        """
        stars = stars_of(problem)
        return problem.mesh.connectivity.diagonal_stars if self.diagonal else stars


def stars_of(problem: Problem) -> IntArray:
    """(S, 5) stars of the mesh.

    Raises:
        InputError: the mesh has no vertex with four faces around it.
    """
    stars = problem.mesh.connectivity.stars
    if not len(stars):
        raise InputError(
            f"{problem.net} net: needs inner vertices with four faces around them, the mesh "
            "has none; give a mesh of at least 2 x 2 faces"
        )
    return stars
