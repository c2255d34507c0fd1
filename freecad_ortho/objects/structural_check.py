"""The structural check in a document: a net as a frame, its loads, and what it comes to."""

from __future__ import annotations

import json
from collections.abc import Mapping
from hashlib import sha256
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import __version__, answers, convert
from freecad_ortho.objects import outdated, places
from freecad_ortho.objects.build import material_of
from freecad_ortho.objects.check_results import RESULTS, store
from freecad_ortho.objects.kinds import BEAMS, LAMELLAS, TITLES, is_structure
from freecad_ortho.objects.net import is_net
from freecad_ortho.objects.option_properties import properties, read, stored
from freecad_ortho.objects.properties import Property, version_of
from freecad_ortho.objects.system_properties import system_of
from freecad_ortho.standing import check_structure, size_structure
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.design import Design
from freecad_ortho.structural.model import GRAVITY
from freecad_ortho.structural.sizing import Sizing
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 1
_GROUP = "Structural check"
# Settings of a design that are lists of texts -> their properties.
TEXTS = {"wind": "Wind", "load": "PointLoads"}
# Checking takes about so long for each member, with balance in the deformed shape too.
_SECONDS_A_MEMBER, _SECONDS_SECOND_ORDER = 2e-3, 3e-2

_PROPERTIES = (
    Property(
        "App::PropertyLink",
        "Net",
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "Net whose edges are the members"),
    ),
    Property(
        "App::PropertyLink",
        "Members",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Beams or lamellas whose section and material count; empty: those given here",
        ),
    ),
    Property(
        "App::PropertyLink",
        "Cladding",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property", "Structure whose weight is a load by the surface, such as panels"
        ),
    ),
    *(item for option in Design.options for item in properties(option, _GROUP)),
    Property(
        "App::PropertyStringList",
        TEXTS["wind"],
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "The wind has this pressure in kN/m2 and blows this way, as 0.6@x; a case each",
        ),
    ),
    Property(
        "App::PropertyStringList",
        TEXTS["load"],
        _GROUP,
        QT_TRANSLATE_NOOP("App::Property", "These vertices carry these forces in kN, as 12:0,0,-5"),
    ),
    Property(
        "App::PropertyStringList",
        "Combinations",
        _GROUP,
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Lines as 'strength: 1.35 self-weight + 1.5 snow'; empty: those of EN 1990",
        ),
    ),
    *outdated.updating(_GROUP),
    *RESULTS,
    version_of(_GROUP, VERSION),
)


