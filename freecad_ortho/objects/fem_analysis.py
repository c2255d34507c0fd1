"""The model of a structural check as an analysis of the FEM workbench."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from importlib.util import find_spec
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.objects import fem_loads
from freecad_ortho.structural.calculix import ARM, PIECES, JoinedBeams, arm_side, what_is_missing
from freecad_ortho.structural.model import Model
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate


def refuse_missing(model: Model) -> None:
    """Raise InputError where there is no FEM workbench, or it has no such model."""
    if find_spec("ObjectsFem") is None:
        raise InputError(
            "FEM analysis: FreeCAD's FEM workbench is not installed; the files of the check have "
            "the model for CalculiX itself"
        )
    missing = what_is_missing(model)
    if missing:
        raise InputError(
            f"FEM analysis: CalculiX in the FEM workbench does not know the model's {missing}; "
            "model.json among the files of the check has all of it"
        )


def create(
    document: FreeCAD.Document, model: Model, factors: Mapping[str, float], shift: FloatArray
) -> FreeCAD.DocumentObject:
    """Add the analysis.

    Args:
        document: where to.
        model: of the check.
        factors: of the load cases by their names; the others are there with 0.
        shift: (3,) that takes the model to its place, mm.
    """
    import ObjectsFem

    from freecad_ortho.objects import fem_solver

    analysis = ObjectsFem.makeAnalysis(document, "NetAnalysis")
    joined = JoinedBeams.of(model)
    lines = _lines(document, joined, shift)
    members = [fem_solver.create(document), _mesh(document, model, joined, lines, shift)]
    members += _sections(ObjectsFem, document, model, joined, lines)
    members += _supports(ObjectsFem, document, model, joined, lines)
    for case in model.cases:
        factor = float(factors.get(case.name, 0.0))
        members.append(fem_loads.create(document, case.name, factor, joined.forces(case.loads)))
    for member in (lines, *members):
        analysis.addObject(member)
    if FreeCAD.GuiUp:
        import FemGui

        # As with an analysis of FreeCAD's own: "Run solver" asks for an active one.
        FemGui.setActiveAnalysis(analysis)
    return analysis


def _lines(document: Any, joined: JoinedBeams, shift: FloatArray) -> Any:
    """An edge for every member, with two vertices each, which sections and supports name."""
    import Part

    ends = (joined.frame.nodes + shift)[joined.frame.members]
    edges = [Part.makeLine(*convert.vectors(pair)) for pair in ends]
    feature = document.addObject("Part::Feature", "MemberLines")
    feature.Label = translate("Ortho", "Lines of the members")
    feature.Shape = Part.makeCompound(edges)
    return feature


def _mesh(document: Any, model: Model, joined: JoinedBeams, lines: Any, shift: FloatArray) -> Any:
    import Fem

    cut = joined.cut
    mesh, places = Fem.FemMesh(), cut.frame.nodes + shift
    for node in cut.used.tolist():
        mesh.addNode(*places[node].tolist(), node + 1)
    for number, (one, middle, two) in enumerate((cut.elements + 1).tolist(), 1):
        mesh.addEdge([one, two, middle], number)
    feature = document.addObject("Fem::FemMeshObject", "MemberMesh")
    feature.FemMesh = mesh
    feature.Label = translate("Ortho", "Line elements of the members")
    if "Shape" not in feature.PropertiesList:
        feature.addProperty("App::PropertyLink", "Shape", "FEM Mesh", "Geometry of the mesh")
    feature.Shape = lines
    words = "Direction of the width of each member's section"
    feature.addProperty("App::PropertyVectorList", "SectionWidths", "FEM Mesh", words, 4)
    feature.SectionWidths = convert.vectors(joined.frame.axes[:, 1])
    words = "Elements of each member, one member after the other"
    feature.addProperty("App::PropertyInteger", "ElementsPerMember", "FEM Mesh", words, 1)
    feature.ElementsPerMember = PIECES
    words = "The first nodes are those of the net, so many"
    feature.addProperty("App::PropertyInteger", "NetNodes", "FEM Mesh", words, 5)
    feature.NetNodes = len(model.mesh.vertices)
    words = "Lines for CalculiX: joints that give, panels that stiffen, springs of supports"
    feature.addProperty("App::PropertyStringList", "Links", "FEM Mesh", words, 4)
    feature.Links = list(joined.link_lines(model))
    return feature


def _sections(
    fem: Any, document: Any, model: Model, joined: JoinedBeams, lines: Any
) -> Iterable[Any]:
    """A section and a material for each group of members, and for arms beside the net."""
    one_for_all = len(model.groups) == 1 and len(joined.frame.members) == len(model.families)
    for group in model.groups:
        profile, material = group.profile, group.material
        on = [] if one_for_all else _named(lines, np.flatnonzero(group.members))
        section = _section(fem, document, profile.series, profile)
        # In brackets: FreeCAD counts on from numbers that labels end with, as that of a wall.
        section.Label = f"{group.name or translate('Ortho', 'Members')} ({profile.name})"
        section.References = on
        yield section
        poisson = material.youngs_modulus / (2 * material.shear_modulus) - 1
        yield _material(
            fem,
            document,
            material.name,
            (material.youngs_modulus, min(poisson, 0.49), material.density),
            on,
        )
    arms = np.arange(len(model.families), len(joined.frame.members))
    if len(arms):
        side, on = arm_side(model), _named(lines, arms)
        section = _rectangle(fem, document, side, side)
        section.Label, section.References = translate("Ortho", "Arms beside the net"), on
        yield section
        stiff = ARM * float(model.bare.stiffness.youngs.max())
        yield _material(fem, document, translate("Ortho", "Arms"), (stiff, 0.3, 0.0), on)


def _section(fem: Any, document: Any, series: str, profile: Any) -> Any:
    width, height, wall = profile.width, profile.height, profile.wall
    section = _rectangle(fem, document, width, height)
    if series == "chs":
        section.SectionType = "Pipe"
        section.PipeDiameter, section.PipeThickness = f"{height} mm", f"{wall} mm"
    elif series == "tube" and "Box" in section.getEnumerationsOfProperty("SectionType"):
        section.SectionType = "Box"
        section.BoxWidth, section.BoxHeight = f"{width} mm", f"{height} mm"
        for side in ("BoxT1", "BoxT2", "BoxT3", "BoxT4"):
            setattr(section, side, f"{wall} mm")
    elif series == "tube":
        # Before FreeCAD 1.1 sections of rectangles are solid.
        words = "Wall of this hollow rectangle, which the solver of this analysis heeds"
        section.addProperty("App::PropertyLength", "Wall", "RectBeamSection", words)
        section.Wall = f"{wall} mm"
    return section


def _rectangle(fem: Any, document: Any, width: float, height: float) -> Any:
    section = fem.makeElementGeometry1D(document, name="MemberSection")
    section.SectionType = "Rectangular"
    section.RectWidth, section.RectHeight = f"{width} mm", f"{height} mm"
    return section


def _material(
    fem: Any, document: Any, name: str, values: tuple[float, float, float], on: list[Any]
) -> Any:
    """Young's modulus in MPa, Poisson's ratio, density in kg/m3."""
    feature = fem.makeMaterialSolid(document, "MemberMaterial")
    youngs, poisson, density = values
    feature.Label = f"{translate('Ortho', 'Material')} ({name})"
    feature.Material = {
        "Name": name,
        "YoungsModulus": f"{youngs:.9g} MPa",
        "PoissonRatio": f"{poisson:.9g}",
        "Density": f"{density:.9g} kg/m^3",
    }
    feature.References = on
    return feature


def _supports(
    fem: Any, document: Any, model: Model, joined: JoinedBeams, lines: Any
) -> Iterable[Any]:
    """A constraint for every kind of support."""
    held, first = model.supports.fixed, {}
    for place, node in enumerate(joined.frame.members.ravel().tolist(), 1):
        first.setdefault(node, f"Vertex{place}")
    kinds, which = np.unique(held, axis=0, return_inverse=True)
    for kind, fixed in enumerate(kinds):
        if not fixed.any():
            continue
        nodes = np.flatnonzero(which.ravel() == kind).tolist()
        names = tuple(first[node] for node in nodes if node in first)
        if fixed.all():
            support = fem.makeConstraintFixed(document, "Support")
        else:
            support = fem.makeConstraintDisplacement(document, "Support")
            for word, holds in zip(("x", "y", "z", "rotx", "roty", "rotz"), fixed, strict=True):
                setattr(support, f"{word}Free", not holds)
                # Until FreeCAD 0.21; since then what is not free and moves by 0 is held.
                if f"{word}Fix" in support.PropertiesList:
                    setattr(support, f"{word}Fix", bool(holds))
        support.References = [(lines, names)]
        yield support


def _named(lines: Any, members: FloatArray) -> list[Any]:
    return [(lines, tuple(f"Edge{k + 1}" for k in members.tolist()))]
