"""Members beside the net: off it by an eccentricity, and lines u and v in two layers.

Lamellas that turn in their slots are such layers too, next to each other.
Members then run between nodes of their own, which arms along the axes join to the vertices:
where lines cross, the arms of both are the bolt, and one layer may turn about it against the other.
Loads and supports stay on the vertices. An arm is so much stiffer than members that it does not
count, and no stiffer, as that would cost digits.

Source: rigid offsets of members as in McGuire, Gallagher, Ziemian (2000), Matrix Structural
Analysis, 13.5, by stiff members in place of equations.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

import numpy as np

from freecad_ortho.structural.design import Design
from solver.errors import InputError
from solver.frame.model import Frame, Stiffness
from solver.mesh.connectivity import IntArray
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Stiffness of an arm by that of a member of usual length.
_STIFF = 300.0
# How far apart lines are that turn against each other in one layer, mm: next to nothing.
_SLOT = 1.0
# Of a member's springs: turning about its axis at its first node.
_TURN = 3


@dataclass(frozen=True, eq=False)
class _Places:
    """Where the ends of members lie.

    Attributes:
        vertices: (K,) of the net, whose arms there are.
        layers: (K,) 0 of lines u, 1 of lines v.
        heights: (K,) over the net along the axes, not zero.
        of_ends: (M, 2) number of a place, -1 where a member ends on the net itself.
    """

    vertices: IntArray
    layers: IntArray
    heights: FloatArray
    of_ends: IntArray


def off_the_net(frame: Frame, mesh: QuadMesh, axes: FloatArray, design: Design) -> Frame:
    """The frame with its members where the design has them, and arms after them.

    Args:
        frame: members on the edges of the net.
        mesh: the net, mm.
        axes: (V, 3) unit axes of the vertices.
        design: eccentricity, layers, and how these are joined.

    Raises:
        InputError: layers, or turning crossings, of lines that cannot be told apart.
    """
    turning = design.crossing_spring()
    apart = design.layers
    if not apart and np.isfinite(turning):
        apart = _SLOT
    if not apart and not design.eccentric:
        return frame
    # Above the net is upwards, over the whole.
    up = axes if axes[:, 2].sum() >= 0 else -axes
    places = _places(frame, mesh, design.eccentric, apart)
    first = len(frame.nodes)
    nodes = mesh.vertices[places.vertices] + places.heights[:, None] * up[places.vertices]
    inside = np.where(places.of_ends < 0, frame.members, first + places.of_ends)
    arms = np.stack([places.vertices, first + np.arange(len(nodes))], axis=1)
    springs = np.full((len(arms), 12), np.inf)
    # One layer turns: the other keeps to the bolt, or lies on the net and is the vertex.
    springs[places.layers == places.layers.max(), _TURN] = turning
    return replace(
        frame,
        nodes=np.concatenate([frame.nodes, nodes]),
        members=np.concatenate([inside, arms]),
        stiffness=_with_arms(frame, np.abs(places.heights)),
        up=np.concatenate([frame.up, _across(up[places.vertices])]),
        springs=np.concatenate([frame.springs, springs]),
    )


def _places(frame: Frame, mesh: QuadMesh, eccentric: float, apart: float) -> _Places:
    layer = np.zeros(len(frame.members), dtype=np.int64)
    if apart:
        family = ParameterLines.of(mesh).edge_family
        if (family < 0).any():
            raise InputError(
                "layers: the lines of this net cannot be told apart into families u and v, so "
                "they cannot lie in two layers or turn where they cross; leave layers and "
                "crossings out"
            )
        layer = np.asarray(family, dtype=np.int64)
    height = eccentric + apart * np.array([0.5, -0.5])
    ends = 2 * frame.members + layer[:, None]
    kept, of_ends = np.unique(ends, return_inverse=True)
    of_ends = of_ends.reshape(ends.shape)
    off = height[kept % 2] != 0
    number = np.where(off, np.cumsum(off) - 1, -1)
    kept = kept[off]
    return _Places(kept // 2, kept % 2, height[kept % 2], number[of_ends])


def _with_arms(frame: Frame, lengths: FloatArray) -> Stiffness:
    """Sections of members, then of arms, each as stiff as the stiffest of members many times."""
    of, usual = frame.stiffness, float(np.median(frame.lengths))
    youngs, shear = float(of.youngs.max()), float(of.shear.max())
    by = _STIFF * lengths / usual
    bent = max(float((of.youngs * of.about_y).max()), float((of.youngs * of.about_z).max()))
    stretched = float((of.youngs * of.area).max())
    arms = Stiffness(
        area=by * stretched / youngs,
        about_y=by * bent / youngs,
        about_z=by * bent / youngs,
        torsion=by * bent / shear,
        youngs=np.full(len(lengths), youngs),
        shear=np.full(len(lengths), shear),
        # Short arms would be far stiffer across than along without it, which costs digits.
        shear_area_y=by * stretched / shear,
        shear_area_z=by * stretched / shear,
    )
    parts = (np.concatenate([getattr(of, one.name), getattr(arms, one.name)]) for one in fields(of))
    return Stiffness(*parts)


def _across(directions: FloatArray) -> FloatArray:
    """(K, 3) some direction at right angles to each."""
    least = np.eye(3)[np.abs(directions).argmin(axis=1)]
    return np.cross(directions, least)
