"""Beams as parts: names, flat patterns with their marks, measures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.assembly import SlotWay, judged, lean
from freecad_ortho.fabrication.bevels import bevels_of
from freecad_ortho.fabrication.bodies import Polyhedron
from freecad_ortho.fabrication.drilled import drilled
from freecad_ortho.fabrication.folded import Chain, FoldedPlate, folded_plate
from freecad_ortho.fabrication.level_plate import LevelPlate
from freecad_ortho.fabrication.part import Measures, Part, part_names
from freecad_ortho.fabrication.pattern import FlatPattern, Hole, overlaps_itself, texts_between
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.border import BorderEnds
from freecad_ortho.fabrication.systems.beams.geometry import LEFT_SIDE, RIGHT_SIDE, BeamGeometry
from freecad_ortho.fabrication.systems.beams.lines import Crossings, chain, line_name
from freecad_ortho.fabrication.systems.beams.rolled import RolledSection
from freecad_ortho.fabrication.systems.beams.sections import Section, SectionPiece
from freecad_ortho.fabrication.systems.beams.web_holes import web_holes
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.lines import ParameterLine
from solver.mesh.quadmesh import FloatArray

# Directions of a part's coordinates in those of its beam: along, up, right.
_UPRIGHT = np.eye(3)
_LYING = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])


def edge_beams(
    site: Site,
    geometry: BeamGeometry,
    section: Section | RolledSection,
    chosen: BoolArray,
    border: BorderEnds | None,
    misfit: FloatArray | None,
) -> tuple[Part, ...]:
    """Return the parts of each chosen edge (E,), in the order of the edges.

    ``misfit`` (V,) is how far lower sides lie apart at the vertices, where the section is constant.
    """
    edges = site.mesh.connectivity.edges.tolist()
    names = part_names("B", len(edges))
    families, lines = site.edge_family, site.lines.edge_line.tolist()
    twist = np.degrees(np.arcsin(np.clip(site.axes.twist, 0.0, 1.0)))
    nodes = part_names("N", len(site.mesh.vertices))
    made = section.pieces(geometry)
    bored: dict[int, tuple[Hole, ...]] = {}
    if isinstance(section, Section):
        bored = web_holes(geometry, section, site.mesh.connectivity.edges)
    parts = []
    for edge in np.flatnonzero(chosen).tolist():
        for piece in made:
            name = names[edge] + piece.suffix
            ends = [nodes[vertex] for vertex in edges[edge]]
            if border is not None:
                at_border = border.cut[edge]
                ends = ["" if cut else end for end, cut in zip(ends, at_border, strict=True)]
            pattern, origin = _pattern(geometry, piece, edge, name, ends)
            turn = _LYING if piece.role == "flange" else _UPRIGHT
            body = piece.body(edge, origin, turn)
            if pattern is not None and isinstance(body, Polyhedron):
                seen = "above" if piece.role == "flange" else "right"
                pattern = replace(pattern, bevels=bevels_of(body), seen=seen)
                if piece.role == "plate" and edge in bored:
                    pattern = replace(pattern, holes=_moved(bored[edge], -origin[:2]))
                    half = piece.thickness / 2
                    body = drilled(body, pattern.holes, (-half, half), (LEFT_SIDE, RIGHT_SIDE))
            parts.append(
                Part(
                    name=name,
                    kind="beam",
                    body=body,
                    origin=geometry.start[edge] + origin @ geometry.frame[edge] + site.shift,
                    frame=turn @ geometry.frame[edge],
                    pattern=pattern,
                    length=float(np.ptp(piece.corners[edge, :, 0]))
                    if pattern is None
                    else float(pattern.size[0]),
                    width=float(piece.width[edge]),
                    thickness=piece.thickness,
                    area=piece.skin(edge) if pattern is None else pattern.area,
                    volume=body.volume,
                    material=site.material,
                    vertices=tuple(edges[edge]),
                    family=families[edge],
                    line=lines[edge],
                    measures=Measures(
                        gap_mm=float(geometry.twist_mm[edge]),
                        twist_deg=float(twist[edge]),
                        misfit_mm=None if misfit is None else float(misfit[edges[edge]].max()),
                    ),
                    note=_cut_angles(geometry, section, piece, edge) if pattern is None else "",
                    section_width=section.overall_width if pattern is None else None,
                    section=section.name,
                    weighed=piece.weighed(edge),
                )
            )
    return tuple(parts)


def _moved(holes: tuple[Hole, ...], shift: FloatArray) -> tuple[Hole, ...]:
    """Holes somewhere else."""
    return tuple(replace(hole, centre=hole.centre + shift) for hole in holes)


def line_beams(
    site: Site,
    geometry: BeamGeometry,
    thickness: float,
    lines: tuple[ParameterLine, ...],
    laps: Crossings | None,
    border: BorderEnds | None,
) -> tuple[tuple[Part, ...], list[str]]:
    """Return one folded plate for each line, and what is to be said about putting them together.

    Raises:
        InputError: sizes that do not fit, or a flat pattern that overlaps itself.
    """
    across, nodes = names_across(site), part_names("N", len(site.mesh.vertices))
    parts: list[Part] = []
    ways: dict[str, list[SlotWay]] = {}
    for line in lines:
        form = chain(site, geometry, line, thickness / 2, laps, border)
        plate = folded_plate(form)
        name = name_after(line_name(line), parts)
        if laps is not None:
            ways[name] = _ways(site, geometry, line, form, laps.clearance, across)
        parts.append(line_part(site, geometry, line, form, plate, name, across, nodes))
    return judged(parts, ways)


def name_after(name: str, parts: list[Part]) -> str:
    """The name of a line's beam: with a letter from its second stretch on."""
    if parts and parts[-1].name.startswith(name):
        letters = parts[-1].name[len(name) :].split("-")[0] or "a"
        # After z come za, zb and so on, which are sorted behind it.
        last = letters[-1]
        return name + (letters + "a" if last == "z" else letters[:-1] + chr(ord(last) + 1))
    return name


