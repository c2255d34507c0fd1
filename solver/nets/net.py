"""What a net is: one entry of the table from which all that offers nets is made."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.options import NetOptions
from solver.problem import Problem

Recipe = Callable[[Problem, NetOptions], Problem]


@dataclass(frozen=True)
class Measure:
    """How far a bare mesh is from a property that nets ask for.

    Attributes:
        name: word of reports and of the command line.
        of: gives one dimensionless value each; of the diagonal meshes with the keyword
            ``diagonal`` where ``across`` names a place.
        place: what a value belongs to; at a vertex it is a star's.
        across: what a value of the diagonal meshes belongs to; empty where nets ask it of the
            mesh itself in all their variants.
        square: it says where lines cross at right angles, which they cannot at singular vertices.
        shown: what fields and tables call it where that is more than its name in capitals.
    """

    name: str
    of: Callable[..., FloatArray]
    place: Literal["face", "edge", "vertex"]
    across: Literal["", "face", "vertex"] = ""
    square: bool = False
    shown: str = ""

    @property
    def title(self) -> str:
        """Name of the field that shows it."""
        return self.shown or self.name.capitalize()

    def on(self, mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
        """(n,) values, of the diagonal meshes where that is asked for and makes a difference."""
        return self.of(mesh, diagonal=True) if diagonal and self.across else self.of(mesh)

    def place_of(self, diagonal: bool) -> Literal["face", "edge", "vertex"]:
        """What a value of the mesh, or of its diagonal meshes, belongs to."""
        return (self.across or self.place) if diagonal else self.place

    def left_out(self, mesh: QuadMesh, diagonal: bool = False) -> BoolArray:
        """(n,) true for values that nets do not ask to vanish: right angles at singular vertices.

        A net of an irregular mesh is smooth elsewhere and has no right angles there.
        """
        net = mesh.connectivity
        at_stars = diagonal and bool(self.across)
        if self.square:
            return net.singular_stars if at_stars else net.singular_faces
        return np.zeros(len(self.on(mesh, diagonal)), dtype=bool)


class Easier(NamedTuple):
    """An easier net that is made first.

    Attributes:
        net: its name.
        fairness: factor on the fairness of the attempts at it.
        evenness: weight of evenness, on the way to the wanted net too; zero for none.
    """

    net: str
    fairness: float = 1.0
    evenness: float = 0.0


@dataclass(frozen=True)
class Way:
    """What ``solver.plan`` does where the start itself leads nowhere.

    Attributes:
        easier: nets that are made first, tried one after the other.
        bent: starts bent in one direction only are tried.
        rigid: of these the one that a doubly curved start does not reach.
        guarded: the net is reached as easily with faces crossed over as without: guards stand by
            from the start.
        evenness: weights of evenness in the attempts after the first.
        calms: so much is free that noise of the start would stay: where its lines zigzag they are
            drawn even.
        early: a net whose lines zigzag is led on along the nets, near to the start where no other
            surface is given, before other guides are tried.
        righted: a net with sharp corners, or one that shrank or zigzags, whatever was tried, is led
            on along the nets to one more like the start.
    """

    easier: tuple[Easier, ...] = ()
    bent: bool = False
    rigid: bool = False
    guarded: bool = False
    evenness: tuple[float, ...] = (1.0,)
    calms: bool = False
    early: bool = False
    righted: bool = False


@dataclass(frozen=True)
class Net:
    """A net: what is asked, what can be said about it, and the words for it.

    Attributes:
        name: of the command line and of macros.
        recipe: adds the terms that must vanish to a problem.
        place: where it stands in lists, from 1.
        title: what a list of nets shows: a name and, after a colon, what it is known by.
        condition: what is asked, in the words of the table in docs/nets.md.
        purpose: what for in a building, likewise.
        gives: one sentence on what it gives its builder.
        abbreviation: name where there is little room, by default that of the title.
        colours: field that shows best what is asked, by default the last measure.
        measures: by which a bare mesh is judged; none where that takes more than a mesh.
        options: names of those fields of ``NetOptions`` that it heeds.
        supports: what carries its loads where nothing is said: boundary or corners; none of a net
            that carries no loads.
        held: what fixed vertices are called.
        shape: surfaces that carry it: any, developable ones only, minimal ones only, or those that
            are saddles everywhere.
        along_curvature: its lines follow the principal directions.
        begins_as: the net whose lines it begins with on a surface, where these are others.
        conjugate: its faces are flat and nothing else is asked: its lines are conjugate.
        asymptotic: tells from the options whether its lines, or diagonals, follow the asymptotic
            directions at whatever angle these cross.
        flat: a plane is a shape as good as any other, as it is of sheets.
        general: others are special cases of it, and are advised before it.
        telling: a mesh that is this net is said to be so, though it is general.
        nearest: the start is the design surface where no other is given: of all such nets the one
            nearest to it is meant.
        stays: where no other surface is given, the start guides the way as one to stay close to:
            without it the surface would give way rather than the lines.
        turning: options that, where they are given, turn lines so far that they leave the border:
            such a start is carried on beyond it.
        any_faces: faces may have any number of corners.
        way: how it is reached where the start leads nowhere.
    """

    name: str
    recipe: Recipe
    place: int
    title: str
    condition: str
    purpose: str
    gives: str
    abbreviation: str = ""
    colours: str = ""
    measures: tuple[Measure, ...] = ()
    options: tuple[str, ...] = ()
    supports: str = "none"
    held: str = "fixed vertices"
    shape: Literal["any", "developable", "minimal", "saddle"] = "any"
    along_curvature: bool = False
    begins_as: str = ""
    conjugate: bool = False
    asymptotic: Callable[[NetOptions], bool] = lambda options: False
    flat: bool = False
    general: bool = False
    telling: bool = False
    nearest: bool = False
    stays: bool = False
    turning: tuple[str, ...] = ()
    any_faces: bool = False
    way: Way = Way()

    @property
    def short(self) -> str:
        """Name where there is little room."""
        return self.abbreviation or self.title.split(":")[0].strip()

    @property
    def field(self) -> str:
        """Name of the field that shows where a mesh is this net."""
        return self.colours or (self.measures[-1].title if self.measures else "Orthogonality")

    @property
    def lines(self) -> str:
        """The net as which it begins on a surface; empty where no lines of one lead to it."""
        return self.begins_as or "principal" * (self.along_curvature or self.conjugate)

    @property
    def told(self) -> tuple[str, ...]:
        """Names of all choices that it can be given: of its options, and of its supports."""
        return self.options if self.supports == "none" else ("supports", *self.options)

    @property
    def variants(self) -> tuple[bool, ...]:
        """Whether stars may be those of the diagonal net: values of the option ``diagonal``."""
        return (False, True) if "diagonal" in self.options else (False,)
