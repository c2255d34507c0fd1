"""What a structural check keeps of its results in a document: for people, and for the view."""

from __future__ import annotations

import json
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.objects.properties import HIDDEN, OUTPUT, READ_ONLY, Property
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.diagrams import drawn_combination, forces_along
from freecad_ortho.structural.numbers import check_numbers
from solver.mesh.quadmesh import FloatArray

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_SEEN = OUTPUT | READ_ONLY
_KEPT = OUTPUT | READ_ONLY | HIDDEN
# Of the forces of all combinations, kN and kNm: numbers that are short in binary pack well.
_FORCE_STEP = 2.0**-17


def _result(kind: str, name: str, tooltip: str, flags: int = _SEEN) -> Property:
    return Property(f"App::Property{kind}", name, "Result", tooltip, flags=flags)


RESULTS = (
    _result(
        "Bool", "Passed", QT_TRANSLATE_NOOP("App::Property", "Whether all that was checked holds")
    ),
    _result(
        "Float",
        "Utilisation",
        QT_TRANSLATE_NOOP("App::Property", "Of the most used member, %; 100 is all that it has"),
    ),
    _result(
        "Integer",
        "MostUsedMember",
        QT_TRANSLATE_NOOP("App::Property", "Number of the most used member: that of its edge"),
    ),
    _result(
        "Float",
        "BucklingFactor",
        QT_TRANSLATE_NOOP("App::Property", "Least factor on the loads; 0 where nothing buckles"),
    ),
    _result(
        "Length",
        "LargestDisplacement",
        QT_TRANSLATE_NOOP("App::Property", "Of a node in service"),
    ),
    _result(
        "Length",
        "DisplacementLimit",
        QT_TRANSLATE_NOOP("App::Property", "Largest displacement that passes"),
    ),
    _result(
        "Float",
        "ShareOfBending",
        QT_TRANSLATE_NOOP(
            "App::Property", "Largest share of the strain energy that is not of axial forces, %"
        ),
    ),
    _result(
        "String",
        "CheckedSection",
        QT_TRANSLATE_NOOP("App::Property", "Section and material checked"),
    ),
    _result("Float", "MemberMass", QT_TRANSLATE_NOOP("App::Property", "Mass of all members, kg")),
    _result(
        "StringList",
        "Remarks",
        QT_TRANSLATE_NOOP("App::Property", "What is to be known of the model"),
    ),
    _result("String", "Report", QT_TRANSLATE_NOOP("App::Property", "The check as JSON"), _KEPT),
    _result("VectorList", "Nodes", QT_TRANSLATE_NOOP("App::Property", "Nodes of the frame"), _KEPT),
    _result(
        "IntegerList",
        "MemberNodes",
        QT_TRANSLATE_NOOP("App::Property", "Nodes of the members, two each"),
        _KEPT,
    ),
    _result(
        "FloatList",
        "MemberUtilisation",
        QT_TRANSLATE_NOOP("App::Property", "Utilisation of each member, 1 is all"),
        _KEPT,
    ),
    _result(
        "FloatList",
        "AxialForces",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Axial force of each member where it is used most, kN; tension positive",
        ),
        _KEPT,
    ),
    _result(
        "String",
        "DiagramsOf",
        QT_TRANSLATE_NOOP("App::Property", "Combination whose forces are drawn as diagrams"),
    ),
    _result(
        "FloatList",
        "ForcesAlong",
        QT_TRANSLATE_NOOP(
            "App::Property", "N, Vy, Vz, T, My, Mz at start, middle and end of the members, kN, kNm"
        ),
        _KEPT,
    ),
    _result(
        "VectorList",
        "SectionsUp",
        QT_TRANSLATE_NOOP("App::Property", "Where the height of the members' sections points to"),
        _KEPT,
    ),
    _result(
        "VectorList",
        "Displacements",
        QT_TRANSLATE_NOOP("App::Property", "Of the nodes, in the service case that moves one most"),
        _KEPT,
    ),
    _result(
        "StringList",
        "CombinationNames",
        QT_TRANSLATE_NOOP("App::Property", "All combinations, any of which can be drawn"),
        _KEPT,
    ),
    _result(
        "FloatList",
        "AllForcesAlong",
        QT_TRANSLATE_NOOP("App::Property", "As ForcesAlong, of all combinations, one by one"),
        _KEPT,
    ),
    _result(
        "VectorList",
        "AllDisplacements",
        QT_TRANSLATE_NOOP("App::Property", "Of the nodes in all combinations, one by one"),
        _KEPT,
    ),
    _result(
        "FloatList",
        "BucklingFactors",
        QT_TRANSLATE_NOOP("App::Property", "Of the modes under the loads that buckle it first"),
        _KEPT,
    ),
    _result(
        "VectorList",
        "BucklingShapes",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "Movements of nodes, then middles of members; modes one after the other",
        ),
        _KEPT,
    ),
    _result(
        "String",
        "Verdict",
        QT_TRANSLATE_NOOP("App::Property", "What the check comes to, in one line"),
    ),
)


