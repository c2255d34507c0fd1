"""The equations of a frame: unknowns of nodes, supports, and what moves freely."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.sparse import coo_array, csc_array, diags_array
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import SuperLU, splu

from solver.errors import InputError, SingularSystemError
from solver.frame import elements
from solver.frame.model import Frame, Supports
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Stiffness, by that of the members that meet in a node, below which a movement costs nothing.
_NOTHING = 1e-13
# Part of the largest movement from which on a node is said to move, and most nodes that are named.
_MOVES, _NAMED = 0.3, 8
_REPEATS = 4


class FrameSystem:
    """Stiffness of a supported frame, factored.

    Args:
        frame: the frame.
        supports: of its nodes.

    Attributes:
        turn: (M, 12, 12) from the unknowns of a member's nodes to the member's own axes.
        joined: the members with their springs.
        panels: (6 N, 6 N) stiffness of the panels alone.
        matrix: (6 N, 6 N) stiffness, panels and springs of supports included, in the directions of
            supports.
        free: numbers of the unknowns that may move.
        idle: stiffness of rotations that turn no member, which nothing else would hold.
        kept: (n, n) stiffness of the free unknowns.

    Raises:
        InputError: supports or joints that let something move freely, naming the nodes.
    """

    def __init__(self, frame: Frame, supports: Supports) -> None:
        if len(supports.fixed) != len(frame.nodes):
            raise InputError(
                f"supports: expected {len(frame.nodes)} nodes, got {len(supports.fixed)}"
            )
        self.frame, self.supports = frame, supports
        self.turn = turns(frame, supports, frame.axes)
        rigid = elements.stiffness(frame)
        self.joined = elements.joined(frame, rigid)
        self._numbers = _unknowns(frame)
        self.panels = self.assembled_panels(frame.panels.elastic(frame.nodes))
        own = self.assembled(self.joined.stiffness) + self.panels
        self.matrix = (own + diags_array(supports.springs.ravel(), format="csc")).tocsc()
        self._refuse_loose()
        used = np.zeros(len(frame.nodes), dtype=bool)
        used[frame.members] = True
        free = ~supports.fixed & used[:, None]
        self.free: IntArray = np.flatnonzero(free.ravel())
        self.idle = self._idle_turns()
        self.kept = (self.matrix + self.idle)[self.free][:, self.free].tocsc()
        # What a node would resist with were all joints rigid: next to that nothing is nothing.
        usual = self.assembled(rigid).diagonal() + supports.springs.ravel()
        self._factors = self._factored(usual[self.free])

    def assembled(self, k: FloatArray, turn: FloatArray | None = None) -> csc_array:
        """(6 N, 6 N) sum of matrices (M, 12, 12) in members' own axes, or those of ``turn``."""
        turn = self.turn if turn is None else turn
        whole = np.swapaxes(turn, 1, 2) @ k @ turn
        rows = np.broadcast_to(self._numbers[:, :, None], whole.shape)
        columns = np.broadcast_to(self._numbers[:, None, :], whole.shape)
        size = 6 * len(self.frame.nodes)
        pair = (rows.ravel(), columns.ravel())
        return coo_array((whole.ravel(), pair), shape=(size, size)).tocsc()

    def assembled_panels(self, k: FloatArray) -> csc_array:
        """(6 N, 6 N) sum of matrices (P, 12, 12) of panels in the model's directions."""
        turn, numbers = self._panel_turns()
        whole = np.swapaxes(turn, 1, 2) @ k @ turn
        rows = np.broadcast_to(numbers[:, :, None], whole.shape).ravel()
        columns = np.broadcast_to(numbers[:, None, :], whole.shape).ravel()
        size = 6 * len(self.frame.nodes)
        return coo_array((whole.ravel(), (rows, columns)), shape=(size, size)).tocsc()

    def gathered_panels(self, forces: FloatArray) -> FloatArray:
        """(6 N,) sum at the nodes of forces (P, 12) of panels in the model's directions."""
        turn, numbers = self._panel_turns()
        own = np.einsum("pji,pj->pi", turn, forces).ravel()
        size = 6 * len(self.frame.nodes)
        return np.asarray(np.bincount(numbers.ravel(), own, minlength=size), dtype=np.float64)

    def _panel_turns(self) -> tuple[FloatArray, IntArray]:
        """(P, 12, 12) from the directions of supports to the model's, and (P, 12) unknowns."""
        corners = self.frame.panels.corners
        turn = np.zeros((len(corners), 4, 3, 4, 3))
        for k in range(4):
            turn[:, k, :, k, :] = np.swapaxes(self.supports.directions[corners[:, k]], 1, 2)
        numbers = 6 * corners[:, :, None] + np.arange(3)
        return turn.reshape(-1, 12, 12), np.asarray(numbers.reshape(-1, 12))

    def gathered(self, ends: FloatArray, turn: FloatArray | None = None) -> FloatArray:
        """(6 N,) sum at the nodes of forces (M, 12) in the members' own axes, or others."""
        forces = np.einsum("mji,mj->mi", self.turn if turn is None else turn, ends)
        size = 6 * len(self.frame.nodes)
        return np.asarray(
            np.bincount(self._numbers.ravel(), forces.ravel(), minlength=size), dtype=np.float64
        )

    def at_members(self, movement: FloatArray) -> FloatArray:
        """(M, 12) movement of the nodes (6 N,) in the axes of each member."""
        return np.asarray(np.einsum("mij,mj->mi", self.turn, movement[self._numbers]))

    def own(self, values: FloatArray) -> FloatArray:
        """(N, 6) in the model's directions, of values (N, 6) in those of the supports."""
        parts = values.reshape(-1, 2, 3)
        own = np.einsum("nji,nkj->nki", self.supports.directions, parts)
        return np.asarray(own.reshape(-1, 6))

    def along_supports(self, values: FloatArray) -> FloatArray:
        """(N, 6) in the directions of the supports, of values (N, 6) in those of the model."""
        parts = values.reshape(-1, 2, 3)
        along = np.einsum("nij,nkj->nki", self.supports.directions, parts)
        return np.asarray(along.reshape(-1, 6))

    def solved(self, right: FloatArray) -> FloatArray:
        """(n,) movement of the free unknowns under forces (n,), repeated for what is left."""
        found = self._factors.solve(right)
        return np.asarray(found + self._factors.solve(right - self.kept @ found))

    @property
    def solve_once(self) -> Callable[[FloatArray], FloatArray]:
        """Solves for forces (n,) without repeating."""
        return self._factors.solve  # type: ignore[no-any-return]

    def _refuse_loose(self) -> None:
        """Refuse a frame, or a part of one, that nothing supports."""
        frame, held = self.frame, self.supports.fixed.any(axis=1)
        held = held | (self.supports.springs > 0).any(axis=1)
        if not held.any():
            raise InputError("supports: there are none; support three nodes at least")
        one, two = frame.members.T
        count = len(frame.nodes)
        graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
        _, part = connected_components(graph, directed=False)
        standing = np.zeros(count, dtype=bool)
        standing[part[held]] = True
        loose = frame.members[~standing[part[one]]]
        if len(loose):
            nodes = np.unique(loose[part[loose[:, 0]] == part[loose[0, 0]]])
            raise InputError(
                f"supports: a part with {_listed(nodes)} hangs loose; support it or leave it out"
            )

    def _idle_turns(self) -> csc_array:
        """Stiffness for rotations of nodes that turn no member, as in trusses: they stay at zero.

        A block of a positive matrix that is zero in a direction is so in its whole row.
        """
        size, count = self.matrix.shape[0], len(self.frame.nodes)
        blocks = np.zeros((count, 3, 3))
        number = 6 * np.arange(count)[:, None, None] + 3
        rows = np.broadcast_to(number + np.arange(3)[None, :, None], blocks.shape)
        columns = np.broadcast_to(number + np.arange(3)[None, None, :], blocks.shape)
        blocks[:] = np.asarray(self.matrix[rows.ravel(), columns.ravel()]).reshape(blocks.shape)
        value, direction = np.linalg.eigh(blocks)
        usual = self._usual_turn()
        idle = np.where(value <= 1e-12 * usual, usual, 0.0)
        extra = np.einsum("nik,nk,njk->nij", direction, idle, direction)
        self._idle_directions = direction * (idle > 0)[:, None, :]
        return coo_array(
            (extra.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size)
        ).tocsc()

    def _usual_turn(self) -> float:
        """What it takes to turn the end of a member, about."""
        of = self.frame.stiffness
        return float(np.median(4 * of.youngs * of.about_z / self.frame.lengths))

    def refuse_idle_moments(self, nodal: FloatArray) -> None:
        """Refuse moments (N, 3), in the directions of supports, that no member takes.

        Raises:
            InputError: naming the node.
        """
        left = np.einsum("nik,ni->nk", self._idle_directions, nodal)
        left[self.supports.fixed[:, 3:].any(axis=1)] = 0.0
        bad = np.flatnonzero(np.abs(left).max(axis=1) > 1e-9 * np.abs(nodal).max(initial=0.0))
        if len(bad):
            raise InputError(
                f"loads: the moment at node {bad[0]} turns joints that nothing holds; leave it out"
            )

    def _factored(self, usual: FloatArray) -> SuperLU:
        if not len(self.free):
            raise InputError("supports: hold every node; leave some free")
        nothing = self.kept.diagonal() <= _NOTHING * usual
        if nothing.any():
            raise InputError(_free_words(np.unique(self.free[nothing] // 6)))
        try:
            factors = factored(self.kept)
        except SingularSystemError:
            # A trifle stiffer it can be solved, and then shows what moves.
            trifle = diags_array(1e-12 * usual, format="csc")
            factors = factored((self.kept + trifle).tocsc())
        self._refuse_mechanism(factors, usual)
        return factors

    def _refuse_mechanism(self, factors: SuperLU, usual: FloatArray) -> None:
        """Find the movement that costs least, by inverse iteration, and refuse one for nothing."""
        scale = 1.0 / np.sqrt(usual)
        move = np.random.default_rng(7).standard_normal(len(usual))
        for _ in range(_REPEATS):
            move = factors.solve(move / scale) / scale
            move /= np.linalg.norm(move)
        moved = scale * move
        if moved @ (self.kept @ moved) > _NOTHING:
            return
        movement = np.zeros(6 * len(self.frame.nodes))
        movement[self.free] = moved
        parts = np.linalg.norm(movement.reshape(-1, 2, 3), axis=2)
        # Turns that go with displacements are not worth mention.
        parts[:, 1] *= self.frame.lengths.mean()
        size = parts[:, 0] if parts[:, 0].max() > 0.1 * parts[:, 1].max() else parts[:, 1]
        raise InputError(_free_words(np.flatnonzero(size > _MOVES * size.max())))


def factored(matrix: csc_array) -> SuperLU:
    """Factors of a symmetric matrix.

    Raises:
        SingularSystemError: the matrix has none.
    """
    try:
        return splu(
            matrix,
            permc_spec="MMD_AT_PLUS_A",
            diag_pivot_thresh=0.0,
            options={"SymmetricMode": True},
        )
    except RuntimeError as error:
        # So the library says that a pivot is zero.
        raise SingularSystemError("frame: the stiffness is singular; add supports") from error


def negative_pivots(matrix: csc_array) -> int | None:
    """How many values of a symmetric matrix are negative; None where its pivots cannot tell."""
    try:
        factors = factored(matrix)
    except SingularSystemError:
        return None
    if not np.array_equal(factors.perm_r, factors.perm_c):
        return None
    return int((factors.U.diagonal() < 0).sum())


def _free_words(nodes: IntArray) -> str:
    moves = "moves" if len(nodes) == 1 else "move"
    return (
        f"supports: a mechanism: {_listed(nodes)} {moves} freely; support more directions, or make "
        "joints rigid"
    )


def _listed(nodes: IntArray) -> str:
    words = ", ".join(map(str, nodes[:_NAMED].tolist()))
    if len(nodes) == 1:
        return f"node {words}"
    return f"nodes {words}" + (f" and {len(nodes) - _NAMED} more" if len(nodes) > _NAMED else "")


def _unknowns(frame: Frame) -> IntArray:
    """(M, 12) numbers of the unknowns of each member's nodes."""
    return np.asarray((6 * frame.members[:, :, None] + np.arange(6)).reshape(-1, 12))


def turns(frame: Frame, supports: Supports, axes: FloatArray) -> FloatArray:
    """(M, 12, 12) from the directions of supports to axes (M, 3, 3), a direction a row."""
    turn = np.zeros((len(frame.members), 12, 12))
    for end in (0, 1):
        directions = supports.directions[frame.members[:, end]]
        block = axes @ np.swapaxes(directions, 1, 2)
        for first in (6 * end, 6 * end + 3):
            turn[:, first : first + 3, first : first + 3] = block
    return turn
