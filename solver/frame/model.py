"""What a frame in space is made of: nodes, members, supports, loads.

Units are free but have to fit each other, such as N and mm. Every node has six unknowns: three
displacements and three rotations, in this order. A member has axes of its own: x from its first
node to its second, z as near to its ``up`` as is at right angles to x, and y = z x x.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace

import numpy as np

from solver.errors import InputError
from solver.frame.panels import ShearPanels
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, row_lengths

# Names of what a support holds, or a spring at a member's end lets go.
DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")
# Sine of the least angle between a member and its ``up``.
_LEAST_ANGLE = 1e-6


@dataclass(frozen=True, eq=False)
class Stiffness:
    """Sections and moduli of members, each an array (M,).

    Attributes:
        area: of the section.
        about_y: second moment of area about y, of bending in the plane of x and z.
        about_z: second moment of area about z.
        torsion: Saint-Venant's torsion constant.
        youngs: Young's modulus.
        shear: shear modulus.
        shear_area_y: for shear along y; infinite is a beam of Euler and Bernoulli.
        shear_area_z: for shear along z.
    """

    area: FloatArray
    about_y: FloatArray
    about_z: FloatArray
    torsion: FloatArray
    youngs: FloatArray
    shear: FloatArray
    shear_area_y: FloatArray
    shear_area_z: FloatArray

    @classmethod
    def same(
        cls,
        count: int,
        *,
        area: float,
        about_y: float,
        about_z: float,
        torsion: float,
        youngs: float,
        shear: float,
        shear_area_y: float = np.inf,
        shear_area_z: float = np.inf,
    ) -> Stiffness:
        """One section for ``count`` members."""
        values = (area, about_y, about_z, torsion, youngs, shear, shear_area_y, shear_area_z)
        return cls(*(np.full(count, float(value)) for value in values))

    def taken(self, members: IntArray) -> Stiffness:
        """Those of the members with these numbers."""
        return Stiffness(*(getattr(self, one.name)[members] for one in fields(self)))


@dataclass(frozen=True, eq=False)
class Frame:
    """Straight members between nodes.

    Args:
        nodes: (N, 3) positions.
        members: (M, 2) nodes at their ends.
        stiffness: of the members.
        up: (M, 3) where their z axes point to.
        springs: (M, 12) stiffness of the joints between a member's ends and its nodes along and
            about the member's axes: infinite where they are rigid (:func:`rigid_joints`), 0 where a
            hinge lets go.
        panels: that stiffen it against shear.

    Raises:
        InputError: what makes no frame: members without length or stiffness, numbers of no node.
    """

    nodes: FloatArray
    members: IntArray
    stiffness: Stiffness
    up: FloatArray
    springs: FloatArray
    panels: ShearPanels = field(default_factory=ShearPanels)

    def __post_init__(self) -> None:
        count = len(self.members)
        if not count:
            raise InputError("frame: has no members; give one at least")
        if self.members.min() < 0 or self.members.max() >= len(self.nodes):
            raise InputError(f"members: expected numbers of nodes from 0 to {len(self.nodes) - 1}")
        if not np.isfinite(self.nodes).all():
            raise InputError("nodes: expected finite positions")
        self._refuse_no_length()
        for one in fields(self.stiffness):
            values = getattr(self.stiffness, one.name)
            if values.shape != (count,):
                raise InputError(f"{one.name}: expected one number a member, got {values.shape}")
            bad = np.flatnonzero(~(values > 0))
            if len(bad):
                raise InputError(
                    f"{one.name}: member {bad[0]} has {values[bad[0]]:g}, so no stiffness; give a "
                    "positive number"
                )
        if self.up.shape != (count, 3) or self.springs.shape != (count, 12):
            raise InputError("up, springs: expected 3 and 12 numbers a member")
        if not (self.springs >= 0).all():
            raise InputError("springs: expected stiffnesses of 0 or more at every member's end")

    def _refuse_no_length(self) -> None:
        span = self.nodes[self.members[:, 1]] - self.nodes[self.members[:, 0]]
        short = np.flatnonzero(row_lengths(span) <= 1e-9 * np.ptp(self.nodes, axis=0).max())
        if len(short):
            one, two = self.members[short[0]]
            raise InputError(
                f"member {short[0]}: has no length between nodes {one} and {two}; merge them"
            )

    @property
    def lengths(self) -> FloatArray:
        """(M,) lengths of the members."""
        return row_lengths(self.nodes[self.members[:, 1]] - self.nodes[self.members[:, 0]])

    @property
    def axes(self) -> FloatArray:
        """(M, 3, 3) axes x, y, z of each member as rows.

        Raises:
            InputError: a member whose ``up`` runs along it.
        """
        x = self.nodes[self.members[:, 1]] - self.nodes[self.members[:, 0]]
        x = x / row_lengths(x)[:, None]
        y = np.cross(self.up, x)
        sine = row_lengths(y)
        along = np.flatnonzero(~(sine > _LEAST_ANGLE * row_lengths(self.up)))
        if len(along):
            raise InputError(
                f"member {along[0]}: its section is turned by a direction along the member; give "
                "one across it"
            )
        y = y / sine[:, None]
        return np.stack([x, y, np.cross(x, y)], axis=1)

    def divided(self, pieces: int) -> Frame:
        """The frame with every member cut into so many pieces, in order along it.

        Nodes keep their numbers; those between pieces follow, member by member.
        """
        if pieces == 1:
            return self
        count, first = len(self.members), len(self.nodes)
        start, end = (self.nodes[self.members[:, k]] for k in (0, 1))
        part = np.arange(1, pieces)[None, :, None] / pieces
        between = (start[:, None] + part * (end - start)[:, None]).reshape(-1, 3)
        inner = first + np.arange(count * (pieces - 1)).reshape(count, pieces - 1)
        chain = np.concatenate([self.members[:, :1], inner, self.members[:, 1:]], axis=1)
        members = np.stack([chain[:, :-1], chain[:, 1:]], axis=2).reshape(-1, 2)
        springs = np.full((count, pieces, 12), np.inf)
        springs[:, 0, :6], springs[:, -1, 6:] = self.springs[:, :6], self.springs[:, 6:]
        whole = np.repeat(np.arange(count), pieces)
        return replace(
            self,
            nodes=np.concatenate([self.nodes, between]),
            members=members,
            stiffness=self.stiffness.taken(whole),
            up=self.up[whole],
            springs=springs.reshape(-1, 12),
        )


def rigid_joints(count: int) -> FloatArray:
    """(M, 12) springs at the ends of ``count`` members none of which turns in its joints."""
    return np.full((count, 12), np.inf)


@dataclass(frozen=True, eq=False)
class Supports:
    """What holds the nodes.

    Args:
        fixed: (N, 6) true where a node cannot move or turn.
        springs: (N, 6) stiffness of what holds it elastically, 0 for nothing.
        directions: (N, 3, 3) directions x, y, z of each node's support as rows.
    """

    fixed: BoolArray
    springs: FloatArray
    directions: FloatArray

    @classmethod
    def upright(cls, fixed: BoolArray, springs: FloatArray | None = None) -> Supports:
        """Supports in the model's own directions, none of them elastic unless springs say so."""
        count = len(fixed)
        soft = np.zeros((count, 6)) if springs is None else springs
        return cls(fixed, soft, np.broadcast_to(np.eye(3), (count, 3, 3)))

    @classmethod
    def at(cls, count: int, held: dict[int, str]) -> Supports:
        """Supports of some of ``count`` nodes: ``{0: "x y z rx ry rz", 7: "x y z"}``."""
        fixed = np.zeros((count, 6), dtype=bool)
        for node, words in held.items():
            fixed[node, [DIRECTIONS.index(word) for word in words.split()]] = True
        return cls.upright(fixed)

    def followed_by(self, count: int) -> Supports:
        """The same with nodes after them, ``count`` in all, that nothing holds."""
        more = count - len(self.fixed)
        return Supports(
            np.concatenate([self.fixed, np.zeros((more, 6), dtype=bool)]),
            np.concatenate([self.springs, np.zeros((more, 6))]),
            np.concatenate([self.directions, np.broadcast_to(np.eye(3), (more, 3, 3))]),
        )