def store(
    feature: FreeCAD.DocumentObject, found: StructuralCheck, nodes: FloatArray, turn: FloatArray
) -> None:
    """Keep what a check came to.

    Args:
        feature: the structural check.
        found: its results.
        nodes: (N, 3) of the frame, in the coordinates of the net, mm.
        turn: (3, 3) rotation from there to where z is up.
    """
    report = check_numbers(found)
    # Drawn on the net, arms or not.
    members = np.asarray(found.model.mesh.connectivity.edges)
    moved = max(found.service, key=lambda one: float(one.displacement.max()), default=None)
    first = found.first_to_buckle
    modes = None if first is None else first.buckling
    moves = np.zeros((0, 3)) if moved is None else moved.response.displacements[: len(nodes), :3]
    everywhere = [one.response.displacements[: len(nodes), :3] for one in found.found]
    shapes = np.zeros((0, 3)) if modes is None else _with_middles(modes.shapes, found)
    values: dict[str, Any] = {
        "Passed": found.passed,
        "Utilisation": 100 * report["utilisation"],
        "MostUsedMember": report["most_used_member"],
        "BucklingFactor": found.factor or 0.0,
        "LargestDisplacement": found.deflection,
        "DisplacementLimit": found.deflection_limit,
        "ShareOfBending": 100 * max(one.bent or 0.0 for one in found.strength),
        "CheckedSection": f"{report['section']} of {report['material']}",
        "MemberMass": report["mass_of_members_kg"],
        "Remarks": report["warnings"],
        "Report": json.dumps(report),
        "Nodes": convert.vectors(nodes),
        "MemberNodes": members.ravel().tolist(),
        "MemberUtilisation": found.utilisation.tolist(),
        "AxialForces": (found.governing_forces[:, 0] / 1e3).tolist(),
        "DiagramsOf": drawn_combination(found).combination.name,
        "ForcesAlong": forces_along(found).ravel().tolist(),
        "SectionsUp": convert.vectors(found.model.bare.axes[:, 2] @ turn),
        "Displacements": convert.vectors(moves @ turn),
        "AllForcesAlong": _stepped(np.ravel([forces_along(found, one) for one in found.found])),
        "AllDisplacements": convert.vectors(np.concatenate(everywhere) @ turn),
        "CombinationNames": [one.combination.name for one in found.found],
        "BucklingFactors": [] if modes is None else modes.factors.tolist(),
        "BucklingShapes": convert.vectors(shapes @ turn),
        "Verdict": found.verdict,
    }
    for name, value in values.items():
        setattr(feature, name, value)


def _stepped(forces: FloatArray) -> list[float]:
    return (np.round(forces / _FORCE_STEP) * _FORCE_STEP).tolist()


def _with_middles(shapes: FloatArray, found: StructuralCheck) -> FloatArray:
    """(k (N + M), 3) of modes (k, ..., 6) of the frame with its members in pieces."""
    frame, pieces = found.model.frame, found.model.design.pieces
    within = shapes[:, len(frame.nodes) :, :3]
    within = within.reshape(len(shapes), len(frame.members), pieces - 1, 3)
    within = within[:, : len(found.model.families)]
    count = found.model.mesh.connectivity.vertex_count
    middles = 0.5 * (within[:, :, (pieces - 2) // 2] + within[:, :, (pieces - 1) // 2])
    return np.concatenate([shapes[:, :count, :3], middles], axis=1).reshape(-1, 3)
