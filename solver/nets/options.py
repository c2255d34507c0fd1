"""What only some nets can be told: each choice declared once, for all that offers it."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Any

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.option import Kind, Option, Range
from solver.problem import Problem

_FORCES = {
    "free": "compression and tension",
    "compression": "compression only",
    "tension": "tension only",
}
_PLANE = {
    "one": "the family nearer to it",
    "u": "along u",
    "v": "along v",
    "both": "both families",
}
_SINGULAR = {"exempt": "left out", "include": "asked too"}


def _offered(kind: Kind, meaning: str, **words: Any) -> dict[str, Any]:
    """What a field is offered with, as the ``Option`` that is called as the field is."""
    return {"kind": kind, "meaning": meaning, **words}


@dataclass(frozen=True)
class NetOptions:
    """Choices beyond the name of the net.

    Attributes:
        diagonal: ask star properties of a vertex and the four opposite corners of its faces.
        flatness: largest distance between the diagonals of a face of a planar net, in model
            units, None for flat to the last digit.
        angle: between the medial lines in degrees, None for what the net has by itself: a right
            angle of orthogonal nets, any one angle of asymptotic nets at a constant angle, any
            angles of others.
        tilt_u: angle in degrees between the surface and the strips along u of a pseudo-geodesic
            net, 90 upright, 0 or 180 lying; None for one that is found.
        tilt_v: the same along v.
        plane: u, v, both or one: of which families the lines of a net of plane lines lie in
            planes; one for the family that is nearer to that.
        web: aag, agg, gga or ggg: of a web what the two families of lines and that of diagonals
            are, asymptotic or geodesic.
        radius: radius of the star spheres in model units, None for free.
        length: edge length of a Chebyshev net in model units, None for free.
        per_family: a Chebyshev net has one length for each family of parameter lines.
        reference: (V, 3) positions of the shape to which an isometric net is isometric.
        load: vertical load of each vertex of a stress net, downwards, kN or in another unit of
            force, which only scales the forces.
        load_area: load of a unit of surface, in that unit of force by model unit squared.
        load_length: weight of a unit of edge, in that unit of force by model unit.
        forces: free, compression or tension: which forces the edges of a stress net may carry.
        singular: exempt or include: whether right angles are asked of the faces at inner vertices
            where more or fewer than four meet.
    """

    diagonal: bool = field(
        default=False,
        metadata=_offered(
            "flag",
            "It is asked of the diagonals of the faces, not of the edges",
            title="Asked",
            brief="stars of a vertex and the opposite corners of its faces",
            shown={"yes": "on the face diagonals"},
            stored="DiagonalNet",
        ),
    )
    flatness: float | None = field(
        default=None,
        metadata=_offered(
            "length",
            "Planar nets: the diagonals of a face are this far apart at most",
            brief="largest distance between the diagonals of a face; none where that is not given",
            absent="exactly flat",
            stored="LargestGap",
        ),
    )
    angle: float | None = field(
        default=None,
        metadata=_offered(
            "angle",
            "The two directions meet at this angle",
            title="Angle",
            brief="angle between the lines; right for orthogonal nets, any for others",
            absent="as the net has it",
            stored="MedialAngle",
            within=Range(0.0, 180.0, above=True, below=True),
        ),
    )
    tilt_u: float | None = field(
        default=None,
        metadata=_offered(
            "angle",
            "Strips along u have this angle to the surface: 90 stands, 180 lies",
            title="Strips along u",
            brief="angle between surface and strips along u: 90 stands, 180 lies",
            absent="free",
            within=Range(0.0, 180.0),
        ),
    )
    tilt_v: float | None = field(
        default=None,
        metadata=_offered(
            "angle",
            "Strips along v have this angle to the surface: 90 stands, 180 lies",
            title="Strips along v",
            brief="angle between surface and strips along v: 90 stands, 180 lies",
            absent="free",
            within=Range(0.0, 180.0),
        ),
    )
    plane: str = field(
        default="one",
        metadata=_offered(
            "choice",
            "These lines lie in planes of their own",
            title="Plane lines",
            choices=tuple(_PLANE),
            shown=_PLANE,
        ),
    )
    web: str = field(
        default="aag",
        metadata=_offered(
            "choice",
            "Lines u, lines v and diagonals of a web are these: a asymptotic, g geodesic",
            title="Web",
            choices=("aag", "agg", "gga", "ggg"),
        ),
    )
    radius: float | None = field(
        default=None,
        metadata=_offered(
            "length",
            "CMC nets: the vertex spheres have this radius",
            brief="radius of the spheres",
            absent="free",
            stored="TargetRadius",
        ),
    )
    length: float | None = field(
        default=None,
        metadata=_offered(
            "length",
            "Chebyshev nets: the edges are this long",
            title="Edge length",
            brief="edge length",
            absent="free",
            stored="TargetEdge",
        ),
    )
    per_family: bool = field(
        default=False,
        metadata=_offered(
            "flag",
            "Chebyshev nets: each direction has a length of its own",
            title="Edges",
            brief="a length for each direction",
            shown={"yes": "a length for each direction"},
        ),
    )
    reference: FloatArray | None = field(
        default=None,
        metadata=_offered(
            "mesh",
            "Isometric nets: faces keep the shape that this net has; empty: as it starts",
            title="Own shape",
            brief="the same mesh in the shape whose faces are kept",
            shown={"none": "as it starts"},
            stored="IsometricTo",
        ),
    )
    load: float = field(
        default=0.0,
        metadata=_offered(
            "force",
            "Stress nets: every vertex carries this load, downwards",
            title="Load at a vertex",
            brief="downward load of a vertex; 1 where no load is given",
            stored="VertexWeight",
        ),
    )
    load_area: float = field(
        default=0.0,
        metadata=_offered(
            "per_area",
            "Stress nets: a square millimetre carries this load, downwards",
            title="Load of 1 mm2",
            brief="downward load of a square of the mesh's unit, or as 1.5kN/m2",
            stored="AreaWeight",
        ),
    )
    load_length: float = field(
        default=0.0,
        metadata=_offered(
            "per_length",
            "Stress nets: a millimetre of edge has this weight",
            title="Weight of 1 mm edge",
            brief="weight of edges by the mesh's unit, or as 0.2kN/m",
            stored="EdgeWeight",
        ),
    )
    forces: str = field(
        default="free",
        metadata=_offered(
            "choice",
            "Stress nets: edges may carry these forces",
            brief="only forces of this kind",
            choices=tuple(_FORCES),
            shown=_FORCES,
            stored="AllowedForces",
        ),
    )
    singular: str = field(
        default="exempt",
        metadata=_offered(
            "choice",
            "Faces at inner irregular vertices are left out, or asked for right angles too, which "
            "no smooth surface has there",
            title="Irregular",
            brief="right angles at inner irregular vertices, which no smooth surface has there",
            choices=tuple(_SINGULAR),
            shown=_SINGULAR,
        ),
    )

    def __post_init__(self) -> None:
        for option in OPTIONS.values():
            option.check(getattr(self, option.name), "")

    @property
    def given(self) -> tuple[str, ...]:
        """Names of the choices that are other than usual."""
        values = {name: getattr(self, name) for name in OPTIONS}
        return tuple(name for name, value in values.items() if not OPTIONS[name].is_default(value))

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


OPTIONS: dict[str, Option] = {
    item.name: Option(item.name, item.default, **item.metadata) for item in fields(NetOptions)
}


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
