"""Parts that are cut from a plate: their sizes follow from the flat pattern."""

from __future__ import annotations

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.site import Site
from solver.mesh.quadmesh import FloatArray

_UNMEASURED = Measures()


def plate_part(
    site: Site,
    name: str,
    kind: str,
    body: Body,
    place: tuple[FloatArray, FloatArray],
    pattern: FlatPattern,
    thickness: float,
    *,
    vertices: tuple[int, ...] = (),
    face: int | None = None,
    family: str = "",
    line: int | None = None,
    measures: Measures = _UNMEASURED,
    height: float | None = None,
    weighed: float | None = None,
    assembly: str = "",
) -> Part:
    """Return the part of a plate, its length and width those of its pattern's box.

    Args:
        site: where it is built in.
        name: of the part.
        kind: what it is, in one word.
        body: in the part's own coordinates, mm.
        place: their origin (3,) in the site's mesh, mm, and the directions (3, 3) of their x, y and
            z, one a row.
        pattern: the flat pattern.
        thickness: of the plate, mm.
        vertices: like all that follow as in ``Part``.
        face: of the mesh.
        family: of the parameter line.
        line: its number.
        measures: how true the part is.
        height: of the section, where the pattern is curved.
        weighed: volume by which it weighs, where that is not its own, mm3.
        assembly: what keeps it from being put together.
    """
    length, width = pattern.size.tolist()
    origin, frame = place
    return Part(
        name=name,
        kind=kind,
        body=body,
        origin=origin + site.shift,
        frame=frame,
        pattern=pattern,
        length=length,
        width=width,
        thickness=thickness,
        area=pattern.area,
        volume=body.volume,
        material=site.material,
        vertices=vertices,
        face=face,
        family=family,
        line=line,
        measures=measures,
        height=height,
        weighed=weighed,
        assembly=assembly,
    )
