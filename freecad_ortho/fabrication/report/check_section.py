"""The structural check in the fabrication report: verdict, what governs, what is not checked."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from freecad_ortho.fabrication.bolt_strength import bolts_used
from freecad_ortho.fabrication.cleat_strength import cleats_used

# Columns of the governing members: of the numbers, in the table.
_COLUMNS = {
    "member": "member",
    "family": "family",
    "used": "utilisation",
    "by": "by",
    "N_kN": "N, kN",
    "My_kNm": "My, kNm",
    "Mz_kNm": "Mz, kNm",
    "shape": "shape",
    "combination": "combination",
}


def check_section(
    check: Mapping[str, Any],
    nodes: Mapping[str, Any] | None = None,
    lamellas: Mapping[str, Any] | None = None,
) -> str:
    """A section of the page.

    Args:
        check: what a structural check writes into its ``check.json``.
        nodes: what the report says of bolted nodes, None where there are none.
        lamellas: what it says of these.
    """
    forces = check.get("largest_end_forces")
    bolts = ""
    if forces is not None and nodes is not None and "bolts_an_end" in nodes:
        bolts = f"<p>{escape(bolts_used(nodes, forces))}</p>"
    if forces is not None and lamellas is not None and "cleat_bolt" in lamellas:
        bolts += f"<p>{escape(cleats_used(lamellas, forces))}</p>"
    verdict, design = check["verdict"], escape(f"{check['section']} of {check['material']}")
    bad = "" if verdict["passed"] else " bad"
    head = "".join(f"<th>{escape(words)}</th>" for words in _COLUMNS.values())
    rows = "".join(
        f"<tr>{''.join(f'<td>{escape(_shown(row[name]))}</td>' for name in _COLUMNS)}</tr>"
        for row in check["governing_members"]
    )
    return (
        "<h2>Structural check</h2>"
        f'<p class="verdict{bad}">{escape(verdict["words"])}</p>'
        f"<p>{check['members']} members {design} on the edges of the net, node to node; members "
        "and nodes count as in the check. It is a design check of a conceptual model, no proof for "
        "a permit, and does not know the parts of this report but by what it was told of them.</p>"
        f"{_list('', check['warnings'])}"
        "<p>The most used members, with the forces that govern them:</p>"
        f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{bolts}"
        f"{_list('Not checked:', check['not_checked'])}"
    )


def _list(title: str, items: list[str]) -> str:
    points = "".join(f"<li>{escape(item)}</li>" for item in items)
    return f"<p>{title}</p><ul>{points}</ul>" if points else ""


def _shown(value: Any) -> str:
    return f"{value:.3g}" if isinstance(value, float) else str(value)
