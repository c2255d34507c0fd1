"""Whether edges are as long as what stands at their ends takes, and what helps where not."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from freecad_ortho.fabrication.bolts import BOLTS
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.beams.cover_plates import CoverPlates
from freecad_ortho.fabrication.systems.beams.fins import FinPlates
from freecad_ortho.fabrication.systems.beams.geometry import BeamGeometry, NoRoom
from freecad_ortho.fabrication.systems.beams.options import BOLTED, SPLICED
from freecad_ortho.fabrication.systems.beams.sections import Section
from freecad_ortho.fabrication.systems.beams.web_holes import AWAY, joint_middles
from solver.errors import InputError
from solver.mesh.connectivity import IntArray

# Part of a beam's length that its cuts must leave.
_LEAST_LEFT = 1e-3
# Part of what cuts take from which on it is the distance of hubs, and not the mitres' own.
_BY_HUBS = 0.9
# Below it plates are not welded or bolted, mm.
_THINNEST = 3

Settings = dict[str, Any]


def refuse_short(beams: BeamGeometry, section: Section, edges: IntArray) -> None:
    """Refuse beams on which the cover plates of both ends have no room.

    ``edges`` (E, 2) are the vertices at the ends.

    Raises:
        NoRoom: naming the worst of them.
    """
    covers = beams.bolted
    if not isinstance(covers, CoverPlates):
        return
    middles = joint_middles(beams, section, covers, edges)
    joined = beams.meeting & (beams.hub_radii[edges] > 0)
    setback = np.stack([beams.setback[:, [0, 3]].max(axis=1), beams.setback[:, [1, 2]].max(axis=1)])
    starts = np.stack([0 * beams.lengths, beams.lengths], axis=1)
    cut = starts + beams.slopes * middles[..., 1] + AWAY * setback.T
    taken = np.where(joined, middles[..., 0] + AWAY * covers.half_length, cut)
    room = np.where(beams.built & joined.any(axis=1), taken[:, 1] - taken[:, 0], np.inf)
    worst = int(np.argmin(room))
    if room[worst] >= 0:
        return
    length = float(beams.lengths[worst])
    arms = "fins" if isinstance(covers, FinPlates) else "arms"
    raise NoRoom(
        f"beam ends: {_where(edges, worst)} is on an edge {length:.1f} mm long, its cover plates "
        f"and the {arms} before them take {length - float(room[worst]):.1f} mm"
    )


def refuse_width(beams: BeamGeometry, edges: IntArray, section_width: float) -> None:
    """Refuse beams of which their cuts leave nothing.

    ``edges`` (E, 2) are the vertices at the ends; ``section_width`` mm.

    Raises:
        NoRoom: where hubs or beams that run through take all of an edge.
        InputError: where mitres do, with the largest width that fits.
    """
    cuts, outline = beams.cuts, beams.outline[:, :, 0]
    available = np.minimum(outline[:, 1] - outline[:, 0], outline[:, 2] - outline[:, 3])
    fixed = cuts.middle.sum(axis=1)
    room = available * (1 - _LEAST_LEFT)
    setback = cuts.setback(section_width / 2)
    needed = np.maximum(setback[:, 0] + setback[:, 1], setback[:, 2] + setback[:, 3])
    if not (needed > room).any():
        return
    edge = int(np.argmax(needed / room))
    here = _where(edges, edge)
    if fixed[edge] >= _BY_HUBS * needed[edge]:
        raise NoRoom(
            f"beam ends: {here} is on an edge that is {available[edge]:.1f} mm long where it is "
            f"shortest, and what stands at its ends takes {needed[edge]:.1f} mm"
        )
    largest = section_width * float(((room - fixed) / (needed - fixed))[edge])
    raise InputError(
        f"beam thickness: {section_width:g} mm does not fit {here}, whose mitres need "
        f"{needed[edge]:.1f} of its {available[edge]:.1f} mm; take at most "
        f"{rounded_down(largest)} mm"
    )


def _where(edges: IntArray, edge: int) -> str:
    """The name of a beam and of the nodes at its ends."""
    nodes = part_names("N", int(edges.max()) + 1)
    first, second = (nodes[vertex] for vertex in edges[edge].tolist())
    return f"{part_names('B', len(edges))[edge]} between {first} and {second}"


def what_helps(settings: Settings, fits: Callable[[Settings], bool]) -> str:
    """The least change of sizes with which all edges are long enough, in words.

    Args:
        settings: ends, bolt, bolts, hub_diameter, thickness and section of the beams.
        fits: whether the beams have room with these changes.
    """
    for change in _changes(settings):
        if fits(change):
            return f"with {_words(change, settings)} all have room"
    for change in _smallest(settings):
        name, most = _largest(change, settings, fits)
        if most is not None:
            others = {key: value for key, value in change.items() if key != name}
            also = f" and {_words(others, settings)}" if others else ""
            return f"with a {_SIZES[name]} of at most {most} mm{also} all have room"
    if settings["ends"] in (*SPLICED, "cover-plate", "cone"):
        hubs = {"ends": "end-plate", "hub_diameter": None}
        if fits(hubs) or fits(hubs | {"bolts": 1, "bolt": next(iter(BOLTS))}):
            return "no smaller sizes help; take bolted hubs, or longer edges"
    return "no smaller sizes help; take longer edges, or mitred ends"


# Sizes that the largest is looked for of, as they are called.
_SIZES = {"hub_diameter": "hub diameter", "thickness": "beam thickness"}


def _changes(settings: Settings) -> Iterator[Settings]:
    """Other choices that take less room, from the least to the largest change."""
    ends = settings["ends"]
    if ends not in BOLTED:
        return
    sizes = list(BOLTS)
    smaller = sizes[: sizes.index(settings["bolt"])][::-1]
    if settings["hub_diameter"] is not None:
        yield {"hub_diameter": None}
    yield from ({"bolt": bolt} for bolt in smaller)
    if ends in SPLICED:
        other = next(choice for choice in SPLICED if choice != ends)
        yield {"ends": other}
        yield from ({"ends": other, "bolt": bolt} for bolt in smaller)
    if settings["bolts"] > 1 and ends != "cone":
        yield {"bolts": 1}
        yield from ({"bolts": 1, "bolt": bolt} for bolt in smaller)


def _smallest(settings: Settings) -> Iterator[Settings]:
    """The same with the size, None, of which the largest that fits is looked for."""
    if settings["ends"] == "hub":
        yield {"hub_diameter": None}
    if settings["section"] != "plate":
        return
    yield {"thickness": None}
    if settings["ends"] in BOLTED:
        yield {"thickness": None, "bolts": 1, "bolt": next(iter(BOLTS))}


def _largest(
    change: Settings, settings: Settings, fits: Callable[[Settings], bool]
) -> tuple[str, int | None]:
    """The size that is looked for, and the most of it that fits, in whole mm; None for none."""
    name = next(key for key, value in change.items() if value is None)
    above = int(np.ceil(settings[name]))
    # Small hubs may be too small: halves of what is given are tried until one fits.
    below = above // 2
    while below >= _THINNEST and not fits(change | {name: float(below)}):
        above, below = below, below // 2
    if below < _THINNEST:
        return name, None
    while above - below > 1:
        middle = (above + below) // 2
        if fits(change | {name: float(middle)}):
            below = middle
        else:
            above = middle
    return name, below


def _words(change: Settings, settings: Settings) -> str:
    """Choices as a sentence names them."""
    found = []
    if "ends" in change:
        found.append(f"ends {change['ends']}")
    if "bolt" in change or "bolts" in change:
        bolt = change.get("bolt", settings["bolt"])
        found.append(f"one {bolt} a joint" if change.get("bolts") == 1 else f"bolts {bolt}")
    if "hub_diameter" in change:
        found.append("hubs as large as each has to be")
    return " and ".join(found)
