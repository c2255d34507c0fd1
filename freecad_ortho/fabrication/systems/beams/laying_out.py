"""Where beams lie and end, before parts are made of them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.bolts import bolt_of
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.ball_tubes import with_tubes
from freecad_ortho.fabrication.systems.beams.balls import BallJoints, smallest_angles
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.fins import FinPlates, runs_through
from freecad_ortho.fabrication.systems.beams.frames import Around, Frames, around_axes, beam_frames
from freecad_ortho.fabrication.systems.beams.geometry import (
    BeamGeometry,
    Cuts,
    beam_geometry,
    clear_of_through,
    coped,
    hub_distance,
    mitred,
    square,
)
from freecad_ortho.fabrication.systems.beams.lines import Crossings, half_laps
from freecad_ortho.fabrication.systems.beams.options import COPED, SPLICED
from freecad_ortho.fabrication.systems.beams.rolled import RolledSection
from freecad_ortho.fabrication.systems.beams.room import refuse_short, refuse_width
from freecad_ortho.fabrication.systems.beams.running import Running
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.settings import BeamSettings
from freecad_ortho.fabrication.systems.edge_beam.hubs import without_hubs
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

Bolted = EndPlates | CoverPlates | BallJoints


@dataclass(frozen=True, eq=False)
class LaidOut:
    """Where beams lie and end, before parts are made of them.

    Attributes:
        geometry: of all of them.
        built: (E,) which edges have a beam, and which of these are wanted; (E,) as well.
        folded: (E,) which are parts of folded plates along lines.
        laps: half laps of these.
        border: where a border cuts them.
        stubs: names of those that are left out there.
        misfit: (V,) how far lower sides lie apart, mm, of a section of the catalogue.
    """

    geometry: BeamGeometry
    built: BoolArray
    wanted: BoolArray
    folded: BoolArray
    laps: Crossings | None
    border: BorderEnds | None
    stubs: tuple[str, ...]
    misfit: FloatArray | None


def laid_out(beams: BeamSettings, site: Site) -> LaidOut | None:
    """Where beams lie and end; None where none is wanted.

    Raises:
        NoRoom: an edge too short for what stands at its ends.
        InputError: other sizes that do not fit the net.
    """
    section = beams.profile
    rolled = section if isinstance(section, RolledSection) else None
    frames = beam_frames(site.mesh, site.axes)
    built = np.ones(len(site.mesh.connectivity.edges), dtype=bool)
    if not beams.boundary_beams:
        built = ~site.mesh.connectivity.boundary_edges
    border = BorderEnds.of(site, frames, beams.levels, section.overall_width / 2)
    if border is not None:
        built &= border.within
    wanted = site.chosen_edges & built
    if not wanted.any():
        return None
    around = around_axes(site.mesh, site.axes, frames.along, built)
    bolted = _bolted(beams, site, frames, built)
    cuts, folded, laps = _cuts(beams, site, frames, around, built, bolted)
    width = section.overall_width
    stubs: tuple[str, ...] = ()
    if border is not None:
        left = border.lengths(site.mesh.edge_lengths, cuts, width / 2)
        short = built & border.cut.any(axis=1) & (left < beams.least_length)
        names = part_names("B", len(built))
        stubs = tuple(names[edge] for edge in np.flatnonzero(short & wanted))
        built, wanted = built & ~short, wanted & ~short
        border = replace(border, cut=border.cut & built[:, None])
        around = around_axes(site.mesh, site.axes, frames.along, built)
        cuts, folded, laps = _cuts(beams, site, frames, around, built, bolted)
        cuts = cuts.where(np.stack([built, built], axis=1), square(frames, 0 * frames.slope))
        frames, cuts = border.applied(frames, cuts, site.mesh.edge_lengths, width / 2)
    geometry = beam_geometry(site.mesh, beams.levels, width, frames, cuts, wanted)
    meeting = wanted[:, None] & ~(np.zeros(2, bool) if border is None else border.cut)
    if isinstance(bolted, FinPlates):
        meeting &= ~bolted.running.ends
    geometry = replace(geometry, meeting=meeting, bolted=bolted)
    if bolted is not None:
        geometry = replace(geometry, hub_radii=_hub_radii(site, around, bolted))
    edges = site.mesh.connectivity.edges
    if isinstance(section, Section):
        refuse_short(geometry, section, edges)
    refuse_width(geometry, edges, width)
    misfit = None
    if rolled is not None:
        misfit = rolled.misfit(site, geometry, meeting)
        geometry = replace(geometry, height=np.full_like(geometry.height, rolled.height))
        if isinstance(bolted, BallJoints):
            geometry = with_tubes(geometry, rolled.height, edges)
    return LaidOut(geometry, built, wanted, folded, laps, border, stubs, misfit)


def _cuts(
    beams: BeamSettings,
    site: Site,
    frames: Frames,
    around: Around,
    built: BoolArray,
    bolted: Bolted | None,
) -> tuple[Cuts, BoolArray, Crossings | None]:
    """Where beams end, which edges are parts of folded plates, and their half laps."""
    width = beams.profile.overall_width
    none, all_edges = np.zeros(len(built), dtype=bool), np.ones(len(built), dtype=bool)
    if beams.ends == "mitred":
        return mitred(frames, around), none, None
    if beams.ends == "hub":
        distance = beams.across / 2 + beams.clearance
        cuts = square(frames, hub_distance(site.mesh, around, width, distance))
        hubs = ~without_hubs(site, beams.across)[site.mesh.connectivity.edges]
        return cuts.where(hubs, mitred(frames, around)), none, None
    if bolted is not None and not isinstance(bolted, FinPlates):
        radii = _hub_radii(site, around, bolted)[site.mesh.connectivity.edges]
        cuts = square(frames, radii + bolted.setback)
        if isinstance(bolted, BallJoints):
            cuts = Cuts(radii + bolted.setback, 0 * cuts.slope)
        return cuts.where(radii > 0, mitred(frames, around)), none, None
    if beams.ends == "lapped":
        laps = half_laps(site, around, beams.sizes.thickness, beams.clearance)
        return mitred(frames, around), all_edges, laps
    gaps = clear_of_through(around, width, beams.clearance)
    if isinstance(bolted, FinPlates):
        edges, runs = site.mesh.connectivity.edges, bolted.running.ends
        radii = _hub_radii(site, around, bolted)[edges]
        cuts = square(frames, np.where(radii > 0, radii + bolted.setback, gaps))
        cuts = cuts.where((radii > 0) | ~bolted.running.stars[edges], mitred(frames, around))
        cuts = square(frames, 0 * gaps).where(runs, cuts)
        return cuts, np.asarray(runs.any(axis=1)), None
    through = runs_through(site.lines, beams.ends)
    alone = around_axes(site.mesh, site.axes, frames.along, built & through)
    others = square(frames, gaps)
    if beams.ends in COPED:
        others = coped(frames, around, through, width, beams.clearance)
    cuts = mitred(frames, alone).where(np.stack([through, through], axis=1), others)
    return cuts, through if beams.section == "plate" else none, None


def _bolted(beams: BeamSettings, site: Site, frames: Frames, built: BoolArray) -> Bolted | None:
    """How the beams of edges that are built, (E,), are bolted; None where they are not."""
    if beams.ends == "end-plate":
        return beams.end_plates
    section, bolt, sizes = beams.profile, bolt_of(beams.bolt), beams.sizes
    if beams.ends == "cone":
        edges, count = site.mesh.connectivity.edges, len(site.mesh.vertices)
        apart = smallest_angles(frames.along, edges, built, count)
        return BallJoints(bolt, sizes.height, sizes.thickness, apart, beams.hub_diameter)
    if beams.ends not in ("cover-plate", *SPLICED) or isinstance(section, RolledSection):
        return None
    rise = frames.rise[built]
    plates = (
        *(bolt, beams.bolts, sizes.thickness, section.overall_width, beams.clearance),
        float(sizes.height * rise.min()) - sum(section.flanges),
        float(np.abs(frames.slope[built] / rise[:, None]).max()),
        beams.hub_diameter,
    )
    if beams.ends in SPLICED:
        return FinPlates(*plates, running=Running.of(site.lines, beams.ends))
    return CoverPlates(*plates)


def _hub_radii(site: Site, around: Around, bolted: Bolted) -> FloatArray:
    """(V,) from the axes to what beams are bolted to, mm; 0 where there is nothing."""
    radii = bolted.radii(around, len(site.mesh.vertices))
    left_out = without_hubs(site, 2 * (radii + bolted.setback))
    return np.where(left_out, 0.0, radii)