def line_part(
    site: Site,
    geometry: BeamGeometry,
    line: ParameterLine,
    form: Chain,
    plate: FoldedPlate,
    name: str,
    across: dict[int, list[str]],
    nodes: list[str],
) -> Part:
    """One folded plate.

    Raises:
        InputError: a flat pattern that overlaps itself.
    """
    if overlaps_itself(plate.outline):
        raise InputError(
            f"beams: the flat pattern of {name} overlaps itself; take mitred or hub ends, or "
            "cut the mesh"
        )
    twist = np.degrees(np.arcsin(np.clip(site.axes.twist[line.edges], 0.0, 1.0)))
    return plate_part(
        site,
        name,
        "beam",
        plate.body,
        (form.vertices[0], form.frame[0]),
        _folded_pattern(name, plate, line, across, nodes),
        2 * form.half,
        vertices=tuple(vertex for vertex in line.vertices.tolist() if vertex >= 0),
        family=line.family,
        line=line.number,
        measures=Measures(
            gap_mm=float(geometry.twist_mm[line.edges].max()), twist_deg=float(twist.max())
        ),
        height=float(geometry.height[line.edges].max()),
    )


def _ways(
    site: Site,
    geometry: BeamGeometry,
    line: ParameterLine,
    form: Chain,
    clearance: float,
    across: dict[int, list[str]],
) -> list[SlotWay]:
    """How others are pushed into the slots of a beam, which is rigid."""
    net = site.mesh.connectivity
    depth = float(geometry.height[line.edges].min()) / 2
    found = []
    for vertex, slot, offset in zip(line.vertices.tolist(), form.slots, form.offsets, strict=False):
        others = [name for name in across[vertex] if name != line_name(line)]
        if slot is None or not others:
            continue
        beside = np.setdiff1d(np.flatnonzero((net.edges == vertex).any(axis=1)), line.edges)
        length = float(site.mesh.edge_lengths[beside].min())
        direction = offset / np.linalg.norm(offset) * (1 if slot.above else -1)
        give = lean(site.material, 2 * form.half, length)
        found.append(SlotWay(others[0], direction, depth, clearance, give))
    return found


