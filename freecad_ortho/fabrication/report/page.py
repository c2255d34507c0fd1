"""The report as one HTML page: verdict first, then pictures, numbers, lists and every part."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import fields
from html import escape

import numpy as np

from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.part import Measures
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.report.pictures import (
    BAD,
    CORNER,
    GOOD,
    INK,
    PLAN,
    sheet_picture,
    structure_view,
)
from freecad_ortho.fabrication.report.plots import histogram
from freecad_ortho.words import counted, plural

_STYLE = f"""
body {{ font: 15px/1.45 system-ui, sans-serif; color: {INK}; margin: 2rem auto; max-width: 64rem;
  padding: 0 1rem; }}
h1 {{ margin-bottom: 0; }} h2 {{ margin-top: 2.2rem; border-bottom: 1px solid #ccd3da; }}
.verdict {{ font-size: 1.25rem; padding: .6rem 1rem; border-left: .5rem solid {GOOD};
  background: #f3f6f9; }}
.verdict.bad {{ border-color: {BAD}; }}
.row {{ display: flex; flex-wrap: wrap; gap: 1.2rem; }} .row > * {{ flex: 1 1 18rem; margin: 0; }}
figure {{ break-inside: avoid; }} figcaption {{ color: #66727e; }} svg {{ max-width: 100%; }}
.plots text {{ font: 11px sans-serif; }}
.sheets > * {{ flex: 0 1 19rem; }}
.good {{ fill: {GOOD}; }} .bad {{ fill: {BAD}; }}
path.good, path.bad {{ stroke: {INK}; stroke-width: .35; stroke-linejoin: round; }}
.bar {{ fill: {GOOD}; }} .axis {{ stroke: {INK}; }} .limit {{ stroke: {BAD}; stroke-width: 2; }}
table {{ border-collapse: collapse; font-size: .85rem; }} thead {{ display: table-header-group; }}
th, td {{ padding: .15rem .6rem; text-align: right; border-bottom: 1px solid #e4e8ec; }}
th:first-child, td:first-child, td.text {{ text-align: left; }} tr {{ break-inside: avoid; }}
tr.bad td {{ background: #fbe9eb; }}
@media print {{ body {{ margin: 0; max-width: none; font-size: 10pt; }} }}
"""


def report_page(production: Production, project: str = "") -> str:
    """Write the page; pictures and plots are part of it, so it works without a network.

    Args:
        production: what is reported.
        project: what the page is headed by, such as the name of the mesh.
    """
    title = escape(f"Fabrication report: {project}" if project else "Fabrication report")
    sections = [
        f"<h1>{title}</h1>",
        _summary(production),
        _views(production),
        _messages(production.messages),
        _plots(production),
        _families(production),
        _sheets(production),
        _stock(production),
        _clashes(production),
        _parts(production),
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{_STYLE}</style></head>\n'
        f"<body>{chr(10).join(section for section in sections if section)}</body></html>\n"
    )


def _summary(production: Production) -> str:
    parts, verdicts = production.structure.parts, production.verdicts
    failed = sum(words != OK for words in verdicts)
    kinds = Counter(part.kind for part in parts)
    counts = ", ".join(counted(count, kind) for kind, count in kinds.items())
    masses = production.structure.masses
    words = (
        f"All {len(parts)} parts are within the limits."
        if not failed
        else f"{failed} of {len(parts)} parts exceed a limit; they are red below."
    )
    return (
        f"<p>{escape(_kind_and_size(production))}</p>"
        f"<p>{escape(counts)}; {escape(_of_materials(masses))}</p>"
        f'<p class="verdict{" bad" * bool(failed)}">{words}</p>'
    )


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
            name, _, unit = field.name.rpartition("_")
            limit = production.structure.common_limit(field.name)
            plots.append(histogram(name.replace("_", " "), unit, known, limit))
    return f'<h2>Measures</h2><div class="row plots">{"".join(plots)}</div>'


def _families(production: Production) -> str:
    report = production.families.report()
    rows = []
    for what in ("lengths", "shapes"):
        for kind, entry in report[what].items():
            rows.append((f"{what} of {plural(kind)}", entry))
    rows.append(("nodes", report["nodes"]))
    table = [(name, entry["different"], _largest(entry["groups"])) for name, entry in rows]
    words = f"Equal within {report['tolerance_mm']:g} mm and {report['tolerance_deg']:g} degrees."
    return f"<h2>Equal parts</h2><p>{words}</p>" + _table(
        ("what", "different ones", "largest groups"), table
    )


def _largest(groups: Sequence[Sequence[str]]) -> str:
    return "; ".join(f"{len(group)} like {group[0]}" for group in groups[:6]) or "none"


def _sheets(production: Production) -> str:
    if not production.sheets:
        return ""
    width, height = production.workshop.sheet or (0.0, 0.0)
    used = sum(sheet.used for sheet in production.sheets)
    waste = 1 - used / (width * height * len(production.sheets))
    figures = [
        f"<figure>{sheet_picture(sheet)}<figcaption>{escape(sheet.title)}, "
        f"{counted(len(sheet.placements), 'part')}, waste {100 * sheet.waste:.0f} %"
        "</figcaption></figure>"
        for sheet in production.sheets
    ]
    return (
        f"<h2>Sheets</h2><p>{counted(len(production.sheets), 'sheet')} of {width:g} x "
        f"{height:g} mm, "
        f'waste {100 * waste:.1f} %.</p><div class="row sheets">{"".join(figures)}</div>'
    )


def _stock(production: Production) -> str:
    if not production.bars:
        return ""
    rows = [
        (bar.name, bar.kind, f"{bar.width:.1f} x {bar.thickness:g}", f"{bar.length:g}")
        + (f"{bar.length - bar.used:.1f}", " ".join(bar.parts))
        for bar in production.bars
    ]
    head = ("bar", "for", "section mm", "length mm", "left over mm", "parts")
    return "<h2>Stock</h2>" + _table(head, rows)


def _clashes(production: Production) -> str:
    check = production.clashes
    words = f"{check.near:,} pairs of parts come near each other"
    if check.open:
        names = "; ".join(" and ".join(pair) for pair in check.open)
        words += f", of which the CAD kernel leaves {len(check.open)} open ({escape(names)})"
    if not check.clashes:
        others = " of the others" if check.open else ""
        return f"<h2>Clash check</h2><p>{words}; none{others} shares volume.</p>"
    rows = [(clash.first, clash.second, f"{clash.volume:.1f}") for clash in check.clashes]
    return (
        f"<h2>Clash check</h2><p>{words}; {len(rows)} share{'s' * (len(rows) == 1)} volume:</p>"
        + _table(("part", "cuts", "by mm3"), rows)
    )


def _parts(production: Production) -> str:
    names = [field.name for field in fields(Measures)]
    parts = production.structure.parts
    used = [name for name in names if any(getattr(p.measures, name) is not None for p in parts)]
    rows, classes = [], []
    for part, verdict in zip(parts, production.verdicts, strict=True):
        line = "" if part.line is None else f"{part.family} {part.line}"
        values = (getattr(part.measures, name) for name in used)
        numbers = ("" if value is None else f"{value:.3g}" for value in values)
        sizes = f"{part.length:.1f} x {part.width:.1f} x {part.thickness:g}"
        rows.append((part.name, line, sizes, f"{part.mass:.2f}", *numbers, verdict))
        classes.append("" if verdict == OK else "bad")
    head = ("part", "line", "size mm", "mass kg", *(_title(name) for name in used), "verdict")
    return "<h2>Parts</h2>" + _table(head, rows, classes)


def _title(name: str) -> str:
    return name.replace("_", " ")


def _table(
    head: Iterable[str], rows: Iterable[Sequence[object]], classes: Sequence[str] = ()
) -> str:
    top = "".join(f"<th>{escape(word)}</th>" for word in head)
    lines = []
    for number, row in enumerate(rows):
        kind = f' class="{classes[number]}"' if classes and classes[number] else ""
        cells = "".join(f"<td>{escape(str(value))}</td>" for value in row)
        lines.append(f"<tr{kind}>{cells}</tr>")
    return f"<table><thead><tr>{top}</tr></thead><tbody>{chr(10).join(lines)}</tbody></table>"