class Check(outdated.Following):
    """Proxy of a structural check."""

    properties = _PROPERTIES
    version = VERSION

    def rebuild(
        self, feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None
    ) -> None:
        """Check anew."""
        rebuild(feature, progress)

    def fingerprint(self, feature: FreeCAD.DocumentObject) -> str:
        """A word that stands for all that is checked."""
        return _fingerprint(feature)

    def stands_on(self, feature: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
        """The structures that members and weights come from."""
        return [item for item in (feature.Members, feature.Cladding) if is_structure(item)]

    def is_built(self, feature: FreeCAD.DocumentObject) -> bool:
        """Tell whether it was checked before."""
        return bool(feature.Verdict)

    def seconds_about(self, feature: FreeCAD.DocumentObject) -> float:
        """What checking takes about."""
        each = _SECONDS_SECOND_ORDER if feature.SecondOrder else _SECONDS_A_MEMBER
        return each * len(feature.MemberUtilisation)


def create(
    document: FreeCAD.Document, net: FreeCAD.DocumentObject, given: Mapping[str, Any]
) -> FreeCAD.DocumentObject:
    """Add a structural check to a document without checking yet.

    Args:
        document: where to.
        net: whose edges are the members.
        given: values of its properties, by name.
    """
    feature = document.addObject("App::FeaturePython", "StructuralCheck")
    Check(feature)
    outdated.watch()
    feature.Label = FreeCAD.Qt.translate("Ortho", "Structural check")
    feature.Net = net
    for name, value in given.items():
        setattr(feature, name, value)
    if FreeCAD.GuiUp:
        answers.ask("show structural check", feature.ViewObject)
    return feature


def is_check(feature: object) -> bool:
    """Tell whether a document object is a structural check."""
    return isinstance(getattr(feature, "Proxy", None), Check)


def written(design: Mapping[str, Any]) -> dict[str, Any]:
    """Values of properties, by their names, of settings of a design by theirs."""
    options = {option.name: option for option in Design.options}
    found: dict[str, Any] = {}
    for name, value in design.items():
        if name in TEXTS:
            found[TEXTS[name]] = [value] if isinstance(value, str) else list(value)
        else:
            found |= stored(options[name], options[name].plain(value))
    return found


def design_of(feature: FreeCAD.DocumentObject) -> dict[str, Any]:
    """Settings of the design by their names, as the properties say them."""
    design = {option.name: read(feature, option) for option in Design.options}
    return design | {name: tuple(getattr(feature, word)) for name, word in TEXTS.items()}


def checked(
    feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None
) -> StructuralCheck:
    """Check what the properties say.

    Raises:
        InputError: what cannot be checked.
    """
    mesh, _ = _standing_mesh(feature)
    lines = list(feature.Combinations) or None
    return check_structure(mesh, combinations=lines, progress=progress, **_design(feature))


def checked_in_place(
    feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None
) -> tuple[StructuralCheck, FloatArray]:
    """As ``checked``, and (3,) the shift that takes nodes of its model to the document's place."""
    found, (mesh, _) = checked(feature, progress), _standing_mesh(feature)
    return found, mesh.vertices[0] - found.model.mesh.vertices[0]


def sized(
    feature: FreeCAD.DocumentObject,
    sections: str,
    groups: str,
    progress: outdated.Progress | None = None,
) -> Sizing:
    """Look for the lightest section with which it passes.

    Raises:
        InputError: what cannot be checked, or members that are those of beams.
    """
    if feature.Members is not None:
        raise InputError(
            f"{feature.Label}: has the members of {feature.Members.Label}; give its section here "
            "first"
        )
    mesh, _ = _standing_mesh(feature)
    design = _design(feature)
    design.pop("section")
    common: Any = {"combinations": list(feature.Combinations) or None, "progress": progress}
    return size_structure(mesh, sections, groups=groups, **common, **design)


def rebuild(feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None) -> None:
    """Check anew and keep what came of it.

    Raises:
        OrthoError: what cannot be checked; nothing was changed.
    """
    with outdated.timed(feature):
        found = checked(feature, progress)
    feature.Outdated, feature.Notice = False, outdated.notice(feature)
    feature.BuiltFrom = _fingerprint(feature)
    # What the view draws lies in the coordinates of the net.
    _, place = _standing_mesh(feature)
    store(feature, found, convert.array(feature.Net.Vertices), convert.placing(place)[0])
    say = FreeCAD.Console.PrintMessage if found.passed else FreeCAD.Console.PrintWarning
    say(f"{feature.Label}: {found.verdict}\n")


def _standing_mesh(feature: FreeCAD.DocumentObject) -> tuple[QuadMesh, FreeCAD.Placement]:
    """The net as it stands in the document, where z is up, and how it was moved there."""
    if not is_net(feature.Net):
        raise InputError(f"{feature.Label}: stands on no net; set its property 'Net' first")
    place = places.container(feature.Net)
    return places.moved_mesh(convert.quad_mesh(feature.Net), place), place


def _design(feature: FreeCAD.DocumentObject) -> dict[str, Any]:
    """The design with what its structures say of members and weights."""
    design = design_of(feature)
    if feature.Members is not None:
        design |= _members(feature.Members)
    if feature.Cladding is not None:
        design["panels"] += _weight(feature.Cladding)
    return design


def _members(beams: FreeCAD.DocumentObject) -> dict[str, Any]:
    """Section and material of beams or lamellas, and how these stand.

    Raises:
        InputError: neither, or some that are not on every edge.
    """
    if is_structure(beams) and beams.System == LAMELLAS:
        return _lamellas(beams)
    if not is_structure(beams) or beams.System != BEAMS:
        raise InputError(f"{beams.Label}: has no section for members; choose beams or lamellas")
    system = system_of(beams, TITLES[BEAMS])
    if beams.Family != "Both" or len(beams.Lines) or not system.boundary_beams:
        raise InputError(
            f"{beams.Label}: has no beams on some edges, and the check has a member on each; give "
            "the section itself"
        )
    material = material_of(beams)
    own = getattr(system.profile, "material", None)
    return {
        "section": system.profile_name,
        "material": (material if own is None else own(material)).name,
    }


def _lamellas(structure: FreeCAD.DocumentObject) -> dict[str, Any]:
    """Plates of lamellas, where they stand, and how far apart two layers of them are.

    Raises:
        InputError: some that are not on every edge.
    """
    if structure.Family != "Both" or len(structure.Lines):
        raise InputError(
            f"{structure.Label}: has no lamellas on some edges, and the check has a member on "
            "each; give the section itself"
        )
    system = system_of(structure, TITLES[LAMELLAS])
    across = system.thickness if system.position == "lying" else system.width
    return {
        "section": f"plate:{system.thickness:g}x{system.width:g}",
        "material": material_of(structure).name,
        "position": system.position,
        "layers": across + system.clearance if system.layers == 2 else 0.0,
    }


def _weight(structure: FreeCAD.DocumentObject) -> float:
    """Weight of a structure by the surface of its net, kN/m2."""
    if not is_structure(structure) or not structure.Report:
        raise InputError(f"{structure.Label}: weighs nothing yet; build it first, or choose panels")
    area = float(np.linalg.norm(convert.quad_mesh(structure.Net).face_area_vectors, axis=1).sum())
    return float(json.loads(structure.Report)["mass_kg"]) * GRAVITY / 1e3 / (area / 1e6)


def _fingerprint(feature: FreeCAD.DocumentObject) -> str:
    mesh, _ = _standing_mesh(feature)
    word = sha256(mesh.vertices.tobytes() + mesh.connectivity.half_edges[:, 0].tobytes())
    # Another version of the workbench may check in another way.
    said = (__version__, sorted(_design(feature).items()), list(feature.Combinations))
    word.update(repr(said).encode())
    return word.hexdigest()
