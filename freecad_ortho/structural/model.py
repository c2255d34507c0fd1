"""The frame of a net: members on its edges, their sections turned by the axes, its load cases."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from freecad_ortho.structural.design import Design
from freecad_ortho.structural.groups import Group, groups_of
from freecad_ortho.structural.layers import off_the_net
from freecad_ortho.structural.stances import axes_of, heights_of
from freecad_ortho.structural.supports import supports_of
from solver.errors import InputError
from solver.frame.model import Frame, Loads, Stiffness, Supports
from solver.frame.panels import ShearPanels
from solver.mesh.connectivity import IntArray
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Acceleration of gravity, m/s2, as EN 1991-1-1, annex A, has weights.
GRAVITY = 9.81
# kN/m2 in MPa.
_MPA = 1e-3
PERMANENT, SNOW, WIND, IMPOSED = "permanent", "snow", "wind", "imposed"


@dataclass(frozen=True, eq=False)
class Case:
    """Loads that come and go together.

    Attributes:
        name: as in the tables.
        kind: permanent, snow, wind or imposed, by which combinations take it.
        loads: N and mm.
    """

    name: str
    kind: str
    loads: Loads


@dataclass(frozen=True, eq=False)
class Model:
    """What is checked, in N, mm and MPa.

    Attributes:
        mesh: the net, mm; its vertices are the first nodes, its edges the first members.
        design: what it was made from.
        groups: of members, each with its section; every member is in one.
        frame: of members; after them the arms of those that are not on the net.
        supports: of the nodes.
        cases: of loads.
        families: (M,) of each member, ``u``, ``v`` or ``border``; ``inner`` where these do not
            tell. Or the groups that were asked for.
    """

    mesh: QuadMesh
    design: Design
    groups: tuple[Group, ...]
    frame: Frame
    supports: Supports
    cases: tuple[Case, ...]
    families: tuple[str, ...]

    @property
    def span(self) -> float:
        """Second longest side of the nodes' box, mm: of a roof the shorter one in plan."""
        used = self.mesh.vertices[self.mesh.connectivity.referenced]
        return float(np.sort(np.ptp(used, axis=0))[1])

    @cached_property
    def bare(self) -> Frame:
        """The members alone, without arms; all nodes."""
        frame, own = self.frame, np.arange(len(self.families))
        return replace(
            frame,
            members=frame.members[own],
            stiffness=frame.stiffness.taken(own),
            up=frame.up[own],
            springs=frame.springs[own],
        )

    @property
    def mass(self) -> float:
        """Of all members by their length from node to node, kg."""
        lengths = self.bare.lengths
        return sum(
            group.material.mass(group.profile.area * float(lengths[group.members].sum()))
            for group in self.groups
        )

    @property
    def section_numbers(self) -> IntArray:
        """(M,) which of the groups each member is in."""
        return np.asarray(np.argmax([group.members for group in self.groups], axis=0))

    @property
    def section_words(self) -> str:
        """Names of the sections, with the groups that have them."""
        words = (f"{group.profile.name} {group.name}".strip() for group in self.groups)
        return ", ".join(words)

    @property
    def material_words(self) -> str:
        """Names of the materials."""
        return ", ".join(dict.fromkeys(group.material.name for group in self.groups))


def model_of(mesh: QuadMesh, design: Design, groups: Sequence[str] | None = None) -> Model:
    """Make the frame and the load cases.

    Args:
        mesh: the net, mm, z upwards.
        design: members, supports and loads.
        groups: (M,) names of groups that ``design.section`` speaks of; by default the families.

    Raises:
        InputError: what cannot be used, or no load at all.
    """
    words = families_of(mesh) if groups is None else tuple(groups)
    sections = groups_of(design.section, design.material, words)
    frame = _frame(mesh, sections, design)
    supports = supports_of(design.supports, mesh.connectivity).followed_by(len(frame.nodes))
    cases = tuple(_cases(mesh, frame, design, sections))
    if not cases:
        raise InputError("loads: there are none; give snow, wind, panels or a load")
    return Model(mesh, design, sections, frame, supports, cases, words)


def families_of(mesh: QuadMesh) -> tuple[str, ...]:
    """``u``, ``v``, ``border`` or ``inner`` for every edge."""
    border = mesh.connectivity.boundary_edges
    family = ParameterLines.of(mesh).edge_family
    return tuple(
        "border" if border[k] else ("u", "v", "inner")[family[k]] for k in range(len(border))
    )


