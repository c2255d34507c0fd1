"""The model as an input file of CalculiX, which FreeCAD's FEM workbench runs too.

Arms of members beside the net are beams too, far stiffer than members. One that turns about its
axis is a sleeve on a pin: a second arm in its place, and equations that hold both ends together.
Ends of members that give are linked to their nodes, see ``calculix_links``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.structural import calculix_links
from freecad_ortho.structural.calculix_links import Link
from freecad_ortho.structural.groups import Group
from freecad_ortho.structural.model import Model
from solver.frame.model import Frame, Loads
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Elements a member: they are turned into solids, of which one alone is too stiff.
PIECES = 4
# Young's modulus of arms by the largest of members, and of their square sections the side by the
# largest height.
ARM, _SIDE = 100.0, 1.0
# Length of levers by the side of arms.
_LEVER = 2.0
# Of a member's springs: turning about its axis at its first node.
_TURN = 3
# Of the load along an element with three nodes: what each of them takes.
_SHARES = (1 / 6, 2 / 3, 1 / 6)


@dataclass(frozen=True, eq=False)
class BeamElements:
    """Members as elements of three nodes, ``PIECES`` a member, one member after the other.

    Attributes:
        frame: members in halves of elements; its first nodes are those of the model.
        elements: (E, 3) nodes at the start, in the middle and at the end.
    """

    frame: Frame
    elements: IntArray

    @classmethod
    def of(cls, frame: Frame) -> BeamElements:
        """Cut the members of a frame."""
        divided = frame.divided(2 * PIECES)
        chain = divided.members.reshape(-1, 2, 2)
        return cls(divided, np.column_stack([chain[:, 0], chain[:, 1, 1]]))

    @property
    def used(self) -> IntArray:
        """(K,) nodes that elements meet, in order."""
        return np.unique(self.frame.members)

    def forces(self, whole: Frame, loads: Loads) -> FloatArray:
        """(N, 3) forces on the nodes in N, of loads on the frame that was cut."""
        divided = loads.divided(whole, 2 * PIECES)
        force = divided.nodal[:, :3].copy()
        halves = (divided.spread * self.frame.lengths[:, None]).reshape(-1, 2, 3)
        for at, share in zip(self.elements.T, _SHARES, strict=True):
            np.add.at(force, at, share * halves.sum(axis=1))
        return force


def input_file(model: Model) -> str | None:
    """Beams with three nodes, a static step a load case; N, mm, t.

    None where CalculiX has no such model, see ``what_is_missing``.
    """
    if what_is_missing(model):
        return None
    sections = [found for found in map(_section, model.groups) if found is not None]
    return "\n".join(_lines(model, sections)) + "\n"


def what_is_missing(model: Model) -> str:
    """What of a model beams of CalculiX cannot be, in words; nothing where they can."""
    for group in model.groups:
        if _section(group) is None:
            return (
                f"section {group.profile.name}: its beams are rectangles and tubes, round or not, "
                "and what it takes by numbers twists like a round bar"
            )
    return ""


def arm_side(model: Model) -> float:
    """Side of the square sections of arms, mm."""
    return _SIDE * max(group.profile.height for group in model.groups)


def _section(group: Group) -> tuple[str, str] | None:
    """Kind and sizes; the first size is along the direction that is given with it."""
    profile = group.profile
    height, width, wall = profile.height, profile.width, profile.wall
    if profile.series == "chs":
        return "PIPE", f"{height / 2:g}, {wall:g}"
    if profile.series == "tube":
        return "BOX", f"{height:g}, {width:g}, {wall:g}, {wall:g}, {wall:g}, {wall:g}"
    if len(profile.rings) == 1 and len(profile.rings[0].corners) == 4:
        return "RECT", f"{height:g}, {width:g}"
    return None


@dataclass(frozen=True, eq=False)
class JoinedBeams:
    """A model as beams and what links them.

    Attributes:
        frame: its first members are the model's, then its arms, then pins and levers, all as
            stiff as arms.
        links: between its nodes.
        cut: the frame in elements.
    """

    frame: Frame
    links: Sequence[Link]
    cut: BeamElements

    @classmethod
    def of(cls, model: Model) -> JoinedBeams:
        """Beams of a model."""
        pinned, pairs = _with_pins(model)
        frame, links = calculix_links.giving_joints(pinned, _LEVER * arm_side(model))
        for one, two in pairs.tolist():
            links += [Link(((one, k, 1.0), (two, k, -1.0))) for k in range(3)]
        return cls(
            frame, [*links, *calculix_links.stiffening_panels(frame)], BeamElements.of(frame)
        )

    def forces(self, loads: Loads) -> FloatArray:
        """(N, 3) forces on the nodes of the elements in N, of loads on the model."""
        found = Loads.none(self.frame)
        found.nodal[: len(loads.nodal)] = loads.nodal
        found.spread[: len(loads.spread)] = loads.spread
        return self.cut.forces(self.frame, found)

    def link_lines(self, model: Model) -> Iterator[str]:
        """Lines of an input file: equations of the links, springs of links and of supports."""
        element = 1 + len(self.cut.elements)
        held = np.argwhere(model.supports.springs > 0)
        for number, (node, direction) in enumerate(held.tolist(), element):
            stiffness = float(model.supports.springs[node, direction])
            yield from calculix_links.spring(number, node + 1, direction + 1, stiffness)
        node = 1 + len(self.cut.frame.nodes)
        yield from calculix_links.lines(self.links, self.frame.nodes, node, element + len(held))


def _lines(model: Model, sections: Sequence[tuple[str, str]]) -> Iterator[str]:
    joined = JoinedBeams.of(model)
    cut = joined.cut
    yield f"** {model.section_words} of {model.material_words}; N, mm, t; z upwards"
    yield "*NODE, NSET=ALL"
    for node in cut.used.tolist():
        x, y, z = cut.frame.nodes[node].tolist()
        yield f"{node + 1}, {x:.9g}, {y:.9g}, {z:.9g}"
    yield "*ELEMENT, TYPE=B32R, ELSET=MEMBERS"
    for number, (one, middle, two) in enumerate(cut.elements.tolist(), 1):
        yield f"{number}, {one + 1}, {middle + 1}, {two + 1}"
    yield from _materials(model, len(joined.frame.members))
    yield from _sections(model, joined.frame, sections)
    yield from joined.link_lines(model)
    yield "*BOUNDARY"
    for node in np.flatnonzero(model.supports.fixed.any(axis=1)).tolist():
        for direction in np.flatnonzero(model.supports.fixed[node]).tolist():
            yield f"{node + 1}, {direction + 1}"
    for case in model.cases:
        yield f"** {case.name}"
        yield "*STEP"
        yield "*STATIC"
        yield "*CLOAD, OP=NEW"
        force = joined.forces(case.loads)
        for node, direction in np.argwhere(force != 0).tolist():
            yield f"{node + 1}, {direction + 1}, {force[node, direction]:.9g}"
        yield "*NODE FILE, OUTPUT=2D"
        yield "U, RF"
        yield "*NODE PRINT, NSET=ALL"
        yield "U"
        yield "*END STEP"


def _with_pins(model: Model) -> tuple[Frame, IntArray]:
    """The frame with a pin in every arm that turns, and nodes (K, 2) that move together.

    The arm leaves the vertex for a node of its own there; the pin runs from the vertex to a new
    node where the arm ends.
    """
    frame = model.frame
    turning = np.flatnonzero(frame.springs[:, _TURN] == 0)
    if not len(turning):
        return frame, np.empty((0, 2), dtype=np.int64)
    vertex, end = frame.members[turning].T
    own = len(frame.nodes) + np.arange(len(turning))
    tip = own + len(turning)
    members = np.concatenate([frame.members, np.stack([vertex, tip], axis=1)])
    members[turning, 0] = own
    every = np.concatenate([np.arange(len(frame.members)), turning])
    pinned = replace(
        frame,
        nodes=np.concatenate([frame.nodes, frame.nodes[vertex], frame.nodes[end]]),
        members=members,
        stiffness=frame.stiffness.taken(every),
        up=frame.up[every],
        springs=_without_turning(frame.springs[every]),
    )
    pairs = [np.stack([own, vertex], axis=1), np.stack([tip, end], axis=1)]
    return pinned, np.concatenate(pairs)


def _without_turning(springs: FloatArray) -> FloatArray:
    """Springs of which those that pins are for are rigid."""
    found = springs.copy()
    found[found[:, _TURN] == 0, _TURN] = np.inf
    return found


def _materials(model: Model, members: int) -> Iterator[str]:
    for number, group in enumerate(model.groups, 1):
        material = group.material
        poisson = material.youngs_modulus / (2 * material.shear_modulus) - 1
        # What has fibres shears more than any Poisson's ratio says; 0.49 is the most there is.
        elastic = f"{material.youngs_modulus:g}, {min(poisson, 0.49):.6g}"
        yield from _material(f"MATERIAL{number}", elastic, f"{material.density * 1e-12:g}")
    if members > len(model.families):
        stiff = ARM * float(model.bare.stiffness.youngs.max())
        # Arms weigh nothing.
        yield from _material("ARMS", f"{stiff:g}, 0.3", "1e-20")


def _material(name: str, elastic: str, density: str) -> Iterator[str]:
    yield f"*MATERIAL, NAME={name}"
    yield "*ELASTIC"
    yield elastic
    yield "*DENSITY"
    yield density


def _sections(model: Model, frame: Frame, sections: Sequence[tuple[str, str]]) -> Iterator[str]:
    numbers = np.arange(1, PIECES * len(frame.members) + 1).reshape(-1, PIECES)
    up, of_group = frame.axes[:, 2], model.section_numbers.tolist()
    side = arm_side(model)
    for member, (x, y, z) in enumerate(up.tolist()):
        if member < len(of_group):
            name, material = f"M{member + 1}", f"MATERIAL{of_group[member] + 1}"
            kind, sizes = sections[of_group[member]]
        else:
            name, material = f"ARM{member + 1 - len(of_group)}", "ARMS"
            kind, sizes = "RECT", f"{side:g}, {side:g}"
        yield f"*ELSET, ELSET={name}"
        yield ", ".join(map(str, numbers[member].tolist()))
        yield f"*BEAM SECTION, ELSET={name}, MATERIAL={material}, SECTION={kind}"
        yield sizes
        yield f"{x:.9g}, {y:.9g}, {z:.9g}"
