"""The report as one HTML page: verdict first, then pictures, groups, numbers and lists.

It is meant to be read and printed: long lists end after some rows with the name of the file that
holds all of them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import fields
from html import escape
from typing import Any

import numpy as np

from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.part import Measures, measure_words
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.report.adjustment import adjustment
from freecad_ortho.fabrication.report.check_section import check_section
from freecad_ortho.fabrication.report.lists import (
    clash_causes,
    clashes,
    equal_parts,
    groups_of_parts,
    parts_list,
    sheets,
    stock,
    way_to_it,
)
from freecad_ortho.fabrication.report.pictures import (
    BAD,
    CORNER,
    GOOD,
    INK,
    PLAN,
    structure_view,
)
from freecad_ortho.fabrication.report.plots import histogram
from freecad_ortho.fabrication.report.way import StagesBefore
from freecad_ortho.words import counted

STYLE = f"""
body {{ font: 15px/1.45 system-ui, sans-serif; color: {INK}; margin: 2rem auto; max-width: 64rem;
  padding: 0 1rem; }}
h1 {{ margin-bottom: 0; }} h2 {{ margin-top: 2.2rem; border-bottom: 1px solid #ccd3da;
  break-after: avoid; }}
.verdict {{ font-size: 1.25rem; padding: .6rem 1rem; border-left: .5rem solid {GOOD};
  background: #f3f6f9; }}
.verdict.bad {{ border-color: {BAD}; }}
.row {{ display: flex; flex-wrap: wrap; gap: 1.2rem; }} .row > * {{ flex: 1 1 18rem; margin: 0; }}
figure {{ break-inside: avoid; }} figcaption {{ color: #66727e; }} svg {{ max-width: 100%; }}
.plots text {{ font: 11px sans-serif; }} .plots > * {{ flex: 0 0 19rem; }}
.sheets > * {{ flex: 0 1 19rem; }}
.good {{ fill: {GOOD}; }} .bad {{ fill: {BAD}; }}
path.good, path.bad {{ stroke: {INK}; stroke-width: .35; stroke-linejoin: round; }}
.bar {{ fill: {GOOD}; }} .axis {{ stroke: {INK}; }} .limit {{ stroke: {BAD}; stroke-width: 2; }}
table {{ border-collapse: collapse; font-size: .85rem; }} thead {{ display: table-header-group; }}
th, td {{ padding: .15rem .6rem; text-align: right; border-bottom: 1px solid #e4e8ec; }}
th:first-child, td:first-child, td.text {{ text-align: left; }} tr {{ break-inside: avoid; }}
.parts td:nth-child(3) {{ white-space: nowrap; }}
.parts th:last-child, .parts td:last-child {{ text-align: left; min-width: 11rem; }}
tr.bad td {{ background: #fbe9eb; }}
@media print {{ body {{ margin: 0; max-width: none; font-size: 10pt; }} }}
"""


def report_page(
    production: Production,
    project: str = "",
    way: StagesBefore | None = None,
    check: Mapping[str, Any] | None = None,
) -> str:
    """Write the page; pictures and plots are part of it, so it works without a network.

    Args:
        production: what is reported.
        project: what the page is headed by, such as the name of the mesh.
        way: how the net came to be.
        check: numbers of a structural check.
    """
    joints = production.structure.results.get("nodes")
    nodes = None if joints is None else joints.report
    of_lamellas = production.structure.results.get("lamellas")
    lamellas = None if of_lamellas is None else of_lamellas.report
    title = escape(f"Fabrication report: {project}" if project else "Fabrication report")
    sections = [
        f"<h1>{title}</h1>",
        "" if way is None else way_to_it(way),
        _summary(production),
        _views(production),
        _messages(production.messages),
        "" if check is None else check_section(check, nodes, lamellas),
        "" if nodes is None else adjustment(nodes),
        groups_of_parts(production),
        _plots(production),
        equal_parts(production),
        sheets(production),
        stock(production),
        clashes(production),
        parts_list(production),
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{STYLE}</style></head>\n'
        f"<body>{chr(10).join(section for section in sections if section)}</body></html>\n"
    )


def _summary(production: Production) -> str:
    parts = production.structure.parts
    kinds = Counter(part.kind for part in parts)
    counts = ", ".join(counted(count, kind) for kind, count in kinds.items())
    words, bad = _verdict(production)
    return (
        f"<p>{escape(_kind_and_size(production))}</p>"
        f"<p>{escape(counts)}; {escape(_of_materials(production.structure.masses))}</p>"
        f'<p class="verdict{" bad" * bad}">{escape(words)}</p>'
    )


def _verdict(production: Production) -> tuple[str, bool]:
    """What is wrong with the parts: clashes called clashes, limits limits, sizes sizes."""
    verdicts = production.structure.verdicts
    over = sum(words != OK for words in verdicts)
    causes = clash_causes(production)
    words = [f"Clashes: {cause}." for cause in causes]
    if production.clashes.open:
        words.append(f"{counted(len(production.clashes.open), 'pair')} may clash, see below.")
    if over:
        words.append(f"{over} of {len(verdicts)} parts exceed a limit.")
    if production.not_cut:
        few = counted(len(production.not_cut), "part")
        words.append(f"{few} too large for the sheets or bars to be cut from.")
    if words:
        return " ".join([*words, "Such parts are red below."]), True
    return f"All {len(verdicts)} parts are within the limits, and none clash.", False


def _of_materials(masses: dict[str, float]) -> str:
    return " and ".join(f"{mass:,.1f} kg of {name}" for name, mass in masses.items())


def _kind_and_size(production: Production) -> str:
    """The systems with their sizes, and the box of the whole net."""
    systems = []
    for name, result in production.structure.results.items():
        sizes = [
            f"{size} {value:g} mm"
            for size in ("height", "width", "thickness")
            if isinstance(value := result.report.get(f"{size}_mm"), (int, float))
        ]
        systems.append(name + (f" ({', '.join(sizes)})" if sizes else ""))
    mesh = production.structure.mesh
    points = mesh.vertices[mesh.connectivity.referenced]
    box = " x ".join(f"{side / 1000:.3g}" for side in np.ptp(points, axis=0).tolist())
    return f"{' and '.join(systems)} on a net of {box} m"


def _views(production: Production) -> str:
    parts, verdicts = production.structure.parts, production.verdicts
    views = (("plan", PLAN), ("from a corner", CORNER))
    figures = [
        f"<figure>{structure_view(parts, verdicts, eye, name)}"
        f"<figcaption>{name}</figcaption></figure>"
        for name, eye in views
    ]
    return f'<div class="row">{"".join(figures)}</div>'


def _messages(messages: Sequence[str]) -> str:
    if not messages:
        return ""
    items = "".join(f"<li>{escape(message)}</li>" for message in messages)
    return f"<h2>Out of the ordinary</h2><ul>{items}</ul>"


def _plots(production: Production) -> str:
    parts = production.structure.parts
    plots = [histogram("length", "mm", [part.length for part in parts])]
    for field in fields(Measures):
        values = [getattr(part.measures, field.name) for part in parts]
        known = [value for value in values if value is not None]
        if known:
            limit = production.structure.common_limit(field.name)
            plots.append(histogram(*measure_words(field.name), known, limit))
    return f'<h2>Measures</h2><div class="row plots">{"".join(plots)}</div>'
