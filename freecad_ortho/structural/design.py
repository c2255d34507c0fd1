"""What is checked under which loads: settings, each an option that is declared here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.structural.stances import STANCES
from solver.errors import InputError, refuse_unknown
from solver.mesh.quadmesh import FloatArray
from solver.option import AXES, NOT_NEGATIVE, POSITIVE, Option, Range

_JOINTS = ("rigid", "hinged")


@dataclass(frozen=True)
class Design:
    """Members, supports and loads of a shell; loads in kN and m.

    The fields are what ``options`` say, and:

    Attributes:
        wind: texts as ``0.6@x``.
        load: texts as ``12:0,0,-5``.

    Raises:
        InputError: a value that cannot be used.
    """

    section: str = "tube:100x60x5"
    material: str = ""
    supports: str = "boundary"
    joints: str = "rigid"
    position: str = "beams"
    eccentric: float = 0.0
    layers: float = 0.0
    crossings: str = "rigid"
    slots: float = 0.5
    self_weight: bool = True
    panels: float = 0.0
    panel_shear: float = 0.0
    snow: float = 0.0
    snow_side: str | Sequence[float] = (0.0, 0.0, 0.0)
    modes: int = 5
    pieces: int = 2
    buckling_length: float = 1.0
    deflection: float = 200.0
    second_order: bool = False
    imperfection: float | None = None
    wind: tuple[str, ...] = ()
    load: tuple[str, ...] = ()

    options: ClassVar[tuple[Option, ...]] = (
        Option(
            "section", "tube:100x60x5", "text",
            "The members have this profile; groups another one after it, as "
            "tube:100x60x5,border=tube:120x60x5",
        ),
        Option(
            "material", "", "text", "The members are made of this", absent="the profile's own",
        ),
        Option(
            "supports", "boundary", "text",
            "These are held: boundary, corners or numbers of vertices, each with :pinned, :fixed, "
            ":sliding (up and down only) or :springs=X/Y/Z (kN/mm), joined by +",
        ),
        Option(
            "joints", "rigid", "text",
            "Ends of members are rigid, hinged, or have springs of this stiffness in kNm/rad",
        ),
        Option(
            "position", "beams", "choice",
            "Sections stand as those of beams do, or as lamellas of plate:THICKNESSxWIDTH: "
            "standing, lying or tilted as the net wants it",
            STANCES,
        ),
        Option(
            "eccentric", 0.0, "distance",
            "The middle of sections lies this far above the net, along its axes",
        ),
        Option(
            "layers", 0.0, "length",
            "Lines u and v lie in two layers, u above, the middles of their sections this far "
            "apart",
            absent="one layer",
        ),
        Option(
            "crossings", "rigid", "text",
            "Where lines u and v cross, in slots of one layer or about the bolts of two, they turn "
            "like this about their axis: rigid, hinged, or the stiffness of a spring in kNm/rad",
        ),
        Option(
            "slots", 0.5, "number",
            "Slots leave this part of the height of lamellas that cross in one layer; with 1 "
            "there are none",
            within=Range(0.0, 1.0, above=True),
        ),
        Option(
            "self_weight", True, "flag", "The weight of the members is a load",
            brief="leave out the weight of the members",
        ),
        Option(
            *("panels", 0.0, "pressure", "Panels weigh this much by their surface, kN/m2"),
            within=NOT_NEGATIVE,
        ),
        Option(
            "panel_shear", 0.0, "number",
            "Panels with what holds them have this shear stiffness G t, kN/mm; with 0 they are "
            "load only",
            within=NOT_NEGATIVE,
        ),
        Option(
            *("snow", 0.0, "pressure", "Snow weighs this much by the plan, kN/m2"),
            within=NOT_NEGATIVE,
        ),
        Option(
            "snow_side", (0.0, 0.0, 0.0), "direction",
            "Snow also lies on one half, as a case of its own: the half towards this direction",
            absent="none",
        ),
        Option("modes", 5, "count", "So many modes of buckling are found", within=Range(1)),
        # With one piece no member bows.
        Option(
            *("pieces", 2, "count", "For buckling and second order each member has so many pieces"),
            within=Range(2),
        ),
        Option(
            *("buckling_length", 1.0, "number", "Members buckle in so many times their length"),
            within=POSITIVE,
        ),
        Option(
            "deflection", 200.0, "number",
            "The largest displacement that passes is this part of the second longest side of the "
            "net's box: 200 for 1/200",
            within=POSITIVE,
        ),
        Option("second_order", False, "flag", "Balance is found in the deformed, imperfect shape"),
        Option(
            "imperfection", None, "length", "The imperfection is this large",
            absent="1/300 of the second longest side of the box",
        ),
    )  # fmt: skip

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Design:
        """Make a design from values by name.

        Raises:
            InputError: a name that there is not, or a value that cannot be used.
        """
        refuse_unknown("check_structure", values, [one.name for one in fields(cls)])
        given: dict[str, Any] = dict(values)
        for name in ("wind", "load"):
            if isinstance(given.get(name), str):
                given[name] = (given[name],)
            given[name] = tuple(given.get(name) or ())
        return cls(**given)

    def __post_init__(self) -> None:
        for option in self.options:
            value = getattr(self, option.name)
            if not (value is None and option.default is None):
                option.check(option.plain(value))
        self.winds()
        self.points()
        self.joint_spring()
        self.crossing_spring()

    def winds(self) -> list[tuple[float, FloatArray, str]]:
        """Pressure, kN/m2, unit direction and name of each wind."""
        found = []
        for text in self.wind:
            size, _, towards = text.partition("@")
            sign = -1.0 if towards.startswith("-") else 1.0
            word = towards.strip().lower().removeprefix("-")
            try:
                pressure = float(size)
                direction = np.array(AXES.get(word) or [float(n) for n in towards.split(",")])
            except ValueError:
                pressure, direction = np.nan, np.zeros(0)
            length = float(np.linalg.norm(direction)) if direction.shape == (3,) else 0.0
            if not np.isfinite(pressure) or not length or not np.isfinite(length):
                raise InputError(
                    f"wind: expected a pressure in kN/m2 and where it blows to, as 0.6@x or "
                    f"0.6@1,1,0, got '{text[:40]}'"
                )
            unit = direction / length * (sign if word in AXES else 1.0)
            found.append((pressure, unit, f"wind {text.strip()}"))
        names = [name for _, _, name in found]
        if len(set(names)) < len(names):
            raise InputError(f"wind: '{self.wind[0]}' is given twice; give each once")
        return found

    def points(self) -> list[tuple[int, FloatArray]]:
        """Vertex and force, kN, of each point load."""
        found = []
        for text in self.load:
            vertex, _, numbers = text.partition(":")
            try:
                force = np.array([float(number) for number in numbers.split(",")])
                node = int(vertex)
            except ValueError:
                node, force = -1, np.zeros(0)
            if force.shape != (3,) or not np.isfinite(force).all() or node < 0:
                raise InputError(
                    f"load: expected a vertex and a force in kN, as 12:0,0,-5, got '{text[:40]}'"
                )
            found.append((node, force))
        return found

    def joint_spring(self) -> float:
        """Stiffness about the member's y and z at its ends, Nmm/rad; infinite where rigid."""
        return _turning("joints", self.joints)

    def crossing_spring(self) -> float:
        """Stiffness of layers turning about their bolts, Nmm/rad; infinite where rigid."""
        return _turning("crossings", self.crossings)

    def chosen_side(self) -> FloatArray | None:
        """(3,) direction of the half that snow lies on alone, None for none."""
        option = next(one for one in self.options if one.name == "snow_side")
        side = np.asarray(option.plain(self.snow_side), dtype=float)
        return side if side.any() else None


def _turning(name: str, text: str) -> float:
    """Stiffness of a joint, Nmm/rad."""
    words: Mapping[str, float] = dict(zip(_JOINTS, (np.inf, 0.0), strict=True))
    if text in words:
        return words[text]
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0 <= value < np.inf:
        raise InputError(
            f"{name}: expected rigid, hinged or a stiffness in kNm/rad, got '{text[:40]}'"
        )
    return 1e6 * value