def names_across(site: Site) -> dict[int, list[str]]:
    """Names of the lines through each vertex."""
    names: dict[int, list[str]] = {}
    for line in site.lines.all:
        for vertex in line.vertices.tolist():
            names.setdefault(vertex, []).append(line_name(line))
    return names


def _pattern(
    geometry: BeamGeometry, piece: SectionPiece, edge: int, name: str, ends: list[str]
) -> tuple[FlatPattern | None, FloatArray]:
    """Flat pattern of a part, and the origin of its coordinates in those of the beam."""
    corners = piece.corners[edge]
    if piece.role == "flange":
        flat = corners[:6] @ _LYING.T
        origin = np.array([flat[:, 0].min(), corners[0, 1], flat[:, 1].min()])
        outline = flat[:, :2] - [origin[0], origin[2]]
        return _plain(name, outline[[5, 0, 1, 2, 3, 4]], ends), origin * [1, 1, -1]
    origin = piece.origin(edge)
    if piece.role == "tube":
        return None, origin
    middle = corners[[0, 3, 9, 6]] - origin
    setback = geometry.cuts.setback(piece.thickness / 2)[edge]
    inner = setback - geometry.cuts.middle[edge][[0, 1, 1, 0]]
    return _plate_pattern(name, middle[:, :2], inner, ends), origin


def _cut_angles(
    geometry: BeamGeometry, section: Section | RolledSection, piece: SectionPiece, edge: int
) -> str:
    """Cuts of a tube in words: the saw's tilt from square, in elevation and in plan."""
    tilt = np.degrees(np.arctan(geometry.slopes[edge]))
    plan = np.degrees(np.arctan(geometry.cuts.slope[edge]))
    words = [
        f"{end}: elevation {tilt[k]:.2f}, plan right {plan[right]:.2f} left {plan[left]:.2f} deg"
        if known is None
        else f"{end}: {known}"
        for k, (end, right, left, known) in enumerate(
            (("start", 0, 3, piece.cut_words(edge)[0]), ("end", 1, 2, piece.cut_words(edge)[1]))
        )
    ]
    return "; ".join([section.size(float(geometry.height[edge])), *words])


def _plate_pattern(
    name: str, corner: FloatArray, setback: FloatArray, ends: list[str]
) -> FlatPattern:
    """Outline of the plate seen from its right side, the edge running to the right."""
    height = float(corner[:, 1].max())
    bottom_start, bottom_end, top_end, top_start = corner
    start = max(bottom_start[0], top_start[0]) + max(setback[0], setback[3])
    end = min(bottom_end[0], top_end[0]) - max(setback[1], setback[2])
    size = (float(corner[:, 0].max()), height)
    return FlatPattern(corner, *texts_between(name, ends, (start, end), height / 2, size))


def _plain(name: str, outline: FloatArray, ends: list[str]) -> FlatPattern:
    """Outline of a flange seen from above, the edge running to the right."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    middle = float(outline[:, 1].mean())
    start, end = np.sort(outline[:, 0])[[2, 3]].tolist()
    size = (float(high[0]), float((high - low)[1]))
    return FlatPattern(outline, *texts_between(name, ends, (start, end), middle, size))


def _folded_pattern(
    name: str,
    plate: FoldedPlate,
    line: ParameterLine,
    across: dict[int, list[str]],
    nodes: list[str],
) -> FlatPattern:
    """The unrolled plate, its ends level, with the names of nodes and beams beside the bends."""
    level = LevelPlate.of(plate)
    count, marks = len(level.middles), []
    for node, vertex in enumerate(line.vertices.tolist()):
        if vertex < 0:
            continue
        step, ahead = (node, -1.0) if node < count else (node - 1, 1.0)
        text = " ".join(
            [nodes[vertex], *(other for other in across[vertex] if not name.startswith(other))]
        )
        marks.append(level.mark(text, step, 0.22 * ahead, 0.3, 0.3, 12.0))
    return level.pattern(name, marks, 0.12, 0.25, 0.3)
