"""The system of support feet: settings, parts, and the list of anchors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from freecad_ortho.fabrication.bolts import BOLTS, GRADE, NUTS, WASHERS, bolt_of
from freecad_ortho.fabrication.cleat import Cleat, OnCleats
from freecad_ortho.fabrication.fasteners import Supply
from freecad_ortho.fabrication.material import metal_for
from freecad_ortho.fabrication.part import Part, part_names
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_options, check_size, offset_levels, size
from freecad_ortho.fabrication.systems.feet.fins import WELD, fin_parts
from freecad_ortho.fabrication.systems.feet.parts import FootSizes, foot_parts
from freecad_ortho.fabrication.systems.feet.places import standing, undersides
from freecad_ortho.fabrication.systems.shared_options import CLEARANCE, HEIGHT, OFFSET
from freecad_ortho.fabrication.systems.system import System, SystemParts, Table, sums
from solver.errors import InputError
from solver.option import Option

_ANCHORS = 4
_COLUMNS = ("foot", "vertex", "anchor", "grade", "count", "hole_mm", "post_mm")


@dataclass(frozen=True)
class Feet(System):
    """A base plate with four anchors, a post and a cap below every supported vertex.

    The cap is square to the node axis, below the beams or the hub; the post stands upright under
    its middle. Both plates are welded to it.

    Args:
        places: "corners", "boundary", or numbers of vertices joined by commas.
        foot_height: from the vertex down to the lower side of the base plate, mm.
        diameter: of the post, a round tube, mm.
        wall: of the post, mm.
        plate: thickness of base plate and cap, mm.
        anchor: size of the anchor bolts.
        height: of the beams, where none are built, mm.
        offset: of these beams.
        clearance: between the beams and the cap, mm.

    Raises:
        InputError: a length that is not positive and finite, or an unknown choice.
    """

    places: str = "corners"
    foot_height: float = 600.0
    diameter: float = 88.9
    wall: float = 5.0
    plate: float = 15.0
    anchor: str = "M16"
    height: float = 200.0
    offset: str = "centre"
    clearance: float = 1.0

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "feet"
    excludes: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("bent-panels", "patches"),
        "cannot be built together: feet stand below nodes, beams and lamellas; leave the feet out",
    )
    options: ClassVar[tuple[Option, ...]] = (
        Option(
            "foot_at",
            "corners",
            "text",
            "these vertices stand on feet: corners, boundary, or their numbers as 0,12,40",
        ),
        size("foot_height", 600.0, "the base plates lie this far below the vertices"),
        size("post_diameter", 88.9, "the posts are round tubes of this diameter"),
        size("post_wall", 5.0, "the walls of the posts are this thick"),
        size("foot_plate", 15.0, "base plates and caps are this thick"),
        Option("anchor", "M16", "choice", "four anchor bolts hold a base plate", tuple(BOLTS)),
        HEIGHT,
        OFFSET,
        CLEARANCE,
    )

    def __post_init__(self) -> None:
        check_options(
            self, self.options, diameter="post_diameter", wall="post_wall", plate="foot_plate"
        )
        check_size("clearance", self.clearance)
        if 2 * self.wall >= self.diameter:
            raise InputError(
                f"post wall: {self.wall:g} mm fills a tube of {self.diameter:g} mm; take less than "
                f"{self.diameter / 2:g} mm"
            )
        _ = self.sizes

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Feet:
        """Make the settings from options."""
        given = dict(values)
        names = {"places": "foot_at", "diameter": "post_diameter", "wall": "post_wall"}
        names["plate"] = "foot_plate"
        return cls(**{own: given.pop(option) for own, option in names.items()}, **given)

    @property
    def sizes(self) -> FootSizes:
        """Of every foot."""
        return FootSizes(self.diameter, self.wall, self.plate, bolt_of(self.anchor))

    def _fins(self, site: Site, cleat: Cleat, name: str, level: float) -> tuple[Part, Part]:
        """The fins on the cap that lies at a level below the vertex, along its axis."""
        axis = site.axes.directions[cleat.vertex]
        axis = axis if axis[2] > 0 else -axis
        top = site.mesh.vertices[cleat.vertex] - level * axis
        return fin_parts(site, cleat, name, top, axis)

    def build(self, site: Site) -> SystemParts:
        """Work out the feet.

        Raises:
            InputError: no such vertices, axes that lie flat there, or a height without room.
        """
        site = replace(site, material=metal_for(site.material))
        sizes, cleats = self.sizes, {}
        numbers = standing(site, self.places)
        lamellas = site.geometry_of("lamellas", OnCleats)
        if lamellas is not None:
            cleats = _cleats_at(lamellas, numbers.tolist())
            beside = max(cleat.sizes.beside for cleat in cleats.values()) + WELD
            sizes = replace(sizes, beside=beside)
        levels = offset_levels(self.offset, self.height)
        below = undersides(site, numbers, levels, sizes.reach) + self.clearance
        names = part_names("FT", len(site.mesh.vertices))
        feet = [
            foot_parts(site, vertex, names[vertex], sizes, level, self.foot_height)
            for vertex, level in zip(numbers.tolist(), below.tolist(), strict=True)
        ]
        fins = [
            part
            for vertex, level in zip(numbers.tolist(), below.tolist(), strict=True)
            if vertex in cleats
            for part in self._fins(site, cleats[vertex], names[vertex], level)
        ]
        parts = tuple(part for foot in feet for part in foot) + tuple(fins)
        bolts = self.anchor, GRADE, _ANCHORS, f"{sizes.bolt.hole:g}"
        rows = tuple(
            (post.name, vertex, *bolts, f"{post.length:.3f}")
            for vertex, (_, post, _) in zip(numbers.tolist(), feet, strict=True)
        )
        report = {
            "feet": len(feet),
            "fins": len(fins),
            "base_mm": sizes.base,
            "cap_mm": sizes.cap,
            "anchors": _ANCHORS * len(feet),
            "anchor": self.anchor,
            "post_min_mm": min(post.length for _, post, _ in feet),
            "post_max_mm": max(post.length for _, post, _ in feet),
            **sums(parts),
        }
        count = _ANCHORS * len(feet)
        supplies = (
            Supply("anchor", self.anchor, count, "piece", "base plates of feet", "", GRADE),
            Supply("anchor washer", self.anchor, count, "piece", "anchors", WASHERS, "200 HV"),
            Supply("anchor nut", self.anchor, count, "piece", "anchors", NUTS, GRADE[0]),
        )
        table = Table("anchors.csv", _COLUMNS, rows)
        return SystemParts(parts, report, tables=(table,), supplies=supplies)


def _cleats_at(lamellas: OnCleats, vertices: Sequence[int]) -> dict[int, Cleat]:
    """The cleats that fins share their bolts with.

    Raises:
        InputError: a vertex where no two lamellas are joined by one.
    """
    for vertex in vertices:
        if vertex not in lamellas.cleats or vertex not in lamellas.around:
            raise InputError(
                f"foot at: at vertex {vertex} no two lamellas cross with room for a cleat, which "
                "the foot shares its bolts with; name other vertices, take smaller holes, longer "
                "stock, or strip twisted"
            )
    return {vertex: lamellas.cleats[vertex] for vertex in vertices}
