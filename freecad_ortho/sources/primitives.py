"""The solver's primitives as sources, one each, in metres where the solver's default is 1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from freecad_ortho.sources.placing import PLACEMENT, Placing, placed
from freecad_ortho.sources.source import Made, Source
from solver.mesh.primitives import PRIMITIVES, Parameter, primitive
from solver.option import Former, Kind, Option, Range

_METRE = 1000.0
_LENGTHS = {
    "radius", "top_radius", "height", "waist", "size", "widest", "narrowest", "length",
    "width", "semi_axes", "first", "second",
}  # fmt: skip
_DISTANCES = {"pitch", "rise", "cross_rise"}
_ANGLES = {"angles", "angle", "latitudes"}
_AREAS = {"t_range"}
_LINES = {
    "catenoid": ("principal", "asymptotic"),
    "enneper": ("asymptotic", "principal"),
    "helicoid": ("asymptotic", "principal"),
    "scherk": ("asymptotic", "principal"),
    "unduloid": ("principal", "cmc"),
}
# A vase, for a rotational net of which no profile is known yet.
_PROFILE = ((2000.0, 0.0, 0.0), (2600.0, 1500.0, 0.0), (1500.0, 3500.0, 0.0), (1900.0, 4500.0, 0.0))
_MEANINGS = {
    "angles": "The net goes from the first to the second of these angles about the axis",
    "angle": "The helix turns by this angle",
    "clear": "This part of the range is left free at each end",
    "cross_rise": "The arch along y rises by this, or hangs where it is negative",
    "first": "At its vertex the surface has this radius of curvature, the larger one",
    "height": "The surface is this high",
    "latitudes": "The net goes from the first to the second of these latitudes",
    "length": "The net is this long along x",
    "lines": "The net follows these lines of the surface",
    "narrowest": "The narrowest circle has this radius",
    "periods": "The surface has so many waves along its axis",
    "pitch": "One turn rises by this",
    "profile": "These points (radius, height) are turned about z",
    "radius": "The surface has this radius",
    "reach": "The net reaches so far over the surface, farther where this is larger",
    "rise": "The arch along x rises by this, or hangs where it is negative",
    "second": "At its vertex the surface has this radius of curvature, the smaller one",
    "semi_axes": "The semi-axes are this long, the largest comes first",
    "size": "The surface grows in proportion to this length",
    "spine": "The tangents of these points make the sheet; empty for a helix",
    "t_range": "The net goes from the first to the second t of the confocal family",
    "top_radius": "The upper end has this radius",
    "waist": "The narrowest circle has this radius",
    "widest": "The widest circle has this radius",
    "width": "The net is this wide across",
}
# Of these the same word means something else.
_OWN_MEANINGS = {
    ("cone", "radius"): "The lower end has this radius",
    ("helicoid", "radius"): "The net reaches this far from the axis on both sides",
    ("tangent-developable", "radius"): "The helix has this radius",
}


def roots(squares: Sequence[float]) -> tuple[float, ...]:
    """Semi-axes of which the squares were given."""
    return tuple(math.copysign(math.sqrt(abs(square)), square) for square in squares)


_FORMER = {("confocal-conics", "semi_axes"): Former("squares", roots)}


def primitive_sources() -> dict[str, Source]:
    """All primitives by name."""
    return {name: _source(name) for name in PRIMITIVES}


def sampling(u: int, v: int) -> Option:
    """The option for how many vertices there are along u and v."""
    return Option(
        "sampling",
        (u, v),
        "count",
        "So many vertices stand along u and along v",
        suffixes=("U", "V"),
        within=Range(2),
    )


def _source(name: str) -> Source:
    entry = PRIMITIVES[name]
    options = tuple(_option(name, parameter) for parameter in entry.parameters)

    def build(unit: str, sampling: tuple[int, int], placement: Placing, **parameters: Any) -> Made:
        for key, value in list(parameters.items()):
            if key in ("profile", "spine"):
                points = value[:, :2] if key == "profile" and len(value) else value
                parameters[key] = points if len(points) else None
        return Made(placed(primitive(name, *sampling, **parameters), placement))

    return Source(name, entry.meaning, (sampling(25, 13), *options, PLACEMENT), build)


def _option(name: str, parameter: Parameter) -> Option:
    key, default = parameter.name, parameter.default
    meaning = _OWN_MEANINGS.get((name, key), _MEANINGS[key])
    if parameter.kind == "points":
        return Option(key, _PROFILE if key == "profile" else (), "points", meaning)
    if parameter.kind == "word":
        return Option(key, default, "choice", meaning, _LINES[name])
    kind: Kind = "length" if key in _LENGTHS else "number"
    others: dict[Kind, set[str]] = {"distance": _DISTANCES, "angle": _ANGLES, "area": _AREAS}
    for other, names in others.items():
        kind = other if key in names else kind
    scale = {"length": _METRE, "distance": _METRE, "area": _METRE**2}.get(kind, 1.0)
    former = _FORMER.get((name, key))
    if isinstance(default, tuple):
        value = tuple(scale * float(x) for x in default)
        return Option(key, value, kind, meaning, former=former)
    assert isinstance(default, (int, float))
    return Option(key, scale * float(default), kind, meaning)