def _frame(mesh: QuadMesh, groups: Sequence[Group], design: Design) -> Frame:
    members = np.asarray(mesh.connectivity.edges)
    count = len(members)
    axes = axes_of(mesh, design.position)
    springs = np.full((count, 12), np.inf)
    springs[:, [4, 5, 10, 11]] = design.joint_spring()

    def each(value: Callable[[Group], float]) -> FloatArray:
        found = np.empty(count)
        for group in groups:
            found[group.members] = value(group)
        return found

    stiffness = Stiffness(
        area=each(lambda group: group.profile.area),
        about_y=each(lambda group: group.profile.inertia_y),
        about_z=each(lambda group: group.profile.inertia_z),
        torsion=each(lambda group: group.profile.torsion),
        youngs=each(lambda group: group.material.youngs_modulus),
        shear=each(lambda group: group.material.shear_modulus),
        shear_area_y=each(lambda group: group.profile.shear_area_y),
        shear_area_z=each(lambda group: group.profile.shear_area_z),
    )
    panels = ShearPanels()
    if design.panel_shear:
        faces = np.asarray(mesh.faces)
        panels = ShearPanels.of_shear(mesh.vertices, faces, 1000.0 * design.panel_shear)
    up = heights_of(mesh, axes, design.position)
    on_net = Frame(mesh.vertices, members, stiffness, up, springs, panels)
    return off_the_net(on_net, mesh, axes, design)


def _cases(mesh: QuadMesh, frame: Frame, design: Design, groups: Sequence[Group]) -> list[Case]:
    found = []
    area = mesh.face_area_vectors
    # Outwards is upwards, over the whole.
    area = area if area[:, 2].sum() >= 0 else -area
    size = np.linalg.norm(area, axis=1)
    down = np.array([0.0, 0.0, -1.0])
    if design.self_weight:
        loads = Loads.none(frame)
        for group in groups:
            weight = group.material.mass(1.0) * group.profile.area * GRAVITY
            loads.spread[np.flatnonzero(group.members)] = weight * down
        found.append(Case("self-weight", PERMANENT, loads))
    if design.panels:
        force = design.panels * _MPA * size[:, None] * down
        found.append(Case("panels", PERMANENT, _on_members(mesh, frame, force)))
    if design.snow:
        force = design.snow * _MPA * np.abs(area[:, 2:]) * down
        found.append(Case("snow", SNOW, _on_members(mesh, frame, force)))
        side = design.chosen_side()
        if side is not None:
            middle = mesh.vertices[mesh.faces].mean(axis=1) @ side
            half = middle > 0.5 * (middle.min() + middle.max())
            found.append(
                Case("snow on one half", SNOW, _on_members(mesh, frame, force * half[:, None]))
            )
    for pressure, direction, name in design.winds():
        normal = area / np.where(size > 0, size, 1.0)[:, None]
        force = pressure * _MPA * (normal @ direction)[:, None] * area
        found.append(Case(name, WIND, _on_members(mesh, frame, force)))
    points = design.points()
    if points:
        loads = Loads.none(frame)
        for vertex, force in points:
            count = mesh.connectivity.vertex_count
            if not (vertex < count and mesh.connectivity.referenced[vertex]):
                raise InputError(
                    f"load: there is no vertex {vertex} in the net; it has {count}, counted from 0"
                )
            loads.nodal[vertex, :3] += 1000.0 * force
        found.append(Case("point loads", IMPOSED, loads))
    return found


def _on_members(mesh: QuadMesh, frame: Frame, force: FloatArray) -> Loads:
    """Hand forces on faces (F, 3) to their edges, each the part of the face that is nearest to it.

    Spread evenly along the edge. The parts are the triangles between edges and the face's middle.
    """
    corners = mesh.vertices[mesh.faces]
    middle = corners.mean(axis=1)
    ahead = np.roll(corners, -1, axis=1)
    parts = np.linalg.norm(np.cross(corners - middle[:, None], ahead - middle[:, None]), axis=2)
    parts = parts / np.maximum(parts.sum(axis=1), 1e-300)[:, None]
    shares = (parts[:, :, None] * force[:, None, :]).reshape(-1, 3)
    edges = mesh.connectivity.face_edges.reshape(-1)
    count = len(frame.members)
    total = np.stack([np.bincount(edges, shares[:, c], count) for c in range(3)], axis=1)
    return Loads(np.zeros((len(frame.nodes), 6)), total / frame.lengths[:, None])
