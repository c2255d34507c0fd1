"""What pulls at a vertex: cables, a membrane of constant stress, loads; and what holds it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.option import NOT_NEGATIVE, number_within


class Tension(Protocol):
    """Anything that pulls vertices towards each other."""

    @property
    def linear(self) -> bool:
        """Whether the force densities do not depend on the shape."""

    def links(self, mesh: QuadMesh) -> tuple[IntArray, FloatArray]:
        """(K, 2) vertices and (K,) force densities (force / length) in the present shape."""

    def freedom(self, mesh: QuadMesh) -> FloatArray | None:
        """(V, 3, 3) projections onto the directions that the shape has to settle; None for all."""


@dataclass(frozen=True, eq=False)
class CableNet:
    """Cables along the edges with prescribed force densities.

    Attributes:
        densities: one number or (E,) numbers, force / length; negative in compression.

    Source: Schek (1974), The force density method for form finding and computation of general
    networks.
    """

    densities: ArrayLike = 1.0
    linear: bool = field(default=True, init=False)

    def links(self, mesh: QuadMesh) -> tuple[IntArray, FloatArray]:
        """Edges and their densities.

        Raises:
            InputError: other than one number an edge.
        """
        edges = mesh.connectivity.edges
        given = np.asarray(self.densities, dtype=np.float64)
        if given.shape not in ((), (len(edges),)) or not np.isfinite(given).all():
            raise InputError(
                f"densities: expected one finite number or {len(edges)}, one an edge, got shape "
                f"{given.shape}"
            )
        return edges, np.broadcast_to(given, len(edges)).copy()

    def freedom(self, mesh: QuadMesh) -> FloatArray | None:
        """Cables settle every direction."""
        return None


@dataclass(frozen=True, eq=False)
class Membrane:
    """A membrane of constant isotropic stress in the faces, with cables along free borders.

    Without loads its equilibrium is a minimal surface, under pressure p one of mean curvature
    p / (2 stress). A face counts as the mean of its two pairs of triangles.

    Constant stress resists no motion within the surface. Equilibrium is therefore asked along the
    normals of the surface (and across a free border), and vertices move only that way: the net
    keeps the pattern that it was drawn with.

    Attributes:
        stress: force / length, positive.
        cable: constant force in every boundary edge.

    Source: Pinkall, Polthier (1993), Computing discrete minimal surfaces and their conjugates.
    """

    stress: float = 1.0
    cable: float = 0.0
    linear: bool = field(default=False, init=False)

    def __post_init__(self) -> None:
        number_within("stress", self.stress)
        number_within("cable", self.cable, NOT_NEGATIVE)

    def links(self, mesh: QuadMesh) -> tuple[IntArray, FloatArray]:
        """Sides and diagonals of all faces with cotangent densities, and the cables."""
        faces, points = mesh.faces, mesh.vertices
        pairs, densities = [], []
        for corners in ((0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)):
            for turn in range(3):
                apex, start, end = (faces[:, corners[(turn + k) % 3]] for k in range(3))
                one, two = points[start] - points[apex], points[end] - points[apex]
                area = np.linalg.norm(np.cross(one, two), axis=1)
                cotangent = np.einsum("ij,ij->i", one, two) / np.maximum(area, 1e-300)
                pairs.append(np.stack([start, end], axis=1))
                # Half for the cotangent formula, half for the mean of two triangulations.
                densities.append(0.25 * self.stress * cotangent)
        if self.cable:
            net = mesh.connectivity
            pairs.append(net.edges[net.boundary_edges])
            lengths = mesh.edge_lengths[net.boundary_edges]
            densities.append(self.cable / np.maximum(lengths, 1e-300))
        return np.concatenate(pairs), np.concatenate(densities)

    def freedom(self, mesh: QuadMesh) -> FloatArray | None:
        """Along the normal inside, across the border on it."""
        net, normals = mesh.connectivity, mesh.vertex_normals
        result = normals[:, :, None] * normals[:, None, :]
        border = np.flatnonzero(net.twins < 0)
        start = mesh.faces.ravel()[border]
        end = np.roll(mesh.faces, -1, axis=1).ravel()[border]
        arms = unit_rows(mesh.vertices[end] - mesh.vertices[start])
        tangents = np.zeros_like(normals)
        np.add.at(tangents, start, arms)
        np.add.at(tangents, end, arms)
        tangents = unit_rows(tangents)
        across = np.eye(3) - tangents[:, :, None] * tangents[:, None, :]
        result[start] = across[start]
        return result


@dataclass(frozen=True, eq=False)
class VertexLoads:
    """Loads on the vertices; what depends on the shape follows it.

    Attributes:
        vertex: (3,) or (V, 3) force at each vertex.
        area: (3,) force per area of the faces (self-weight of a shell).
        beam: (3,) force per length of the edges (self-weight of beams).
        pressure: force per area along the face normals (air).
    """

    vertex: ArrayLike = (0.0, 0.0, 0.0)
    area: ArrayLike = (0.0, 0.0, 0.0)
    beam: ArrayLike = (0.0, 0.0, 0.0)
    pressure: float = 0.0

    @property
    def follow(self) -> bool:
        """Whether the loads depend on the shape."""
        return bool(np.any(self.area) or np.any(self.beam) or self.pressure)

    def forces(self, mesh: QuadMesh) -> FloatArray:
        """(V, 3) forces in the present shape.

        Raises:
            InputError: loads of another shape or not finite.
        """
        count = len(mesh.vertices)
        area, beam = self._vector("area", (3,)), self._vector("beam", (3,))
        given = np.asarray(self.vertex, dtype=np.float64)
        vertex = self._vector("vertex", (3,) if given.ndim == 1 else (count, 3))
        if not np.isfinite(self.pressure):
            raise InputError("pressure: expected a finite number; change it")
        total = np.broadcast_to(vertex, (count, 3)).copy()
        areas = np.linalg.norm(mesh.face_area_vectors, axis=1)
        faces = areas[:, None] * area + self.pressure * mesh.face_area_vectors
        _spread(total, mesh.faces, faces)
        _spread(total, mesh.connectivity.edges, mesh.edge_lengths[:, None] * beam)
        return total

    def _vector(self, name: str, shape: tuple[int, ...]) -> FloatArray:
        value = np.asarray(getattr(self, name), dtype=np.float64)
        if value.shape != shape or not np.isfinite(value).all():
            raise InputError(
                f"{name} load: expected finite numbers of shape {shape}, got shape {value.shape}"
            )
        return value


def _spread(total: FloatArray, groups: IntArray, forces: FloatArray) -> None:
    """Add each group's force to its vertices in equal parts."""
    size, count = groups.shape[1], len(total)
    share = np.repeat(forces / size, size, axis=0)
    for k in range(3):
        total[:, k] += np.bincount(groups.ravel(), share[:, k], count)


