"""The check as one HTML page: verdict, pictures, governing members, assumptions, what is left."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

import numpy as np

from freecad_ortho.fabrication.report.page import STYLE
from freecad_ortho.fabrication.report.pictures import CORNER, PLAN
from freecad_ortho.structural.check import ENOUGH, CombinationResult, StructuralCheck
from freecad_ortho.structural.diagram_pictures import diagram_picture
from freecad_ortho.structural.diagrams import FORCES, drawn_combination, forces_along
from freecad_ortho.structural.pictures import frame_picture
from freecad_ortho.structural.strength import used_share
from freecad_ortho.structural.words import NOT_CHECKED, assumptions, loads, warnings
from solver.mesh.quadmesh import FloatArray

_WIDE = ".frames > * { flex: 1 1 26rem; }"
_MEANINGS = {
    "N": "axial force: tension is positive, upwards",
    "Vy": "shear across the height, in plan",
    "Vz": "shear along the height",
    "T": "torsion",
    "My": "moment in the plane of the height, at the side that it pulls at",
    "Mz": "moment across it, in plan, at the side that it pulls at",
}
# Most members in the list, and how far shapes are drawn, by the span.
_LISTED, _DRAWN = 15, 0.06


def check_page(check: StructuralCheck, project: str = "") -> str:
    """The page; pictures are part of it, so it works without a network.

    Args:
        check: what is reported.
        project: what the page is headed by.
    """
    title = escape(f"Structural check: {project}" if project else "Structural check")
    model = check.model
    bad = "" if check.passed else " bad"
    sections = [
        f"<h1>{title}</h1>",
        f"<p>{len(model.families)} members {escape(model.section_words)} of "
        f"{escape(model.material_words)}, {model.mass / 1000:.2f} t by their length from node to "
        "node. A design check of a conceptual model, no proof for a permit: an engineer has to "
        "answer for it.</p>",
        f'<p class="verdict{bad}">{escape(check.verdict)}</p>',
        _limits(check),
        _list("Mind", warnings(check)),
        _pictures(check),
        _diagrams(check),
        _loads(check),
        _combinations(check),
        _governing(check),
        _supports(check),
        _list("Assumptions", assumptions(check)),
        _list("Not checked", NOT_CHECKED),
        "<p>Imbalance of loads and reactions: "
        f"{check.balance:.1e} of their sum. N is tension where positive; My bends a member in the "
        "plane of its section's height, Mz across it.</p>",
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{STYLE}{_WIDE}</style></head>\n'
        f"<body>{chr(10).join(section for section in sections if section)}</body></html>\n"
    )


def _limits(check: StructuralCheck) -> str:
    """What the numbers of the verdict are measured by."""
    design, limit = check.model.design, check.deflection_limit
    return (
        "<p>Limits: members 100 % with their partial factors, displacements of nodes in service "
        f"{limit:.1f} mm (1/{design.deflection:g} of {check.model.span / 1000:.2f} m), buckling "
        f"factors {'1' if design.second_order else f'{ENOUGH:g}, and 1 with second order'}; they "
        "are on loads that have their partial factors already.</p>"
    )


def _list(title: str, items: Sequence[str]) -> str:
    if not items:
        return ""
    return f"<h2>{title}</h2><ul>{''.join(f'<li>{escape(item)}</li>' for item in items)}</ul>"


def _pictures(check: StructuralCheck) -> str:
    frame = check.model.bare
    percent = 100 * check.utilisation
    figures = [
        _figure(
            frame_picture(frame, percent, 100.0, "%", eye, f"utilisation, {name}"),
            f"Utilisation of members, {name}",
        )
        for name, eye in (("plan", PLAN), ("from a corner", CORNER))
    ]
    moved = max(check.service, key=lambda one: float(one.displacement.max()), default=None)
    if moved is not None:
        figures.append(_deflected(check, moved))
    first = check.first_to_buckle
    if first is not None and first.buckling is not None:
        shape = first.buckling.shapes[0][: len(frame.nodes), :3]
        words = f"First buckling mode, factor {first.factor:.2f} under {first.combination.name}"
        figures.append(_shape(check, shape, words, ""))
    return f'<h2>Pictures</h2><div class="row frames">{"".join(figures)}</div>'


def _figure(picture: str, words: str) -> str:
    return f"<figure>{picture}<figcaption>{escape(words)}</figcaption></figure>"


def _deflected(check: StructuralCheck, found: CombinationResult) -> str:
    shape = found.response.displacements[:, :3]
    return _shape(check, shape, f"Deflected shape, {found.combination.name}", "mm")


def _shape(check: StructuralCheck, shape: FloatArray, words: str, unit: str) -> str:
    size = np.linalg.norm(shape, axis=1)
    largest = float(size.max())
    drawn = _DRAWN * check.model.span / largest if largest else 0.0
    values = size[check.model.bare.members].mean(axis=1)
    picture = frame_picture(
        check.model.bare, values, largest, unit, CORNER, words, moved=drawn * shape
    )
    times = f", drawn {drawn:.3g} times as large" if unit else ""
    return _figure(picture, f"{words}{times}")


def _diagrams(check: StructuralCheck) -> str:
    """Forces along the members, in the combination that uses one most."""
    forces, frame = forces_along(check), check.model.bare
    name = drawn_combination(check).combination.name
    figures = []
    for number, force in enumerate(FORCES):
        words = f"{force}, {_MEANINGS[force]}"
        eye = PLAN if force in ("Vy", "Mz") else CORNER
        figures.append(
            _figure(diagram_picture(frame, force, forces[:, :, number], eye, words), words)
        )
    deformed = (
        " Those in the deformed shape may be much larger: see the governing members."
        if check.imperfection is not None
        else ""
    )
    note = (
        f"<p>{escape(name)}, by first order.{deformed} Ordinates stand on the members, along their "
        "sections' height or width; the bar is as long as one that is seen from the side.</p>"
    )
    return f'<h2>Diagrams</h2>{note}<div class="row frames">{"".join(figures)}</div>'


def _loads(check: StructuralCheck) -> str:
    rows = [
        (name, given, *(f"{force + 0.0:.1f}" for force in np.round(total, 1).tolist()))
        for name, given, total in loads(check)
    ]
    head = ("case", "given", "sum along x, kN", "along y", "along z, upwards")
    return "<h2>Loads</h2>" + _table(head, rows)


def _combinations(check: StructuralCheck) -> str:
    rows = []
    for one in check.found:
        factors = [] if one.buckling is None else one.buckling.factors.tolist()
        used = used_share(float(one.utilisation.max()))
        strength = one in check.strength
        rows.append(
            (
                one.combination.name,
                used if strength else "",
                ", ".join(f"{factor:.2f}" for factor in factors),
                "" if one.bent is None else f"{100 * one.bent:.0f} %",
                "" if one.membrane is None else f"{100 * one.membrane.carried:.0f} %",
                "" if one.carried is None else f"{100 * one.carried:.0f} %",
                "" if strength else f"{float(one.displacement.max()):.1f}",
            )
        )
    head = ("combination", "utilisation", "buckling factors", "bending", "by axial forces")
    more = ("carried, 2nd order", "moves, mm")
    note = (
        "<p>Bending is the share of the strain energy that is not of axial forces: small where the "
        "shell carries by its form. By axial forces: the part of the load at the nodes that these "
        f"alone balance.{_form(check)}</p>"
    )
    return "<h2>Combinations</h2>" + note + _table((*head, *more), rows)


def _form(check: StructuralCheck) -> str:
    """How near the form is to one that bends nowhere under the load that is worst for it."""
    some = [one for one in check.strength if one.membrane is not None]
    worst = max(some, key=lambda one: one.membrane.left if one.membrane else 0.0, default=None)
    if worst is None or worst.membrane is None:
        return ""
    return (
        f" In this form no axial forces can balance {100 * worst.membrane.left:.1f} % of "
        f"{escape(worst.combination.name)}, more than of any other; a stress net leaves nothing "
        "of the load it was made for, but how much its frame then bends is up to its stiffness. "
        f"The nearest axial forces that balance the rest are {worst.membrane.needed:.1f} times as "
        f"large as the frame's, which are {100 * worst.membrane.apart:.0f} % apart: where that is "
        "much, the form asks for more push and pull than the frame takes up, and it bends."
    )


def _governing(check: StructuralCheck) -> str:
    order = np.argsort(-check.utilisation, kind="stable")[:_LISTED]
    rows = []
    for member in order.tolist():
        by = check.strength[int(check.governing[member])]
        forces = check.governing_forces[member]
        rows.append(
            (
                f"{member} ({check.model.families[member]})",
                used_share(check.utilisation[member]),
                by.by(member),
                *(f"{forces[k] / 1e3:.2f}" for k in range(3)),
                *(f"{forces[k] / 1e6:.3f}" for k in range(3, 6)),
                "deformed" if check.governed_deformed[member] else "as drawn",
                by.combination.name,
            )
        )
    head = ("member", "utilisation", "by", "N, kN", "Vy, kN", "Vz, kN", "T, kNm", "My, kNm")
    note = (
        "<p>The most used members, with the forces that govern them: those of the section that is "
        "used most, or where the member buckles between its ends the most compression and the "
        "largest of the others along it; a slot is what one leaves of a section. Shape: "
        "as drawn (first order), or deformed from an imperfect one (second order). All are in "
        "members.csv, those of first order in forces.csv.</p>"
    )
    more = ("Mz, kNm", "shape", "combination")
    return "<h2>Governing members</h2>" + note + _table((*head, *more), rows)


def _supports(check: StructuralCheck) -> str:
    down, up, sideways = (force / 1e3 for force in check.largest_reactions)
    return (
        "<h2>Supports</h2><p>In combinations for strength, by first order, one support pushes the "
        "shell up by "
        f"{up:.1f} kN at most, holds it down by {down:.1f} kN and sideways by {sideways:.1f} kN. "
        "What is below has to take that, and not give way where the check has it held: what yields "
        "sideways bends the shell and lets it buckle earlier. All are in reactions.csv.</p>"
    )


def _table(head: Iterable[str], rows: Iterable[Sequence[str]]) -> str:
    names = "".join(f"<th>{escape(name)}</th>" for name in head)
    body = "".join(
        f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows
    )
    return f"<table><thead><tr>{names}</tr></thead><tbody>{body}</tbody></table>"
