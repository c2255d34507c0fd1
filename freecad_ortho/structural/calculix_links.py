"""Joints that give and panels that stiffen, as CalculiX has them: equations and springs.

Beams of CalculiX are solids, of which nodes only move: how far they turn is told by the ends of
levers, stiff beams across a member, one pair of them on its own end and one on its node.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from solver.frame.model import Frame
from solver.mesh.quadmesh import FloatArray

# Turning about a member's x, y, z at its first node, and what is added for its last.
_TURNS, _LAST = (3, 4, 5), 6
# What a lever's end says about these: which axis the lever lies along, which way its end moves,
# and the sign of that.
_TELLS = {3: (1, 2, 1.0), 4: (2, 0, 1.0), 5: (1, 0, -1.0)}


@dataclass(frozen=True, eq=False)
class Link:
    """A sum of movements that a spring resists, or that has to stay zero.

    Attributes:
        terms: node, direction (0 to 2) and factor of each movement; the first of them follows
            from the others where the sum has to stay zero.
        stiffness: of the spring, N/mm; infinite for none.
    """

    terms: tuple[tuple[int, int, float], ...]
    stiffness: float = np.inf


def giving_joints(frame: Frame, length: float) -> tuple[Frame, list[Link]]:
    """The frame with levers where members' ends turn against their nodes, and links of these.

    Args:
        frame: its springs are of turning only.
        length: of the levers.

    Returns:
        The frame: each such end has a node of its own, and levers follow as members, as stiff as
        the last one of the frame; and the links.
    """
    loose = np.isfinite(frame.springs).reshape(-1, 2, _LAST).any(axis=2)
    ends = np.argwhere(loose)
    if not len(ends):
        return frame, []
    count = len(frame.nodes)
    own = count + np.arange(len(ends))
    vertex = frame.members[ends[:, 0], ends[:, 1]]
    axes = frame.axes[ends[:, 0]]
    # Tips: of each end along y and z from the vertex, then along y and z from the member.
    tips = count + len(ends) + np.arange(4 * len(ends)).reshape(-1, 4)
    reach = frame.nodes[vertex][:, None] + length * axes[:, [1, 2, 1, 2]]
    members = frame.members.copy()
    members[ends[:, 0], ends[:, 1]] = own
    starts = np.stack([vertex, vertex, own, own], axis=1)
    levers = np.stack([starts.ravel(), tips.ravel()], axis=1)
    like = np.concatenate([np.arange(len(members)), np.full(len(levers), len(members) - 1)])
    springs = np.full((len(like), 2 * _LAST), np.inf)
    joined = replace(
        frame,
        nodes=np.concatenate([frame.nodes, frame.nodes[vertex], reach.reshape(-1, 3)]),
        members=np.concatenate([members, levers]),
        stiffness=frame.stiffness.taken(like),
        up=np.concatenate([frame.up, np.repeat(axes[:, 0], 4, axis=0)]),
        springs=springs,
    )
    links: list[Link] = []
    for (member, end), node, at, row, three in zip(
        ends.tolist(), own.tolist(), vertex.tolist(), tips.tolist(), axes, strict=True
    ):
        links += [Link(((node, k, 1.0), (at, k, -1.0))) for k in range(3)]
        springs_here = frame.springs[member, _LAST * end :][:_LAST]
        links += _turning(springs_here, row, three, length)
    return joined, links


def _turning(
    springs: FloatArray, tips: Sequence[int], axes: FloatArray, length: float
) -> list[Link]:
    found = []
    for turn in _TURNS:
        lever, way, sign = _TELLS[turn]
        fixed, moving = tips[lever - 1], tips[lever + 1]
        if not springs[turn] > 0:
            continue
        factors = sign * axes[way]
        order = np.argsort(-np.abs(factors))
        terms = [(moving, int(k), float(factors[k])) for k in order]
        terms += [(fixed, int(k), -float(factors[k])) for k in order]
        kept = tuple(term for term in terms if term[2])
        found.append(Link(kept, float(springs[turn]) / length**2))
    return found


def stiffening_panels(frame: Frame) -> list[Link]:
    """Springs on the difference of the diagonals of each panel."""
    panels = frame.panels
    if not len(panels.corners):
        return []
    slopes = panels.slopes(frame.nodes).reshape(-1, 4, 3)
    return [
        Link(
            tuple(
                (int(corners[k]), j, float(slope[k, j]))
                for k in range(4)
                for j in range(3)
                if slope[k, j]
            ),
            float(stiffness),
        )
        for corners, slope, stiffness in zip(panels.corners, slopes, panels.stiffness, strict=True)
    ]


def lines(links: Sequence[Link], nodes: FloatArray, node: int, element: int) -> Iterator[str]:
    """Lines of an input file that link movements.

    Args:
        links: the links.
        nodes: (N, 3) positions of the frame's nodes.
        node: the first number that no node has; a spring has a node that moves by its sum.
        element: the first number that no element has.
    """
    for link in links:
        terms = [(at + 1, way + 1, factor) for at, way, factor in link.terms]
        if np.isfinite(link.stiffness):
            yield "*NODE"
            x, y, z = nodes[link.terms[0][0]].tolist()
            yield f"{node}, {x:.9g}, {y:.9g}, {z:.9g}"
            terms.insert(0, (node, 1, -1.0))
        yield "*EQUATION"
        yield str(len(terms))
        yield from (f"{at}, {way}, {factor:.9g}" for at, way, factor in terms)
        if np.isfinite(link.stiffness):
            yield from spring(element, node, 1, link.stiffness)
            yield "*BOUNDARY"
            yield f"{node}, 2, 3"
            node, element = node + 1, element + 1


def spring(number: int, node: int, direction: int, stiffness: float) -> Iterator[str]:
    """A spring between a node and the ground."""
    yield f"*ELEMENT, TYPE=SPRING1, ELSET=SPRING{number}"
    yield f"{number}, {node}"
    yield f"*SPRING, ELSET=SPRING{number}"
    yield f"{direction}"
    # It takes a number without a point for another direction.
    yield f"{stiffness:.9E}"
