"""Words of the workbench that stand in its catalogues and not beside a call of ``translate``.

Rooms without FreeCAD list them (nets, fields, sources, systems, materials); panels and property
editors translate them when they are shown.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from freecad_ortho.fabrication import MATERIALS, SYSTEMS, Limits, Workshop
from freecad_ortho.fabrication.formats import FORMATS
from freecad_ortho.fabrication.workshop import ON_SHEETS
from freecad_ortho.sources import GROUPS, SOURCES
from freecad_ortho.structural.design import Design
from solver.analysis.fields import fields
from solver.mesh.remesh import OPTIONS as REMESHING
from solver.nets import NETS
from solver.nets.options import OPTIONS
from solver.nets.settings import WEIGHTS
from solver.nets.supports import SUPPORTS
from solver.option import Option

_PANELS, _PROPERTIES = "Ortho", "App::Property"


def words() -> Iterator[tuple[str, str]]:
    """Give pairs of context and word; some come twice."""
    for names in (NETS, fields(), ("None",), MATERIALS, *GROUPS.values()):
        yield from ((_PANELS, name) for name in names)
    for net in NETS.values():
        yield from ((_PANELS, words) for words in (net.title, net.gives))
    for choice in (*OPTIONS.values(), *WEIGHTS.values(), SUPPORTS):
        yield _PROPERTIES, choice.sentence
        yield from ((_PANELS, words) for words in (choice.label, *choice.shown.values()))
        yield from ((_PANELS, words) for words in (choice.meaning, choice.absent) if words)
    for source in SOURCES.values():
        yield _PANELS, source.meaning
        for option in source.options:
            yield from _option(option)
            yield _PROPERTIES, option.meaning
    # Sheets and files to be written have fields of their own.
    for size in Workshop.options:
        if size.name not in ("sheet", "write"):
            yield from _option(size)
    yield from ((_PROPERTIES, size.sentence) for size in ON_SHEETS)
    for entry in REMESHING[1:]:
        yield from _option(entry)
    for option in Design.options:
        yield from _option(option)
        yield _PROPERTIES, option.sentence
    yield from ((_PANELS, each.contents) for each in FORMATS.values())
    for limit in Limits.options:
        yield _PROPERTIES, limit.sentence
    for system in SYSTEMS.values():
        for entry in system.options:
            yield from _option(entry)
            yield _PROPERTIES, f"{entry.label}: {entry.sentence}"


def _option(option: Option) -> Iterator[tuple[str, str]]:
    yield _PANELS, option.label
    if option.absent:
        yield _PANELS, option.absent
    yield _PANELS, option.meaning
    yield from ((_PANELS, word) for word in (*option.words.values(), *option.shown.values()))