def family_densities(
    mesh: QuadMesh, u: float = 1.0, v: float = 1.0, border: float | None = None
) -> FloatArray:
    """(E,) force densities by family, the border's edges apart (cables, usually stronger).

    Side 0 of each face is u; on a mesh whose faces do not agree on that the mean counts.
    """
    net = mesh.connectivity
    sides = np.bincount(net.face_edges[:, ::2].ravel(), minlength=len(net.edges))
    both = np.bincount(net.face_edges.ravel(), minlength=len(net.edges))
    share = sides / both
    result = u * share + v * (1 - share)
    return result if border is None else np.where(net.boundary_edges, border, result)


def supported(mesh: QuadMesh, words: str) -> BoolArray:
    """(V,) which vertices are held: ``boundary``, ``corners``, or numbers ``I,J,K``.

    Raises:
        InputError: other words, numbers out of range, or nothing held.
    """
    net = mesh.connectivity
    if words in ("boundary", "corners"):
        held = net.boundary_vertices if words == "boundary" else net.corners
        result = held.copy()
    else:
        try:
            numbers = np.array([int(word) for word in words.split(",")])
        except ValueError:
            raise InputError(
                f"supports: expected boundary, corners or vertex numbers I,J,K, got '{words[:40]}'"
            ) from None
        if ((numbers < 0) | (numbers >= len(mesh.vertices))).any():
            raise InputError(
                f"supports: vertices are numbered 0 to {len(mesh.vertices) - 1}, got {words[:40]}"
            )
        result = np.zeros(len(mesh.vertices), dtype=bool)
        result[numbers] = True
    if not result.any():
        raise InputError(f"supports: the mesh has no {words}; name vertices to hold")
    return result
