"""From the words of a macro to the properties of a net, and from these to the solver's settings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert, preferences, written
from freecad_ortho.keywords import PassedSettings
from freecad_ortho.objects import constraints
from freecad_ortho.objects import net as net_object
from freecad_ortho.objects.net_settings import FIX_RULES
from freecad_ortho.objects.option_properties import read, write
from solver.errors import InputError, refuse_unknown
from solver.mesh.quadmesh import QuadMesh
from solver.nets import NETS, net_named, refuse_foreign
from solver.nets.constraints import Constraints
from solver.nets.options import OPTIONS, NetOptions
from solver.nets.settings import WEIGHTS, fixed_vertices
from solver.nets.supports import SUPPORTS, supports_of
from solver.option import Option, one_of


@dataclass(frozen=True)
class _Plain:
    """A keyword that is one property.

    Attributes:
        name: of the property.
        read: from the property's value to the keyword's.
        write: the other way; raises InputError.
    """

    name: str
    read: Callable[[Any], Any] = lambda value: value
    write: Callable[[Any], Any] = lambda value: value


def _choice(word: str, name: str, choices: Iterable[str]) -> _Plain:
    def write(value: str) -> str:
        one_of(word, value, choices)
        return value

    return _Plain(name, str, write)


def _option_value(option: Option, value: Any) -> Any:
    """The value of an option of nets as its properties hold it."""
    if option.kind == "mesh" and value is not None and not net_object.is_net(value):
        raise InputError(f"{option.name}: expected a Net, got {getattr(value, 'Label', value)}")
    plain = convert.option_value(option, value)
    option.check(plain)
    return plain


_PLAIN = {
    "net": _choice("net", "NetType", NETS),
    "symmetry": _Plain("MirrorPlanes", write=written.mirror_planes),
}
_DECLARED = {**OPTIONS, **WEIGHTS, SUPPORTS.name: SUPPORTS}
# What a net keeps, and what only the solver is told.
KEPT = (*_PLAIN, *_DECLARED, "fix", "handles", "glide", "close_to")
PASSED = tuple(PassedSettings.__annotations__)

Fix = str | Sequence[int | str]


def words(net: FreeCAD.DocumentObject) -> dict[str, Any]:
    """All settings of a net as the keywords of :func:`freecad_ortho.api.optimise_net`."""
    found = {word: item.read(getattr(net, item.name)) for word, item in _PLAIN.items()}
    found |= {word: read(net, option) for word, option in _DECLARED.items()}
    numbers = list(net.FixedVertices)
    found["fix"] = net.FixRule if not numbers else _fix_words(net.FixRule, numbers)
    places = (tuple(place) for place in net.HandlePlaces)
    found["handles"] = dict(zip(net.Handles, places, strict=True))
    found["glide"] = constraints.glide_words(net)
    found["close_to"] = constraints.references(net.CloseTo)
    return found


def store(net: FreeCAD.DocumentObject, given: dict[str, Any]) -> None:
    """Write settings into a net's properties; what is not given stays.

    Raises:
        InputError: a setting that cannot be used.
    """
    refuse_unknown("net", given, KEPT)
    for word, value in given.items():
        if word in _DECLARED:
            write(net, _DECLARED[word], _option_value(_DECLARED[word], value))
        elif word in _PLAIN:
            item = _PLAIN[word]
            setattr(net, item.name, item.write(value))
        elif word == "fix":
            net.FixRule, net.FixedVertices = _fix(value)
        elif word == "handles":
            vertices, places = _handles(value)
            net.Handles, net.HandlePlaces = vertices, places
        elif word == "glide":
            constraints.store_glide(net, value)
        else:
            constraints.store_close_to(net, value)


def refuse_foreign_words(net: FreeCAD.DocumentObject, given: Mapping[str, Any]) -> None:
    """Refuse what is said of a net that does not heed it; a default may be said of any.

    Raises:
        InputError: naming the option and the nets that have it.
    """
    asked = net_named(given.get("net", net.NetType))
    own = {**OPTIONS, SUPPORTS.name: SUPPORTS}
    said = [word for word in given if word in own and not own[word].is_default(given[word])]
    refuse_foreign(asked, said)


def divided(settings: dict[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Divide settings into those that a net keeps and those that only the solver is told.

    Raises:
        InputError: a setting that there is not.
    """
    refuse_unknown("net", settings, [*KEPT, *PASSED])
    kept = {word: value for word, value in settings.items() if word in KEPT}
    passed = {word: value for word, value in settings.items() if word in PASSED}
    return kept, passed


