"""What is to be said of panels at the border: cut, joined, left out, blunted, not carried."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.systems.panels.parts import PanelParts
from freecad_ortho.fabrication.systems.sheets import left_out_words, narrower
from freecad_ortho.fabrication.trimming import Trimming
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# Names of pieces that a message says.
_SHOWN = 5


def at_border(
    laid: PanelParts,
    trimming: Trimming,
    carried: tuple[BoolArray, FloatArray | None],
    least_width: float,
    edge_beam: bool,
    material: Material,
) -> tuple[dict[str, Any], list[str]]:
    """Report and messages.

    Args:
        laid: the panels.
        trimming: of the site.
        carried: (F,) faces that have a panel, and how wide each bears, mm, None without beams.
        least_width: pieces that are narrower are slivers, mm.
        edge_beam: whether there is one.
        material: of the panels.
    """
    made, least = carried
    report = {
        "joined": {name: to for name, (to, _) in laid.joined.items()},
        "joined_above_max_mm": max((above for _, above in laid.joined.values()), default=0.0),
        "trimmed": sum(part.face in trimming.regions for part in laid.parts),
        "left_out": sorted(laid.left_out),
        "left_out_mm2": sum(piece.area for piece in laid.left_out.values()),
        "blunted": sorted(laid.blunt),
    }
    what, remedy = _slivers(least_width, edge_beam, material)
    words = _joined_words(laid.joined, what)
    areas = {name: piece.area for name, piece in laid.left_out.items()}
    words += left_out_words("panels", areas, what, remedy)
    words += _blunt_words(laid.blunt, material)
    if least is not None:
        cut = np.isin(np.arange(len(made)), list(trimming.regions))
        words += _uncarried_words(least[made & cut], edge_beam)
        report["bearing_min_mm"] = float(least[made & ~cut].min(initial=np.inf))
    return report, words


def _slivers(least_width: float, edge_beam: bool, material: Material) -> tuple[str, str]:
    """What slivers are, and what keeps them.

    Args:
        least_width: pieces that are narrower are slivers, mm.
        edge_beam: whether pieces that lie on too few beams are slivers, too.
        material: of the panels.
    """
    if material.plate_limits is None:
        loose = ", twice that with fewer than two beams below" if edge_beam else ""
        return f"{narrower(least_width)}{loose}", "a smaller least width keeps it"
    loose = f", {4 * least_width:g} mm with fewer than two beams below" if edge_beam else ""
    what = f"{narrower(least_width)}{loose}, or too small or pointed for {material.name}"
    return what, "close it with sheet metal"


def _blunt_words(blunt: Mapping[str, float], material: Material) -> list[str]:
    """A message where corners are cut off that could not be made, with how far, mm."""
    if not blunt or material.plate_limits is None:
        return []
    shown = ", ".join(list(blunt)[:_SHOWN]) + (" ..." if len(blunt) > _SHOWN else "")
    least = material.plate_limits
    return [
        f"panels: {len(blunt)} at the border have corners cut off, up to {max(blunt.values()):.0f} "
        f"mm, as {material.name} needs {least.angle_deg:g} degrees and sides of {least.side_mm:g} "
        f"mm: {shown}; seal what is open there"
    ]


def _joined_words(joined: Mapping[str, tuple[str, float]], what: str) -> list[str]:
    """A message where slivers are part of their neighbours, with how far these stand off."""
    if not joined:
        return []
    pairs = [f"{name} of {to}" for name, (to, _) in joined.items()]
    shown = ", ".join(pairs[:_SHOWN]) + (" ..." if len(pairs) > _SHOWN else "")
    above = max(above for _, above in joined.values())
    return [
        f"panels: {len(pairs)} at the border {what} are part of their neighbours, "
        f"which stand up to {above:.2g} mm above the net there: {shown}"
    ]


def _uncarried_words(bearings: FloatArray, edge_beam: bool) -> list[str]:
    """A message where panels at the border, by how wide they bear, do not lie on beams enough.

    Args:
        bearings: (N,) of panels at the border, mm.
        edge_beam: whether they lie on one.
    """
    loose = int((bearings <= 0).sum())
    if not loose:
        return []
    remedy = "a smaller least length of beams or a larger least width of panels helps"
    if not edge_beam:
        remedy = "they need something along the border that carries them: an edge beam"
    return [f"panels: {loose} at the border have fewer than two beams under them; {remedy}"]
