"""What only some nets can be told: each choice declared once, for all that offers it."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from typing import Any, Literal

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.problem import Problem


@dataclass(frozen=True)
class NetOption:
    """How a choice of some nets is offered by forms, properties and the command line.

    Attributes:
        name: keyword in Python; ``--per-family`` on the command line.
        default: where nothing is said; None of a length that is free.
        kind: ``flag``, ``length`` (in model units), ``angle`` (degrees), ``number``, ``choice`` or
            ``mesh`` (one with the same faces).
        label: what stands before its field in a form.
        brief: what it is, in the words of the command line and of docs/nets.md.
        meaning: one sentence on it in a document, where lengths are in mm; without its full stop.
        shown: what stands beside a box to tick, by choice the words for each, or for none.
    """

    name: str
    default: Any
    kind: Literal["flag", "length", "angle", "number", "choice", "mesh"]
    label: str
    brief: str
    meaning: str
    shown: dict[str, str]

    @property
    def sentence(self) -> str:
        """The meaning with what stands for "let it be found"."""
        return f"{self.meaning}; 0 is free" if self.kind == "length" else self.meaning


def _offered(
    kind: str, label: str, brief: str, meaning: str, **shown: str
) -> dict[str, tuple[Any, ...]]:
    return {"option": (kind, label, brief, meaning, shown)}


@dataclass(frozen=True)
class NetOptions:
    """Choices beyond the name of the net.

    Attributes:
        diagonal: ask star properties of a vertex and the four opposite corners of its faces.
        angle: angle of the medial lines in degrees, 90 for orthogonal.
        radius: radius of the star spheres in model units, None for free.
        length: edge length of a Chebyshev net in model units, None for free.
        per_family: a Chebyshev net has one length for each family of parameter lines.
        reference: (V, 3) positions of the shape to which an isometric net is isometric.
        load: vertical load of each vertex of a stress net, downwards, in any unit of force.
        load_area: load of a unit of surface, in the same unit of force.
        load_length: weight of a unit of edge, in the same unit of force.
        forces: free, compression or tension: which forces the edges of a stress net may carry.
    """

    diagonal: bool = field(
        default=False,
        metadata=_offered(
            "flag",
            "Asked",
            "stars of a vertex and the opposite corners of its faces",
            "Ask it of the diagonals of the faces, not of the edges",
            yes="on the face diagonals",
        ),
    )
    angle: float = field(
        default=90.0,
        metadata=_offered(
            "angle",
            "Angle",
            "angle of the lines",
            "Orthogonal nets: angle between the two directions",
        ),
    )
    radius: float | None = field(
        default=None,
        metadata=_offered(
            "length",
            "Radius",
            "radius of the spheres",
            "CMC nets: radius of the vertex spheres",
        ),
    )
    length: float | None = field(
        default=None,
        metadata=_offered(
            "length",
            "Edge length",
            "edge length",
            "Chebyshev nets: length of the edges",
        ),
    )
    per_family: bool = field(
        default=False,
        metadata=_offered(
            "flag",
            "Edges",
            "a length for each direction",
            "Chebyshev nets: each direction has a length of its own",
            yes="a length for each direction",
        ),
    )
    reference: FloatArray | None = field(
        default=None,
        metadata=_offered(
            "mesh",
            "Own shape",
            "the same mesh in the shape whose faces are kept",
            "Isometric nets: net whose faces give the shape; empty: as it starts",
            none="as it starts",
        ),
    )
    load: float = field(
        default=0.0,
        metadata=_offered(
            "number",
            "Load at a vertex",
            "downward load of a vertex; 1 where no load is given",
            "Stress nets: downward load at every vertex",
        ),
    )
    load_area: float = field(
        default=0.0,
        metadata=_offered(
            "number",
            "Load of 1 mm2",
            "downward load of unit area",
            "Stress nets: downward load of a square millimetre",
        ),
    )
    load_length: float = field(
        default=0.0,
        metadata=_offered(
            "number",
            "Weight of 1 mm edge",
            "weight of unit edge",
            "Stress nets: weight of a millimetre of edge",
        ),
    )
    forces: str = field(
        default="free",
        metadata=_offered(
            "choice",
            "Forces",
            "only forces of this kind",
            "Stress nets: forces that edges may carry",
            free="compression and tension",
            compression="compression only",
            tension="tension only",
        ),
    )

    def __post_init__(self) -> None:
        for option in OPTIONS.values():
            _refuse(option, getattr(self, option.name))
        if not 0 < self.angle < 180:
            raise InputError(f"angle: expected degrees between 0 and 180, got {self.angle}")

    @property
    def load_vectors(self) -> list[tuple[float, float, float]]:
        """Loads of a stress net as vectors, of a vertex, of unit area and of unit length."""
        return [(0.0, 0.0, -load) for load in (self.load, self.load_area, self.load_length)]

    def stars(self, problem: Problem) -> IntArray:
        """(S, 5) stars of the net or of its diagonal net.

        Raises:
            InputError: the mesh has no vertex with four faces around it.
        """
        stars = stars_of(problem)
        return problem.mesh.connectivity.diagonal_stars if self.diagonal else stars


OPTIONS: dict[str, NetOption] = {
    item.name: NetOption(item.name, item.default, *item.metadata["option"])
    for item in fields(NetOptions)
}


def _refuse(option: NetOption, value: Any) -> None:
    """Say what is wrong with a value."""
    if option.kind == "length" and value is not None and not (math.isfinite(value) and value > 0):
        raise InputError(f"{option.name}: expected a positive length, got {value}")
    if option.kind == "number" and not math.isfinite(value):
        raise InputError(f"{option.name}: expected a number, got {value}")
    if option.kind == "choice" and value not in option.shown:
        *most, last = option.shown
        words = f"{', '.join(most)} or {last}"
        raise InputError(f"{option.name}: expected {words}, got '{value}'")


def stars_of(problem: Problem) -> IntArray:
    """(S, 5) stars of the mesh.

    Raises:
        InputError: the mesh has no vertex with four faces around it.
    """
    stars = problem.mesh.connectivity.stars
    if not len(stars):
        raise InputError(
            f"{problem.net} net: needs inner vertices with four faces around them, the mesh "
            "has none; give a mesh of at least 2 x 2 faces"
        )
    return stars