def held(net: FreeCAD.DocumentObject, mesh: QuadMesh) -> np.ndarray:
    """(V,) true for vertices of a net that do not move: those that are fixed, or its supports."""
    found = for_solver(net, mesh)
    return supports_of(mesh, NETS[net.NetType], found["fix"], found["supports"]).fixed


def for_solver(net: FreeCAD.DocumentObject, mesh: QuadMesh) -> dict[str, Any]:
    """Keyword arguments of ``solver.start_optimisation`` from the properties of a net.

    Raises:
        InputError: a shape that has gone, or settings that do not fit the mesh.
    """
    return solver_settings(words(net), mesh, net)


def solver_settings(
    values: dict[str, Any], mesh: QuadMesh, net: FreeCAD.DocumentObject
) -> dict[str, Any]:
    """Keyword arguments of ``solver.start_optimisation`` from all that :func:`words` names.

    Raises:
        InputError: a shape that has gone, or settings that do not fit the mesh.
    """
    # Which solver is a matter of the machine and its user, not of the net.
    settings: dict[str, Any] = preferences.solver_settings()
    settings.update((word, values[word]) for word in WEIGHTS if values[word] is not None)
    asked = NETS[values["net"]]
    # What other nets are told stays in the document and is none of this net's business.
    options = {word: values[word] for word in asked.options}
    for word in asked.options:
        if OPTIONS[word].kind == "mesh" and options[word] is not None:
            options[word] = convert.array(options[word].Vertices)
    fix = _numbers(mesh, *_fix(values["fix"]))
    supports = values["supports"] if "supports" in asked.told else ""
    handles = values["handles"]
    if handles:
        handles = _drawn(handles, mesh, supports_of(mesh, asked, fix, supports).fixed)
    wanted = Constraints(
        handles=handles,
        glide=constraints.glides(values["glide"], mesh, net),
        close_to=constraints.close_to(values["close_to"], mesh, net),
        symmetry=values["symmetry"],
    )
    settings.update(
        net=values["net"],
        fix=fix,
        supports=supports,
        options=NetOptions(**options),
    )
    if handles or wanted.glide or wanted.close_to or wanted.symmetry:
        settings["constraints"] = wanted
    return settings


def _drawn(
    handles: dict[int, tuple[float, ...]], mesh: QuadMesh, fixed: np.ndarray
) -> dict[int, np.ndarray]:
    """The handles, without those of vertices that are fixed where the last drag left them."""
    places = {vertex: np.array(place) for vertex, place in handles.items()}
    there = {
        vertex
        for vertex, place in places.items()
        if 0 <= vertex < len(fixed) and fixed[vertex] and (place == mesh.vertices[vertex]).all()
    }
    return {vertex: place for vertex, place in places.items() if vertex not in there}


def _numbers(mesh: QuadMesh, rule: str, vertices: list[int]) -> str | list[int]:
    """What the solver is to fix."""
    if not vertices:
        return rule
    mask = fixed_vertices(mesh, rule) | fixed_vertices(mesh, vertices)
    return np.flatnonzero(mask).tolist()


def _fix_words(rule: str, vertices: list[int]) -> list[int | str]:
    return vertices if rule == "none" else [rule, *vertices]


def _fix(value: Fix) -> tuple[str, list[int]]:
    """Take apart a rule, numbers, or a list of both."""
    parts = value.replace(" ", "").split(",") if isinstance(value, str) else list(value)
    rule, vertices = "none", []
    for part in parts:
        if part in FIX_RULES:
            rule = part if rule == "none" else rule
            continue
        try:
            vertices.append(int(part))
        except (TypeError, ValueError):
            raise InputError(
                f"fix: expected {', '.join(FIX_RULES)} or vertex numbers such as 0,5,12, got "
                f"'{value}'"
            ) from None
    return rule, sorted(set(vertices))


def _handles(value: Any) -> tuple[list[int], list[FreeCAD.Vector]]:
    """Vertices and places: of a dictionary, or of texts as on the command line, numbers in mm."""
    texts = [value] if isinstance(value, str) else value
    if isinstance(texts, (list, tuple)) and all(isinstance(text, str) for text in texts):
        value = dict(written.place("handles", text) for text in texts)
    try:
        pairs = sorted((int(vertex), _place(where)) for vertex, where in value.items())
    except (AttributeError, TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(
            f"handles: expected places by vertex such as {{12: (0, 0, 3500)}}, got {value}"
        ) from None
    return [vertex for vertex, _ in pairs], [place for _, place in pairs]


def _place(where: Any) -> FreeCAD.Vector:
    numbers = where.split(",") if isinstance(where, str) else where
    return FreeCAD.Vector(*(convert.millimetres(number, "handles") for number in numbers))
