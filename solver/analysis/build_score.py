"""How easily a grid shell is built, in the measures of the freeGrid benchmark.

Five numbers, the smaller the better: how flat faces are, how many joints there are, how many kinds
of them, how much the lengths of beams differ, and how many cross sections beams have. What the
benchmark makes of them together with its structural measures is not computed here.

Source: Bruno et al. (2023), Exploring new frontiers in gridshell design: The FreeGrid benchmark;
kinds of joints after Liu et al. (2023), as the benchmark's own measure of them.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from solver.analysis.kinds import kinds_within, laid, spokes
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.option import Option, Range

SECTIONS = Option("sections", 1, "count", "Its beams have so many cross sections", within=Range(1))

# Joints are of one kind where the tips of their unit directions miss by so much on average.
JOINTS_ALIKE = 0.01
# Beams shorter than this, in metres, are no beams of the benchmark.
SHORTEST_M = 0.1
# Lengths and panels are counted in kinds within this, in mm: half a bin of the benchmark's lengths.
LENGTHS_MM, PANELS_MM = 2.5, 2.5


@dataclass(frozen=True)
class BuildScore:
    """Measures of buildability.

    Attributes:
        planarity: 1 + mean over the faces of the mean distance of a face's corners from its best
            plane / half its circumference.
        joints: number of vertices.
        joint_kinds: kinds of joints, such that each is within 0.01 of the first of its kind.
        lengths: 1 + standard deviation / mean of the lengths of beams of 0.1 m and more.
        sections: number of cross sections, as given.
        length_kinds: kinds of lengths within 2.5 mm, at least so many.
        panel_kinds: kinds of panels within 2.5 mm.
        length_range: shortest and longest beam, mm.
        area_range: smallest and largest panel, m2.
    """

    planarity: float
    joints: int
    joint_kinds: int
    lengths: float
    sections: int
    length_kinds: int
    panel_kinds: int
    length_range: tuple[float, float]
    area_range: tuple[float, float]

    def as_dict(self) -> dict[str, Any]:
        """Return plain numbers for JSON."""
        return asdict(self)


def build_score(mesh: QuadMesh, millimetres: float, sections: int = 1) -> BuildScore:
    """Measure how easily a grid shell on the edges of a mesh is built.

    Args:
        mesh: in a unit of so many ``millimetres``.
        millimetres: of a unit of length.
        sections: how many cross sections its beams have.

    Raises:
        InputError: no cross section, or no beam that is long enough to be one.
    """
    SECTIONS.check(sections)
    lengths = mesh.edge_lengths * (millimetres / 1000)
    beams = lengths[lengths > SHORTEST_M]
    if len(beams) < 2:
        raise InputError(
            f"build: no beams longer than {SHORTEST_M:g} m, the longest edge has "
            f"{lengths.max():.3g} m; mind the unit of the mesh (--unit m)"
        )
    areas = np.linalg.norm(mesh.face_area_vectors, axis=1) * (millimetres / 1000) ** 2
    return BuildScore(
        planarity=1.0 + float(flatness_of_faces(mesh).mean()),
        joints=int(mesh.connectivity.referenced.sum()),
        joint_kinds=joint_kinds(mesh),
        lengths=1.0 + float(beams.std(ddof=1) / beams.mean()),
        sections=sections,
        length_kinds=kinds_within(mesh, "edges", LENGTHS_MM / millimetres).number,
        panel_kinds=kinds_within(mesh, "panels", PANELS_MM / millimetres).number,
        length_range=(float(1000 * lengths.min()), float(1000 * lengths.max())),
        area_range=(float(areas.min()), float(areas.max())),
    )


def flatness_of_faces(mesh: QuadMesh) -> FloatArray:
    """(F,) mean distance of corners from the best plane / half the circumference of the face."""
    corners = mesh.vertices[mesh.faces]
    away = corners - corners.mean(axis=1, keepdims=True)
    normal = np.linalg.svd(away)[2][:, 2]
    distance = np.abs(np.einsum("fki,fi->fk", away, normal)).mean(axis=1)
    around = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).sum(axis=1)
    return np.asarray(distance / (0.5 * around))


def joint_kinds(mesh: QuadMesh, within: float = JOINTS_ALIKE) -> int:
    """How many kinds of joints there are, of every number of edges by themselves.

    The joint farthest from all kinds so far begins the next one, until none is farther than
    ``within``: the root mean square distance of the tips of its unit directions from those of the
    kind, laid on each other in the best of the orders around the joint, from either side.
    """
    by_count: dict[int, list[FloatArray]] = {}
    for hubs in spokes(mesh):
        arms = mesh.vertices[hubs.neighbours] - mesh.vertices[hubs.vertices][:, None]
        by_count.setdefault(arms.shape[1], []).append(unit_rows(arms))
    return sum(_farthest_first(np.concatenate(arms), within) for arms in by_count.values())


def _farthest_first(joints: FloatArray, within: float) -> int:
    orders = _orders(joints.shape[1])
    nearest, number, leader = np.full(len(joints), np.inf), 0, 0
    while number == 0 or nearest.max() > within:
        leader = int(np.argmax(nearest)) if number else 0
        away = [_root_mean_square(joints[:, order], joints[leader]) for order in orders]
        nearest = np.minimum(nearest, np.min(away, axis=0))
        nearest[leader] = 0.0
        number += 1
    return number


def _orders(count: int) -> list[IntArray]:
    around = np.arange(count)
    turned = [np.roll(around, -turn) for turn in range(count)]
    return [*turned, *(order[::-1] for order in turned)]


def _root_mean_square(joints: FloatArray, shape: FloatArray) -> FloatArray:
    other = np.broadcast_to(shape, joints.shape)
    away = laid(joints, other) - other
    return np.asarray(np.sqrt((away**2).sum(axis=2).mean(axis=1)))
