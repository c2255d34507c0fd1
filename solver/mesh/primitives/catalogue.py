"""All primitives by name, with their parameters, for command lines and panels."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import refuse_sampling
from solver.mesh.intake import refuse_empty_faces
from solver.mesh.primitives.developable import cone, cylinder, tangent_developable
from solver.mesh.primitives.limits import positive
from solver.mesh.primitives.minimal import catenoid, enneper, helicoid, scherk
from solver.mesh.primitives.plane import rectangle
from solver.mesh.primitives.quadrics import ellipsoid, elliptic_paraboloid
from solver.mesh.primitives.rotational import rotational, sphere, unduloid
from solver.mesh.primitives.translational import arch, translational
from solver.mesh.quadmesh import QuadMesh
from solver.multinet.planar import confocal_conics
from solver.option import one_of

Value = float | str | tuple[float, ...] | ArrayLike | None


@dataclass(frozen=True)
class Parameter:
    """One parameter of a primitive.

    Attributes:
        name: keyword of the function.
        default: what it is if not given; None asks for points.
        kind: ``number``, ``numbers``, ``word`` or ``points``.
    """

    name: str
    default: float | str | tuple[float, ...] | None
    kind: str


@dataclass(frozen=True)
class Primitive:
    """One entry of the catalogue.

    Attributes:
        build: function of m, n and the parameters.
    """

    build: Callable[..., QuadMesh]

    @property
    def meaning(self) -> str:
        """First line of the function's documentation."""
        return (inspect.getdoc(self.build) or "").splitlines()[0]

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Keyword parameters in order."""
        found = inspect.signature(self.build).parameters.values()
        keywords = [entry for entry in found if entry.kind is inspect.Parameter.KEYWORD_ONLY]
        return tuple(Parameter(e.name, e.default, _kind(e.default)) for e in keywords)


def _kind(default: object) -> str:
    if default is None:
        return "points"
    if isinstance(default, tuple):
        return "numbers"
    return "word" if isinstance(default, str) else "number"


def _rotational(
    m: int,
    n: int,
    *,
    profile: ArrayLike | None = None,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Profile of (radius, height) points turned about z, n points along it by interpolation."""
    if profile is None:
        raise InputError("profile: expected points (radius, height), got none; give a file")
    points = np.asarray(profile, dtype=np.float64)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    run = np.concatenate([[0.0], np.cumsum(steps)])
    place = run if n == len(points) else np.linspace(0.0, run[-1], n)
    even = np.stack([np.interp(place, run, points[:, k]) for k in (0, 1)], axis=1)
    return rotational(m, even, angles=angles)


def _confocal_conics(
    m: int,
    n: int,
    *,
    semi_axes: tuple[float, float] = (2.0, 1.0),
    angles: tuple[float, float] = (0.0, 360.0),
    t_range: tuple[float, float] = (0.0, 4.0),
) -> QuadMesh:
    """Confocal ellipses x^2/(a + t) + y^2/(b + t) = 1 and their hyperbolas, flat; a multi-net."""
    a, b = (length**2 for length in semi_axes)
    return confocal_conics(a, b, angles=angles, t_range=t_range).sampled(m, n)


def _translational(
    m: int,
    n: int,
    *,
    length: float = 3.0,
    width: float = 2.0,
    rise: float = 0.6,
    cross_rise: float = 0.4,
) -> QuadMesh:
    """Circular arch moved along another one; negative rises hang."""
    positive(length=length, width=width)
    return translational(
        arch(m, length, rise, (1.0, 0.0, 0.0)), arch(n, width, cross_rise, (0.0, 1.0, 0.0))
    )


PRIMITIVES = {
    "catenoid": Primitive(catenoid),
    "cone": Primitive(cone),
    "confocal-conics": Primitive(_confocal_conics),
    "cylinder": Primitive(cylinder),
    "ellipsoid": Primitive(ellipsoid),
    "elliptic-paraboloid": Primitive(elliptic_paraboloid),
    "enneper": Primitive(enneper),
    "helicoid": Primitive(helicoid),
    "rectangle": Primitive(rectangle),
    "rotational": Primitive(_rotational),
    "scherk": Primitive(scherk),
    "sphere": Primitive(sphere),
    "tangent-developable": Primitive(tangent_developable),
    "translational": Primitive(_translational),
    "unduloid": Primitive(unduloid),
}


def primitive(name: str, m: int, n: int, **parameters: Value) -> QuadMesh:
    """Build a primitive by name with m x n vertices.

    Raises:
        InputError: no such primitive or parameter, a value of the wrong kind, or fewer vertices
            than it needs.
    """
    one_of("primitive", name, PRIMITIVES)
    refuse_sampling(m, n)
    entry = PRIMITIVES[name]
    known = {parameter.name: parameter for parameter in entry.parameters}
    for key, value in parameters.items():
        if key not in known:
            raise InputError(f"{name}: has {', '.join(known)}, not '{key}'; choose one of these")
        _check(name, known[key], value)
    mesh = entry.build(m, n, **parameters)
    try:
        refuse_empty_faces(mesh)
    except InputError:
        raise InputError(
            f"{name}: with {m} x {n} vertices some faces have no area; take more vertices"
        ) from None
    return mesh


def _check(name: str, parameter: Parameter, value: Value) -> None:
    if parameter.kind == "points":
        return
    default = parameter.default
    if isinstance(default, tuple):
        good = isinstance(value, tuple) and len(value) == len(default)
    else:
        good = isinstance(value, str if isinstance(default, str) else (int, float))
    if not good:
        raise InputError(f"{name}: {parameter.name} is of the kind of {default}, got {value!r}")
