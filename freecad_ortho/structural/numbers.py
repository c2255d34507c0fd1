"""Results and model as plain numbers for other programs."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from freecad_ortho import __version__
from freecad_ortho.structural.check import StructuralCheck
from freecad_ortho.structural.combinations import Combination
from freecad_ortho.structural.groups import Group
from freecad_ortho.structural.model import Model
from freecad_ortho.structural.strength import used_share
from freecad_ortho.structural.words import NOT_CHECKED, assumptions, loads, warnings

# Most members in the list of those that are used most.
_LISTED = 5


def check_numbers(check: StructuralCheck) -> dict[str, Any]:
    """The report: verdict, combinations, assumptions; kN, m and mm as the names say."""
    model, worst = check.model, int(check.utilisation.argmax())
    down, up, sideways = check.largest_reactions
    pull, push, shear, moment = check.largest_end_forces
    return {
        "program": f"freecad_ortho {__version__}",
        "verdict": {"passed": check.passed, "words": check.verdict, "failures": check.failures},
        "section": model.section_words,
        "material": model.material_words,
        "members": len(model.families),
        "mass_of_members_kg": model.mass,
        "utilisation": float(check.utilisation[worst]),
        "most_used_member": worst,
        "governing": check.strength[int(check.governing[worst])].combination.name,
        "buckling_factor": check.factor,
        "displacement_mm": check.deflection if check.service else None,
        "displacement_limit_mm": check.deflection_limit,
        "largest_support_forces_kN": {
            "down": down / 1e3,
            "up": up / 1e3,
            "sideways": sideways / 1e3,
        },
        "largest_end_forces": {
            "tension_kN": pull / 1e3,
            "compression_kN": push / 1e3,
            "shear_kN": shear / 1e3,
            "moment_kNm": moment / 1e6,
        },
        "largest_shear_of_panels_kN_m": check.panel_shear,
        "imbalance": check.balance,
        "load_cases": [
            {"name": name, "given": given, "sum_kN": total.tolist()}
            for name, given, total in loads(check)
        ],
        "combinations": [
            {
                "name": one.combination.name,
                "utilisation": float(one.utilisation.max()),
                "displacement_mm": float(one.displacement.max()),
                "buckling_factors": [] if one.buckling is None else one.buckling.factors.tolist(),
                "share_of_bending": one.bent,
                "carried_second_order": one.carried,
                "membrane": None if one.membrane is None else asdict(one.membrane),
            }
            for one in check.found
        ],
        "governing_members": _most_used(check),
        "assumptions": assumptions(check),
        "warnings": warnings(check),
        "not_checked": NOT_CHECKED,
    }


def _most_used(check: StructuralCheck) -> list[dict[str, Any]]:
    """The most used members with the forces that govern them; kN and kNm."""
    found = []
    for member in np.argsort(-check.utilisation, kind="stable")[:_LISTED].tolist():
        by = check.strength[int(check.governing[member])]
        n, _, _, t, my, mz = check.governing_forces[member].tolist()
        found.append(
            {
                "member": member,
                "family": check.model.families[member],
                "used": used_share(check.utilisation[member]),
                "by": by.by(member),
                "N_kN": n / 1e3,
                "T_kNm": t / 1e6,
                "My_kNm": my / 1e6,
                "Mz_kNm": mz / 1e6,
                "shape": "deformed" if check.governed_deformed[member] else "as drawn",
                "combination": by.combination.name,
            }
        )
    return found


def combination_numbers(combinations: list[Combination]) -> dict[str, Any]:
    """The table of combinations, to be edited and read again."""
    return {
        "combinations": [
            {"name": one.name, "kind": one.kind, "factors": dict(one.factors)}
            for one in combinations
        ]
    }


def model_numbers(model: Model) -> dict[str, Any]:
    """The frame with sections, supports and load cases; N, mm, MPa, z upwards."""
    frame, bare = model.frame, model.bare
    count = len(model.families)
    springs = [
        {"node": int(node), "stiffness": model.supports.springs[node].tolist()}
        for node in range(len(frame.nodes))
        if model.supports.springs[node].any()
    ]
    return {
        "units": {"force": "N", "length": "mm", "stress": "MPa", "density": "kg/m3"},
        "nodes": frame.nodes.tolist(),
        "members": [
            {"nodes": pair, "z": up, "family": family, "section": section}
            for pair, up, family, section in zip(
                bare.members.tolist(),
                bare.axes[:, 2].tolist(),
                model.families,
                model.section_numbers.tolist(),
                strict=True,
            )
        ],
        "joints": model.design.joints,
        "arms_and_bolts": [
            {"nodes": pair, "turning_about_it": None if np.isinf(turning) else turning}
            for pair, turning in zip(
                frame.members[count:].tolist(), frame.springs[count:, 3].tolist(), strict=True
            )
        ],
        "sections": [_section(group) for group in model.groups],
        "supports": [
            {"node": int(node), "fixed": model.supports.fixed[node].tolist()}
            for node in range(len(frame.nodes))
            if model.supports.fixed[node].any()
        ],
        "spring_supports": springs,
        "load_cases": [
            {
                "name": case.name,
                "kind": case.kind,
                "force_by_length_of_members": case.loads.spread[:count].tolist(),
                "forces_at_nodes": [
                    {"node": int(node), "force": case.loads.nodal[node].tolist()}
                    for node in range(len(frame.nodes))
                    if case.loads.nodal[node].any()
                ],
            }
            for case in model.cases
        ],
    }


def _section(group: Group) -> dict[str, Any]:
    """Section and material of a group of members."""
    profile, material = group.profile, group.material
    return {
        "name": profile.name,
        "area": profile.area,
        "inertia_y": profile.inertia_y,
        "inertia_z": profile.inertia_z,
        "torsion": profile.torsion,
        "shear_area_y": profile.shear_area_y,
        "shear_area_z": profile.shear_area_z,
        "modulus_y": profile.modulus_y,
        "modulus_z": profile.modulus_z,
        "material": {
            "name": material.name,
            "youngs_modulus": material.youngs_modulus,
            "shear_modulus": material.shear_modulus,
            "density": material.density,
            "strength": material.bending_limit,
        },
    }
