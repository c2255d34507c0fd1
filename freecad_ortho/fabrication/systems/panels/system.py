"""The system of panels: settings, parts and report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import (
    check_options,
    offset_levels,
    size,
)
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.panels.bearing import (
    at_the_edge,
    bearings,
    least_bearing,
    measures_of,
)
from freecad_ortho.fabrication.systems.panels.border import at_border
from freecad_ortho.fabrication.systems.panels.build_ups import build_up_report
from freecad_ortho.fabrication.systems.panels.cassette import Fold, fold_report, refuse_brittle
from freecad_ortho.fabrication.systems.panels.cold import ColdBent, bending_report
from freecad_ortho.fabrication.systems.panels.frame import Covered
from freecad_ortho.fabrication.systems.panels.framing import FRAMES, Framing
from freecad_ortho.fabrication.systems.panels.geometry import (
    PanelGeometry,
    neighbours,
    panel_geometry,
)
from freecad_ortho.fabrication.systems.panels.hubs import Stands
from freecad_ortho.fabrication.systems.panels.mixed import mixed_panels
from freecad_ortho.fabrication.systems.panels.parts import panel_parts
from freecad_ortho.fabrication.systems.panels.way_in import closing, inward_normals, judged
from freecad_ortho.fabrication.systems.panels.words import (
    UNDER_BEAMS,
    faces_down,
    gap_words,
    messages_of,
    report_of,
)
from freecad_ortho.fabrication.systems.shared_options import (
    CLEARANCE,
    LEAST_WIDTH,
    OFFSET,
    PANEL_THICKNESS,
    joint,
    plate_thickness,
)
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, SameSize
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import Option, Range

EDGES = ("square", "bevel")
AT_HUBS = ("cut", "lift")
SLIVERS = ("join", "leave-out")
BENDINGS = ("none", "cold")
_GAP = 8.0


@dataclass(frozen=True)
class Panels(System):
    """A plate of this thickness in every face.

    Args:
        thickness: plate thickness, mm.
        gap: joint between neighbours measured on the mesh, mm; each side shrinks by half of it.
        offset: along the face normal the panels occupy ``[0, thickness]`` (above), half to each
            side (centre) or ``[-thickness, 0]`` (below); with beams they lie on top instead.
        edge: "square" to the panel, or "bevel": parallel to the beams, towards the node axes.
        at_hubs: "cut" corners of panels off beside hubs, or "lift" panels over them; without beams
            corners are cut off whatever it says.
        clearance: between hubs and corners that are cut off beside them, mm.
        least_width: pieces at the border are slivers where no circle of this diameter fits in, mm.
        slivers: "join" makes them part of a neighbour whose plane goes on over them 0 to 5 mm above
            theirs, others and those of bevelled panels are left out; "leave-out" leaves all out.
        frame: "plate": pressure plates and caps along the edges hold them, which say how wide the
            joints are; "silicone": adapters that they are glued onto; "none".
        frame_width: of pressure plates, mm; by default 50.
        edge_cover: how far panels reach under these, mm; by default 15. Where neither is given both
            are larger where the panels' material needs it.
        gasket: thickness of the gaskets below and above panels in frames, mm.
        bite: width of joints of structural silicone, mm.
        fold: depth by which the edges of metal panels are folded down, mm; 0 for none.
        bend_radius: inside of these folds, mm, by default as large as the thickness.
        k_factor: of these folds, 0 for that of DIN 6935.
        bending: "cold": panels are flat plates that are pressed into faces that are not planar;
            "none": they are the faces' best planes.

    Raises:
        InputError: a length that is not positive and finite, or an unknown offset.
    """

    thickness: float
    gap: float
    offset: str = "centre"
    edge: str = "square"
    at_hubs: str = "cut"
    clearance: float = 1.0
    least_width: float = 60.0
    slivers: str = "join"
    frame: str = "none"
    frame_width: float | None = None
    edge_cover: float | None = None
    gasket: float = 5.0
    bite: float = 12.0
    bending: str = "none"
    fold: float = 0.0
    bend_radius: float | None = None
    k_factor: float = 0.0

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "panels"
    options: ClassVar[tuple[Option, ...]] = (
        plate_thickness(12.0),
        PANEL_THICKNESS,
        joint(_GAP),
        OFFSET,
        Option(
            "panel_edge",
            "square",
            "choice",
            "the sides of the panels are square, or bevelled along the beams",
            EDGES,
        ),
        Option(
            "at_hubs",
            "cut",
            "choice",
            "the panels' corners are cut off beside hubs, or the panels lifted over them",
            AT_HUBS,
        ),
        CLEARANCE,
        LEAST_WIDTH,
        Option(
            "slivers",
            "join",
            "choice",
            "slivers at the border become part of their neighbours where they can, or are left out",
            SLIVERS,
        ),
        Option(
            "frame",
            "none",
            "choice",
            "pressure plates and caps hold the panels, or structural silicone on adapters",
            FRAMES,
        ),
        Option(
            *("frame_width", None, "length"),
            "pressure plates and caps are this wide, by default 50 mm or as wide as glass needs",
        ),
        Option(
            *("edge_cover", None, "length"),
            "panels reach this far under pressure plates, by default 15 mm or as glass needs",
        ),
        size("gasket", 5.0, "gaskets below and above framed panels are this thick"),
        size("bite", 12.0, "joints of structural silicone are this wide"),
        Option(
            "bending",
            "none",
            "choice",
            "the panels are flat, or bent cold into faces that are not planar",
            BENDINGS,
        ),
        Option(
            *("fold", 0.0, "length", "edges of metal panels are folded down by this"),
            absent="none",
        ),
        Option(
            *("bend_radius", None, "length"),
            "folds have this radius inside, by default that of the thickness",
        ),
        Option(
            *("k_factor", 0.0, "number"),
            "folds keep the length of the fibre at this part of the thickness, 0: by DIN 6935",
            within=Range(0.0, 0.5),
        ),
    )

    def __post_init__(self) -> None:
        check_options(self, self.options, thickness="panel_thickness", edge="panel_edge")
        if self.folding is not None and (
            (self.edge, self.bending) != ("square", "none") or self.frame == "silicone"
        ):
            raise InputError(
                "fold: cassettes have square edges, are not bent cold and are not glued on; leave "
                "one of both out"
            )
        if self.bending == "cold" and self.edge != "square":
            raise InputError(
                "bending: bevelled panels cannot be bent cold; take square edges or none"
            )
        if self.bending == "cold" and self.frame == "silicone":
            raise InputError(
                "bending: panels that are bent cold pull at structural silicone for ever; hold "
                "them by frame plate, or leave one of both out"
            )
        # Refuses what cannot be held so.
        _ = self.framing

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Panels:
        """Make the settings from options; panels are as thick as the beams unless told."""
        plate = values["panel_thickness"]
        plate = values["thickness"] if plate is None else plate
        names = "gap offset panel_edge at_hubs clearance least_width slivers"
        own = "frame frame_width edge_cover gasket bite bending fold bend_radius k_factor"
        return cls(plate, *(values[name] for name in f"{names} {own}".split()))

    @property
    def joint(self) -> float:
        """Between neighbours, mm: the gap, or what a frame makes it."""
        return self.framing.joint(self.gap)

    @property
    def unheeded(self) -> tuple[str, ...]:
        """Words on a gap that was given beside a frame, which makes the joint."""
        if self.gap in (_GAP, self.joint):
            return ()
        return gap_words(self.framing.width, self.framing.cover, self.joint, self.gap)

    @property
    def folding(self) -> Fold | None:
        """How the edges are folded, None where they are not."""
        if not self.fold:
            return None
        radius = self.thickness if self.bend_radius is None else self.bend_radius
        return Fold(self.fold, radius, self.thickness, self.k_factor or None)

    @property
    def below(self) -> tuple[float, float]:
        """From what carries panels to them, and the depth of what is along their sides, mm."""
        deep = self.fold - self.thickness if self.fold else 0.0
        return self.framing.bed + deep, max(self.framing.depth, deep)

    @cached_property
    def framing(self) -> Framing:
        """How the panels are held."""
        return Framing(
            *(self.frame, self.frame_width, self.edge_cover, self.gasket, self.bite),
        )

    @property
    def levels(self) -> tuple[float, float]:
        """Lower and upper level along the face normal, mm from the mesh."""
        return offset_levels(self.offset, self.thickness)

    def build(self, site: Site) -> SystemParts:
        """Work out the panels, on the beams and clear of the hubs where there are some.

        Raises:
            InputError: a face that the gap or the hubs leave nothing of, or no panel that the
                border leaves.
        """
        if self.folding is not None:
            refuse_brittle(site.material)
        beams = site.geometry_of("beams", BeamGeometry)
        if site.mesh.connectivity.mixed:
            return self._mixed(site, beams)
        edge_beam = site.geometry_of("edge-beam", EdgeGeometry)
        mesh, levels = self._bed(site, beams, edge_beam)
        inward = inward_normals(site) if self.edge == "bevel" else None
        whole = np.ones(len(mesh.faces), dtype=bool)
        geometry = panel_geometry(
            *(mesh, levels, self.joint, beams, inward, self._stands(site, beams)),
            wanted=whole if site.trimming is None else site.trimming.made,
            bed=self.below[0],
            depth=self.below[1],
        )
        least = None if beams is None else self._bearing(site, geometry, beams, edge_beam)
        gaps = diagonal_distances(site.mesh)
        cold = None if self.bending == "none" else ColdBent.of(geometry.planes, mesh)
        measures = measures_of(gaps, least)
        if cold is not None:
            measures = cold.measured(measures, site.material, self.thickness)
        join = self.slivers == "join" and self.edge == "square"
        formed = cold if self.folding is None else self.folding
        loose = None if edge_beam is None or least is None else least <= 0
        sizes = self.thickness, measures, self.least_width
        laid = panel_parts(site, geometry, *sizes, join, formed, loose)
        if not laid.parts:
            raise InputError(
                "panels: the border leaves no piece that is wide enough or can be made of "
                f"{site.material.name}; take a smaller least width or larger faces"
            )
        parts, doubts = laid.parts, list[str]()
        made = ~whole
        made[[part.face for part in parts if part.face is not None]] = True
        if inward is not None:
            parts, doubts = self._put_in(parts, mesh, geometry, inward, made, beams is not None)
        rims = [(each.below(self.framing.depth), each.above) for each in laid.layers]
        bow = np.zeros(len(made)) if cold is None else cold.bow
        held = self.framing.held(
            *(site, geometry, parts, rims),
            Covered(made | (laid.onto >= 0), bow + laid.above, laid.onto),
            beams,
        )
        report = report_of(self, geometry, made, least, parts) | sums((*parts, *held.parts))
        report |= held.report or {}
        if site.trimming is not None:
            on_edge, carried = edge_beam is not None, (made, least)
            kept = self.least_width, on_edge, site.material
            more, words = at_border(laid, site.trimming, carried, *kept)
            report, doubts = report | more, doubts + words
        gap = 0.0 if cold is not None else float(gaps[made].max())
        messages = (*messages_of(report, gap, site.material), *self.unheeded, *doubts)
        messages += held.messages
        if beams is not None and faces_down(site.mesh):
            messages += (UNDER_BEAMS,)
        tables = held.tables
        if cold is not None:
            report |= bending_report(parts)
            tables = (cold.table(parts), *tables)
        if self.folding is not None:
            report |= fold_report(self.folding, parts)
        if site.material.layers:
            report |= build_up_report(site.material, parts)
            tables = (laid.table, *tables)
        found = SystemParts((*parts, *held.parts), report, messages, geometry, tables=tables)
        return replace(found, supplies=held.supplies, loose=held.loose)

    def _mixed(self, site: Site, beams: BeamGeometry | None) -> SystemParts:
        """The panels of faces of several sizes."""
        mesh, levels = self._bed(site, beams, None)
        stands = self._stands(site, beams)

        def making(same: SameSize) -> PanelGeometry:
            return panel_geometry(mesh, levels, self.joint, beams, None, stands, same=same)

        return mixed_panels(self, site, making, beams)

    def _stands(self, site: Site, beams: BeamGeometry | None) -> Stands | None:
        """Hubs in the way of panels."""
        hubs = site.geometry_of("nodes", dict)
        if hubs is None:
            return None
        return Stands(hubs, self.at_hubs == "cut" or beams is None, self.clearance)

    def _bearing(
        self,
        site: Site,
        geometry: PanelGeometry,
        beams: BeamGeometry,
        edge_beam: EdgeGeometry | None,
    ) -> FloatArray:
        """(F,) least width of each panel on its beams, mm."""
        widths = bearings(site.mesh.connectivity, beams, geometry.lower_edges())
        if edge_beam is not None:
            widths = np.concatenate([widths, at_the_edge(site, edge_beam, self.joint)], axis=1)
        if site.material.layers:
            widths = widths - site.material.layers[-1].step
        return least_bearing(widths)

    def _put_in(
        self,
        parts: tuple[Part, ...],
        mesh: QuadMesh,
        geometry: PanelGeometry,
        inward: FloatArray,
        made: BoolArray,
        on_beams: bool,
    ) -> tuple[tuple[Part, ...], list[str]]:
        """Bevelled panels with what keeps them from being put in between their neighbours."""
        across = neighbours(mesh.connectivity)
        beside = (across >= 0) & made[across]
        normals = geometry.planes.frame[:, 2]
        closes = closing(normals, inward, beside, self.thickness, self.joint)
        if not on_beams:
            below = closing(-normals, inward, beside, self.thickness, self.joint)
            closes = np.minimum(closes, below)
        faces = [part.face for part in parts if part.face is not None]
        return judged(parts, closes[faces], self.joint)

    def _bed(
        self, site: Site, beams: BeamGeometry | None, edge_beam: EdgeGeometry | None
    ) -> tuple[QuadMesh, tuple[float, float]]:
        """The net that the panels lie on, and their levels above it."""
        tops = [] if beams is None else [beams.levels[1]]
        tops += [] if edge_beam is None else [edge_beam.top]
        if not tops:
            return site.mesh, self.levels
        raised = site.mesh.vertices + tops[0] * site.axes.offsets
        bed = self.below[0]
        return site.mesh.with_vertices(raised), (bed, bed + self.thickness)
