"""Nodes with bolts: what they are made of, their lists and their report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from freecad_ortho.fabrication.ball_body import Ball
from freecad_ortho.fabrication.equal import equal_groups
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry
from freecad_ortho.fabrication.systems.nodes.ball_parts import BallMaking
from freecad_ortho.fabrication.systems.nodes.fin_plates import FinMaking
from freecad_ortho.fabrication.systems.nodes.hub_plates import HubMaking
from freecad_ortho.fabrication.systems.nodes.star_plates import StarMaking
from freecad_ortho.fabrication.systems.nodes.stars import Star
from freecad_ortho.fabrication.systems.nodes.type_list import NodeSize, node_types
from freecad_ortho.fabrication.systems.system import SystemParts, sums
from freecad_ortho.words import counted


def with_end_plates(
    site: Site, geometry: BeamGeometry, sizes: EndPlates, joined: Sequence[Star]
) -> SystemParts:
    """Hollow hubs, and end plates on the beams.

    Raises:
        InputError: beams that are too low for the bolts.
    """
    making = HubMaking(site, geometry, sizes)
    hubs = tuple(making.hub(star) for star in joined)
    plates = tuple(part for _, part in sorted(making.plates.items()))
    groups = equal_names(hubs)
    widths = [hub.width for hub in hubs]
    report = {
        "kind": "bolted",
        "diameter_mm": max(widths, default=0.0),
        "diameter_min_mm": min(widths, default=0.0),
        "wall_mm": sizes.wall,
        "end_plates": len(plates),
        "end_plate_mm": sizes.thickness,
        "bolt": f"{sizes.bolt.name}x{sizes.length:g}",
        "bolts": making.bolts,
        **making.clamped.report(1 if making.single else sizes.count),
        "gap_mm": sizes.clearance,
        "shims_mm": sizes.shims,
        "play_across_mm": sizes.bolt.play,
        "not_put_on": sum(bool(hub.assembly) for hub in hubs),
        **equal_report(groups),
        **sums((*hubs, *plates)),
    }
    named = {
        hub.name: NodeSize(star, hub.width, hub.length, hub.thickness)
        for hub, star in zip(hubs, joined, strict=True)
    }
    types = node_types(named, list(groups.values()), site.axes)
    tables = (making.bolt_list(), making.hole_list(), types)
    corners = {hub.vertices[0]: (hub.points - site.shift).reshape(2, 2, -1, 3)[0] for hub in hubs}
    said = (*making.remarks(), *_doubts(hubs))
    bolts = (making.fasteners,)
    return SystemParts((*hubs, *plates), report, said, corners, tables=tables, fasteners=bolts)


def with_cover_plates(making: StarMaking, joined: Sequence[Star]) -> SystemParts:
    """Stars of plates, and the cover plates that bolt the beams to them."""
    covers, site, radii = making.covers, making.site, making.beams.hub_radii
    each = {making.nodes[star.vertex]: (star, making.arms(star)) for star in joined}
    arms = tuple(part for _, some in each.values() for part in some)
    plates = tuple(part for _, part in sorted(making.plates.items()))
    if isinstance(making, FinMaking):
        plates += making.splice_plates()
    groups = _equal_stars({name: some for name, (_, some) in each.items()})
    widths = [2 * float(radii[star.vertex]) for star in joined]
    report = {
        "kind": making.kind,
        "diameter_mm": max(widths, default=0.0),
        "diameter_min_mm": min(widths, default=0.0),
        "arms": len(arms),
        "cover_plates": len(plates),
        "cover_plate_mm": covers.thickness,
        "bolt": f"{covers.bolt.name}x{covers.length:g}",
        "bolts": len(making.placed),
        **making.clamped.report(covers.count),
        "gap_mm": covers.clearance,
        # Both groups of holes of a cover plate give.
        "play_along_mm": 2 * covers.bolt.play,
        "play_across_mm": 2 * covers.bolt.play,
        "not_put_on": sum(bool(arm.assembly) for arm in arms),
        **making.more(),
        **equal_report(groups),
        **sums((*arms, *plates)),
    }
    named = {
        name: NodeSize(
            star,
            2 * float(radii[star.vertex]),
            max((arm.width for arm in some), default=0.0),
            covers.web,
        )
        for name, (star, some) in each.items()
    }
    tables = (making.bolt_list(), node_types(named, list(groups.values()), site.axes))
    bolts = (making.fasteners,)
    said = (*making.remarks(), *_doubts(arms))
    return SystemParts((*arms, *plates), report, said, {}, tables=tables, fasteners=bolts)


def with_balls(making: BallMaking, joined: Sequence[Star]) -> SystemParts:
    """Balls, and the cones and sleeves of the tubes that are screwed into them."""
    site, joints = making.site, making.joints
    balls = tuple(making.ball(star) for star in joined)
    cones = tuple(part for _, pair in sorted(making.pieces.items()) for part in pair)
    groups = equal_names(balls)
    widths = [ball.width for ball in balls]
    report = {
        "kind": "ball",
        "diameter_mm": max(widths, default=0.0),
        "diameter_min_mm": min(widths, default=0.0),
        "cones": len(making.pieces),
        "cone_mm": joints.cone,
        "sleeve_mm": joints.sleeve,
        "bolt": f"{joints.bolt.name}x{joints.length:g}",
        "bolts": len(making.pieces),
        **making.clamped.report(1),
        **equal_report(groups),
        **sums((*balls, *cones)),
    }
    named = {
        ball.name: NodeSize(star, ball.width, ball.width, ball.width)
        for ball, star in zip(balls, joined, strict=True)
    }
    around = {
        ball.vertices[0]: ball.origin - site.shift + ball.body.around() @ ball.frame
        for ball in balls
        if isinstance(ball.body, Ball)
    }
    tables = (*making.tables(), node_types(named, list(groups.values()), site.axes))
    bolts = (making.fasteners,)
    return SystemParts((*balls, *cones), report, (), around, tables=tables, fasteners=bolts)


def equal_names(joints: Sequence[Part]) -> dict[str, list[str]]:
    """Names of equal joints by that of the first of them."""
    groups = equal_groups(joints)
    return {joints[group[0]].name: [joints[number].name for number in group] for group in groups}


def equal_report(groups: Mapping[str, list[str]]) -> dict[str, Any]:
    """What the report says of them."""
    equal = {name: some for name, some in groups.items() if len(some) > 1}
    return {"different": len(groups), "equal": equal}


def _equal_stars(each: Mapping[str, Sequence[Part]]) -> dict[str, list[str]]:
    """Names of stars with equal arms in the same order around, by that of the first of them."""
    arms = [arm for some in each.values() for arm in some]
    kinds = {arms[k].name: group[0] for group in equal_groups(arms) for k in group}
    found: dict[tuple[int, ...], list[str]] = {}
    for name, some in each.items():
        ring = [kinds[arm.name] for arm in some]
        turned = min((tuple(ring[k:] + ring[:k]) for k in range(len(ring))), default=())
        found.setdefault(turned, []).append(name)
    return {some[0]: some for some in found.values()}


def _doubts(parts: Sequence[Part]) -> tuple[str, ...]:
    doubtful = [part for part in parts if part.assembly]
    if not doubtful:
        return ()
    first = doubtful[0]
    return (
        f"nodes: {counted(len(doubtful), 'part')} with bolts that cannot be put in or reached, "
        f"{first.name} for one: {first.assembly.split('; ')[0]}; leave the hub diameter out for "
        "nodes as large as they have to be, or take smaller bolts",
    )