@dataclass(frozen=True, eq=False)
class Loads:
    """One load case.

    Attributes:
        nodal: (N, 6) forces and moments at the nodes.
        spread: (M, 3) forces along the members, by their length, in the model's directions.
    """

    nodal: FloatArray
    spread: FloatArray

    @classmethod
    def none(cls, frame: Frame) -> Loads:
        """No load."""
        return cls(np.zeros((len(frame.nodes), 6)), np.zeros((len(frame.members), 3)))

    def __add__(self, other: Loads) -> Loads:
        """Both together."""
        return Loads(self.nodal + other.nodal, self.spread + other.spread)

    def __rmul__(self, factor: float) -> Loads:
        """The load, so many times."""
        return Loads(factor * self.nodal, factor * self.spread)

    def total(self, frame: Frame) -> FloatArray:
        """(3,) sum of all forces."""
        spread = frame.lengths @ self.spread
        return np.asarray(self.nodal[:, :3].sum(axis=0) + spread)

    def divided(self, frame: Frame, pieces: int) -> Loads:
        """The load on the frame whose members are cut into pieces."""
        more = len(frame.members) * (pieces - 1)
        nodal = np.concatenate([self.nodal, np.zeros((more, 6))])
        return Loads(nodal, np.repeat(self.spread, pieces, axis=0))
