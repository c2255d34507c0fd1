"""The system of nodes: settings, parts, equal ones, report."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.equal import equal_groups
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import OFFSETS, check_offset, check_size, offset_levels
from freecad_ortho.fabrication.systems.beams.frames import (
    Around,
    Frames,
    around_axes,
    beam_frames,
)
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.beams.system import Beams
from freecad_ortho.fabrication.systems.edge_beam.hubs import without_hubs
from freecad_ortho.fabrication.systems.nodes.hubs import face_widths, hub
from freecad_ortho.fabrication.systems.nodes.sockets import least_radius, socket
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.option import Option

KINDS = ("hub", "socket")


@dataclass(frozen=True)
class Nodes(System):
    """A joint at every vertex: a hub that beams are butted on, or a socket under a crossing.

    Where there are beams, these say how high and thick they are, what lies above the net, how much
    room is left, and how wide the hubs are that they end at.

    Args:
        kind: "hub", a prism about the axis with a face square to each beam, as high as the beams;
            "socket", a printed disc under the beams with a slot for each plate.
        diameter: of the hub across its faces, or of the disc, mm.
        bore: diameter of a hole along the hub's axis, mm; 0 for none.
        depth: how far plates stand in a socket, mm; its disc is a third as thick.
        height: of the beams, mm.
        thickness: of the beams, mm.
        offset: of the beams.
        clearance: on both sides of a plate in a socket together, and below it, mm.
        boundary_beams: false where the edges of the boundary have no beams.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    kind: str = "hub"
    diameter: float = 100.0
    bore: float = 0.0
    depth: float = 30.0
    height: float = 200.0
    thickness: float = 20.0
    offset: str = "centre"
    clearance: float = 1.0
    boundary_beams: bool = True

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "nodes"
    options: ClassVar[tuple[Option, ...]] = (
        Option("node", "hub", "choice", "the beams are joined by hubs or sockets", KINDS),
        Option("hub_diameter", 100.0, "length", "hubs or sockets measure this across their faces"),
        Option(
            "bore",
            0.0,
            "length",
            "the hubs have a hole of this diameter along their axis",
            absent="none",
        ),
        Option("socket_depth", 30.0, "length", "the plates stand this deep in the sockets"),
        Option("height", 200.0, "length", "the beams are this high"),
        Option("thickness", 20.0, "length", "the plates are this thick"),
        Option(
            "offset",
            "centre",
            "choice",
            "the parts lie above the net, about it or below it",
            OFFSETS,
        ),
        Option("clearance", 1.0, "length", "slots and hubs leave this much air"),
        Option("no_boundary_beams", False, "flag", "no beams are made along the boundary"),
    )

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise InputError(f"node: expected one of {', '.join(KINDS)}, got '{self.kind}'")
        for words, value in (
            ("hub diameter", self.diameter),
            ("socket depth", self.depth),
            ("beam height", self.height),
            ("beam thickness", self.thickness),
        ):
            check_size(words, value)
        check_offset(self.offset)
        if not 0 <= self.clearance < float("inf"):
            raise InputError(f"clearance: expected 0 mm or more, got {self.clearance:g}")
        if not 0 <= self.bore < 0.8 * self.diameter:
            raise InputError(
                f"bore: expected 0 to {0.8 * self.diameter:g} mm in a hub of {self.diameter:g} mm, "
                f"got {self.bore:g}"
            )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Nodes:
        """Make the settings from options."""
        given = dict(values)
        given["boundary_beams"] = not given.pop("no_boundary_beams")
        names = {"kind": "node", "diameter": "hub_diameter", "depth": "socket_depth"}
        return cls(**{own: given.pop(option) for own, option in names.items()}, **given)

    def build(self, site: Site) -> SystemParts:
        """Work out the joints at the vertices of the chosen edges.

        Raises:
            InputError: a hub too small for its beams, or beams that leave it no room.
        """
        beams = site.done["beams"].settings if "beams" in site.done else None
        return self._fitting(beams)._build(site) if isinstance(beams, Beams) else self._build(site)

    def _fitting(self, beams: Beams) -> Nodes:
        """These joints with the sizes of the beams that they join."""
        if self.kind == "hub" and beams.ends != "hub":
            raise InputError(
                f"nodes: the beams are {beams.ends} and leave no room for hubs; set ends hub, or "
                "take sockets for nodes"
            )
        if self.kind == "socket" and (beams.ends == "hub" or beams.section != "plate"):
            raise InputError(
                "nodes: sockets hold plates that reach their axes; set section plate and ends "
                "mitred or lapped, or take hubs for nodes"
            )
        return replace(
            self,
            diameter=beams.hub_diameter if self.kind == "hub" else self.diameter,
            height=beams.height,
            thickness=beams.profile.overall_width,
            offset=beams.offset,
            clearance=beams.clearance,
            boundary_beams=beams.boundary_beams,
        )

    def _build(self, site: Site) -> SystemParts:
        frames = beam_frames(site.mesh, site.axes)
        built = site.chosen_edges.copy()
        if not self.boundary_beams:
            built &= ~site.mesh.connectivity.boundary_edges
        within = np.ones(len(site.mesh.vertices), dtype=bool)
        if site.trimming is not None:
            beams = site.geometry_of("beams", BeamGeometry)
            kept = np.isin(np.arange(len(built)), list(site.trimming.spans))
            built &= kept if beams is None else beams.built
            within = site.trimming.vertices(site.mesh.connectivity.edges)
        within &= ~without_hubs(site, self.diameter)
        if not built.any():
            return SystemParts(())
        around = around_axes(site.mesh, site.axes, frames.along, built)
        names = part_names("N", len(site.mesh.vertices))
        parts = tuple(
            self._part(site, names[vertex], vertex, arms, turn)
            for vertex, arms, turn in _stars(frames, around)
            if within[vertex]
        )
        groups = {
            parts[group[0]].name: [parts[number].name for number in group]
            for group in equal_groups(parts)
        }
        report = {
            "kind": self.kind,
            "diameter_mm": self.diameter,
            "different": len(groups),
            "equal": {name: some for name, some in groups.items() if len(some) > 1},
            **sums(parts),
        }
        joints = tuple(part for part in parts if part.name in groups)
        return SystemParts(parts, report, geometry=self._hubs(site, parts), joints=joints)

    def _hubs(self, site: Site, parts: tuple[Part, ...]) -> dict[int, FloatArray]:
        """(2, K, 3) lower and upper corners of the hub at each vertex, in the site's mesh, mm."""
        if self.kind != "hub":
            return {}
        return {part.vertices[0]: (part.points - site.shift).reshape(2, -1, 3) for part in parts}

    def _part(self, site: Site, name: str, vertex: int, arms: FloatArray, turn: FloatArray) -> Part:
        axis = site.axes.directions[vertex]
        length = float(np.linalg.norm(site.axes.offsets[vertex]))
        body = self._body(name, turn, arms @ axis, length)
        return Part(
            name=name,
            kind="node",
            body=body,
            origin=site.mesh.vertices[vertex] + site.shift,
            frame=_frame(arms[0], axis),
            pattern=None,
            length=float(np.ptp(body.points[:, 2])),
            width=self.diameter,
            thickness=self.diameter,
            area=0.0,
            volume=body.volume,
            material=site.material,
            vertices=(vertex,),
            measures=Measures(lean_deg=float(site.axes.lean_deg[vertex])),
        )

    def _body(self, name: str, turn: FloatArray, rises: FloatArray, length: float) -> Body:
        """Body of one joint: directions of its beams, their rise, and length of its offset."""
        radius = self.diameter / 2
        low, high = (level * length for level in offset_levels(self.offset, self.height))
        if self.kind == "hub":
            narrow = float(face_widths(turn, radius).min())
            if narrow < self.thickness:
                raise InputError(
                    f"hub: {name} has {narrow:.1f} mm for beams {self.thickness:g} mm thick; take "
                    f"at least {self.diameter * self.thickness / narrow:.0f} mm hub diameter"
                )
            return hub(turn, radius, low, high, self.bore)
        half = (self.thickness + self.clearance) / 2
        least = 1.2 * least_radius(turn, half)
        if radius < least:
            raise InputError(
                f"hub: the socket {name} leaves no pillars between plates {self.thickness:g} mm "
                f"thick; take at least {2 * least:.0f} mm hub diameter"
            )
        # Undersides of plates that slope down from the axis stay above the disc.
        slopes = rises / np.sqrt(1 - rises**2)
        floor = low + min(0.0, float(slopes.min())) * radius - self.clearance / 2
        levels = np.array([floor - self.depth / 3, floor, floor + self.depth])
        return socket(turn, radius, half, levels)


def _stars(frames: Frames, around: Around) -> Iterator[tuple[int, FloatArray, FloatArray]]:
    """For each vertex its number, the (K, 3) directions of its beams and (K,) their angles.

    Counter-clockwise from the half-edge with the smallest number.
    """
    half_edges = np.flatnonzero(around.left >= 0)
    order = half_edges[np.argsort(around.vertex[half_edges], kind="stable")]
    for group in np.split(order, np.flatnonzero(np.diff(around.vertex[order])) + 1):
        ring = [int(group.min())]
        while (ahead := int(around.left[ring[-1]])) != ring[0]:
            ring.append(ahead)
        count = len(frames.along)
        outward = np.where(np.array(ring) < count, 1.0, -1.0)[:, None]
        turn = np.concatenate([[0.0], np.cumsum(around.angle[ring[:-1]])])
        yield int(around.vertex[ring[0]]), outward * frames.along[np.array(ring) % count], turn


def _frame(arm: FloatArray, axis: FloatArray) -> FloatArray:
    """(3, 3) x towards the first beam, z along the axis."""
    first = unit_rows((arm - (arm @ axis) * axis)[None])[0]
    return np.stack([first, np.cross(axis, first), axis])
