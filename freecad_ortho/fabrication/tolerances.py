"""How far nodes land off where beams are cut and drilled with errors: a seeded Monte Carlo.

A shell is bolted together from nodes that are held, and bolts are tightened when all of it stands.
A beam says where its second node is, relative to where it should be seen from the first, by

    e = a l + u b + s c,

l along it, b up and c across. a sums the errors of two cuts and two holes; u those of two holes,
and what two holes at a distance h apart turn the beam by, over its length; s what a slot or an end
plate turns it by sideways, over the node's diameter. The nodes settle where what all beams miss is
least, each weighed by the inverse of the variance of its errors:

    sum over beams of (x_j - x_i - e)^T W (x_j - x_i - e),   W = sum over l, b, c of d d^T / var(d).

Holes miss by what a beam misses along, and by h / length of what it misses up, as it turns.

All errors are uniform within plus and minus the tolerance and independent. What comes of it is
proportional to the tolerance, so the tolerance that a design bears follows from one run.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np
import scipy.sparse
from scipy.sparse.linalg import splu

from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.sizes import check_options, size
from freecad_ortho.fabrication.systems.beams.frames import beam_frames
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.offset.axes import torsion_free_axes
from solver.option import Option, Range

# What counts of all shells: so many of them are no worse.
_MOST = 0.95
_LEAST, _MOST_TRIALS = 10, 100_000
# Variance of an error that is uniform within plus and minus 1.
_UNIFORM = 1 / 3


@dataclass(frozen=True)
class Tolerances:
    """Errors of the workshop and what a design does with them.

    Args:
        tolerance: largest error of a cut or a hole, mm.
        trials: number of shells that are bolted together.
        seed: of the errors.
        holes: distance of the outer holes of a beam's end, across it, mm.
        node: diameter over which a node holds a beam sideways, mm.
        play: by which a bolt may be off in its hole, mm.
        allowed: distance that nodes may land off, mm.

    Raises:
        InputError: a number that cannot be used.
    """

    tolerance: float = 0.5
    trials: int = 500
    seed: int = 0
    holes: float = 120.0
    node: float = 100.0
    play: float = 1.0
    allowed: float = 10.0

    options: ClassVar[tuple[Option, ...]] = (
        size("tolerance", 0.5, "no cut and no hole is further off than this"),
        Option(
            *("trials", 500, "count", "so many shells are bolted together"),
            within=Range(_LEAST, _MOST_TRIALS),
        ),
        Option("seed", 0, "count", "another number draws other errors"),
        size("holes", 120.0, "the outer holes of a beam's end are so far apart"),
        size("node", 100.0, "nodes hold beams sideways over this diameter"),
        size("play", 1.0, "a bolt may be off by this in its hole"),
        size("allowed", 10.0, "nodes may land off by this"),
    )

    def __post_init__(self) -> None:
        check_options(self, self.options)


@dataclass(frozen=True, eq=False)
class BeamRows:
    """Beams between nodes, one row each.

    Attributes:
        ends: (E, 2) numbers of nodes.
        lengths: (E,) mm.
        frame: (E, 3, 3) rows along, up and across.
    """

    ends: IntArray
    lengths: FloatArray
    frame: FloatArray

    @classmethod
    def of(cls, mesh_mm: QuadMesh) -> BeamRows:
        """Those on the edges of a net, upright along its axes."""
        frames = beam_frames(mesh_mm, torsion_free_axes(mesh_mm))
        rows = np.stack([frames.along, frames.up, frames.left], axis=1)
        return cls(mesh_mm.connectivity.edges, mesh_mm.edge_lengths, rows)

    def factors(self, settings: Tolerances) -> FloatArray:
        """(E, 3) standard deviation of a beam's errors along, up and across, per mm of tolerance.

        Two cuts and two holes; two holes and the turn by two more; the turn by two edges of a slot.
        """
        turned = 2 * (self.lengths / settings.holes) ** 2
        sideways = 2 * (self.lengths / settings.node) ** 2
        squares = np.stack([np.full(len(self.lengths), 4.0), 2.0 + turned, sideways], axis=1)
        return np.asarray(np.sqrt(_UNIFORM * squares))


@dataclass(frozen=True, eq=False)
class Landed:
    """Where nodes land in all trials.

    Attributes:
        settings: of the run.
        rings: (V,) how many beams each node is from one that is held, -1 where none leads there.
        off: (T, V) distances from where nodes should be, mm.
        missed: (T, E) how far a hole of each beam is from that of its node, mm.
    """

    settings: Tolerances
    rings: IntArray
    off: FloatArray
    missed: FloatArray

    @cached_property
    def bears(self) -> float:
        """Tolerance at which 95 of 100 shells fit their holes and land where they may, mm."""
        misfit = self._share(self.missed.max(axis=1))
        off = self._share(self.off.max(axis=1))
        by_play = self.settings.play / misfit if misfit > 0 else math.inf
        by_place = self.settings.allowed / off if off > 0 else math.inf
        return self.settings.tolerance * min(by_play, by_place)

    def report(self) -> dict[str, Any]:
        """Numbers, ready for JSON; lengths in mm."""
        names = part_names("N", self.off.shape[1])
        worst = self.off.mean(axis=0).argmax()
        last = int(self.rings.argmax())
        return {
            "unit": "mm",
            "tolerance_mm": self.settings.tolerance,
            "trials": self.settings.trials,
            "seed": self.settings.seed,
            "nodes_free": int((self.rings > 0).sum()),
            "last_node": names[last],
            "last_off_mean_mm": float(self.off[:, last].mean()),
            "last_off_95_mm": self._share(self.off[:, last]),
            "worst_node": names[int(worst)],
            "off_mean_mm": float(self.off.max(axis=1).mean()),
            "off_95_mm": self._share(self.off.max(axis=1)),
            "holes_missed_95_mm": self._share(self.missed.max(axis=1)),
            "play_mm": self.settings.play,
            "allowed_mm": self.settings.allowed,
            "tolerance_borne_mm": self.bears,
        }

    def words(self) -> str:
        """One line on what came of it."""
        found = self.report()
        return (
            f"cut and drilled to {found['tolerance_mm']:g} mm, in 95 of 100 shells nodes land off "
            f"by {found['off_95_mm']:.1f} mm at most, the last one, {found['last_node']}, by "
            f"{found['last_off_95_mm']:.1f} mm, and holes miss by "
            f"{found['holes_missed_95_mm']:.1f} mm; with {found['play_mm']:g} mm of play and "
            f"{found['allowed_mm']:g} mm allowed the design bears "
            f"{found['tolerance_borne_mm']:.2f} mm"
        )

    def _share(self, values: FloatArray) -> float:
        return float(np.quantile(values, _MOST))


def bolted(beams: BeamRows, held: BoolArray, settings: Tolerances) -> Landed:
    """Bolt a shell together in many trials.

    Args:
        beams: between its nodes.
        held: (V,) nodes that stay where they are.
        settings: errors, play and what is allowed.

    Raises:
        InputError: no node is held, or none is free, or some hang on none that is held.
    """
    rings = _rings(beams.ends, held)
    free = np.flatnonzero(~held & (rings > 0))
    deviation = beams.factors(settings)
    weights = np.einsum("eac,ead->ecd", beams.frame / deviation[..., None] ** 2, beams.frame)
    errors = _errors(beams, settings)
    difference = _differences(beams.ends, len(held))[:, _coordinates(free)]
    weighed = scipy.sparse.block_diag(list(weights), format="csr")
    pulled = weighed @ errors.reshape(settings.trials, -1).T
    matrix = (difference.T @ weighed @ difference).tocsc()
    place = np.zeros((settings.trials, len(held), 3))
    settled = splu(matrix, permc_spec="MMD_AT_PLUS_A").solve(difference.T @ pulled)
    place[:, free] = settled.T.reshape(settings.trials, -1, 3)
    first, second = beams.ends.T
    rest = np.einsum(
        "tec,eac->tea", place[:, second] - place[:, first] - errors, beams.frame[:, :2]
    )
    turned = np.minimum(settings.holes / beams.lengths, 1.0)
    missed = np.hypot(rest[..., 0], turned * rest[..., 1])
    standing = held[first] & held[second]
    missed[:, standing | (rings[first] < 0)] = 0.0
    return Landed(settings, rings, np.linalg.norm(place, axis=2), missed)


def _differences(ends: IntArray, count: int) -> scipy.sparse.csc_matrix:
    """(3 E, 3 V) second node of each beam less its first one."""
    beams = len(ends)
    rows = np.repeat(np.arange(beams), 2)
    signs = np.tile([-1.0, 1.0], beams)
    one = scipy.sparse.coo_matrix((signs, (rows, ends.ravel())), (beams, count))
    return scipy.sparse.kron(one, scipy.sparse.identity(3), format="csc")


def _coordinates(nodes: IntArray) -> IntArray:
    """(3 N,) numbers of the coordinates of nodes."""
    return np.asarray((3 * nodes[:, None] + np.arange(3)).ravel())


def held_nodes(mesh: QuadMesh, nodes: Sequence[int] | None) -> BoolArray:
    """(V,) the nodes that are held: those that are named, or the boundary.

    Raises:
        InputError: a node that the net has not, or a net without a boundary.
    """
    held = np.zeros(len(mesh.vertices), dtype=bool)
    if nodes is None:
        held |= mesh.connectivity.boundary_vertices
        if not held.any():
            raise InputError("held: the net has no boundary; say which nodes are held")
        return held
    wrong = [node for node in nodes if not 0 <= node < len(held)]
    if wrong or not nodes:
        raise InputError(
            f"held: expected nodes from 0 to {len(held) - 1}, got {wrong or 'none'}; name others"
        )
    held[list(nodes)] = True
    return held


def _errors(beams: BeamRows, settings: Tolerances) -> FloatArray:
    """(T, E, 3) by how much each beam misplaces its second end, in space, mm."""
    drawn = np.random.default_rng(settings.seed).uniform(
        -settings.tolerance, settings.tolerance, (settings.trials, len(beams.ends), 10)
    )
    lengths = beams.lengths[:, None]
    along = drawn[..., :4].sum(axis=2)
    turn = (drawn[..., 6] - drawn[..., 7]) * lengths[:, 0] / settings.holes
    up = drawn[..., 4] + drawn[..., 5] + turn
    across = (drawn[..., 8] - drawn[..., 9]) * lengths[:, 0] / settings.node
    local = np.stack([along, up, across], axis=2)
    return np.asarray(np.einsum("tea,eac->tec", local, beams.frame))


def _rings(ends: IntArray, held: BoolArray) -> IntArray:
    """(V,) how many beams each node is from one that is held, -1 where none leads there.

    Raises:
        InputError: no node is held, or none is free.
    """
    beside: list[list[int]] = [[] for _ in held]
    for one, other in ends.tolist():
        beside[one].append(other)
        beside[other].append(one)
    rings = np.where(held, 0, -1)
    queue = deque(np.flatnonzero(held).tolist())
    while queue:
        here = queue.popleft()
        for node in beside[here]:
            if rings[node] < 0:
                rings[node] = rings[here] + 1
                queue.append(node)
    if rings.max() < 1:
        raise InputError("held: every node is held or none is; hold those that stay in place")
    return rings
