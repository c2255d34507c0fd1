"""The tables of the report: groups first, then single ones as far as people read them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import fields
from html import escape

from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.part import Measures, Part, measure_words
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.report.pictures import sheet_picture
from freecad_ortho.fabrication.report.way import StagesBefore
from freecad_ortho.fabrication.stock import Bar, bars_by_section
from freecad_ortho.words import counted, plural

# Rows of a list and pictures of sheets that a page holds; the files hold all of them.
_ROWS, _PICTURES = 60, 24
# mm, degrees, MPa: no workshop measures less.
_NOTHING = 1e-9


def way_to_it(way: StagesBefore) -> str:
    """How the net came to be: an item a stage, with what was asked and what came of it."""
    items = "".join(
        f"<li><b>{escape(stage.name)}</b> ({escape(stage.asked)}): {escape(stage.reached)}</li>"
        for stage in way.stages
    )
    return f"<h2>The way to it</h2><ol>{items}</ol>"


def groups_of_parts(production: Production) -> str:
    """Parts of one kind, material and thickness: how many, how many different, how long, heavy."""
    equal_to = production.groups.equal_to
    failed = {part.name for part in _failing(production)}
    groups: dict[tuple[str, str, float], list[Part]] = {}
    for part in production.structure.parts:
        groups.setdefault((part.kind, part.material.name, part.thickness), []).append(part)
    rows = []
    for (kind, material, thickness), parts in groups.items():
        lengths = [part.length for part in parts]
        bad = sum(part.name in failed for part in parts)
        cut = [equal_to.get(part.name, part.name) for part in parts if part.pattern is not None]
        rows.append(
            (
                *(kind, material, f"{thickness:g}", f"{len(parts):,}"),
                f"{len(set(cut)):,}" if cut else "",
                f"{min(lengths):,.1f} to {max(lengths):,.1f}",
                f"{sum(part.mass for part in parts):,.1f}",
                f"{bad:,}" if bad else "none",
            )
        )
    head = ("parts", "material", "thickness, mm", "number", "different", "length, mm")
    return "<h2>Parts in groups</h2>" + table((*head, "mass, kg", "not ok"), rows)


def equal_parts(production: Production) -> str:
    """How many different ones there are, and the largest groups of equal ones."""
    report = production.groups.report()
    rows = []
    for what in ("lengths", "shapes"):
        for kind, entry in report[what].items():
            rows.append((f"{what} of {plural(kind)}", entry))
    rows.append(("nodes", report["nodes"]))
    largest = [(name, entry["different"], _largest(entry["groups"])) for name, entry in rows]
    words = f"Equal within {report['tolerance_mm']:g} mm and {report['tolerance_deg']:g} degrees."
    return f"<h2>Equal parts</h2><p>{words}</p>" + table(
        ("what", "different ones", "largest groups"), largest
    )


def sheets(production: Production) -> str:
    """Pictures of the sheets, and what is lost on them."""
    if not production.sheets:
        return ""
    used = sum(sheet.used for sheet in production.sheets)
    waste = 1 - used / sum(sheet.width * sheet.height for sheet in production.sheets)
    figures = [
        f"<figure>{sheet_picture(sheet)}<figcaption>{escape(sheet.title)}, "
        f"{counted(len(sheet.placements), 'part')}, waste {100 * sheet.waste:.0f} %"
        "</figcaption></figure>"
        for sheet in production.sheets[:_PICTURES]
    ]
    stores = Counter(
        (sheet.material, f"{sheet.thickness:g}", f"{sheet.width:g} x {sheet.height:g}")
        for sheet in production.sheets
    )
    rows = [(*store, count) for store, count in stores.items()]
    return (
        f"<h2>Sheets</h2><p>{counted(len(production.sheets), 'sheet')}, waste "
        f"{100 * waste:.1f} %.</p>"
        + table(("material", "thickness, mm", "size, mm", "sheets"), rows)
        + f'<div class="row sheets">{"".join(figures)}</div>'
        + _more(len(production.sheets), _PICTURES, "sheet", "sheets/overview.svg")
    )


def stock(production: Production) -> str:
    """What bars to take from the store."""
    if not production.bars:
        return ""
    rows = []
    for bars in bars_by_section(production.bars):
        low, high = min(bar.widths[0] for bar in bars), max(bar.widths[1] for bar in bars)
        cut, length = sum(bar.cut for bar in bars), sum(bar.length for bar in bars)
        kept = sum(bar.left for bar in bars if bar.usable)
        rows.append(
            (
                *(bars[0].section, bars[0].material, f"{low:.1f} to {high:.1f}"),
                *(f"{len(bars):,}", _lengths(bars)),
                f"{sum(len(bar.parts) for bar in bars):,}",
                *(f"{kept / 1000:,.1f}", f"{100 * (1 - (cut + kept) / length):.1f}"),
            )
        )
    shop = production.workshop
    head = ("section", "material", "widths of parts, mm", "bars", "length, mm", "parts")
    return (
        f"<h2>Stock</h2><p>{shop.trim:g} mm are cut off at each end of a bar and {shop.saw:g} mm "
        f"lost behind each part; rests from {shop.rest:g} mm on are kept. Bar by bar: stock.csv."
        "</p>" + table((*head, "rests kept, m", "waste, %"), rows)
    )


def _lengths(bars: Sequence[Bar]) -> str:
    """Lengths of bars, the shortest first."""
    return " and ".join(f"{length:,g}" for length in sorted({bar.length for bar in bars}))


def clash_causes(production: Production) -> list[str]:
    """What clashes with what: pairs of kinds, most frequent first, each with its worst pair."""
    kinds = {part.name: part.kind for part in production.structure.parts}
    groups: dict[tuple[str, ...], list[tuple[float, str, str]]] = {}
    for clash in production.clashes.clashes:
        pair = tuple(sorted((kinds[clash.first], kinds[clash.second])))
        groups.setdefault(pair, []).append((clash.volume, clash.first, clash.second))
    causes = []
    for pair, found in sorted(groups.items(), key=lambda entry: -len(entry[1])):
        volume, first, second = max(found)
        among = f"a {pair[0]} with a {pair[1]}" if pair[0] != pair[1] else f"two {plural(pair[0])}"
        causes.append(
            f"{counted(len(found), 'time')} {among}, at worst {first} and {second} by "
            f"{volume:,.1f} mm3"
        )
    return causes


def clashes(production: Production) -> str:
    """The pairs that share volume, the worst first."""
    check = production.clashes
    words = f"{check.near:,} pairs of parts come near each other"
    if check.open:
        names = "; ".join(" and ".join(pair) for pair in check.open)
        words += f", of which the CAD kernel leaves {len(check.open)} open ({escape(names)})"
    if not check.clashes:
        others = " of the others" if check.open else ""
        return f"<h2>Clash check</h2><p>{words}; none{others} shares volume.</p>"
    worst = sorted(check.clashes, key=lambda clash: -clash.volume)
    rows = [(clash.first, clash.second, f"{clash.volume:.1f}") for clash in worst]
    return (
        f"<h2>Clash check</h2><p>{words}; {len(rows)} share{'s' * (len(rows) == 1)} volume:</p>"
        + table(("part", "cuts", "by mm3"), rows[:_ROWS])
        + _more(len(rows), _ROWS, "pair", "report.json")
    )


def parts_list(production: Production) -> str:
    """Single parts with their numbers, those that fail first."""
    parts = production.structure.parts
    names = [field.name for field in fields(Measures)]
    verdicts = dict(zip((part.name for part in parts), production.verdicts, strict=True))
    ordered = sorted(parts, key=lambda part: verdicts[part.name] == OK)[:_ROWS]
    used = [name for name in names if any(getattr(p.measures, name) is not None for p in ordered)]
    rows, classes = [], []
    for part in ordered:
        verdict = verdicts[part.name]
        line = "" if part.line is None else f"{part.family} {part.line}"
        values = (getattr(part.measures, name) for name in used)
        numbers = ("" if value is None else _number(value) for value in values)
        sizes = f"{part.length:.1f} x {part.width:.1f} x {part.thickness:g}"
        rows.append((part.name, line, sizes, f"{part.mass:.2f}", *numbers, verdict))
        classes.append("" if verdict == OK else "bad")
    titles = (", ".join(measure_words(name)) for name in used)
    head = ("part", "line", "size, mm", "mass, kg", *titles, "verdict")
    return (
        '<h2>Parts</h2><div class="parts">'
        + table(head, rows, classes)
        + "</div>"
        + _more(len(parts), _ROWS, "part", "parts.csv")
    )


def _number(value: float) -> str:
    """Three digits that count; what is left of nothing by rounding is nothing."""
    return "0" if abs(value) < _NOTHING else f"{value:.3g}"


def _failing(production: Production) -> list[Part]:
    pairs = zip(production.structure.parts, production.verdicts, strict=True)
    return [part for part, verdict in pairs if verdict != OK]


def _more(number: int, shown: int, noun: str, file: str) -> str:
    if number <= shown:
        return ""
    return f"<p>{counted(number - shown, f'more {noun}')}: all are in {file}.</p>"


def _largest(groups: Sequence[Sequence[str]]) -> str:
    return "; ".join(f"{len(group)} like {group[0]}" for group in groups[:6]) or "none"


def table(
    head: Iterable[str], rows: Iterable[Sequence[object]], classes: Sequence[str] = ()
) -> str:
    """A table of texts in HTML, its rows of the classes that are given."""
    top = "".join(f"<th>{escape(word)}</th>" for word in head)
    lines = []
    for number, row in enumerate(rows):
        kind = f' class="{classes[number]}"' if classes and classes[number] else ""
        cells = "".join(f"<td>{escape(str(value))}</td>" for value in row)
        lines.append(f"<tr{kind}>{cells}</tr>")
    return f"<table><thead><tr>{top}</tr></thead><tbody>{chr(10).join(lines)}</tbody></table>"
